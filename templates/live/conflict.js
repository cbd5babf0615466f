// When the file on disk is not the one that was read: what to do, and which lines differ.
import {find, make, makeButton} from "./elements.js";
import {diffLines} from "./diff.js";

const kAround = 2;  // equal lines shown beside those that differ

/** Takes the bar away. */
export function closeNotice() {
  find("notice").hidden = true;
}

/** A bar with the choice: {mine, theirs} are texts, `load` and `keep` what to do. */
export function askAboutDisk({mine, theirs, load, keep, isReadOnly}) {
  find("notice").replaceChildren(
    make("span", {}, "The file changed on disk, and here are unsaved edits."),
    makeButton("Load theirs", load, {id: "load_theirs", title: "Ctrl-Z brings your edits back"}),
    isReadOnly ? null : makeButton("Keep mine and overwrite", keep, {id: "keep_mine"}),
    makeButton("Show which lines differ", () => showDifference(mine, theirs), {id: "show_difference", className: "quiet"}),
    makeButton("Not now", closeNotice, {id: "not_now", className: "quiet"}));
  find("notice").hidden = false;
}

function makeLine(kind, mine, theirs, text) {
  const sign = {same: " ", mine: "+", theirs: "-"}[kind];
  return make("tr", {className: `line_${kind}`}, make("td", {className: "number"}, theirs), make("td", {className: "number"}, mine),
              make("td", {className: "sign"}, sign), make("td", {}, text));
}

/** A window with the lines of both texts that differ. */
export function showDifference(mine, theirs) {
  const lines = diffLines(theirs.split(/\r?\n/), mine.split(/\r?\n/));
  const isNear = lines.map((line, i) => lines.slice(Math.max(0, i - kAround), i + kAround + 1).some((one) => one.kind !== "same"));
  const rows = [];
  lines.forEach((line, i) => {
    if (!isNear[i]) return;
    if (i > 0 && !isNear[i - 1]) rows.push(make("tr", {className: "line_gap"}, make("td", {colSpan: 4})));
    rows.push(makeLine(line.kind, line.mine ?? "", line.theirs ?? "", line.text));
  });
  const dialog = find("difference");
  dialog.replaceChildren(
    make("h2", {id: "difference_title"}, "Lines that differ"),
    make("p", {className: "dim"}, "− on disk, + here. The numbers are the lines on disk and here."),
    make("div", {className: "scroll", tabIndex: 0}, make("table", {className: "difference"}, make("tbody", {}, ...rows))),
    make("p", {className: "buttons"}, makeButton("Close", () => dialog.close(), {autofocus: true})));
  dialog.showModal();
}
