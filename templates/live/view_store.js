// Models and drawings as the server gives them, each asked for once.
import {askBinary} from "./server.js";
import {BufferAttribute} from "./lib/three.module.js";
import {openAnswer, readShapes} from "./view_data.js";
import {prepareModel} from "./view_figures.js";

const kMost_bytes = 500e6;  // of drawings: some 400 of a head with hair, 130 of one that grows
const kMostModels = 4;
const kAtOnce = 3;          // requests ahead of what is shown

/** What is known of one text. */
export class ViewStore {
  constructor() {
    this.models = new Map();  // by key, the newest last; they outlive a text
    this.setDocument("", null);
  }

  setDocument(doc, clip) {
    this.doc = doc;
    this.clip = clip;
    this.shapes = new Map();    // by drawing: the shapes, once they are here
    this.promises = new Map();  // by drawing
    this.bytes = 0;
    this.queue = [];
    this.running = 0;
  }

  findDrawing(frame) {
    const last = this.clip.frames - 1;
    return this.clip.drawn[Math.min(Math.max(frame, 0), last)] ?? 0;
  }

  // The newest of some; a drawing that is kept has its own.
  keepModel(model) {
    this.models.delete(model.key);
    this.models.set(model.key, model);
    while (this.models.size > kMostModels) this.models.delete(this.models.keys().next().value);
  }

  /** Fewer triangles for `model`, for machines that draw slowly; nothing where an older one's serve. */
  async loadCoarse(frame, model) {
    if (model.hasCoarse || model.actors.every(({parts}) => parts.every((part) => part.is_outline || part.coarse))) return;
    model.hasCoarse = true;
    const buffer = await askBinary("api/coarse", {doc: this.doc, frame, model: model.key});
    const {head, at: begin} = openAnswer(buffer);
    if (head.model !== model.key) return;
    let at = begin;
    model.actors.forEach((actor, a) => actor.parts.forEach((part, i) => {
      const count = head.triangles[a][i];
      if (count > 0) part.coarse = new BufferAttribute(new Uint32Array(buffer, at, 3 * count), 1);
      at += 12 * count;
    }));
  }

  /** A drawing: {model, shapes}. `request` may have camera, actor and values. */
  async askShapes(frame, request = {}) {
    const known = new Map(this.models);  // those that go meanwhile are still known here
    const buffer = await askBinary("api/shapes", {doc: this.doc, frame, known: [...known.keys()], ...request});
    const {model, shapes} = readShapes(buffer, known);
    const kept = this.models.get(model.key) ?? (known.has(model.key) ? model : prepareModel(model));
    this.keepModel(kept);
    return {model: kept, shapes};
  }

  /** The clip's drawing of a frame, from memory if it is there. */
  find(frame, request = {}) {
    const drawing = this.findDrawing(frame);
    if (!this.promises.has(drawing)) {
      const {promises, shapes} = this;
      const promise = this.askShapes(drawing, request).then((answer) => {
        shapes.set(drawing, answer);
        this.bytes += answer.shapes.bytes;
        return answer;
      });
      promise.catch(() => promises.delete(drawing));
      promises.set(drawing, promise);
    }
    return this.promises.get(drawing);
  }

  isReady(frame) {
    return this.clip !== null && this.shapes.has(this.findDrawing(frame));
  }

  /**
   * Drawings from `from` to `to` into memory, some at once, and `then` [from, to] those of another range; what was wanted
   * before is wanted no more.
   */
  fetchAhead(from, to, then = null) {
    if (!this.clip) return;
    if (!then) this.makeRoom(from, to);
    const wanted = new Set();
    for (const [first, last] of then ? [[from, to], then] : [[from, to]])
      for (let frame = first; frame <= last; ++frame) wanted.add(this.findDrawing(frame));
    this.queue = [...wanted].filter((drawing) => !this.promises.has(drawing));
    for (let i = this.running; i < kAtOnce; ++i) this.fetchNext();
  }

  async fetchNext() {
    const drawing = this.queue.shift();
    if (drawing === undefined || this.bytes > kMost_bytes) return;
    const {promises} = this;
    ++this.running;
    try {
      await this.find(drawing);
    } catch {
      // Whoever shows it is told.
    }
    if (promises !== this.promises) return;  // another text
    --this.running;
    this.fetchNext();
  }

  // Drawings outside the range go, while there are too many.
  makeRoom(from, to) {
    if (this.bytes < 0.8 * kMost_bytes) return;
    for (const [drawing, answer] of this.shapes) {
      if (drawing >= this.findDrawing(from) && drawing <= to) continue;
      this.shapes.delete(drawing);
      this.promises.delete(drawing);
      this.bytes -= answer.shapes.bytes;
    }
  }
}
