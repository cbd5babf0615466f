// The face as graphics: the exact vertices of the kernel, lit as POV-Ray would.
import {askBinary} from "./server.js";
import {openAnswer} from "./view_data.js";
import {Figures, takeOver} from "./view_figures.js";
import {createGhostMaterial} from "./view_shading.js";
import {Stage} from "./view_stage.js";
import {Marks} from "./view_marks.js";
import {ViewStore} from "./view_store.js";
import {createToolbar} from "./view_toolbar.js";
import {dragOrbit} from "./view_camera.js";

const kSky_px = 160;        // width of the ground's picture
const kIdle_ms = 250;       // then the picture is drawn finer
const kMost_px = 2.2e6;     // of one picture
const kQuick_ms = 22;       // what a drawing may take while it moves
const kShadowSteps = 3;     // drawings to one shadow, there
const kPause_ms = 120, kMore_ms = 900;  // after which, and at least how often, the rest is asked for
const kSides = {front: {angle: 0, height: 0}, three_quarter: {angle: 35, height: 0}, side: {angle: 90, height: 0}};

/** Makes the view inside `element`; see the methods for what it can do. */
export async function createView(element, session) {
  return new View(element, session);
}

class View {
  constructor(element) {
    this.element = element;
    this.listeners = {shown: [], error: []};
    this.store = new ViewStore();
    this.toggles = {wire: false, guides: false, landmarks: false, areas: false, ghost: "", beside: false};
    this.orbit = null;       // none: the clip's camera
    this.pose = null;        // {actor, values}
    this.frame = 0;
    this.turn = 0;           // of requests, so that the newest is shown
    this.now = null;         // {model, shapes, frame}
    this.pinned = null;      // the same of the face that stands beside
    this.ghost = null;
    this.skyKey = "";
    this.loaded_ms = -1e9;
    this.scale = 1;          // of the picture's pixels while it moves
    this.build();
  }

