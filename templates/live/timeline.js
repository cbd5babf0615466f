// The timeline: rows of areas by time, a ruler to scrub on, and the playhead.
import {on, state} from "./state.js";
import {find, make, recall, remember} from "./elements.js";
import {isOwn} from "./editor.js";
import {buildRows} from "./timeline_rows.js";
import {drawCurves, drawPlainRow, drawRuler, readColours} from "./timeline_draw.js";
import {computeCuesHeight_px, goToMark, makeHeld, makeMark, nudge, placeHeld, placeMark} from "./timeline_marks.js";
import {goToFrame} from "./player.js";

const kRuler_px = 26;
const kHeights_px = {actor: 20, keys: 22, blinks: 18, stage: 18, turn: 24, area: 24};
const kMostMore_px = 22;   // a row with curves grows by at most this in a high timeline
const kMargin_px = 10;     // before frame 0 and behind the last one, so that marks there are whole
const kClosest_px = 40;    // a frame's width at most
const kZoom = 1.3;

// Frames to pixels of a lane.
class Scale {
  frame_px = 8;
  first = 0;     // the frame at the lane's left margin
  isFit = true;  // the whole clip is shown, whatever the width

  toX(frame) {
    return kMargin_px + (frame - this.first) * this.frame_px;
  }

  toFrame(x) {
    return this.first + (x - kMargin_px) / this.frame_px;
  }
}

export class Timeline {
  constructor(element, editor) {
    this.editor = editor;
    this.scale = new Scale();
    this.open = new Set(recall("open_rows", []));
    this.rows = [];
    this.isDragging = false;
    this.isStale = false;  // rows are older than the clip
    this.ruler = make("canvas", {className: "ruler", "aria-hidden": "true"});
    this.rulerLane = make("div", {className: "lane ruler_lane", role: "slider", tabIndex: 0, "aria-label": "Frame", "aria-valuemin": 0}, this.ruler);
    this.list = make("div", {className: "rows", role: "list", "aria-label": "Rows"});
    this.playhead = make("div", {className: "playhead"});
    this.ghost = make("div", {className: "ghost", hidden: true}, make("span"));
    this.over = make("div", {className: "over", "aria-hidden": "true"}, this.playhead, this.ghost);
    this.body = make("div", {className: "body"},
      make("div", {className: "row ruler_row"}, make("div", {className: "label"}), this.rulerLane), this.list, this.over);
    this.thumb = make("div", {className: "thumb", role: "scrollbar", tabIndex: 0, "aria-label": "Part of the clip", "aria-orientation": "horizontal",
                              "aria-controls": "tracks", "aria-valuemin": 0, "aria-valuemax": 100});
    this.strip = make("div", {className: "strip"}, this.thumb);
    this.element = element;
    element.append(this.body, this.strip);
    this.hear();
  }

  hear() {
    on("clip", () => this.build());
    on("chart", () => this.build());
    on("frame", () => this.showFrame());
    on("cursor", () => this.showCursor());
    new ResizeObserver(() => this.draw()).observe(this.element);
    for (const query of ["(prefers-color-scheme: dark)", `(resolution: ${window.devicePixelRatio}dppx)`])
      window.matchMedia(query).addEventListener("change", () => this.draw());
    find("zoom_in").addEventListener("click", () => this.zoom(kZoom));
    find("zoom_out").addEventListener("click", () => this.zoom(1 / kZoom));
    find("zoom_all").addEventListener("click", () => this.fit());
    this.body.addEventListener("wheel", (event) => this.hearWheel(event), {passive: false});
    this.hearScrub();
    this.hearStrip();
  }

  // The width of a lane.
  get width() {
    return this.rulerLane.clientWidth;
  }

  get frames() {
    return Math.max(1, state.clip?.frames ?? 1);
  }

  build() {
    if (!state.clip || !state.language) return;
    this.isStale = this.isDragging;
    if (this.isDragging) return;
    const focused = document.activeElement?.closest?.("#tracks .mark");
    const again = focused && {kind: focused.dataset.kind, line: focused.dataset.line, column: focused.dataset.column};
    const focusedRow = document.activeElement?.closest?.("#tracks .label button")?.dataset.row;
    this.rows = buildRows(state.clip, state.chart, state.language.areas, this.open);
    for (const row of this.rows) this.buildRow(row);
    this.list.replaceChildren(...this.rows.map((row) => row.element));
    this.draw();
    this.showCursor();
    this.restoreFocus(again, focusedRow);
  }

  restoreFocus(again, focusedRow) {
    const marks = [...this.list.querySelectorAll(".mark")];
    if (marks.length) marks[0].tabIndex = 0;
    if (again) marks.find(({dataset}) => dataset.kind === again.kind && dataset.line === again.line && dataset.column === again.column)?.focus({preventScroll: true});
    if (focusedRow) this.list.querySelector(`button[data-row="${CSS.escape(focusedRow)}"]`)?.focus({preventScroll: true});
  }

