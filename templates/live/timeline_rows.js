// What the timeline shows, as plain rows, from what the clip says and does.

const kAtLimit = 0.01;  // nearer to its limit than this a move stands there

// Chart rows of an area: {left, right} of one that has sides (the same row if both do the same), {both} of others.
function findCurves(chartRows, area) {
  const find = (name) => chartRows.find((row) => row.name === name) ?? null;
  if (!area.left) return {both: find(area.key)};
  const both = find(area.key);
  return {left: both ?? find(area.left), right: both ?? find(area.right)};
}

// The spans in which an actor's move stands at the limit that holds it; none if it is another actor's.
function listSpans(held, chart, area, actor, fps) {
  const row = chart.rows.find((one) => one.actor === actor && (one.name === held.area || one.name === area.key));
  const values = row?.values[row.moves.indexOf(held.move)];
  if (!values || (held.actor ?? actor) !== actor) return [];
  const isAtLimit = (value) => value * held.got > 0 && Math.abs(value) > Math.abs(held.got) - kAtLimit;
  const spans = [];
  for (let frame = Math.round(held.from_s * fps); frame < Math.min(Math.round(held.to_s * fps), values.length); ++frame) {
    if (!isAtLimit(values[frame])) continue;
    const last = spans.at(-1);
    if (last && Math.round(last.to_s * fps) === frame) last.to_s = (frame + 1) / fps;
    else spans.push({...held, from_s: frame / fps, to_s: (frame + 1) / fps});
  }
  return spans;
}

function findHeld(chart, area, names, actor, fps) {
  return chart.held.filter((held) => names.includes(held.area)).flatMap((held) => listSpans(held, chart, area, actor, fps));
}

// Overlapping cues go below each other, and what follows a formula or a table below them.
function layCues(cues) {
  const ends = [];
  const rank = (cue) => ["cue", "law", "table", "speech"].indexOf(cue.layer);
  return [...cues].sort((a, b) => rank(a) - rank(b) || a.from_s - b.from_s).map((cue) => {
    let lane = ends.findIndex((end) => end <= cue.from_s + 1e-6);
    if (lane < 0) lane = ends.length;
    ends[lane] = cue.end_s;
    return {...cue, lane};
  });
}

function buildAreaRows(area, chart, actor, openRows, fps) {
  const findHere = (...names) => findHeld(chart, area, names, actor, fps);
  const id = `${actor}:${area.key}`;
  const curves = findCurves(chart.rows.filter((row) => row.actor === actor), area);
  const isOpen = openRows.has(id);
  const range = {low: Math.min(...area.moves.map((move) => move.low)), moves: area.moves};
  if (!area.left)
    return [{id, kind: "area", label: area.key, actor, level: 1, ...range, lines: [curves.both].filter(Boolean),
             held: findHere(area.key)}];
  const isSame = curves.left === curves.right;
  const row = {id, kind: "area", label: area.key, actor, level: 1, isOpen, canOpen: true, ...range,
               lines: isSame ? [curves.left].filter(Boolean) : [curves.right, curves.left].filter(Boolean),
               held: findHere(area.key, area.left, area.right)};
  if (!isOpen) return [row];
  return [row, ...["left", "right"].map((side) => (
    {id: `${id}:${side}`, kind: "area", label: side, actor, level: 2, ...range, lines: [curves[side]].filter(Boolean),
     held: findHere(area.key, area[side])}))];
}

function buildMarksRow(id, kind, label, marks, actor) {
  return marks.length ? [{id, kind, label, actor, level: 1, marks}] : [];
}

function buildActorRows(clip, chart, areas, actor, openRows) {
  const own = (list) => (list ?? []).filter((mark) => (mark.actor ?? "") === actor);
  const cues = layCues(own(clip.cues));
  const head = chart.rows.find((row) => row.actor === actor && row.name === "head");
  const rows = [
    {id: `${actor}:keys`, kind: "keys", label: "keys", actor, level: 1, marks: own(clip.keys)},
    ...(cues.length ? [{id: `${actor}:cues`, kind: "cues", label: "cues", actor, level: 1, marks: cues,
                        lanes: Math.max(...cues.map((cue) => cue.lane)) + 1}] : []),
    ...buildMarksRow(`${actor}:heads`, "keys", "head", own(clip.heads), actor),
    ...buildMarksRow(`${actor}:blinks`, "blinks", "blinks", own(clip.blinks), actor),
    {id: `${actor}:turn`, kind: "turn", label: "turn", actor, level: 1, marks: own(clip.turns), low: -1, held: [],
     moves: [{move: "turn"}, {move: "nod"}, {move: "tilt"}], lines: head ? [head] : []},
  ];
  for (const area of areas) rows.push(...buildAreaRows(area, chart, actor, openRows, clip.fps));
  return rows;
}

/**
 * Rows from the top: {id, kind: "actor"|"keys"|"cues"|"blinks"|"stage"|"turn"|"area", label, actor, level, marks?, lanes?,
 * lines?: chart rows, moves?, low?, held?, canOpen?, isOpen?}. `openRows`: ids of the rows that are open.
 */
export function buildRows(clip, chart, areas, openRows) {
  const rows = [];
  for (const {name} of clip.actors) {
    const isOne = clip.actors.length === 1;
    const id = `actor:${name}`;
    const isShut = openRows.has(id);  // actors begin open
    if (!isOne) rows.push({id, kind: "actor", label: name, actor: name, level: 0, canOpen: true, isOpen: !isShut});
    if (!isOne && isShut) continue;
    rows.push(...buildActorRows(clip, chart, areas, name, openRows));
  }
  rows.push(...buildMarksRow("camera", "stage", "camera", clip.cameras, ""),
            ...buildMarksRow("light", "stage", "light", clip.lights, ""),
            ...buildMarksRow("background", "stage", "background", clip.backgrounds, ""));
  return rows;
}
