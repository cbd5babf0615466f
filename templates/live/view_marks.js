// What may be drawn over a face: guide lines, landmarks, areas in colours with their limits. Lines that lie on the skin
// move with it.
import {BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Mesh, Points, PointsMaterial} from "./lib/three.module.js";
import {ask, askBinary} from "./server.js";
import {openAnswer} from "./view_data.js";
import {findVertex} from "./view_figures.js";
import {createTintMaterial} from "./view_shading.js";
import {project} from "./view_camera.js";

const kLift_mm = 0.6;  // lines stand before the skin by so much
const kGuide = 0x3d7dd8, kLandmark = 0xd8423d;

// Where the skin's places [a, b, t, a, b, t] lie, pushed out along the normals.
function writePlaces(lines, shape, step_mm, into) {
  const a = [0, 0, 0], b = [0, 0, 0];
  let at = 0;
  for (const line of lines)
    for (let end = 0; end < 6; end += 3) {
      const first = line[end], t = line[end + 2];
      findVertex(shape, first, step_mm, a);
      findVertex(shape, line[end + 1], step_mm, b);
      for (let k = 0; k < 3; ++k)
        into[at++] = a[k] + t * (b[k] - a[k]) + kLift_mm * shape.normals[4 * first + k] / 127;
    }
}

function createLines(count, colour) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(6 * count), 3));
  const lines = new LineSegments(geometry, new LineBasicMaterial({color: colour}));
  lines.frustumCulled = false;
  return lines;
}

/** The marks over one actor's skin; `layer` is an element that labels are put into. */
export class Marks {
  constructor(layer) {
    this.group = new Group();
    this.layer = layer;
    this.data = null;
    this.areas = null;
    this.labels = [];  // {element, place: [x, y, z] or () => [x, y, z]}
    this.shown = {guides: false, landmarks: false, areas: false};
  }

  /** Makes what `shown` asks for; `request` has doc, frame, actor, model and camera. */
  async load(request, figures, actor, shown) {
    this.shown = {...shown};
    if ((shown.guides || shown.landmarks) && this.data?.model !== request.model)
      this.data = {...await ask("api/marks", request), model: request.model};
    if (shown.areas && (this.areas?.model !== request.model || this.areas.camera !== JSON.stringify(request.camera))) {
      const buffer = await askBinary("api/areas", request);
      const {head, at} = openAnswer(buffer);
      this.areas = {...head, tint: new Uint8Array(buffer, at), model: request.model, camera: JSON.stringify(request.camera)};
    }
    this.build(figures, actor);
  }

  build(figures, actor) {
    this.clear();
    this.figures = figures;
    this.actor = actor;
    this.part = figures.model.actors[actor].parts.findIndex((part) => part.name === "skin");
    if (this.shown.guides) this.buildGuides();
    if (this.shown.landmarks) this.buildLandmarks();
    if (this.shown.areas) this.buildAreas();
    this.update();
  }

  buildGuides() {
    this.guides = this.data.guides.filter((guide) => guide.lines.length).map((guide) => {
      const lines = createLines(guide.lines.length, kGuide);
      this.group.add(lines);
      const array = lines.geometry.getAttribute("position").array;
      // Beside the head, where its line reaches furthest to the picture's left.
      if (guide.name !== "middle") this.label(guide.name.replaceAll("_", " "), "guide", () => {
        let best = 0;
        for (let i = 0; i < array.length; i += 3) if (array[i] < array[best]) best = i;
        return [array[best] - 4, array[best + 1], array[best + 2]];
      });
      return {lines, guide};
    });
  }

  buildLandmarks() {
    const geometry = new BufferGeometry(), all = this.data.landmarks;
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * all.length), 3));
    this.points = new Points(geometry, new PointsMaterial({color: kLandmark, size: 5, sizeAttenuation: false}));
    this.points.frustumCulled = false;
    this.group.add(this.points);
    const array = geometry.getAttribute("position").array;
    all.forEach((landmark, i) => this.label(landmark.name, "landmark", () => Array.from(array.subarray(3 * i, 3 * i + 3))));
  }

  buildAreas() {
    const mesh = this.figures.meshes[this.actor][this.part];
    this.tint = new Mesh(new BufferGeometry(), createTintMaterial());
    this.tint.frustumCulled = false;
    this.tint.matrixAutoUpdate = false;
    this.tint.geometry.setIndex(mesh.geometry.index);
    this.tint.geometry.setAttribute("position", mesh.geometry.getAttribute("position"));
    this.tint.geometry.setAttribute("tint", new BufferAttribute(this.areas.tint, 4, true));
    this.tint.matrix.copy(mesh.matrix);
    this.tint.renderOrder = 2;
    this.group.add(this.tint);
    for (const line of this.areas.limits.lines) {
      const drawn = createLines(line.segments.length, 0);
      drawn.material.color.setRGB(...line.colour);
      drawn.material.depthTest = false;
      drawn.renderOrder = 3;
      drawn.geometry.getAttribute("position").array.set(line.segments.flat(2));
      this.group.add(drawn);
    }
    const legend = document.createElement("ul");
    legend.className = "legend";
    for (const area of this.areas.areas) {
      const row = document.createElement("li"), swatch = document.createElement("span");
      swatch.style.background = `rgb(${area.colour.join(",")})`;
      row.append(swatch, `${area.name}, ${area.mm} mm`);
      legend.append(row);
    }
    this.layer.append(legend);
  }

  label(text, kind, place) {
    const element = document.createElement("span");
    element.className = `mark ${kind}`;
    element.textContent = text;
    this.layer.append(element);
    this.labels.push({element, place});
  }

  /** Follows the skin. */
  update() {
    this.part = this.figures?.model.actors[this.actor]?.parts.findIndex((part) => part.name === "skin");
    const shape = this.figures?.shapes?.actors[this.actor]?.[this.part];
    if (!shape) return;
    const step_mm = this.figures.model.step_mm;
    for (const {lines, guide} of this.guides ?? []) {
      writePlaces(guide.lines, shape, step_mm, lines.geometry.getAttribute("position").array);
      lines.geometry.getAttribute("position").needsUpdate = true;
    }
    if (!this.points) return;
    const attribute = this.points.geometry.getAttribute("position"), at = [0, 0, 0];
    attribute.array.fill(0);
    this.data.landmarks.forEach((landmark, i) => landmark.vertices.forEach((vertex, v) => {
      findVertex(shape, vertex, step_mm, at);
      for (let k = 0; k < 3; ++k)
        attribute.array[3 * i + k] += landmark.shares[v] * (at[k] + kLift_mm * shape.normals[4 * vertex + k] / 127);
    }));
    attribute.needsUpdate = true;
  }

  /** Puts the labels where their places are in a picture of this size on the page. */
  placeLabels(camera, left, top, width, height) {
    for (const {element, place} of this.labels) {
      const at = project(camera, place());
      element.hidden = !at.isBefore || at.x < 0 || at.x > 1 || at.y < 0 || at.y > 1;
      element.style.transform =
        `translate(${left + at.x * width}px, ${top + at.y * height}px) translate(-50%, -50%)`;
    }
  }

  clear() {
    for (const child of [...this.group.children]) {
      this.group.remove(child);
      if (child !== this.tint) child.geometry.dispose();
      child.material.dispose();
    }
    this.layer.replaceChildren();
    this.labels = [];
    this.guides = this.points = this.tint = null;
  }
}