  buildRow(row) {
    row.least_px = row.kind === "cues" ? computeCuesHeight_px(row.lanes) : kHeights_px[row.kind];
    row.canvas = make("canvas", {"aria-hidden": "true"});
    row.marksOn = (row.marks ?? []).map((mark) => ({mark, element: makeMark(mark, this)}));
    row.heldOn = (row.held ?? []).filter((held) => held.to_s > held.from_s).map((held) => ({held, element: makeHeld(held, this)}));
    const lane = make("div", {className: "lane"}, row.canvas, ...row.heldOn.map((one) => one.element), ...row.marksOn.map((one) => one.element));
    row.element = make("div", {className: `row row_${row.kind} level_${row.level}`, role: "listitem", data: {row: row.id}}, this.makeLabel(row), lane);
  }

  // Rows with curves share the room that is left.
  shareHeight() {
    const curves = this.rows.filter((row) => row.lines);
    const least_px = this.rows.reduce((sum, row) => sum + row.least_px, kRuler_px + 1);
    const more_px = Math.floor((this.body.clientHeight - least_px) / Math.max(1, curves.length));
    for (const row of this.rows) {
      row.height_px = row.least_px + (row.lines ? Math.max(0, Math.min(kMostMore_px, more_px)) : 0);
      row.element.style.height = `${row.height_px}px`;
    }
  }

  makeLabel(row) {
    const legend = (row.lines ?? []).length && row.kind !== "actor"
      ? make("span", {className: "legend", "aria-hidden": "true"}, ...row.moves.map((move, i) => make("i", {className: `curve_${i + 1}`}, move.move))) : null;
    if (!row.canOpen) return make("div", {className: "label"}, make("span", {className: "name"}, row.label), legend);
    const button = make("button", {type: "button", className: "name opens", "aria-expanded": String(row.isOpen), data: {row: row.id},
                                   title: row.kind === "actor" ? "Show or hide" : "Left and right",
                                   on: {click: () => this.toggleRow(row.id)}}, row.label);
    return make("div", {className: "label"}, button, legend);
  }

  toggleRow(id) {
    if (!this.open.delete(id)) this.open.add(id);
    remember("open_rows", [...this.open]);
    this.build();
  }

  limitScale() {
    const room = Math.max(50, this.width - 2 * kMargin_px);
    const fit_px = room / this.frames;
    if (this.scale.isFit) this.scale.frame_px = fit_px;
    this.scale.frame_px = Math.max(Math.min(fit_px, kClosest_px), Math.min(kClosest_px, this.scale.frame_px));
    this.scale.first = Math.max(0, Math.min(this.frames - room / this.scale.frame_px, this.scale.first));
  }

  /** Draws all anew, as wide as the page is now. */
  draw() {
    if (!state.clip || this.width < 20) return;
    this.limitScale();
    this.shareHeight();
    const {scale, width} = this, {clip} = state;
    const colours = readColours();
    drawRuler(this.ruler, scale, clip, colours, width, kRuler_px);
    for (const row of this.rows) {
      if (row.kind === "actor") continue;
      if (row.lines) drawCurves(row.canvas, row, scale, clip, colours, width, row.height_px - 1);
      else drawPlainRow(row.canvas, row.kind === "keys" || row.kind === "stage" ? row.marks : [], scale, clip, colours, width, row.height_px - 1);
      for (const {mark, element} of row.marksOn) placeMark(element, mark, scale);
      for (const {held, element} of row.heldOn) placeHeld(element, held, scale);
    }
    this.over.style.height = `${this.list.offsetHeight + kRuler_px}px`;
    this.drawStrip();
    this.showFrame();
  }

  showFrame() {
    const x = this.scale.toX(state.frame);
    this.playhead.style.transform = `translateX(${x}px)`;
    this.playhead.hidden = x < 0 || x > this.width;
    this.rulerLane.setAttribute("aria-valuenow", state.frame);
    this.rulerLane.setAttribute("aria-valuemax", this.frames - 1);
    if (state.clip) this.rulerLane.setAttribute("aria-valuetext", `frame ${state.frame}, ${(state.frame / state.clip.fps).toFixed(2)} seconds`);
    if (this.playhead.hidden && state.isPlaying) this.scrollTo(state.frame);
  }

  scrollTo(frame) {
    this.scale.first = frame;
    this.draw();
  }

  showCursor() {
    for (const element of this.list.querySelectorAll(".mark"))
      element.classList.toggle("at_cursor", Number(element.dataset.line) > 0 && Number(element.dataset.line) === state.cursorLine);
  }

  /** While something is dragged no element is replaced. */
  holdRows(isDragging) {
    this.isDragging = isDragging;
    if (!isDragging && this.isStale) this.build();
  }

  /** A line and a time while something is dragged. */
  showGhost(frame, text) {
    this.ghost.hidden = false;
    this.ghost.style.transform = `translateX(${this.scale.toX(frame)}px)`;
    this.ghost.firstChild.textContent = text;
    this.ghost.classList.toggle("at_right", this.scale.toX(frame) > this.width - 130);
  }

