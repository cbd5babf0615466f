// The keyboard: what each key does, and the list of them behind "?".
import {find, isTyping, make, makeButton} from "./elements.js";
import {countFrames, goToFrame, stepFrame, stepKey, toggleLoop, togglePlay} from "./player.js";

const kList = [
  ["Anywhere", [
    ["Ctrl S", "save"], ["F8", "play or stop"], ["F6, Shift F6", "next or last part of the page"], ["F4, Shift F4", "next or last mistake"],
    ["Esc", "back to the clip from a face posed by hand"], ["?", "this list"]]],
  ["Timeline, outside of the text and of fields", [
    ["Space", "play or stop"], ["← →", "frame before, after"], ["Page Up, Page Down", "key before, after"], ["Home, End", "start, end"],
    ["L", "loop"], ["+ − 0", "closer, further, the whole clip"], ["K", "write the pose as a key here"]]],
  ["On a key or a cue", [
    ["← → ↑ ↓", "the next one"], ["Alt ← →", "moves it by a frame"], ["Alt Shift ← →", "moves when a cue goes"], ["Enter", "to its line"], ["Esc", "lets go of a drag"]]],
  ["Text", [
    ["Ctrl Space", "words that may stand here"], ["Ctrl K", "what the word means"], ["Ctrl /", "comment"], ["Ctrl F, Ctrl G", "find, find next"], ["Alt G", "go to a line"],
    ["Ctrl Z, Ctrl Y", "undo, do again"], ["Ctrl M", "Tab leaves the text, or writes spaces again"]]],
  ["Sliders", [["Double-click, Delete", "back to 0"], ["↑ ↓, with Shift", "by 0.01, by 0.1, in the number"]]],
];

/** Shows the list. */
export function showShortcuts() {
  const dialog = find("shortcuts");
  if (dialog.open) return;
  dialog.replaceChildren(make("h2", {id: "shortcuts_title"}, "Keyboard"), make("div", {className: "columns"}, ...kList.map(([title, keys]) =>
    make("section", {}, make("h3", {}, title), make("dl", {}, ...keys.flatMap(([key, does]) => [make("dt", {}, key), make("dd", {}, does)]))))),
    make("p", {className: "buttons"}, makeButton("Close", () => dialog.close(), {autofocus: true})));
  dialog.showModal();
}

/** Hears the keyboard. `actions`: save, dropPose, writeKey, nextMistake(way), nextPart(way), timeline. */
export function startShortcuts(actions) {
  const everywhere = {
    F8: togglePlay,
    F6: (event) => actions.nextPart(event.shiftKey ? -1 : 1),
    F4: (event) => actions.nextMistake(event.shiftKey ? -1 : 1),
  };
  const outside = {
    " ": togglePlay,
    ArrowLeft: () => stepFrame(-1), ArrowRight: () => stepFrame(1),
    PageUp: () => stepKey(-1), PageDown: () => stepKey(1),
    Home: () => goToFrame(0), End: () => goToFrame(countFrames() - 1),
    l: toggleLoop, L: toggleLoop, k: actions.writeKey, K: actions.writeKey,
    "+": () => actions.timeline.zoom(1.3), "=": () => actions.timeline.zoom(1.3), "-": () => actions.timeline.zoom(1 / 1.3), "0": () => actions.timeline.fit(),
    Escape: actions.dropPose, "?": showShortcuts,
  };
  window.addEventListener("keydown", (event) => {
    if (event.defaultPrevented) return;
    if ((event.ctrlKey || event.metaKey) && !event.altKey && event.key.toLowerCase() === "s") {
      event.preventDefault();
      actions.save();
      return;
    }
    let action = event.ctrlKey || event.metaKey || event.altKey ? null : everywhere[event.key];
    if (!action && !event.ctrlKey && !event.metaKey && !event.altKey && !isTyping(event.target)) action = outside[event.key];
    if (event.key === " " && event.target.closest?.("button, summary, a, video")) action = null;
    if (event.target.closest?.("video, .scroll, pre") && /^(Page|Home|End|Arrow)/.test(event.key)) action = null;
    if (!action) return;
    event.preventDefault();
    action(event);
  });
}
