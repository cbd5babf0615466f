// Completion as one types, and meanings as one points.
import {state} from "./state.js";
import {find, make} from "./elements.js";
import {findContext, findWord} from "./yaml_path.js";
import {explain, listKeys, listValues} from "./words.js";

const kHover_ms = 250;      // long enough not to flicker as the mouse passes
const kMostMeaning = 90;    // letters beside a word in the list

const CodeMirror = window.CodeMirror;

function listLines(cm) {
  return cm.getValue().split("\n");
}

function shorten(text) {
  return text.length > kMostMeaning ? `${text.slice(0, kMostMeaning - 1)}…` : text;
}

function drawHint(element, data, hint) {
  element.title = hint.meaning;
  element.append(make("span", {className: "hint_word"}, hint.word), make("span", {className: "hint_meaning"}, shorten(hint.meaning)));
}

// Words that begin with what is written first, then those that hold it.
function sift(words, written) {
  const low = written.toLowerCase();
  const rank = ({word}) => {
    const at = word.toLowerCase().indexOf(low);
    return at === 0 ? 0 : at > 0 ? 1 : 2;
  };
  return words.filter((word) => rank(word) < 2).sort((a, b) => rank(a) - rank(b));
}

function buildHint(word, isKey, rest, isFlow) {
  const needsColon = isKey && !/^\s*:/.test(rest);
  const text = !needsColon ? word.word : word.isMapping && isFlow ? `${word.word}: {}` : word.isList && isFlow ? `${word.word}: []` : `${word.word}: `;
  return {text, word: word.word, meaning: word.meaning, render: drawHint, isKey: needsColon, isOpen: /[}\]]$/.test(text)};
}

/** What CodeMirror's show-hint shows at the cursor. */
export function buildHints(cm) {
  const at = cm.getCursor();
  const lines = listLines(cm);
  const context = findContext(lines, at.line, at.ch);
  if (!context) return null;
  const quote = /^["']/.exec(context.word)?.[0] ?? "";
  const written = context.word.slice(quote.length);
  if (/\s/.test(written)) return null;
  const start = at.ch - written.length;
  const rest = lines[at.line].slice(at.ch);
  const tail = /^[^\s,{}[\]:"'#]*/.exec(rest)[0];
  const isFlow = /[{,]\s*$/.test(lines[at.line].slice(0, start));
  let words = [];
  if (context.kind === "key")
    words = sift(listKeys(context.path).filter((key) => !context.keys.has(key.word)), written)
      .map((word) => buildHint(word, true, rest.slice(tail.length), isFlow));
  if (context.kind === "value" || context.mayBeValue)
    words.push(...sift(listValues(context.path), written).map((word) => buildHint(word, false, "", isFlow)));
  if (words.length === 0 || (words.length === 1 && words[0].text === written)) return null;
  const hints = {list: words, from: CodeMirror.Pos(at.line, start), to: CodeMirror.Pos(at.line, at.ch + tail.length)};
  CodeMirror.on(hints, "pick", (picked) => {
    if (picked.isOpen) cm.execCommand("goCharLeft");
    if (picked.isKey) setTimeout(() => complete(cm), 0);
  });
  return hints;
}

/** Opens the list of words. */
export function complete(cm) {
  cm.showHint({hint: buildHints, completeSingle: false, closeCharacters: /[\s,{}[\]:"'#]/, extraKeys: {}});
}

function listFindingsAt(line, ch) {
  return state.findings.filter((finding) => finding.mark && contains(finding.mark.find(), line, ch));
}

function contains(range, line, ch) {
  return range && range.from.line <= line && line <= range.to.line &&
    (line > range.from.line || ch >= range.from.ch) && (line < range.to.line || ch <= range.to.ch);
}

// Paragraphs about a place of the text, or none.
function describePlace(cm, line, ch) {
  const parts = listFindingsAt(line, ch).map((finding) => make("p", {className: `tip_${finding.kind}`}, finding.message));
  const word = findWord(listLines(cm), line, ch);
  const meaning = word && explain(word.kind, word.path, word.word);
  if (meaning) {
    parts.push(make("p", {}, make("b", {}, meaning.title), meaning.of === undefined ? "" : ` of ${meaning.of}`,
                    meaning.meaning ? ` — ${meaning.meaning}` : ""));
    if (meaning.kinds) parts.push(make("p", {className: "dim"}, meaning.kinds));
    if (meaning.without) parts.push(make("p", {className: "dim"}, `without it: ${meaning.without}`));
  }
  return parts;
}

function showTip(cm, line, ch) {
  const parts = describePlace(cm, line, ch);
  const tip = find("tip");
  if (parts.length === 0) {
    tip.hidden = true;
    return false;
  }
  tip.replaceChildren(...parts);
  tip.hidden = false;
  const place = cm.charCoords({line, ch}, "window");
  const box = tip.getBoundingClientRect();
  const isAbove = place.bottom + box.height + 8 > window.innerHeight;
  tip.style.left = `${Math.max(4, Math.min(place.left, window.innerWidth - box.width - 8))}px`;
  tip.style.top = `${isAbove ? Math.max(4, place.top - box.height - 4) : place.bottom + 4}px`;
  return true;
}

/** Shows what the word at the cursor means, and tells it to screen readers. */
export function explainCursor(cm) {
  const at = cm.getCursor();
  const isShown = showTip(cm, at.line, at.ch);
  find("tip_news").textContent = isShown ? find("tip").textContent : "Nothing is known of this word.";
}

/** Meanings and mistakes where the mouse rests. */
export function startHover(cm) {
  const wrapper = cm.getWrapperElement();
  const hide = () => { find("tip").hidden = true; };
  let timer = 0;
  wrapper.addEventListener("mousemove", (event) => {
    clearTimeout(timer);
    hide();
    if (event.buttons || !event.target.closest(".CodeMirror-line")) return;
    timer = setTimeout(() => {
      const at = cm.coordsChar({left: event.clientX, top: event.clientY}, "window");
      const edge = cm.charCoords({line: at.line, ch: cm.getLine(at.line).length}, "window");
      if (event.clientX <= edge.right + 2) showTip(cm, at.line, at.ch);
    }, kHover_ms);
  });
  wrapper.addEventListener("mouseleave", () => {
    clearTimeout(timer);
    hide();
  });
  cm.on("scroll", hide);
  cm.on("change", hide);
  cm.on("cursorActivity", hide);
}
