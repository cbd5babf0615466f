// The panel of the head: each control is one value of the file.
import {findActor, on, state} from "./state.js";
import {make} from "./elements.js";
import {makeMix, makeReset, makeSlider} from "./controls.js";
import {keepNewest} from "./newest.js";
import {edit} from "./document.js";
import {listKeys, listValues} from "./words.js";

const kUnsaid = "#a06055";   // where the file gives no colour and none is known
const kGesture_ms = 1200;  // changes of one value nearer than this are undone together

const controls = new Map();  // "features.nose_length" to {set(value), isBusy(), reset: element}
const writers = new Map();
let gesture = 0, touched_ms = 0;

/** Where the chosen actor's head stands in the file. */
function findHeadPath() {
  const actor = findActor();
  return actor?.name ? ["actors", actor.name, "head"] : ["head"];
}

function findOrigin(path) {
  const now_ms = performance.now();
  if (now_ms - touched_ms > kGesture_ms) ++gesture;
  touched_ms = now_ms;
  return `*${path.join(".")} ${gesture}`;
}

function showNumber(value) {
  return Number(value.toFixed(2)).toString();
}

// As YAML's flow style has it.
function showMix(value) {
  if (typeof value === "string") return value;
  const pairs = Object.entries(value);
  return pairs.length === 1 ? pairs[0][0] : `{${pairs.map(([word, weight]) => `${word}: ${showNumber(weight)}`).join(", ")}}`;
}

function write(name, value) {
  const path = [...findHeadPath(), ...name.split(".")];
  const key = path.join(".");
  if (!writers.has(key)) writers.set(key, keepNewest((request, origin) => edit(request, origin)));
  writers.get(key)({do: "set", path, value}, findOrigin(path));
}

function remove(name) {
  edit({do: "remove", path: [...findHeadPath(), ...name.split(".")]});
}

function makeLine(name, label, meaning, control) {
  const reset = makeReset(label, () => remove(name));
  controls.set(name, {...control, reset, name});
  return make("div", {className: "line", data: {line: name}}, make("span", {className: "caption", title: meaning}, label.replaceAll("_", " ")), control.element, reset);
}

function makeNumber(name, label, meaning, low, high) {
  return makeLine(name, label, meaning, makeSlider({label, name, low, high, title: meaning, data: {path: name},
                                                    onInput: (value) => write(name, showNumber(value))}));
}

function makeWords(name, label, meaning) {
  const select = make("select", {"aria-label": label, data: {name, path: name}},
                      ...listValues(["head", ...name.split(".")]).map(({word, meaning: about}) => make("option", {value: word, title: about}, word)));
  select.addEventListener("change", () => write(name, select.value));
  return makeLine(name, label, meaning, {element: select, set: (value) => { select.value = value; }, isBusy: () => false});
}

function makeMixLine(name, label, meaning) {
  const words = listValues(["head", name]);
  return makeLine(name, label, meaning, makeMix({label, name, words, onInput: (value) => write(name, showMix(value))}));
}

// A colour, and the names that stand for one.
function makeColour(name, label, meaning) {
  const colour = make("input", {type: "color", "aria-label": label, data: {name, path: name}});
  const names = listValues(["head", ...name.split(".")]);
  const select = names.length ? make("select", {"aria-label": `${label} by name`}, make("option", {value: ""}, "by name…"),
                                     ...names.map(({word, meaning: about}) => make("option", {value: word, title: about}, word))) : null;
  let touched = -Infinity;
  colour.addEventListener("input", () => {
    touched = performance.now();
    write(name, `"${colour.value}"`);
  });
  select?.addEventListener("change", () => {
    if (select.value) write(name, select.value);
    select.value = "";
  });
  return makeLine(name, label, meaning, {element: make("div", {className: "colour"}, colour, select),
    set: (value) => {
      colour.value = value ?? kUnsaid;
      colour.classList.toggle("unsaid", value === undefined);
    }, isBusy: () => performance.now() - touched < 700});
}

function makeGroup(title, ...lines) {
  return make("fieldset", {className: "group"}, make("legend", {}, title), ...lines);
}

const makers = {skin: makeColour, lips: makeColour, iris: makeColour, brow: makeColour, hair: makeColour, beard: makeWords};

const kOnlyWritten = ["texture"];  // a file's name: it has its place in the text

function makeLook({word, meaning}) {
  const name = `look.${word}`;
  return makers[word] ? makers[word](name, word, meaning) : makeNumber(name, word, meaning, 0, 1);
}

function findValue(head, name) {
  const [first, second] = name.split(".");
  if (second === undefined) return head[first];
  return head[first]?.[second] ?? (first === "features" ? 0 : undefined);  // a colour may be left to the skin
}

function show() {
  const head = findActor()?.head_values;
  if (!head) return;
  const said = new Set(Array.isArray(head.said) ? head.said : []);
  for (const [name, control] of controls) {
    const value = findValue(head, name);
    if (!control.isBusy()) control.set(value);
    const isSaid = said.has(name);
    control.reset.disabled = !isSaid;
    control.reset.parentElement.classList.toggle("said", isSaid);
  }
}

/** Builds the panel in `element`. */
export function startHead(element) {
  const meanings = Object.fromEntries(listKeys(["head"]).map(({word, meaning}) => [word, meaning]));
  element.append(make("div", {className: "scroll"},
    makeGroup("Head", ...["age", "skull", "design"].map((word) => makeMixLine(word, word, meanings[word])),
              makeNumber("character", "character", "female (-1) to male (1)", -1, 1), makeWords("hair", "hair", meanings.hair)),
    makeGroup("Look", ...listKeys(["head", "look"]).filter(({word}) => !kOnlyWritten.includes(word)).map(makeLook)),
    makeGroup("Features", ...listKeys(["head", "features"]).map(({word, meaning}) =>
      makeNumber(`features.${word}`, word, `1: ${meaning}`, -1, 1)))));
  on("clip", show);
  on("actor", show);
}
