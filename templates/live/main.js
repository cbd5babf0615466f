// The page: each part is started, and told of the others.
import {get} from "./server.js";
import {emit, on, onFirst, say, state} from "./state.js";
import {find, make} from "./elements.js";
import {setSchema} from "./words.js";
import {Editor} from "./editor.js";
import {save, startDocument} from "./document.js";
import {setView as playOn, showAgain as showFrameAgain, startPlayer, stats} from "./player.js";
import {Timeline} from "./timeline.js";
import {dropPose, setView as poseOn, showAgain as showPoseAgain} from "./posing.js";
import {startPose, writeKeyHere} from "./pose.js";
import {startHead} from "./head.js";
import {startMake} from "./make.js";
import {focusNextPart, startSplits, startTabs, startTheme} from "./panes.js";
import {showShortcuts, startShortcuts} from "./shortcuts.js";

const kLateFace_ms = 3000;  // what waits for the face waits no longer

const mienLive = {state, stats, editor: null, view: null, timeline: null};
window.mienLive = mienLive;

function tellTrouble(message) {
  find("view_trouble").textContent = message;
  find("view_trouble").hidden = !message;
}

// The page works without the face.
async function startView() {
  let view = null;
  try {
    const {createView} = await import("./view.js");
    view = await createView(find("view"), state.session);
  } catch (error) {
    console.warn(error);
    tellTrouble(`The face cannot be shown here: ${error.message}`);
    return;
  }
  view.on("error", ({message}) => tellTrouble(message));
  view.on("shown", () => tellTrouble(""));
  mienLive.view = view;
  playOn(view);
  poseOn(view);
  let tellShown = () => {};
  for (const event of ["shown", "error"]) view.on(event, () => tellShown());
  const setDocument = async () => {
    state.face = new Promise((done) => {
      tellShown = done;
      setTimeout(done, kLateFace_ms);
    });
    await view.setDocument(state.doc, state.clip);
    showFrameAgain();
    showPoseAgain();
  };
  onFirst("clip", setDocument);  // the slowest: the server works while the page is brought up to date
  if (state.clip) setDocument();
}

function showTitle() {
  const mark = state.isUnsaved ? "• " : "";
  document.title = `${mark}${state.session.name} - mien`;
  find("unsaved").hidden = !state.isUnsaved;
  find("save").disabled = !state.isUnsaved || state.session.read_only;
}

function count(number, word) {
  return `${number} ${word}${number === 1 ? "" : "s"}`;
}

function showFindings(editor) {
  const mistakes = state.findings.filter((finding) => finding.kind === "error").length;
  const warnings = state.findings.length - mistakes;
  const button = find("mistakes");
  const text = mistakes ? count(mistakes, "mistake") : warnings ? count(warnings, "warning") : "no mistakes";
  button.dataset.kind = mistakes ? "error" : warnings ? "warning" : "";
  button.textContent = text;
  const first = state.findings[0];
  const news = first ? `${text}. ${first.line > 0 ? `Line ${first.line}: ` : ""}${first.message}` : text;
  if (find("problem_news").textContent !== news) find("problem_news").textContent = news;
  editor.showFindings();
}

function showActors() {
  const names = state.clip.actors.map((actor) => actor.name);
  if (!names.includes(state.actor)) state.actor = names[0] ?? "";
  find("actor_row").hidden = names.length < 2;
  find("actor").replaceChildren(...names.map((name) => make("option", {value: name, selected: name === state.actor}, name)));
}

async function readSession() {
  for (;;) {
    try {
      return await Promise.all([get("api/session"), get("api/language")]);
    } catch (error) {
      say(error.message, true);
      await new Promise((done) => setTimeout(done, 2000));
    }
  }
}

async function start() {
  startTheme(() => mienLive.timeline?.draw());
  startTabs();
  [state.session, state.language] = await readSession();
  setSchema(state.language.schema);
  const editor = new Editor(find("editor"));
  mienLive.editor = editor;
  const timeline = new Timeline(find("tracks"), editor);
  mienLive.timeline = timeline;
  startSplits(() => {
    editor.cm.refresh();
    timeline.draw();
  });
  on("findings", () => showFindings(editor));
  on("unsaved", showTitle);
  on("clip", showActors);
  startPlayer();
  startPose(find("pose"), editor);
  startHead(find("head"));
  startMake(find("make"));
  startShortcuts({save, dropPose, writeKey: writeKeyHere, nextMistake: (way) => editor.goToNextFinding(way),
                  nextPart: (way) => focusNextPart(way, editor), timeline});
  find("file_name").textContent = state.session.name + (state.session.read_only ? " (read only)" : "");
  find("file").title = state.session.file;
  find("save").addEventListener("click", () => save());
  find("help").addEventListener("click", showShortcuts);
  find("mistakes").addEventListener("click", () => editor.goToNextFinding());
  find("actor").addEventListener("change", (event) => {
    state.actor = event.target.value;
    emit("actor");
  });
  showTitle();
  startDocument(editor);
  await startView();
}

start();
