// The clip in real time: which frame is due, and what could not be shown when it was.
import {emit, on, state} from "./state.js";
import {find} from "./elements.js";

const kAhead_s = 2;        // of drawings in memory before they are due
const kFetchEach_s = 0.5;
const kMostWait_ms = 2000;  // for one frame; then a newer one may take its place

/** How many frames were shown while playing, and how many were passed over. */
export const stats = {shown: 0, dropped: 0};

let view = null;
let isShowing = false;
let wanted = null;  // the frame that is to be shown when the view is free

/** The view that shows the frames; null while there is none. */
export function setView(value) {
  view = value;
}

/** The number of frames; 1 without a clip. */
export const countFrames = () => Math.max(1, state.clip?.frames ?? 1);

const clampFrame = (frame) => Math.max(0, Math.min(countFrames() - 1, Math.round(frame)));

// One at a time; the newest wins. Never waited for.
async function showWanted() {
  isShowing = true;
  while (wanted !== null) {
    const frame = wanted;
    wanted = null;
    try {
      await Promise.race([view.showFrame(frame), new Promise((done) => setTimeout(done, kMostWait_ms))]);
      if (state.isPlaying) ++stats.shown;
    } catch (error) {
      console.warn(error);
    }
  }
  isShowing = false;
}

function show(frame) {
  if (!view) return;
  if (wanted !== null && state.isPlaying) ++stats.dropped;  // it was due, and never came
  wanted = frame;
  if (!isShowing) showWanted();
}

/** The frame once more, from a view that has another clip. */
export function showAgain() {
  if (!state.isPlaying) show(state.frame);
}

/** Goes to a frame, stopping if the clip plays. */
export function goToFrame(frame) {
  stop();
  setFrame(clampFrame(frame));
}

function setFrame(frame) {
  state.frame = frame;
  show(frame);
  emit("frame");
}

/** One frame further, or back. */
export function stepFrame(way) {
  goToFrame(state.frame + way);
}

/** To the next key (or cue, turn, blink) of the clip, or the one before. */
export function stepKey(way) {
  const clip = state.clip;
  if (!clip) return;
  const times = [clip.keys, clip.cues, clip.turns, clip.blinks, clip.cameras, clip.lights, clip.backgrounds, clip.heads].flat()
    .map((key) => Math.round(key.at_s * clip.fps));
  const beyond = times.filter((frame) => Math.sign(frame - state.frame) === way);
  if (beyond.length) goToFrame(way > 0 ? Math.min(...beyond) : Math.max(...beyond));
}

let began_ms = 0, beganFrame = 0, lastStep = 0, fetchedUntil = 0;

// Each drawing of a growing head is a head of its own: all of them are made, the next ones first, and played from
// memory from then on.
function fetchAll(frame) {
  const last = countFrames() - 1;
  view.fetchAhead(frame, last, state.isLoop ? [0, frame - 1] : null);
}

function fetchAhead(frame) {
  if (state.clip.is_growing) return;
  const fps = state.clip.fps, count = countFrames();
  if (frame + kAhead_s * fps < fetchedUntil + kFetchEach_s * fps && frame >= fetchedUntil - kAhead_s * fps - 1) return;
  const until = frame + Math.ceil(kAhead_s * fps);
  fetchedUntil = until;
  view.fetchAhead(frame, Math.min(until, count - 1));
  if (until >= count && state.isLoop) view.fetchAhead(0, Math.min(until - count, count - 1));
}

// Of the frames between two steps those whose drawing was not on the screen already: a second frame of one drawing is
// not missed.
function countSkipped(from, to) {
  const {drawn} = state.clip, count = countFrames();
  const find = (step) => drawn[(beganFrame + step) % count];
  let skipped = 0;
  for (let step = from + 1; step < to; ++step) if (find(step) !== find(from)) ++skipped;
  return skipped;
}

