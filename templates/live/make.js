// What is made of the file: clips, stills, prints; and how far they are.
import {ask, get} from "./server.js";
import {on, say, state} from "./state.js";
import {find, make, makeButton} from "./elements.js";
import {save} from "./document.js";

const kRetry_ms = 2000;
const kKinds = [
  {title: "Clip", jobs: [{kind: "sketch", text: "Sketch the clip", about: "Our own quick pictures: seconds"},
                         {kind: "render", text: "Render the clip", about: "POV-Ray, at the file's quality"}]},
  {title: "Picture of this face", isOfFace: true, jobs: [
    {kind: "still_sketch", text: "Sketch", about: "Our own quick picture"}, {kind: "still", text: "Render", about: "POV-Ray, at the file's quality"}]},
  {title: "Bust of this face, to print", isOfFace: true, jobs: [
    {kind: "bust", text: "OpenSCAD", about: "Its source, with sliders for the expression"}, {kind: "stl", text: "STL", about: "For a printer"}]},
];

const buttons = [];
const shown = new Map();  // jobs by id: {element, ...parts}
let version = 0;
let isWatching = false;

function findFace() {
  const {pose} = state;
  if (pose) return {actor: pose.actor, ...(pose.name ? {express: pose.name} : {values: pose.values})};
  return {at_s: state.frame / state.clip.fps};
}

async function start({kind}, isOfFace) {
  const face = isOfFace ? findFace() : {};
  if (state.isUnsaved && !await save()) return;
  try {
    await ask("api/job", {kind, ...face});
    watch();
  } catch (error) {
    say(error.message, true);
  }
}

function findHindrance() {
  if (state.session.read_only) return "Read only: mien live was started with --read-only, so nothing is made.";
  if (!state.isGood) return "The text has mistakes; nothing can be made of it yet.";
  return "";
}

function describeFace() {
  if (!state.clip) return "";
  const {pose} = state;
  return `This face: ${pose ? `${pose.name || "posed by hand"}, looking ahead` : `${(state.frame / state.clip.fps).toFixed(2)} s, frame ${state.frame}`}.`;
}

function showButtons() {
  const hindrance = findHindrance();
  find("make_hindrance").textContent = hindrance || (state.isUnsaved ? "Unsaved edits are saved first." : "");
  find("make_face").textContent = describeFace();
  for (const {button, job} of buttons) {
    button.disabled = hindrance !== "";
    button.textContent = state.isUnsaved && !hindrance ? `Save, ${job.text.replace(/^[SR][a-z]/, (start) => start.toLowerCase())}` : job.text;
  }
}

function makeResult({name, href}) {
  const link = make("a", {href, target: "_blank", rel: "noopener"}, name);
  if (/\.(png|jpe?g|gif|webp|apng|svg)$/i.test(name)) return make("div", {className: "result"}, link, make("a", {href, target: "_blank", rel: "noopener", tabIndex: -1}, make("img", {src: href, alt: name})));
  if (/\.(mp4|webm|mov)$/i.test(name)) {
    const video = make("video", {src: href, controls: true, loop: true, preload: "metadata"});
    return make("div", {className: "result"}, link, video);
  }
  return make("div", {className: "result"}, link);
}

const isOver = (job) => job.state !== "running" && job.state !== "waiting";

function makeJob(job) {
  const parts = {title: make("b"), state: make("span", {className: "dim job_state"}), bar: make("div", {className: "bar", role: "progressbar", "aria-valuemin": 0, "aria-valuemax": 100, "aria-label": job.title}, make("i")),
                 stage: make("p", {className: "dim stage"}), lines: make("pre", {className: "lines", tabIndex: 0, "aria-label": "Last lines"}), results: make("div", {className: "results"})};
  parts.stop = makeButton("Stop", () => ask("api/stop_job", {id: job.id}).catch((error) => say(error.message, true)), {className: "quiet"});
  parts.element = make("li", {className: "job", data: {job: job.id}}, make("div", {className: "job_head"}, parts.title, parts.state, make("span", {className: "spring"}), parts.stop),
                       parts.bar, parts.stage, parts.lines, parts.results);
  parts.names = "";
  shown.set(job.id, parts);
  find("jobs").prepend(parts.element);
  return parts;
}

function showJob(job) {
  const parts = shown.get(job.id) ?? makeJob(job);
  const isRunning = job.state === "running";
  const percent = job.total > 0 ? Math.round(job.done / job.total * 100) : 0;
  if (parts.was === "running" && isOver(job)) say(`${job.title}: ${job.state}`, job.state === "failed");
  parts.was = job.state;
  parts.element.dataset.state = job.state;
  parts.title.textContent = job.title;
  parts.state.textContent = isRunning && job.total > 0 ? `${job.done} of ${job.total}` : job.state;
  parts.bar.hidden = !isRunning;
  parts.bar.classList.toggle("unsure", !(job.total > 0));
  parts.bar.firstChild.style.width = `${percent}%`;
  parts.bar.setAttribute("aria-valuenow", percent);
  parts.stage.textContent = isRunning ? job.stage ?? "" : "";
  parts.stop.hidden = isOver(job);
  parts.lines.textContent = (job.lines ?? []).join("\n");
  parts.lines.hidden = !parts.lines.textContent;
  const names = JSON.stringify(job.results ?? []);
  if (names === parts.names) return;
  parts.names = names;
  parts.results.replaceChildren(...(job.results ?? []).map(makeResult));
}

// Waits for news while something runs.
async function watch() {
  if (isWatching) return;
  isWatching = true;
  for (let isRunning = true; isRunning;) {
    try {
      const answer = await get(`api/jobs?version=${version}`);
      version = answer.version;
      answer.jobs.forEach(showJob);
      isRunning = answer.jobs.some((job) => !isOver(job));
    } catch {
      await new Promise((done) => setTimeout(done, kRetry_ms));
    }
  }
  isWatching = false;
}

/** Builds the panel in `element`. */
export function startMake(element) {
  const groups = kKinds.map(({title, isOfFace, jobs}) => make("fieldset", {className: "group"}, make("legend", {}, title), make("div", {className: "buttons"}, ...jobs.map((job) => {
    const button = makeButton(job.text, () => start(job, isOfFace), {id: `make_${job.kind}`, title: job.about ?? ""});
    buttons.push({button, job});
    return button;
  }))));
  element.append(make("div", {className: "scroll"}, make("p", {id: "make_hindrance", className: "hindrance"}), ...groups,
                      make("p", {id: "make_face", className: "dim"}), make("ul", {id: "jobs", "aria-label": "Jobs"})));
  for (const event of ["unsaved", "findings", "frame", "pose", "clip"]) on(event, showButtons);
  showButtons();
  watch();
}
