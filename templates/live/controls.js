// Small controls of the panels: a slider with its number, a choice that may be a mix, a list to search.
import {make, makeButton} from "./elements.js";

const kBusy_ms = 700;  // after the last touch a control still belongs to the hand

let serial = 0;

const show = (value) => Number(value.toFixed(2)).toString();

/**
 * A slider and its number. {label, name, low, high, reset, title, onInput(value, isOver)}; `isOver`: the hand has let go.
 * Double-click, or Delete, goes back to `reset`. Gives {element, range, set(value), get(), isBusy()}.
 */
export function makeSlider({label, name, low, high, step = 0.01, reset = 0, title = "", data = {}, onInput}) {
  const range = make("input", {type: "range", min: low, max: high, step, value: reset, title, "aria-label": label, data: {name, ...data}});
  const number = make("input", {type: "text", className: "number", inputMode: "decimal", autocomplete: "off", "aria-label": `${label}, number`, data: {number: name}});
  const element = make("div", {className: "slider"}, range, number);
  let value = reset, touched_ms = -Infinity;
  const draw = () => {
    const part = (x) => (Math.max(low, Math.min(high, x)) - low) / (high - low) * 100;
    const zero = part(0), now = part(value);
    range.style.setProperty("--from", `${Math.min(zero, now)}%`);
    range.style.setProperty("--to", `${Math.max(zero, now)}%`);
    element.classList.toggle("at_rest", Math.abs(value - reset) < 0.005);
  };
  const set = (x) => {
    value = x;
    range.value = x;
    range.setAttribute("aria-valuetext", show(x));
    if (document.activeElement !== number) number.value = show(x);
    draw();
  };
  const change = (x, isOver) => {
    touched_ms = performance.now();
    set(x);
    onInput(x, isOver);
  };
  range.addEventListener("input", () => change(Number(range.value), false));
  range.addEventListener("change", () => change(Number(range.value), true));
  range.addEventListener("dblclick", () => change(reset, true));
  range.addEventListener("keydown", (event) => {
    if (event.key === "Delete" || event.key === "Backspace") change(reset, true);
  });
  const takeNumber = () => {
    const x = Number.parseFloat(number.value.replace(",", "."));
    if (Number.isFinite(x) && show(x) !== show(value)) change(Math.max(low, Math.min(high, x)), true);
    number.value = show(value);
  };
  number.addEventListener("change", takeNumber);
  number.addEventListener("focus", () => number.select());
  number.addEventListener("keydown", (event) => {
    const way = {ArrowUp: 1, ArrowDown: -1}[event.key];
    if (event.key === "Enter") takeNumber();
    if (!way) return;
    event.preventDefault();
    const x = Math.max(low, Math.min(high, value + way * (event.shiftKey ? 10 : 1) * step));
    change(x, false);
    number.value = show(x);
  });
  set(reset);
  return {element, range, number, set, get: () => value, isBusy: () => performance.now() - touched_ms < kBusy_ms};
}

/**
 * A choice of one word or of weights of several. {label, name, words: [{word, meaning}], onInput(value)}: a word or
 * {word: weight}. Gives {element, set(value), isBusy()}.
 */
