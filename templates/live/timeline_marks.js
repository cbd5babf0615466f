// Keys, cues and what is held back, as elements one can focus, click and drag.
import {state, say} from "./state.js";
import {make} from "./elements.js";
import {edit, isChecked} from "./document.js";
import {goToFrame} from "./player.js";
import {findContext} from "./yaml_path.js";

const kDragFrom_px = 4;   // a shorter way is a click
const kLane_px = 15;      // height of a cue

const toFrame = (time_s) => Math.round(time_s * state.clip.fps);
const describeTime = (frame) => `${(frame / state.clip.fps).toFixed(2)} s, frame ${frame}`;

function describeMark(mark) {
  const where = mark.line > 0 ? `, line ${mark.line}` : ", in no line of this text";
  const until = mark.kind === "cue" ? ` to ${mark.end_s.toFixed(2)} s` : "";
  return `${mark.kind}${mark.label ? ` ${mark.label}` : ""}: ${mark.at_s.toFixed(2)} s${until}${where}`;
}

// Why nothing of it can be changed here.
function sayPlaceless(mark) {
  say(`This ${mark.kind} stands in no line of this text: it comes from another file, or from mien itself`, true);
}

/** A key: a diamond. A moment of another kind is one too, smaller. */
function makeKey(mark) {
  return make("button", {type: "button", className: `mark mark_key mark_${mark.kind}`, tabIndex: -1, title: describeMark(mark),
                         "aria-label": describeMark(mark), data: {kind: mark.kind, line: mark.line, column: mark.column, at: mark.at_s}});
}

/** A cue: a bar that comes and goes as its strength does. */
function makeCue(mark) {
  const button = make("button", {type: "button", className: `mark mark_cue layer_${mark.layer}`, tabIndex: -1, title: describeMark(mark),
                                 "aria-label": describeMark(mark), data: {kind: "cue", line: mark.line, column: mark.column, at: mark.at_s}},
                      make("span", {className: "cue_label"}, mark.label), make("span", {className: "cue_end", title: "Drag: when it goes"}));
  button.style.top = `${2 + mark.lane * kLane_px}px`;
  return button;
}

/** Where a mark stands on the row. */
export function placeMark(element, mark, scale) {
  const fps = state.clip.fps;
  const x = scale.toX(mark.at_s * fps);
  element.style.left = `${x}px`;
  if (mark.kind !== "cue") return;
  const length = Math.max(6, scale.toX(mark.end_s * fps) - x);
  const percent = (time_s) => `${Math.max(0, Math.min(100, (time_s - mark.from_s) / Math.max(1e-6, mark.end_s - mark.from_s) * 100)).toFixed(2)}%`;
  element.style.width = `${length}px`;
  element.style.setProperty("--full", percent(mark.full_s));
  element.style.setProperty("--ebb", percent(mark.ebb_s));
}

/** The height of a row with so many lanes of cues. */
export const computeCuesHeight_px = (lanes) => 4 + lanes * kLane_px;

async function move(mark, member, frame, origin) {
  if (mark.line < 1) {
    sayPlaceless(mark);
    return;
  }
  if (!isChecked()) {
    say("The text is still being read; try again", true);
    return;
  }
  const {fps} = state.clip;
  const request = {do: "move", line: mark.line, column: mark.column, member, to_s: frame / fps, fps};
  await edit(member === "to" ? [request, setEnd(mark, frame / fps)] : request, origin);
}

// For a cue without a `to`: how long it holds, where it may say so.
function setEnd(mark, to_s) {
  const lines = window.mienLive.editor.cm.getValue().split("\n");
  const {path} = findContext(lines, mark.line - 1, mark.column);
  const isHeld = mark.layer === "cue" && mark.areas.length > 0;
  const value_s = isHeld ? Math.max(0, to_s - mark.full_s) : to_s;
  return {do: "set", path: [...path, isHeld ? "hold" : "to"], value: `${Number(value_s.toFixed(4))}s`};
}

