// The timeline's pictures: the ruler with its drawings, and the curves of the areas.

const kSteps_s = [1 / 24, 1 / 12, 0.25, 0.5, 1, 2, 5, 10, 30, 60, 300, 600];
const kLeastLabel_px = 58;   // between two times of the ruler
const kStrip_px = 6;         // height of the strip of drawings
const kBesideMark_px = 9;
const kLeastWord_px = 16;     // less room than this says nothing
const kLeastCell_px = 2.5;   // a drawing narrower than this has no gap beside it

// A clean canvas in CSS pixels.
function begin(canvas, width, height) {
  const scale = window.devicePixelRatio || 1;
  if (canvas.width !== Math.round(width * scale) || canvas.height !== Math.round(height * scale)) {
    canvas.width = Math.round(width * scale);
    canvas.height = Math.round(height * scale);
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
  }
  const context = canvas.getContext("2d");
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}

/** Colours of the page as they are now. */
export function readColours() {
  const style = getComputedStyle(document.documentElement);
  const read = (name) => style.getPropertyValue(`--${name}`).trim();
  return {line: read("line"), faint: read("faint"), text: read("text"), dim: read("dim"), cell: read("cell"),
          held: read("error"), beyond: read("beyond"), curves: [read("curve_1"), read("curve_2"), read("curve_3")]};
}

/** The time between two labels of the ruler. */
export function findStep_s(scale, fps) {
  return kSteps_s.find((step_s) => step_s * fps >= 0.999 && step_s * fps * scale.frame_px >= kLeastLabel_px) ?? 3600;
}

function describeStep(time_s, step_s, fps) {
  const digits = step_s >= 1 ? 0 : step_s >= 0.5 ? 1 : 2;
  return step_s * fps < 6 ? `${Math.round(time_s * fps)}f` : `${time_s.toFixed(digits)}s`;
}

/** The ruler: times, a tick for each second's part, and below a cell for each drawing. */
export function drawRuler(canvas, scale, clip, colours, width, height) {
  const context = begin(canvas, width, height);
  const {fps, frames, drawn} = clip;
  context.fillStyle = colours.beyond;
  context.fillRect(scale.toX(frames), 0, width, height);
  const step_s = findStep_s(scale, fps);
  const first = Math.max(0, Math.floor(scale.toFrame(0) / fps / step_s));
  context.font = "11px system-ui, sans-serif";
  context.textBaseline = "middle";
  const floor = height - kStrip_px - 2;
  for (let i = first; scale.toX(i * step_s * fps) < width; ++i) {
    const x = Math.round(scale.toX(i * step_s * fps)) + 0.5;
    context.strokeStyle = colours.line;
    context.beginPath();
    context.moveTo(x, 3);
    context.lineTo(x, floor);
    context.stroke();
    if (x + kLeastLabel_px / 2 > width) break;
    context.fillStyle = i * step_s * fps < frames ? colours.text : colours.dim;
    context.fillText(describeStep(i * step_s, step_s, fps), x + 4, floor / 2 + 1);
  }
  drawDrawings(context, scale, frames, drawn, colours, width, height - kStrip_px - 1);
}

function drawDrawings(context, scale, frames, drawn, colours, width, top) {
  const begins = Math.max(0, Math.floor(scale.toFrame(0)));
  let start = begins;
  for (let frame = begins + 1; frame <= frames && scale.toX(start) < width; ++frame) {
    if (frame < frames && drawn[frame] === drawn[frame - 1]) continue;
    const x = scale.toX(start), length = scale.toX(frame) - x;
    context.fillStyle = colours.cell;
    context.fillRect(x, top, Math.max(0.75, length > kLeastCell_px ? length - 1 : length * 0.6), kStrip_px - 1);
    start = frame;
  }
}

// Over the lanes: lines at the ruler's times, and what lies beyond the clip's end.
function drawGrid(context, scale, clip, colours, width, height) {
  const step = findStep_s(scale, clip.fps) * clip.fps;
  context.strokeStyle = colours.faint;
  context.lineWidth = 1;
  context.beginPath();
  for (let i = Math.max(0, Math.floor(scale.toFrame(0) / step)); scale.toX(i * step) < width; ++i) {
    const x = Math.round(scale.toX(i * step)) + 0.5;
    context.moveTo(x, 0);
    context.lineTo(x, height);
  }
  context.stroke();
  context.fillStyle = colours.beyond;
  context.fillRect(scale.toX(clip.frames), 0, width, height);
}

/** A row without curves; beside its marks their labels, each up to the next mark. */
export function drawPlainRow(canvas, marks, scale, clip, colours, width, height) {
  const context = begin(canvas, width, height);
  drawGrid(context, scale, clip, colours, width, height);
  context.font = "11px system-ui, sans-serif";
  context.textBaseline = "middle";
  context.fillStyle = colours.dim;
  marks.forEach((mark, i) => {
    const x = scale.toX(mark.at_s * clip.fps) + kBesideMark_px;
    const end = i + 1 < marks.length ? scale.toX(marks[i + 1].at_s * clip.fps) - kBesideMark_px : width;
    if (end - x < kLeastWord_px) return;
    context.save();
    context.beginPath();
    context.rect(x, 0, end - x, height);
    context.clip();
    context.fillText(mark.label, x, height / 2 + 1);
    context.restore();
  });
}

/** A row's curves: each move in its colour, the right side dashed where the sides differ; what is held back in red. */
export function drawCurves(canvas, row, scale, clip, colours, width, height) {
  const context = begin(canvas, width, height);
  drawGrid(context, scale, clip, colours, width, height);
  const pad = 3, isSigned = row.low < 0;
  const zero = isSigned ? height / 2 : height - pad;
  const reach = isSigned ? height / 2 - pad : height - 2 * pad;
  context.strokeStyle = colours.line;
  context.beginPath();
  context.moveTo(Math.max(0, scale.toX(0)), Math.round(zero) - 0.5);
  context.lineTo(Math.min(width, scale.toX(clip.frames)), Math.round(zero) - 0.5);
  context.stroke();
  const first = Math.max(0, Math.floor(scale.toFrame(0)) - 1);
  const last = Math.min(clip.frames - 1, Math.ceil(scale.toFrame(width)) + 1);
  const toY = (value) => zero - reach * Math.max(-1.1, Math.min(1.1, value));
  const draw = (values, from, to) => {
    context.beginPath();
    for (let frame = from; frame <= to; ++frame) context.lineTo(scale.toX(frame), toY(values[frame] ?? 0));
    context.stroke();
  };
  row.lines.forEach((line, side) => {
    const isRight = row.lines.length > 1 && side === 0;
    context.setLineDash(isRight ? [3, 2] : []);
    line.moves.forEach((move, i) => {
      const values = line.values[i];
      if (!values.some((value) => Math.abs(value) > 1e-3)) return;
      context.lineWidth = 1.4;
      context.strokeStyle = colours.curves[i % colours.curves.length];
      draw(values, first, last);
      for (const held of row.held.filter((one) => one.move === move)) {
        context.lineWidth = 2.4;
        context.strokeStyle = colours.held;
        draw(values, Math.max(first, Math.round(held.from_s * clip.fps)), Math.min(last, Math.round(held.to_s * clip.fps)));
      }
    });
  });
  context.setLineDash([]);
}