export function makeMix({label, name, words, onInput}) {
  const kMix = "a mix…";
  const select = make("select", {"aria-label": label, data: {name}},
                      ...words.map(({word, meaning}) => make("option", {value: word, title: meaning}, word)), make("option", {value: kMix}, kMix));
  const sliders = new Map(words.map(({word, meaning}) => [word, makeSlider({
    label: `${label}: ${word}`, name: `${name}.${word}`, low: 0, high: 1, title: meaning, onInput: () => {
      const weights = Object.fromEntries([...sliders].map(([one, slider]) => [one, slider.get()]).filter(([, weight]) => weight > 0.004));
      if (Object.keys(weights).length) onInput(weights);
    }})]));
  const mix = make("div", {className: "mix", hidden: true},
                   ...[...sliders].map(([word, slider]) => make("div", {className: "line"}, make("span", {className: "caption"}, word), slider.element)));
  select.addEventListener("change", () => {
    mix.hidden = select.value !== kMix;
    if (!mix.hidden) return;
    for (const [word, slider] of sliders) slider.set(word === select.value ? 1 : 0);
    onInput(select.value);
  });
  const set = (value) => {
    if (typeof value === "string") {
      if (select.value === kMix && sliders.get(value)?.get() === 1) return;  // a mix that is about to be made
      select.value = value;
      mix.hidden = true;
      for (const [word, slider] of sliders) slider.set(word === value ? 1 : 0);
      return;
    }
    const most = Math.max(1, ...Object.values(value));
    select.value = kMix;
    mix.hidden = false;
    for (const [word, slider] of sliders) if (!slider.isBusy()) slider.set((value[word] ?? 0) / most);
  };
  return {element: make("div", {className: "choice"}, select, mix), set,
          isBusy: () => [...sliders.values()].some((slider) => slider.isBusy())};
}

/**
 * A field that searches a list. {label, name, placeholder, list(): [{word, meaning}], onPick(word)}. Gives {element, input}.
 */
export function makePicker({label, name, placeholder, list, onPick}) {
  const id = `picker_${++serial}`;
  const options = make("ul", {id, role: "listbox", className: "options", hidden: true, "aria-label": label});
  const input = make("input", {type: "search", role: "combobox", placeholder, autocomplete: "off", "aria-label": label, "aria-expanded": "false",
                               "aria-controls": id, "aria-autocomplete": "list", data: {name}});
  let chosen = -1;
  const items = () => [...options.children];
  const shut = () => {
    options.hidden = true;
    input.setAttribute("aria-expanded", "false");
    input.removeAttribute("aria-activedescendant");
    chosen = -1;
  };
  const choose = (i) => {
    chosen = (i + items().length) % items().length;
    items().forEach((item, k) => item.setAttribute("aria-selected", String(k === chosen)));
    items()[chosen].scrollIntoView({block: "nearest"});
    input.setAttribute("aria-activedescendant", items()[chosen].id);
  };
  const pick = (word) => {
    input.value = word;
    shut();
    onPick(word);
  };
  const open = (written) => {
    const low = written.toLowerCase();
    const all = list().filter(({word}) => word.toLowerCase().includes(low));
    const begins = ({word}) => word.toLowerCase().startsWith(low);
    const found = [...all.filter(begins), ...all.filter((one) => !begins(one))];
    options.replaceChildren(...found.map(({word, meaning}, i) => make("li", {id: `${id}_${i}`, role: "option", data: {expression: word},
      on: {pointerdown: (event) => (event.preventDefault(), pick(word))}}, make("span", {}, word), make("span", {className: "dim"}, meaning))));
    options.hidden = found.length === 0;
    input.setAttribute("aria-expanded", String(found.length > 0));
    if (found.length) choose(0);
  };
  input.addEventListener("focus", () => {
    input.select();
    open("");
  });
  input.addEventListener("click", () => options.hidden && open(""));
  input.addEventListener("input", () => open(input.value));
  input.addEventListener("blur", shut);
  input.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && !options.hidden) return event.preventDefault(), event.stopPropagation(), shut();
    const way = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (way) {
      event.preventDefault();
      if (options.hidden) open("");
      else if (items().length) choose(chosen + way);
    } else if (event.key === "Enter" && chosen >= 0) {
      event.preventDefault();
      pick(items()[chosen].dataset.expression);
    }
  });
  return {element: make("div", {className: "picker"}, input, options), input};
}

/** A small button that takes a value of the file away again. */
export function makeReset(label, action) {
  return makeButton("×", action, {className: "reset", "aria-label": `Reset ${label}`, title: `Reset ${label}: take it out of the file`});
}
