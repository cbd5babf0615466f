// Which lines of two texts differ: the longest common run of lines, by the plain table.

const kMostCells = 4e6;  // of the table; larger texts are told as one block

/** From `before` to `after`, arrays of lines: [{kind: "same"|"theirs"|"mine", text, theirs?, mine?}], numbers from 1. */
export function diffLines(before, after) {
  let start = 0;
  while (start < before.length && start < after.length && before[start] === after[start]) ++start;
  let tail = 0;
  while (tail < before.length - start && tail < after.length - start &&
         before[before.length - 1 - tail] === after[after.length - 1 - tail]) ++tail;
  const a = before.slice(start, before.length - tail), b = after.slice(start, after.length - tail);
  const lines = before.slice(0, start).map((text, i) => ({kind: "same", text, theirs: i + 1, mine: i + 1}));
  for (const line of diffMiddle(a, b))
    lines.push({...line, theirs: line.theirs && line.theirs + start, mine: line.mine && line.mine + start});
  for (let i = 0; i < tail; ++i)
    lines.push({kind: "same", text: before[before.length - tail + i], theirs: before.length - tail + i + 1, mine: after.length - tail + i + 1});
  return lines;
}

function diffMiddle(a, b) {
  const lines = [];
  let i = 0, j = 0;
  const takeTheirs = () => lines.push({kind: "theirs", text: a[i], theirs: ++i});
  const takeMine = () => lines.push({kind: "mine", text: b[j], mine: ++j});
  if (a.length * b.length <= kMostCells) {
    const width = b.length + 1;
    const longest = new Uint32Array((a.length + 1) * width);
    for (let y = a.length - 1; y >= 0; --y)
      for (let x = b.length - 1; x >= 0; --x)
        longest[y * width + x] = a[y] === b[x] ? longest[(y + 1) * width + x + 1] + 1
                                               : Math.max(longest[(y + 1) * width + x], longest[y * width + x + 1]);
    while (i < a.length && j < b.length) {
      if (a[i] === b[j]) lines.push({kind: "same", text: a[i], theirs: ++i, mine: ++j});
      else if (longest[(i + 1) * width + j] >= longest[i * width + j + 1]) takeTheirs();
      else takeMine();
    }
  }
  while (i < a.length) takeTheirs();
  while (j < b.length) takeMine();
  return lines;
}
