// The panel of the pose: a slider for each move of the nine areas.
import {findActor, on, state} from "./state.js";
import {find, make, makeButton, recall, remember} from "./elements.js";
import {makePicker, makeSlider} from "./controls.js";
import {keepNewest} from "./newest.js";
import {findWord} from "./yaml_path.js";
import {askExpression, askPose, dropPose, setPose, writeExpression, writeKey} from "./posing.js";

const sliders = new Map();        // "brow.left.up" to its slider
const unlinked = new Set(recall("unlinked", []));
let values = {};
let editor = null;
let expression = null;            // the one that was picked last
let strength = null;

function takeValues(newValues) {
  values = newValues;
  for (const [name, slider] of sliders) {
    const {area, move} = slider;
    const value = values[area]?.[move];
    if (value !== undefined && !slider.isBusy()) slider.set(value);
  }
}

function moveSlider(area, key, move, value) {
  const keys = area.left && !unlinked.has(area.key) ? [area.left, area.right] : [key];
  const next = structuredClone(values);
  for (const one of keys) {
    next[one] = {...next[one], [move]: value};
    if (one !== key) sliders.get(`${one}.${move}`).set(value);
  }
  values = next;
  setPose(next);
}

function makeMoveSlider(area, key, move) {
  const name = `${key}.${move.move}`;
  const slider = makeSlider({label: name.replaceAll(".", " "), name, low: move.low, high: move.high, title: `${move.meaning}\nDouble-click: 0`,
                             data: {move: name}, onInput: (value) => moveSlider(area, key, move.move, value)});
  slider.area = key;
  slider.move = move.move;
  sliders.set(name, slider);
  return slider.element;
}

function makeLink(area) {
  const button = makeButton("linked", () => {
    if (!unlinked.delete(area.key)) unlinked.add(area.key);
    remember("unlinked", [...unlinked]);
    show();
  }, {className: "link", title: "Whether left and right move together", data: {link: area.key}});
  const show = () => {
    const isLinked = !unlinked.has(area.key);
    button.setAttribute("aria-pressed", String(isLinked));
    button.setAttribute("aria-label", `${area.key}: left and right linked`);
    button.textContent = isLinked ? "linked" : "apart";
  };
  show();
  return button;
}

// The character's right stands at the left, as in the picture.
function makeArea(area) {
  const rows = area.moves.map((move) => make("div", {className: "move"}, make("span", {className: "caption", title: move.meaning}, move.move),
    ...(area.left ? [makeMoveSlider(area, area.right, move), makeMoveSlider(area, area.left, move)] : [makeMoveSlider(area, area.key, move)])));
  return make("fieldset", {className: `area ${area.left ? "sided" : "single"}`, data: {area: area.key}},
    make("legend", {className: "unseen"}, area.key),
    make("div", {className: "area_head", "aria-hidden": "false"}, make("b", {}, area.key), area.left ? makeLink(area) : null,
         area.left ? make("span", {className: "side"}, "right") : null, area.left ? make("span", {className: "side"}, "left") : null),
    ...rows);
}

function findCursorExpression(names) {
  const at = editor.cm.getCursor();
  const lines = editor.cm.getValue().split("\n");
  const word = findWord(lines, at.line, at.ch)?.word;
  if (word && names.has(word)) return word;
  const named = /\bexpress:\s*([A-Za-z][\w/-]*)/.exec(lines[at.line]) ?? /^ {2}([A-Za-z][\w-]*):/.exec(lines[at.line]);
  return named && names.has(named[1]) ? named[1] : null;
}

const plainFirst = (words) => [...words.filter((word) => !word.includes("/")), ...words.filter((word) => word.includes("/"))];

function listExpressions() {
  const own = state.clip?.expressions ?? [];
  const all = [...own.map((word) => ({word, meaning: "of this file"})),
               ...plainFirst(state.language.expressions.filter((word) => !own.includes(word))).map((word) => ({word, meaning: ""}))];
  const first = findCursorExpression(new Set(all.map(({word}) => word)));
  if (!first) return all;
  return [{word: first, meaning: "at the cursor"}, ...all.filter(({word}) => word !== first)];
}

