// Sizes of the parts of the page, its tabs and its light.
import {find, recall, remember} from "./elements.js";

const kStep_px = 16;
const kSizes = {  // each splitter's size in pixels: which way it grows, and between what
  split_text: {name: "text", axis: "x", sign: 1, least: 240, without: () => Math.round(window.innerWidth * 0.36), most: () => window.innerWidth - 520},
  split_side: {name: "side", axis: "x", sign: -1, least: 240, without: () => (window.innerWidth > 1600 ? 380 : 340), most: () => window.innerWidth * 0.5},
  split_timeline: {name: "timeline", axis: "y", sign: -1, least: 90, without: () => Math.round(Math.min(400, window.innerHeight * 0.38)), most: () => window.innerHeight - 220},
};

function startSplit(id, changed) {
  const split = find(id), about = kSizes[id];
  let size = recall(about.name, null);
  const set = (value, isKept = true) => {
    size = isKept ? value : null;
    const now = Math.round(Math.max(about.least, Math.min(about.most(), value ?? about.without())));
    document.documentElement.style.setProperty(`--${about.name}_size`, `${now}px`);
    split.setAttribute("aria-valuenow", now);
    split.setAttribute("aria-valuemin", about.least);
    split.setAttribute("aria-valuemax", Math.round(about.most()));
    changed();
    return now;
  };
  const keep = (value) => remember(about.name, set(value));
  const read = () => Number(split.getAttribute("aria-valuenow"));
  let begin_px = 0, begin = 0;
  const place = (event) => (about.axis === "x" ? event.clientX : event.clientY);
  split.addEventListener("pointerdown", (event) => {
    split.setPointerCapture(event.pointerId);
    begin_px = place(event);
    begin = read();
    event.preventDefault();
  });
  split.addEventListener("pointermove", (event) => {
    if (split.hasPointerCapture(event.pointerId)) keep(begin + about.sign * (place(event) - begin_px));
  });
  split.addEventListener("dblclick", () => {
    remember(about.name, null);
    set(null, false);
  });
  split.addEventListener("keydown", (event) => {
    const ways = about.axis === "x" ? {ArrowLeft: -1, ArrowRight: 1} : {ArrowUp: -1, ArrowDown: 1};
    const way = ways[event.key];
    if (!way) return;
    event.preventDefault();
    event.stopPropagation();
    keep(read() + about.sign * way * kStep_px);
  });
  window.addEventListener("resize", () => set(size, size !== null));
  set(size, size !== null);
}

/** Splitters that are dragged, or moved with the arrows; `changed` is called at each new size. */
export function startSplits(changed) {
  for (const id of Object.keys(kSizes)) startSplit(id, changed);
}

/** Tabs of the panel: arrows go from one to the next. */
export function startTabs() {
  const tabs = [...document.querySelectorAll('#tabs [role="tab"]')];
  const choose = (tab) => {
    for (const one of tabs) {
      const isChosen = one === tab;
      one.setAttribute("aria-selected", String(isChosen));
      one.tabIndex = isChosen ? 0 : -1;
      find(one.getAttribute("aria-controls")).hidden = !isChosen;
    }
    remember("tab", tab.id);
  };
  tabs.forEach((tab, i) => {
    tab.addEventListener("click", () => choose(tab));
    tab.addEventListener("keydown", (event) => {
      const way = {ArrowLeft: -1, ArrowRight: 1}[event.key];
      if (!way) return;
      event.preventDefault();
      event.stopPropagation();
      const next = tabs[(i + way + tabs.length) % tabs.length];
      choose(next);
      next.focus();
    });
  });
  choose(find(recall("tab", "tab_pose")) ?? tabs[0]);
}

const isDark = window.matchMedia("(prefers-color-scheme: dark)");

function applyTheme() {
  document.documentElement.dataset.theme = recall("theme", null) ?? (isDark.matches ? "dark" : "light");
}

/** Light or dark as the system has it, unless the button says otherwise. */
export function startTheme(changed) {
  applyTheme();
  isDark.addEventListener("change", () => {
    applyTheme();
    changed();
  });
  find("theme").addEventListener("click", () => {
    const next = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
    remember("theme", next === (isDark.matches ? "dark" : "light") ? null : next);
    applyTheme();
    changed();
  });
}

const kParts = [  // of the page, each with what has the focus first
  {id: "editor"}, {id: "view", first: "canvas[tabindex], button, [tabindex]"},
  {id: "side", first: '[role="tab"][aria-selected="true"]'}, {id: "timeline", first: ".ruler_lane"}];

/** To the next part of the page. */
export function focusNextPart(way, editor) {
  const here = kParts.findIndex(({id}) => find(id).contains(document.activeElement));
  const next = kParts[(here + way + kParts.length) % kParts.length];
  if (next.id === "editor") return editor.cm.focus();
  const part = find(next.id);
  part.tabIndex = -1;
  (part.querySelector(next.first) ?? part).focus();
}