function tick(now_ms) {
  if (!state.isPlaying) return;
  const count = countFrames();
  const step = Math.floor((now_ms - began_ms) / 1000 * state.clip.fps);
  if (step > lastStep) {
    const isOver = !state.isLoop && beganFrame + step >= count - 1;
    const frame = isOver ? count - 1 : (beganFrame + step) % count;
    stats.dropped += countSkipped(lastStep, step);
    lastStep = step;
    showInTime(frame);
    if (isOver) return stop();
  }
  requestAnimationFrame(tick);
}

function showInTime(frame) {
  state.frame = frame;
  if (view) fetchAhead(frame);
  if (!view) ++stats.shown;
  else if (view.isReady(frame)) show(frame);
  else ++stats.dropped;
  emit("frame");
}

/** Plays from the frame that is shown; from the start where that is the last one. */
export function play() {
  if (state.isPlaying || !state.clip || countFrames() < 2) return;
  if (!state.isLoop && state.frame >= countFrames() - 1) setFrame(0);
  Object.assign(stats, {shown: 0, dropped: 0});
  state.isPlaying = true;
  fetchedUntil = 0;
  restart();
  if (view && state.clip.is_growing) fetchAll(state.frame);
  else if (view) fetchAhead(state.frame);
  emit("playing");
  requestAnimationFrame((now_ms) => {
    began_ms = now_ms;
    tick(now_ms);
  });
}

function restart() {
  began_ms = performance.now();
  beganFrame = state.frame;
  lastStep = 0;
}

/** Stops where it is. */
export function stop() {
  if (!state.isPlaying) return;
  state.isPlaying = false;
  emit("playing");
  if (view) show(state.frame);
  emit("frame");
}

/** Plays or stops. */
export function togglePlay() {
  if (state.isPlaying) stop();
  else play();
}

/** Whether the clip begins again at its end. */
export function toggleLoop() {
  state.isLoop = !state.isLoop;
  if (state.isPlaying) restart();
  emit("playing");
}

function describeTime() {
  const fps = state.clip?.fps ?? 24;
  return `/ ${countFrames()}   ${(state.frame / fps).toFixed(2)} s`;
}

function showTransport() {
  const field = find("frame");
  if (document.activeElement !== field) field.value = state.frame;
  find("time").textContent = describeTime();
  find("dropped").hidden = stats.dropped === 0;
  find("dropped").textContent = `${stats.dropped} dropped`;
}

function showPlaying() {
  const button = find("play");
  button.setAttribute("aria-pressed", String(state.isPlaying));
  button.setAttribute("aria-label", state.isPlaying ? "Stop" : "Play");
  find("loop").setAttribute("aria-pressed", String(state.isLoop));
  document.body.classList.toggle("playing", state.isPlaying);
}

function showFacts() {
  const clip = state.clip;
  if (!clip) return;
  const drawings = clip.drawn.filter((drawn, frame) => drawn === frame).length;
  find("clip_facts").textContent = `${clip.fps} fps, ${drawings} drawings`;
  find("frame").setAttribute("aria-label", `Frame, 0 to ${clip.frames - 1}`);
}

function readFrame(text) {
  const seconds = /^\s*([\d.]+)\s*s\s*$/.exec(text);
  return seconds ? Number(seconds[1]) * (state.clip?.fps ?? 24) : Number.parseFloat(text);
}

/** The buttons above the timeline. */
export function startPlayer() {
  const actions = {to_start: () => goToFrame(0), to_end: () => goToFrame(countFrames() - 1), step_back: () => stepFrame(-1),
                   step_on: () => stepFrame(1), key_before: () => stepKey(-1), key_after: () => stepKey(1),
                   play: togglePlay, loop: toggleLoop};
  for (const [id, action] of Object.entries(actions)) find(id).addEventListener("click", action);
  find("frame").addEventListener("change", (event) => {
    const frame = readFrame(event.target.value);
    if (Number.isFinite(frame)) goToFrame(frame);
    event.target.value = state.frame;
  });
  on("frame", showTransport);
  on("playing", () => {
    showPlaying();
    showTransport();
  });
  on("clip", () => {
    if (state.frame >= countFrames()) setFrame(countFrames() - 1);
    if (state.isPlaying) restart();
    showFacts();
    showTransport();
  });
  showPlaying();
}