const loadExpression = keepNewest(async () => {
  if (!expression) return;
  const amount = strength.get();
  const found = await askExpression(expression, amount);
  takeValues(found);
  setPose(found, amount === 1 ? expression : "");
});

const follow = keepNewest(async () => {
  if (state.pose || !state.doc) return;
  const {frame, doc} = state;
  const found = await askPose();
  if (!state.pose && state.frame === frame && state.doc === doc) takeValues(found);
});

// While it plays the chart is near enough.
function followChart() {
  const actor = findActor()?.name ?? "";
  const next = {};
  for (const area of state.language.areas)
    for (const key of area.left ? [area.left, area.right] : [area.key]) {
      const row = state.chart.rows.find((one) => one.actor === actor && (one.name === key || one.name === area.key));
      if (row) next[key] = Object.fromEntries(row.moves.map((move, i) => [move, row.values[i][state.frame] ?? 0]));
    }
  takeValues(next);
}

function showPosing() {
  const isPosing = state.pose !== null;
  find("posing").hidden = !isPosing;
  const what = !isPosing ? "" : state.pose.name ? `Posed: ${state.pose.name}` : "Posed by hand";
  if (find("posing_what").textContent !== what) find("posing_what").textContent = what;  // told once, not with each move
  find("pose_back").disabled = !isPosing;
  if (!isPosing) follow();
}

function makeNameForm() {
  const input = make("input", {type: "text", id: "expression_name", placeholder: "name", autocomplete: "off", "aria-label": "Name of the expression",
                               pattern: "[A-Za-z][A-Za-z0-9_\\-]{0,63}", title: "Letters, digits, - and _", required: true});
  const form = make("form", {id: "name_form", className: "name_form", hidden: true}, input, make("button", {type: "submit"}, "Write"),
                    makeButton("Cancel", () => { form.hidden = true; find("write_expression").focus(); }, {className: "quiet"}));
  form.addEventListener("submit", async (event) => {
    event.preventDefault();
    if (await writeExpression(input.value, values)) {
      form.hidden = true;
      find("write_expression").focus();
    }
  });
  form.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    form.hidden = true;
    find("write_expression").focus();
  });
  return form;
}

function makeActions() {
  const form = makeNameForm();
  return make("div", {className: "actions"}, form, make("div", {className: "buttons"},
    makeButton("Write as key here", () => writeKey(values), {id: "write_key", title: "A key in the clip at this frame (K)"}),
    makeButton("Write as expression…", () => { form.hidden = false; find("expression_name").focus(); }, {id: "write_expression"}),
    makeButton("Back to the clip", dropPose, {id: "pose_back", disabled: true, title: "Esc"})));
}

/** Writes what the sliders say as a key at this frame. */
export const writeKeyHere = () => writeKey(values);

/** Builds the panel in `element`. */
export function startPose(element, theEditor) {
  editor = theEditor;
  const picker = makePicker({label: "Expression", name: "expression", placeholder: "Expression…", list: listExpressions, onPick: (name) => {
    expression = name;
    strength.range.disabled = strength.number.disabled = false;
    loadExpression();
  }});
  strength = makeSlider({label: "Strength of the expression", name: "strength", low: 0, high: 1, reset: 1, title: "Strength", onInput: loadExpression});
  strength.set(1);
  strength.range.disabled = strength.number.disabled = true;  // of nothing, until one is picked
  element.append(
    make("div", {className: "scroll"},
         make("div", {className: "pick"}, picker.element, strength.element),
         ...state.language.areas.map(makeArea)),
    makeActions());
  find("posing_back").addEventListener("click", dropPose);
  on("pose", showPosing);
  on("clip", follow);
  on("actor", () => state.pose ? dropPose() : follow());
  on("playing", follow);
  on("frame", () => {
    if (state.pose || element.hidden) return;
    if (state.isPlaying) followChart();
    else follow();
  });
}
