// What the page knows, and who wants to hear of a change.

/** All that more than one part of the page needs. */
export const state = {
  session: null,    // api/session
  language: null,   // api/language
  disk: {text: "", hash: "", version: 0},  // the file as the page last saw it on disk
  isUnsaved: false,
  doc: "",          // the key of the last text without mistakes
  clip: null,       // what it says
  chart: {rows: [], held: []},
  face: null,       // a promise: the face of `clip` is shown, or is not to be
  isGood: true,     // the text as it is now has no mistakes
  findings: [],     // mistakes of the text, or warnings
  frame: 0,
  isPlaying: false,
  isLoop: true,
  actor: "",        // whose pose and head the panels show
  pose: null,       // {actor, values, name?} while a face is posed by hand
  cursorLine: 0,    // from 1
};

const listeners = new Map();

/** Calls `listener` at each `emit(event)`: clip chart findings frame playing actor pose cursor unsaved text. */
export function on(event, listener) {
  if (!listeners.has(event)) listeners.set(event, []);
  listeners.get(event).push(listener);
}

/** The same, before all who listen already. */
export function onFirst(event, listener) {
  listeners.set(event, [listener, ...(listeners.get(event) ?? [])]);
}

/** Tells all who listen. */
export function emit(event, detail) {
  for (const listener of listeners.get(event) ?? []) listener(detail);
}

let messageTimer = 0;

/** One calm line in the top bar; it goes by itself. */
export function say(message, isTrouble = false) {
  const element = document.getElementById("message");
  element.textContent = message;
  element.title = message;
  element.classList.toggle("trouble", isTrouble);
  clearTimeout(messageTimer);
  if (message) messageTimer = setTimeout(() => say(""), isTrouble ? 12000 : 5000);
}

/** The name of the chosen actor, or the only one's. */
export function findActor() {
  const actors = state.clip?.actors ?? [];
  return actors.find((actor) => actor.name === state.actor) ?? actors[0] ?? null;
}
