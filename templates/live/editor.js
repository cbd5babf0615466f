// The text, in CodeMirror.
import {emit, state} from "./state.js";
import {find, make, makeButton} from "./elements.js";
import {complete, explainCursor, startHover} from "./completion.js";

const CodeMirror = window.CodeMirror;
const kFlash_ms = 900;

function indentOrMove(cm) {
  if (cm.somethingSelected()) cm.execCommand("indentMore");
  else cm.execCommand("insertSoftTab");
}

const kKeys = {
  "Tab": indentOrMove,
  "Shift-Tab": "indentLess",
  "Ctrl-Space": complete,
  "Ctrl-/": "toggleComment",
  "Cmd-/": "toggleComment",
  "Ctrl-K": explainCursor,
  "Alt-G": "jumpToLine",
  // As CodeMirror would, but with the keys of every platform.
  "Ctrl-M": (cm) => cm.setOption("extraKeys", cm.getOption("extraKeys") === kKeys ? {...kKeys, "Tab": false, "Shift-Tab": false} : kKeys),
};

function listFindingRange(cm, finding) {
  const line = Math.min(Math.max(finding.line - 1, 0), cm.lastLine());
  const text = cm.getLine(line);
  // The server counts characters, CodeMirror UTF-16 units.
  const start = finding.column > 0 ? [...text].slice(0, finding.column - 1).join("").length : text.search(/\S|$/);
  const word = /^("(?:[^"\\]|\\.)*"|'[^']*'|[^\s,{}[\]:#]+)/.exec(text.slice(start));
  const end = finding.column > 0 ? start + (word ? word[0].length : 1) : text.trimEnd().length;
  return {from: CodeMirror.Pos(line, start), to: CodeMirror.Pos(line, Math.max(end, start + 1))};
}

/** Whether a finding is about the file in the editor, not one that it includes. */
export function isOwn(finding) {
  const file = finding.file, own = state.session?.file ?? "";
  return !file || file === own || own.endsWith(`/${file}`) || file.endsWith(`/${own}`);
}

/** A CodeMirror in `element`, and what the page does with it. */
export class Editor {
  constructor(element) {
    this.newline = "\n";
    this.cm = CodeMirror(element, {
      mode: "yaml", theme: "mien", lineNumbers: true, indentUnit: 2, tabSize: 2, indentWithTabs: false,
      matchBrackets: true, autoCloseBrackets: true, styleActiveLine: true, foldGutter: {rangeFinder: CodeMirror.fold.indent},
      gutters: ["CodeMirror-lint-markers", "CodeMirror-linenumbers", "CodeMirror-foldgutter"],
      lint: {getAnnotations: () => this.annotations, lintOnChange: false, tooltips: "gutter"},
      extraKeys: kKeys, historyEventDelay: 600, cursorScrollMargin: 40, viewportMargin: 60,
      screenReaderLabel: "The file's text", spellcheck: false,
    });
    this.annotations = [];
    const input = this.cm.getInputField();
    input.setAttribute("aria-label", "The file's text. Control and M: Tab leaves the text. F6: next part of the page.");
    startHover(this.cm);
    this.cm.on("change", (cm, change) => emit("text", change));
    this.cm.on("cursorActivity", () => {
      state.cursorLine = this.cm.getCursor().line + 1;
      emit("cursor");
    });
    this.cm.on("inputRead", (cm, change) => {
      if (change.origin === "+input" && /^[\w./]$/.test(change.text[0]) && !cm.state.completionActive) complete(cm);
    });
  }

  /** The text with the file's own line ends. */
  getText() {
    return this.cm.getValue(this.newline);
  }

  /** Another text: as read from disk. The cursor and the scroll stay where they can; `isNew` forgets what could be undone. */
  load(text, isNew = false) {
    this.newline = text.includes("\r\n") ? "\r\n" : "\n";
    if (isNew) {
      this.cm.setValue(text);
      this.cm.clearHistory();
    } else {
      this.replace(text, "load");
    }
  }

  /** The smallest change that makes it `text`. Changes with one `*origin` are undone together. */
  replace(text, origin = "edit") {
    const before = this.cm.getValue(), after = text.replace(/\r\n?/g, "\n");
    if (before === after) return;
    let start = 0;
    const most = Math.min(before.length, after.length);
    while (start < most && before[start] === after[start]) ++start;
    let tail = 0;
    while (tail < most - start && before[before.length - 1 - tail] === after[after.length - 1 - tail]) ++tail;
    const scroll = this.cm.getScrollInfo();
    this.cm.operation(() => {
      this.cm.replaceRange(after.slice(start, after.length - tail), this.cm.posFromIndex(start),
                           this.cm.posFromIndex(before.length - tail), origin);
    });
    this.cm.scrollTo(scroll.left, scroll.top);
  }

  /** The cursor to a place (from 1; column 0: the line's first word), and the line lit up for a moment. */
  goTo(line, column = 0, isFocus = false) {
    if (line < 1) return;
    const row = Math.min(line - 1, this.cm.lastLine());
    const text = this.cm.getLine(row);
    this.cm.setCursor(row, column > 0 ? [...text].slice(0, column - 1).join("").length : text.search(/\S|$/));
    this.cm.scrollIntoView(null, 60);
    const handle = this.cm.addLineClass(row, "wrap", "flash");
    setTimeout(() => this.cm.removeLineClass(handle, "wrap", "flash"), kFlash_ms);
    if (isFocus) this.cm.focus();
  }

  /** Underlines, gutter marks and the list below of state.findings. */
  showFindings() {
    this.cm.operation(() => {
      for (const mark of this.marks ?? []) mark.clear();
      this.marks = [];
      this.annotations = [];
      for (const finding of state.findings.filter(isOwn)) {
        const {from, to} = listFindingRange(this.cm, finding);
        finding.mark = this.cm.markText(from, to, {className: `finding_${finding.kind}`});
        this.marks.push(finding.mark);
        this.annotations.push({from, to: null, message: finding.message, severity: finding.kind});
      }
      this.cm.performLint();
    });
    this.listFindings();
  }

  listFindings() {
    const items = state.findings.map((finding) => {
      const place = finding.line > 0 ? `${finding.line}:${finding.column}` : "file";
      const button = makeButton("", () => this.goToFinding(finding), {className: "problem"});
      button.append(make("span", {className: "kind"}, finding.kind),
                    make("span", {className: "place"}, isOwn(finding) ? place : `${finding.file}:${place}`),
                    make("span", {className: "words"}, finding.message));
      return make("li", {className: finding.kind}, button);
    });
    const isHidden = items.length === 0;
    find("problem_list").replaceChildren(...items);
    if (find("problems").hidden === isHidden) return;
    find("problems").hidden = isHidden;
    this.cm.refresh();
  }

  goToFinding(finding) {
    if (!isOwn(finding)) return;
    const place = finding.mark?.find()?.from;
    if (place) this.goTo(place.line + 1, place.ch + 1, true);
    else this.goTo(finding.line, finding.column, true);
  }

  /** The next (or, with -1, the last) mistake from the cursor on. */
  goToNextFinding(way = 1) {
    const places = state.findings.filter((finding) => finding.mark?.find()).sort((a, b) => CodeMirror.cmpPos(a.mark.find().from, b.mark.find().from));
    if (places.length === 0) return;
    const here = this.cm.getCursor();
    const beyond = places.filter((finding) => Math.sign(CodeMirror.cmpPos(finding.mark.find().from, here)) === way);
    this.goToFinding((way > 0 ? beyond[0] : beyond.at(-1)) ?? (way > 0 ? places[0] : places.at(-1)));
  }
}