  hideGhost() {
    this.ghost.hidden = true;
  }

  /** What a click on a mark does: its frame, and its line in the text. */
  choose(mark, element) {
    element.focus({preventScroll: true});
    goToMark(mark, this.editor);
  }

  /** The line that a finding or a held move names. */
  goToPlace(place) {
    if (isOwn(place)) this.editor.goTo(place.line, place.column);
  }

  noteFocus(element) {
    for (const other of this.list.querySelectorAll('.mark[tabindex="0"]')) other.tabIndex = -1;
    element.tabIndex = 0;
  }

  hearMarkKey(event, mark, element) {
    const way = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    const rowWay = {ArrowUp: -1, ArrowDown: 1}[event.key];
    if (way && event.altKey) nudge(mark, way, event.shiftKey);
    else if (way && !event.ctrlKey && !event.metaKey) this.focusBeside(mark, element, way);
    else if (rowWay) this.focusRow(mark, element, rowWay);
    else if (event.key === "Enter") this.editor.goTo(mark.line, mark.column, true);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  focusBeside(mark, element, way) {
    const row = this.rows.find((one) => one.marksOn.some((other) => other.element === element));
    const next = row.marksOn[row.marksOn.findIndex((other) => other.element === element) + way];
    if (next) this.choose(next.mark, next.element);
  }

  focusRow(mark, element, way) {
    const rows = this.rows.filter((row) => row.marksOn?.length);
    const row = rows[rows.findIndex((one) => one.marksOn.some((other) => other.element === element)) + way];
    if (!row) return;
    const near = row.marksOn.reduce((best, one) => Math.abs(one.mark.at_s - mark.at_s) < Math.abs(best.mark.at_s - mark.at_s) ? one : best);
    this.choose(near.mark, near.element);
  }

  /** Closer or further about a place of the lane; without one, about the playhead. */
  zoom(factor, x = this.scale.toX(state.frame)) {
    const about = Math.max(0, Math.min(this.width, x));
    const frame = this.scale.toFrame(about);
    this.scale.isFit = false;
    this.scale.frame_px *= factor;
    const room = Math.max(50, this.width - 2 * kMargin_px);
    if (this.scale.frame_px * this.frames <= room) this.scale.isFit = true;
    this.scale.frame_px = Math.min(kClosest_px, this.scale.frame_px);
    this.scale.first = frame - (about - kMargin_px) / this.scale.frame_px;
    this.draw();
  }

  /** The whole clip. */
  fit() {
    this.scale.isFit = true;
    this.scale.first = 0;
    this.draw();
  }

  hearWheel(event) {
    if (event.ctrlKey || event.metaKey) {
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY * 0.002), event.clientX - this.rulerLane.getBoundingClientRect().left);
    } else if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
      event.preventDefault();
      this.scale.first += (event.deltaX || event.deltaY) / this.scale.frame_px;
      this.draw();
    }
  }

  hearScrub() {
    const scrub = (event) => goToFrame(this.scale.toFrame(event.clientX - this.rulerLane.getBoundingClientRect().left));
    this.rulerLane.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      this.rulerLane.setPointerCapture(event.pointerId);
      scrub(event);
    });
    this.rulerLane.addEventListener("pointermove", (event) => {
      if (this.rulerLane.hasPointerCapture(event.pointerId)) scrub(event);
    });
    this.list.addEventListener("click", (event) => {
      if (event.target.closest(".lane") && !event.target.closest("button")) scrub(event);
    });
  }

  drawStrip() {
    const room = Math.max(1, this.width - 2 * kMargin_px) / this.scale.frame_px;
    const part = Math.min(1, room / this.frames);
    this.strip.hidden = part > 0.999;
    this.thumb.style.width = `${part * 100}%`;
    this.thumb.style.left = `${this.scale.first / this.frames * 100}%`;
    this.thumb.setAttribute("aria-valuenow", Math.round(this.scale.first / Math.max(1, this.frames - room) * 100));
  }

  hearStrip() {
    let begin_px = 0, first = 0;
    this.thumb.addEventListener("pointerdown", (event) => {
      this.thumb.setPointerCapture(event.pointerId);
      begin_px = event.clientX;
      first = this.scale.first;
    });
    this.thumb.addEventListener("pointermove", (event) => {
      if (!this.thumb.hasPointerCapture(event.pointerId)) return;
      this.scale.first = first + (event.clientX - begin_px) / this.strip.clientWidth * this.frames;
      this.draw();
    });
    this.thumb.addEventListener("keydown", (event) => {
      const way = {ArrowLeft: -1, ArrowRight: 1}[event.key];
      if (!way) return;
      event.preventDefault();
      event.stopPropagation();
      this.scale.first += way * this.width / 10 / this.scale.frame_px;
      this.draw();
    });
  }
}