  build() {
    this.toolbar = createToolbar(this);
    this.canvas = document.createElement("canvas");
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "The face. Arrows turn the camera, plus and minus move it, C is the clip's camera");
    this.layer = document.createElement("div");
    this.layer.className = "marks";
    this.place = document.createElement("div");
    this.place.className = "stage";
    this.place.append(this.canvas, this.layer);
    this.element.append(this.toolbar.element, this.place);
    this.stage = new Stage(this.canvas);
    this.marks = new Marks(this.layer);
    this.stage.scene.add(this.marks.group);
    this.ghostMaterial = createGhostMaterial(this.stage.light, [0.25, 0.55, 1, 0.7]);
    this.followPointer();
    new ResizeObserver(() => this.drawSoon()).observe(this.place);
    this.canvas.addEventListener("webglcontextrestored", () => this.drawSoon());
  }

  on(event, listener) {
    this.listeners[event].push(listener);
  }

  tell(event, detail) {
    for (const listener of this.listeners[event]) listener(detail);
  }

  /** The text has changed; the old face stays until the new one is there. */
  async setDocument(doc, clip) {
    this.store.setDocument(doc, clip);
    this.isInk = clip.style === "ink";
    this.skyKey = "";
    this.ghost = null;
    this.canvas.setAttribute("aria-description", clip.title ?? "");
  }

  fetchAhead(from, to, then = null) {
    this.store.fetchAhead(from, to, then);
  }

  isReady(frame) {
    return this.store.isReady(frame);
  }

  // Ink is drawn for one camera.
  findRequest() {
    const request = {};
    if (this.isInk && this.orbit) request.camera = {angle: this.orbit.angle, height: this.orbit.height, distance: this.orbit.distance};
    if (this.pose) Object.assign(request, this.pose);
    return request;
  }

  /** Shows a frame of the clip; done once it is on the screen. */
  async showFrame(frame) {
    this.frame = frame;
    await this.update();
  }

  /** Poses an actor by hand; null: as the clip has it. */
  async showPose(actor, values) {
    this.pose = values ? {actor, values} : null;
    await this.update();
  }

  async update() {
    const turn = ++this.turn, frame = this.frame;
    if (!this.store.clip) return;
    try {
      const request = this.findRequest();
      const isPlain = Object.keys(request).length === 0;
      const drawing = this.store.findDrawing(frame);
      const known = isPlain ? this.store.shapes.get(drawing) : null;
      const answer = known ?? await (isPlain ? this.store.find(frame) : this.store.askShapes(drawing, request));
      if (turn !== this.turn) return;
      const isNewModel = this.now?.model !== answer.model;
      const isSame = this.now?.shapes === answer.shapes;  // on twos every other frame
      this.now = {...answer, frame};
      if (!isSame) this.show();
      this.tell("shown", {frame});
      this.loadLater(turn, isNewModel);
    } catch (error) {
      if (turn === this.turn) this.tell("error", {message: error.message, findings: error.findings ?? []});
      throw error;
    }
  }

  show() {
    const {model, shapes} = this.now;
    if (!this.figures) {
      this.figures = new Figures(model, this.stage.light);
      this.stage.scene.add(this.figures.group);
      this.setWire();
    } else if (this.figures.model !== model) {
      takeOver(this.figures.model, model);
      this.figures.become(model);
      this.setWire();
      this.ghost = null;
      this.shadowedFigures = null;  // its shadow is not late
    }
    this.figures.show(shapes);
    this.stage.setStage(shapes.stage);
    this.shadowOf = null;
    this.marks.update();
    this.draw();
  }

  // While the face moves what comes after it comes now and then.
  loadLater(turn, isNewModel) {
    this.isModelNew = this.isModelNew || isNewModel;
    const load = () => {
      this.loaded_ms = performance.now();
      const isNew = this.isModelNew;
      this.isModelNew = false;
      this.loadMore(this.turn, isNew).catch((error) => this.tell("error", {message: error.message}));
    };
    clearTimeout(this.later);
    if (performance.now() - this.loaded_ms > kMore_ms) load();
    else this.later = setTimeout(load, kPause_ms);
  }

  // What comes after the face: ground, ghost, marks.
  async loadMore(turn, isNewModel) {
    if (this.stage.isSoftware) this.store.loadCoarse(this.now.frame, this.now.model).catch(() => {});
    await this.loadSky(turn);
    if (this.toggles.ghost) await this.loadGhost(turn);
    const {guides, landmarks, areas} = this.toggles;
    if ((guides || landmarks || areas) && (isNewModel || this.marks.figures !== this.figures)) await this.loadMarks();
  }

  // Of the clip's camera and lights, or of the orbit: asked for only when they change.
  async loadSky(turn) {
    const camera = this.orbit && {angle: this.orbit.angle, height: this.orbit.height, distance: this.orbit.distance};
    const said = this.now.shapes.stage.camera;
    const key = JSON.stringify([this.store.doc, camera ?? [said.at, said.forward], this.now.shapes.stage.lamps.length]);
    if (key === this.skyKey || this.isSkyAsked) return;
    this.isSkyAsked = true;
    let isThere = false;
    try {
      const clip = this.store.clip, width = kSky_px, height = Math.max(1, Math.round(kSky_px * clip.height / clip.width));
      const frame = this.store.findDrawing(this.now.frame);
      const buffer = await askBinary("api/sky", {doc: this.store.doc, frame, width, height, ...(camera ? {camera} : {})});
      const {at} = openAnswer(buffer);
      this.stage.setGround(width, height, new Uint8Array(buffer, at, 3 * width * height));
      this.skyKey = key;
      isThere = true;
      if (turn === this.turn) this.draw();
    } catch (error) {
      if (error.name !== "AbortError") console.warn(error);
    } finally {
      this.isSkyAsked = false;
    }
    if (isThere && turn === this.turn) await this.loadSky(turn);  // it has changed meanwhile
  }

  findActor() {
    const name = this.pose?.actor ?? "";
    const index = this.now.model.actors.findIndex((actor) => actor.name === name);
    return Math.max(index, 0);
  }

  async loadMarks() {
    const actor = this.findActor(), said = this.now.shapes.stage.camera;
    const camera = this.orbit ?? {angle: said.angle, height: said.height, distance: said.distance};
    const request = {doc: this.store.doc, frame: this.store.findDrawing(this.now.frame), model: this.now.model.key,
                     actor: this.now.model.actors[actor].name,
                     camera: {angle: camera.angle, height: camera.height, distance: camera.distance}};
    await this.marks.load(request, this.figures, actor, this.toggles);
    this.draw();
  }

  findGhostFrame() {
    const keys = this.store.clip.keys.map((key) => Math.round(key.at_s * this.store.clip.fps));
    return Math.max(0, ...keys.filter((frame) => frame < this.frame));
  }

  async loadGhost(turn) {
    const isRest = this.toggles.ghost === "rest";
    const frame = isRest ? this.frame : this.findGhostFrame();
    const key = `${this.store.doc} ${this.toggles.ghost} ${isRest ? this.store.findDrawing(frame) : frame}`;
    if (this.ghost?.key === key) return;
    const {model, shapes} = await this.store.askShapes(this.store.findDrawing(frame), isRest ? {values: {}} : {});
    if (turn !== this.turn || !this.toggles.ghost) return;
    if (this.ghostFigures?.model !== model) {
      this.ghostFigures?.dispose();
      this.ghostFigures = new Figures(model, this.stage.light, this.ghostMaterial, ["skin"]);
      this.ghostFigures.group.renderOrder = 5;
      this.stage.scene.add(this.ghostFigures.group);
    }
    this.ghostFigures.show(shapes);
    this.ghost = {key};
    this.draw();
  }

  /** "front", "three_quarter", "side", or "clip". */
  setSide(side) {
    this.orbit = side === "clip" ? null : {distance: 1, ...kSides[side]};
    this.moveCamera();
  }

  setOrbit(orbit) {
    this.orbit = orbit;
    this.moveCamera();
  }

  moveCamera() {
    this.toolbar.show();
    if (!this.now) return;
    if (this.isInk) this.update().catch(() => {});
    else {
      this.draw();
      this.loadSky(this.turn);
    }
    if (this.toggles.areas) this.loadMarks();
  }

  findOrbit() {
    if (this.orbit) return this.orbit;
    const said = this.now?.shapes.stage.camera;
    return {angle: said?.angle ?? 0, height: said?.height ?? 0, distance: said?.distance ?? 1};
  }

  /** A toggle of the toolbar: wire, guides, landmarks, areas, ghost ("", "rest", "key"), beside. */
  async setToggle(name, value) {
    this.toggles[name] = value;
    this.toolbar.show();
    if (!this.now) return;
    if (name === "wire") this.setWire();
    if (name === "beside") this.pin();
    if (name === "ghost" && !value) {
      this.ghostFigures?.dispose();
      this.ghostFigures = this.ghost = null;
    }
    if (name === "ghost" && value) await this.loadGhost(this.turn);
    if (name === "guides" || name === "landmarks" || name === "areas") await this.loadMarks();
    this.draw();
  }

  setWire() {
    for (const mesh of this.figures?.meshes.flat() ?? [])
      for (const material of [mesh.fine, mesh.quick]) material.wireframe = this.toggles.wire;
  }

  // The face as it is now goes to the left, and stays.
  pin() {
    this.pinned?.figures.dispose();
    this.pinned = null;
    if (!this.toggles.beside) return;
    const figures = new Figures(this.now.model, this.stage.light);
    figures.show(this.now.shapes);
    figures.group.visible = false;
    this.stage.scene.add(figures.group);
    this.pinned = {figures, shapes: this.now.shapes};
  }

  followPointer() {
    let last = null;
    this.canvas.addEventListener("pointerdown", (event) => {
      last = event;
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (!last || !this.now) return;
      const height = this.canvas.clientHeight || 1;
      const dx = (event.clientX - last.clientX) / height, dy = (event.clientY - last.clientY) / height;
      last = event;
      this.setOrbit(dragOrbit(this.findOrbit(), dx, dy));
    });
    for (const name of ["pointerup", "pointercancel"]) this.canvas.addEventListener(name, () => { last = null; });
    this.canvas.addEventListener("dblclick", () => this.setSide("clip"));
    this.canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY / 800));
    }, {passive: false});
    this.canvas.addEventListener("keydown", (event) => this.hearKey(event));
  }

  zoom(times) {
    const orbit = this.findOrbit();
    this.setOrbit({...orbit, distance: Math.min(Math.max(orbit.distance * times, 0.15), 6)});
  }

  hearKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const orbit = this.findOrbit(), step = event.shiftKey ? 15 : 5;
    const turns = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step]};
    const actions = {1: () => this.setSide("front"), 2: () => this.setSide("three_quarter"), 3: () => this.setSide("side"),
                     c: () => this.setSide("clip"), "+": () => this.zoom(0.9), "=": () => this.zoom(0.9), "-": () => this.zoom(1.1)};
    if (turns[event.key]) {
      const [aside, above] = turns[event.key];
      this.setOrbit({...orbit, angle: orbit.angle + aside, height: Math.min(Math.max(orbit.height + above, -85), 85)});
    } else if (actions[event.key]) {
      actions[event.key]();
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }

  drawSoon() {
    cancelAnimationFrame(this.soon);
    this.soon = requestAnimationFrame(() => this.draw());
  }

  // The picture's place on the page, in its own shape.
  findPlace() {
    const clip = this.store.clip, count = this.pinned ? 2 : 1;
    const aspect = count * clip.width / clip.height;
    const wide = this.place.clientWidth, high = this.place.clientHeight;
    const width = Math.max(1, Math.floor(Math.min(wide, high * aspect))), height = Math.max(1, Math.floor(width / aspect));
    return {left: Math.floor((wide - width) / 2), top: Math.floor((high - height) / 2), width, height, count};
  }

  /** Draws at once, coarsely where the machine is slow, and finer when nothing more comes. */
  draw() {
    this.drawAt(this.scale, true);
    clearTimeout(this.finer);
    this.finer = setTimeout(() => this.drawAt(this.stage.isSoftware ? 1 : window.devicePixelRatio || 1, false), kIdle_ms);
  }

  drawAt(scale, isQuick) {
    if (!this.now || !this.store.clip || document.hidden) return;
    const place = this.findPlace();
    const pixels = Math.min(isQuick && !this.stage.isSoftware ? window.devicePixelRatio || 1 : scale,
                            Math.sqrt(kMost_px / (place.width * place.height)));
    const width = Math.max(16, Math.round(place.width * pixels)), height = Math.max(16, Math.round(place.height * pixels));
    const begun = performance.now();
    const isCoarse = isQuick && this.stage.isSoftware;
    if (this.figures.isCoarse !== isCoarse) this.shadowOf = null;
    this.figures.setCoarse(isCoarse);
    this.drawInto(width, height, place.count);
    Object.assign(this.canvas.style, {left: `${place.left}px`, top: `${place.top}px`, width: `${place.width}px`, height: `${place.height}px`});
    const wide = place.width / place.count;
    this.marks.placeLabels(this.stage.camera, place.left + place.width - wide, place.top, wide, place.height);
    if (!isCoarse) return;
    this.stage.wait();
    this.adapt(performance.now() - begun);
  }

  // Without a graphics card the picture has as many pixels as there is time for.
  adapt(took_ms) {
    const wanted = this.scale * Math.sqrt(kQuick_ms / Math.max(took_ms, 1));
    this.scale = Math.min(1, Math.max(0.4, 0.8 * this.scale + 0.2 * wanted));
  }

  drawInto(width, height, count) {
    const {renderer} = this.stage;
    if (this.canvas.width !== width || this.canvas.height !== height) renderer.setSize(width, height, false);
    const each = width / count, said = this.now.shapes.stage.camera;
    if (this.pinned && count === 2) {
      this.figures.group.visible = this.marks.group.visible = false;
      if (this.ghostFigures) this.ghostFigures.group.visible = false;
      this.pinned.figures.group.visible = true;
      this.stage.drawShadow(this.pinned.figures);
      this.stage.draw(this.pinned.shapes.stage.camera, this.orbit, {x: 0, y: 0, width: each, height});
      this.pinned.figures.group.visible = false;
      this.figures.group.visible = this.marks.group.visible = true;
      if (this.ghostFigures) this.ghostFigures.group.visible = true;
      this.shadowOf = null;
    }
    if (this.shadowOf !== this.figures && !this.isShadowLate()) {
      this.stage.drawShadow(this.figures);
      this.shadowOf = this.figures;
    }
    this.stage.draw(said, this.orbit, {x: (count - 1) * each, y: 0, width: each, height});
  }

  // Without a graphics card the shadow follows a moving face in steps.
  isShadowLate() {
    if (!this.figures.isCoarse || this.figures !== this.shadowedFigures) {
      this.shadowedFigures = this.figures;
      this.late = 0;
      return false;
    }
    this.late = (this.late + 1) % kShadowSteps;
    return this.late !== 0;
  }

  /** The picture at the clip's own size, as a PNG. */
  async takePicture() {
    const {width, height} = this.store.clip, fine = 2;
    while (this.isSkyAsked) await new Promise((done) => setTimeout(done, 20));
    await this.loadSky(this.turn);
    clearTimeout(this.finer);
    this.figures.setCoarse(false);
    this.shadowOf = null;
    this.drawInto(fine * width, fine * height, 1);
    const picture = document.createElement("canvas");
    picture.width = width;
    picture.height = height;
    const context = picture.getContext("2d");
    context.imageSmoothingQuality = "high";
    context.drawImage(this.canvas, 0, 0, width, height);
    this.draw();
    return new Promise((done) => picture.toBlob(done, "image/png"));
  }
}
