// The text's ways: to the server to be checked and edited, to the disk and back.
import {ask, get, reach} from "./server.js";
import {emit, say, state} from "./state.js";
import {debounce, keepNewest} from "./newest.js";
import {setOwnExpressions} from "./words.js";
import {askAboutDisk, closeNotice} from "./conflict.js";

const kTyping_ms = 80;  // a check follows the last letter by this
const kRetry_ms = 2000;
const kOwnChanges = /^(edit|load|\*)/;  // whoever makes these checks at once
const kMostTries = 3;    // of an edit while the text is being typed in

let editor = null;
let warnings = [];
let checkedText = null;  // what state.clip says

const isSame = (a, b) => a.replace(/\r\n?/g, "\n") === b.replace(/\r\n?/g, "\n");

function noteUnsaved() {
  const isUnsaved = !isSame(editor.getText(), state.disk.text);
  if (isUnsaved === state.isUnsaved) return;
  state.isUnsaved = isUnsaved;
  emit("unsaved");
}

function takeFindings(findings) {
  state.findings = [...findings, ...warnings];
  emit("findings");
}

/** Whether the lines of state.clip are those of the text as it is now. */
export const isChecked = () => checkedText === editor.getText();

// After the face, which wants all that the machine has.
const chart = keepNewest(async (doc) => {
  await state.face;
  if (doc !== state.doc) return;
  const answer = await ask("api/chart", {doc});
  if (doc !== state.doc) return;
  state.chart = answer;
  warnings = answer.warnings ?? [];
  emit("chart");
  if (state.isGood) takeFindings([]);
});

/** Checks the text now; of several calls at once the last one counts. */
export const checkNow = keepNewest(async () => {
  const text = editor.getText();
  const answer = await ask("api/check", {text});
  state.isGood = answer.good;
  if (!answer.good) {
    warnings = [];
    takeFindings(answer.findings);
    return;
  }
  takeFindings(answer.findings);
  checkedText = text;
  state.doc = answer.doc;
  state.clip = answer.clip;
  setOwnExpressions(answer.clip.expressions ?? []);
  emit("clip");
  chart(answer.doc);
});

const checkSoon = debounce(checkNow, kTyping_ms);

/** Asks about the last good text; checks it again where the server has forgotten it. */
export async function askOfDocument(path, body) {
  try {
    return await ask(path, {...body, doc: state.doc});
  } catch (error) {
    if (!error.isForgotten) throw error;
    await checkNow();
    return ask(path, {...body, doc: state.doc});
  }
}

let edits = Promise.resolve(true);

/**
 * One edit of the text, after those asked for before it: `request` as api/edit has it, or several, of which the first
 * that can be done is. Edits with the same `origin` that begins with * are undone together. Whether it was done; what
 * hinders it is told in the top bar.
 */
export function edit(request, origin = "edit") {
  edits = edits.then(() => editNow([request].flat(), origin));
  return edits;
}

async function askForEdit(requests, text) {
  for (const [i, request] of requests.entries()) {
    try {
      return await ask("api/edit", {...request, text});
    } catch (error) {
      if (error.status !== 400 || i + 1 === requests.length) throw error;
    }
  }
}

async function editNow(requests, origin) {
  try {
    for (let i = 0; i < kMostTries; ++i) {
      const text = editor.getText();
      const answer = await askForEdit(requests, text);
      if (editor.getText() !== text) continue;
      editor.replace(answer.text, origin);
      checkNow();
      return true;
    }
    say("The text changed meanwhile; try again", true);
  } catch (error) {
    say(error.message, true);
  }
  return false;
}

/** Writes the text to the disk. Whether it is there. `hash`: of what it may replace. */
export async function save(hash = state.disk.hash) {
  if (state.session.read_only) {
    say("Read only: mien live was started with --read-only", true);
    return false;
  }
  const text = editor.getText();
  try {
    const answer = await ask("api/save", {text, hash});
    takeDisk({text, hash: answer.hash, version: Math.max(answer.version ?? 0, state.disk.version)});
    closeNotice();
    say("Saved");
    return true;
  } catch (error) {
    if (error.status === 409) {
      offerChoice(error.body.text, error.body.hash);
    } else {
      say(error.message, true);
    }
    return false;
  }
}

function takeDisk(disk) {
  state.disk = {...state.disk, ...disk};
  noteUnsaved();
}

function loadTheirs(text, hash) {
  editor.load(text);
  takeDisk({text, hash});
  closeNotice();
  checkNow();
}

// Until one is chosen the page knows the disk's text as it was: a save is refused and asked about again.
function offerChoice(text, hash) {
  askAboutDisk({
    mine: editor.getText(), theirs: text,
    load: () => loadTheirs(text, hash),
    keep: () => save(hash),
    isReadOnly: state.session.read_only,
  });
}

function hearDisk(answer) {
  const isNews = answer.version !== state.disk.version || (answer.hash ?? "") !== state.disk.hash;
  state.disk.version = answer.version;
  if (!isNews) return;
  if (answer.exists === false) {
    if (state.disk.hash) say("The file is gone from the disk; saving writes it again", true);
    state.disk.hash = answer.hash ?? "";
    state.disk.text = "";
    noteUnsaved();
  } else if (answer.hash === state.disk.hash) {
    checkNow();  // a file that it includes
  } else if (isSame(answer.text, editor.getText())) {
    takeDisk({text: answer.text, hash: answer.hash});
    closeNotice();
  } else if (!state.isUnsaved) {
    loadTheirs(answer.text, answer.hash);
    say("Loaded again: the file changed on disk");
  } else {
    offerChoice(answer.text, answer.hash);
  }
}

const sleep = (wait_ms) => new Promise((done) => setTimeout(done, wait_ms));

// A page that nobody sees keeps no connection: browsers have few.
const untilSeen = () => document.hidden
  ? new Promise((done) => document.addEventListener("visibilitychange", done, {once: true}))
  : Promise.resolve();

async function watchDisk() {
  for (;;) {
    await untilSeen();
    const stop = new AbortController();
    const leave = () => document.hidden && stop.abort();
    document.addEventListener("visibilitychange", leave);
    try {
      // A server that was lost is asked for an answer at once.
      hearDisk(await get(`api/disk?version=${reach.isThere ? state.disk.version : 0}`, stop.signal));
    } catch (error) {
      if (error.name !== "AbortError") await sleep(kRetry_ms);
    } finally {
      document.removeEventListener("visibilitychange", leave);
    }
  }
}

/** Puts the session's text into the editor and keeps both in step. */
export function startDocument(theEditor) {
  editor = theEditor;
  const {text, hash, disk} = state.session;
  state.disk = {text, hash, version: disk};
  editor.load(text, true);
  checkNow();
  followText();
  watchDisk();
}

function followText() {
  editor.cm.on("change", (cm, change) => {
    noteUnsaved();
    if (!kOwnChanges.test(change.origin ?? "")) checkSoon();
  });
  window.addEventListener("beforeunload", (event) => {
    if (!state.isUnsaved || state.session.read_only) return;
    event.preventDefault();
    event.returnValue = "";
  });
}

reach.forgot = (doc) => {
  if (doc === state.doc) checkNow();
};

reach.changed = (isThere, message) => {
  const line = document.getElementById("connection");
  line.textContent = message;
  line.hidden = isThere;
  document.body.classList.toggle("lost", !isThere);
  if (isThere && editor) checkNow();
};