const findMember = (mark) => mark.kind === "cue" ? "from" : "at";

/** Moves a mark by frames, from the keyboard. */
export function nudge(mark, frames, isEnd) {
  const member = isEnd && mark.kind === "cue" ? "to" : findMember(mark);
  const from_s = member === "to" ? mark.ebb_s : mark.at_s;
  return move(mark, member, Math.max(0, toFrame(from_s) + frames), `*nudge ${mark.kind} ${mark.label}`);
}

/** Follows the pointer from a press on a mark: a click selects it, a drag moves it. */
export function followDrag(event, element, mark, timeline) {
  if (event.button !== 0) return;
  const isEnd = event.target.classList.contains("cue_end");
  const start = toFrame(isEnd ? mark.ebb_s : mark.at_s);
  const begin_px = event.clientX;
  let frame = start, isDragging = false;
  element.setPointerCapture(event.pointerId);
  timeline.holdRows(true);
  const hear = {
    pointermove: (moved) => {
      const way_px = moved.clientX - begin_px;
      if (!isDragging && Math.abs(way_px) < kDragFrom_px) return;
      isDragging = true;
      frame = Math.max(0, start + Math.round(way_px / timeline.scale.frame_px));
      element.classList.add("dragged");
      if (!isEnd) element.style.transform = `translateX(${(frame - start) * timeline.scale.frame_px}px)`;
      timeline.showGhost(frame, describeTime(frame));
    },
    pointerup: () => {
      end();
      if (isDragging && frame !== start) move(mark, isEnd ? "to" : findMember(mark), frame, "edit").finally(restore);
      else restore();
      if (!isDragging) timeline.choose(mark, element);
    },
    pointercancel: () => (end(), restore()),
  };
  const cancel = (key) => {
    if (key.key !== "Escape") return;
    key.preventDefault();
    key.stopPropagation();
    end();
    restore();
  };
  const restore = () => {
    element.style.transform = "";
    element.classList.remove("dragged");
  };
  const end = () => {
    for (const [name, listener] of Object.entries(hear)) element.removeEventListener(name, listener);
    window.removeEventListener("keydown", cancel, true);
    timeline.hideGhost();
    setTimeout(() => timeline.holdRows(false), 0);
  };
  for (const [name, listener] of Object.entries(hear)) element.addEventListener(name, listener);
  window.addEventListener("keydown", cancel, true);
}

function describeHeld(held) {
  return `Held back: ${held.who}${held.line > 0 ? ` (line ${held.line})` : ""}`;
}

/** The red bar over the time in which a limit held something back. */
export function makeHeld(held, timeline) {
  return make("button", {type: "button", className: "held", title: describeHeld(held), "aria-label": describeHeld(held),
                         data: {line: held.line, move: `${held.area}.${held.move}`},
                         on: {click: () => timeline.goToPlace(held)}});
}

/** Where it stands on its row. */
export function placeHeld(element, held, scale) {
  const {fps} = state.clip;
  const x = scale.toX(held.from_s * fps);
  element.style.left = `${x}px`;
  element.style.width = `${Math.max(4, scale.toX(held.to_s * fps) - x)}px`;
}

/** The element of a mark, which hears the pointer. */
export function makeMark(mark, timeline) {
  const element = mark.kind === "cue" ? makeCue(mark) : makeKey(mark);
  element.addEventListener("pointerdown", (event) => followDrag(event, element, mark, timeline));
  element.addEventListener("focus", () => timeline.noteFocus(element));
  element.addEventListener("keydown", (event) => timeline.hearMarkKey(event, mark, element));
  return element;
}

/** Shows the frame of a mark, and its line in the text. */
export function goToMark(mark, editor) {
  goToFrame(toFrame(mark.at_s));
  if (mark.line > 0) editor.goTo(mark.line, mark.column);
  else sayPlaceless(mark);
}
