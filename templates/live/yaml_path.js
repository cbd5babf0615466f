// Where in a YAML text the cursor stands: the keys above it. Tolerant, for text that is half typed.

const kKey = /^("(?:[^"\\]|\\.)*"|'(?:[^']|'')*'|[^\s#,[\]{}&*!|>'"%@`-][^:#{}[\],]*?|-[^\s:#{}[\],][^:#{}[\],]*?)\s*:(?=\s|$)/;

const strip = (word) => word.trim().replace(/^(["'])(.*)\1$/, "$2");

/** Reads a text and keeps the frames (mappings and lists) that are open. */
class Reader {
  frames = [{type: "map", indent: 0, isFlow: false, key: null, keys: new Set(), index: 0}];
  word = "";       // what has been read since the last mark
  quote = "";

  get top() {
    return this.frames.at(-1);
  }

  get isInFlow() {
    return this.top.isFlow;
  }

  push(type, indent, isFlow) {
    this.frames.push({type, indent, isFlow, key: null, keys: new Set(), index: 0});
  }

  setKey(key) {
    this.top.key = strip(key);
    this.top.keys.add(this.top.key);
  }

  // Up to a mapping or a list that may hold something in this column.
  closeTo(indent, isItem) {
    while (this.frames.length > 1 &&
           (this.top.indent > indent || (this.top.indent === indent && this.top.type === "list" && !isItem)))
      this.frames.pop();
  }

  // A line in block style; `isWhole`: nothing is left of it behind `text`.
  readLine(text, isWhole) {
    this.word = "";
    let at = text.search(/\S/);
    if (at < 0) {
      if (!isWhole) this.closeTo(text.length, false);
      return;
    }
    if (text[at] === "#" || /^(---|\.\.\.)/.test(text)) return;
    while (/^-(\s|$)/.test(text.slice(at))) {
      this.closeTo(at, true);
      if (this.top.type === "list" && this.top.indent === at) ++this.top.index;
      else this.push("list", at, false);
      const gap = text.slice(at + 1).search(/\S/);
      if (gap < 0) {
        at = text.length;
        break;
      }
      at += 1 + gap;
    }
    const rest = text.slice(at);
    const key = kKey.exec(rest);
    if (!key) {
      // A word that may become a key, or a value that goes on.
      this.closeTo(at, false);
      this.readFlow(rest);
      return;
    }
    this.closeTo(at, false);
    if (!(this.top.type === "map" && this.top.indent === at)) this.push("map", at, false);
    this.setKey(key[1]);
    this.readFlow(rest.slice(key[0].length));
  }

  // What may hold braces, brackets and quotes.
  readFlow(text) {
    this.word = "";
    for (let i = 0; i < text.length; ++i) {
      const c = text[i];
      if (this.quote) {
        if (c === "\\" && this.quote === '"') this.word += c + (text[++i] ?? "");
        else this.word += c;
        if (c === this.quote) this.quote = "";
        continue;
      }
      if (c === "#" && (i === 0 || /\s/.test(text[i - 1]))) {
        this.isComment = true;
        return;
      }
      if ((c === '"' || c === "'") && !this.word.trim()) {
        this.quote = c;
        this.word += c;
      } else if (c === "{" || (c === "[" && !this.word.trim())) {
        this.push(c === "{" ? "map" : "list", Infinity, true);
        this.word = "";
      } else if ((c === "}" || c === "]") && this.isInFlow) {
        this.frames.pop();
        this.word = "";
      } else if (c === "," && this.isInFlow) {
        if (this.top.type === "list") ++this.top.index;
        else this.top.key = null;
        this.word = "";
      } else if (c === ":" && this.isInFlow && this.top.type === "map" && this.top.key === null &&
                 /\s|^$/.test(text[i + 1] ?? "")) {
        this.setKey(this.word);
        this.word = "";
      } else {
        this.word += c;
      }
    }
  }
}

/**
 * What stands at line `line`, column `ch` (from 0) of `lines`:
 * {path, kind: "key"|"value", word, keys}: the keys and list indices above it; whether a key or a value is being
 * written; what is written of it so far; the keys that its mapping has before it. Null in a comment.
 */
export function findContext(lines, line, ch) {
  const reader = new Reader();
  for (let i = 0; i <= line; ++i) {
    const text = i === line ? lines[i].slice(0, ch) : lines[i];
    reader.isComment = false;
    if (reader.isInFlow || reader.quote) reader.readFlow(text);
    else reader.readLine(text, i < line);
    if (i < line && !reader.quote) reader.word = "";
    if (i === line && (reader.isComment || /^\s*#/.test(text))) return null;
  }
  const context = describe(reader, lines[line].slice(0, ch));
  if (context.indent !== undefined) context.keys = new Set([...context.keys, ...listKeysBelow(lines, line, context.indent)]);
  return context;
}

function describe(reader, text) {
  const word = reader.word.trimStart();
  const top = reader.top;
  let kind = "value";
  if (top.isFlow) {
    kind = top.type === "map" && top.key === null ? "key" : "value";
  } else {
    const start = /^\s*(?:-\s+)*/.exec(text)[0].length;
    const rest = text.slice(start);
    if (!kKey.test(rest) && !/:\s*$/.test(rest)) return describeBlockWord(reader, start, word, /-\s*$/.test(text.slice(0, start)));
  }
  const path = [];
  for (const frame of reader.frames) {
    if (frame.type === "list") path.push(frame.index);
    else if (frame.key !== null && !(frame === top && kind === "key")) path.push(frame.key);
  }
  return {path, kind, word, keys: top.keys};
}

// A lone word of a block: a key of the mapping in its column, or of a new one under the key above.
function describeBlockWord(reader, indent, word, isItem) {
  const frames = [...reader.frames];
  while (frames.length > 1 && !frames.at(-1).isFlow && frames.at(-1).indent > indent) frames.pop();
  const top = frames.at(-1);
  const isOwn = top.type === "map" && top.indent === indent;
  const path = [];
  for (const frame of frames) {
    if (frame.type === "list") path.push(frame.index);
    else if (frame.key !== null && !(frame === top && isOwn)) path.push(frame.key);
  }
  return {path, kind: "key", mayBeValue: !isOwn || isItem, indent, word, keys: isOwn ? top.keys : new Set()};
}

// Keys that a block's mapping has below a line.
function listKeysBelow(lines, line, indent) {
  const keys = [];
  for (let i = line + 1; i < lines.length; ++i) {
    const at = lines[i].search(/\S/);
    if (at < 0 || lines[i][at] === "#" || at > indent) continue;
    const key = at === indent && kKey.exec(lines[i].slice(at));
    if (!key) break;
    keys.push(strip(key[1]));
  }
  return keys;
}

/** As findContext(), of the whole word at that place: {..., start, end} its columns. Null where no word stands. */
export function findWord(lines, line, ch) {
  const text = lines[line] ?? "";
  const isPart = (c) => c !== undefined && /[^\s,{}[\]:"'#]/.test(c);
  let start = ch, end = ch;
  while (isPart(text[start - 1])) --start;
  while (isPart(text[end])) ++end;
  if (start === end) return null;
  const context = findContext(lines, line, end);
  if (!context) return null;
  const isKey = /^["']?\s*:(\s|$)/.test(text.slice(end));
  return {...context, kind: isKey ? "key" : "value", word: text.slice(start, end), start, end};
}
