// Everybody of a model as meshes, and what they look like in a drawing.
import {BufferAttribute, BufferGeometry, Group, Matrix4, Mesh} from "./lib/three.module.js";
import {findSurface} from "./view_shading.js";

/** Layers of meshes: what is seen, and what casts the shadow. */
export const kSeen = 0, kCasting = 1;

/** The lists of triangles that all copies of a model share. */
export function prepareModel(model) {
  for (const actor of model.actors)
    for (const part of actor.parts) {
      if (part.is_outline) continue;
      part.index = new BufferAttribute(part.indices, 1);
      if (part.pieces) part.coarse = new BufferAttribute(part.pieces, 1);
    }
  return model;
}

// Typed arrays.
function isSameList(a, b) {
  if (a === b) return true;
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; ++i) if (a[i] !== b[i]) return false;
  return true;
}

/** Gives `model` what an older one has already, where its parts have the same mesh: triangles, and the coarse ones. */
export function takeOver(older, model) {
  model.actors.forEach((actor, a) => actor.parts.forEach((part) => {
    const known = older.actors[a]?.parts.find((one) => one.name === part.name);
    if (!known || part.is_outline || known.vertices !== part.vertices || !isSameList(known.indices, part.indices)) return;
    part.indices = known.indices;
    part.index = known.index;
    part.coarse = known.coarse ?? part.coarse;
  }));
}

function setVertices(geometry, name, array, isNormalized) {
  const attribute = geometry.getAttribute(name);
  if (attribute && attribute.array.length === array.length) {
    attribute.array = array;
    attribute.needsUpdate = true;
  } else {
    geometry.setAttribute(name, new BufferAttribute(array, 4, isNormalized));
  }
}

function buildGeometry(part) {
  const geometry = new BufferGeometry();
  if (part.is_outline) return geometry;
  geometry.setIndex(part.index);
  fillGeometry(geometry, part);
  return geometry;
}

// What a part has whatever the drawing.
function fillGeometry(geometry, part) {
  setVertices(geometry, "colour", part.colours, true);
  if (!part.is_rigid) return;
  setVertices(geometry, "position", part.rest.places, false);
  setVertices(geometry, "normal", part.rest.normals, true);
}

// An outline has other triangles in each drawing.
function setOutline(mesh, part, shape) {
  mesh.geometry.dispose();
  const geometry = new BufferGeometry(), count = shape.places.length / 4;
  const colours = new Uint8Array(4 * count);
  for (let i = 0; i < count; ++i) colours.set(part.colours, 4 * i);
  geometry.setIndex(new BufferAttribute(shape.indices, 1));
  geometry.setAttribute("colour", new BufferAttribute(colours, 4, true));
  geometry.setAttribute("position", new BufferAttribute(shape.places, 4));
  geometry.setAttribute("normal", new BufferAttribute(shape.normals, 4, true));
  mesh.geometry = geometry;
}

/** Copies of a model that may stand in different drawings. */
export class Figures {
  /** With `material` all parts have it, and only those of `names` are there. */
  constructor(model, light, material = null, names = null) {
    this.model = model;
    this.light = light;
    this.isCoarse = false;
    this.group = new Group();
    this.scale = new Matrix4().makeScale(model.step_mm, model.step_mm, model.step_mm);
    this.meshes = model.actors.map((actor) => actor.parts.map((part) =>
      names && !names.includes(part.name) ? null : this.buildMesh(part, material)));
    this.shapes = null;
  }

  buildMesh(part, material) {
    const mesh = new Mesh(buildGeometry(part), material);
    mesh.frustumCulled = false;
    mesh.matrixAutoUpdate = false;
    mesh.matrix.copy(this.scale);
    mesh.name = part.name;
    this.setLook(mesh, part, material);
    this.group.add(mesh);
    return mesh;
  }

  setLook(mesh, part, material) {
    mesh.fine = material ?? findSurface(this.light, part, false);
    mesh.quick = material ?? findSurface(this.light, part, true);
    mesh.material = this.isCoarse ? mesh.quick : mesh.fine;
    mesh.renderOrder = part.is_clear ? 1 : 0;
    for (const [layer, is] of [[kSeen, part.is_seen || material], [kCasting, part.has_shadow && !material]])
      if (is) mesh.layers.enable(layer);
      else mesh.layers.disable(layer);
  }

  /** Becomes another head: what has the same triangles (takeOver) keeps its mesh, and is only filled anew. */
  become(model) {
    const before = this.meshes.map((meshes, a) => new Map(meshes.map((mesh, i) => [mesh.name, {mesh, part: this.model.actors[a].parts[i]}])));
    this.meshes = model.actors.map((actor, a) => actor.parts.map((part) => {
      const old = before[a]?.get(part.name);
      const isAlike = old && !part.is_outline && old.part.index === part.index && old.part.is_rigid === part.is_rigid;
      if (!isAlike) return this.buildMesh(part, null);
      before[a].delete(part.name);
      fillGeometry(old.mesh.geometry, part);
      this.setLook(old.mesh, part, null);
      return old.mesh;
    }));
    const kept = new Set(this.meshes.flat());
    for (const mesh of [...this.group.children].filter((one) => !kept.has(one))) {
      this.group.remove(mesh);
      mesh.geometry.dispose();
    }
    this.model = model;
    this.setTriangles();
  }

  /** Takes the drawing. */
  show(shapes) {
    this.shapes = shapes;
    this.meshes.forEach((meshes, actor) => meshes.forEach((mesh, i) => {
      if (!mesh) return;
      const part = this.model.actors[actor].parts[i], shape = shapes.actors[actor][i];
      if (part.is_rigid) {
        mesh.matrix.fromArray(shape.transform).multiply(this.scale);
        mesh.matrixWorldNeedsUpdate = true;
      } else if (part.is_outline) {
        setOutline(mesh, part, shape);
      } else {
        setVertices(mesh.geometry, "position", shape.places, false);
        setVertices(mesh.geometry, "normal", shape.normals, true);
      }
    }));
  }

  /** Fewer triangles, where the model has them (see ViewStore.loadCoarse), or all. */
  setCoarse(isCoarse) {
    if (this.isCoarse === isCoarse) return;
    this.isCoarse = isCoarse;
    this.setTriangles();
  }

  setTriangles() {
    this.meshes.forEach((meshes, actor) => meshes.forEach((mesh, i) => {
      const part = this.model.actors[actor].parts[i];
      if (!mesh) return;
      mesh.material = this.isCoarse ? mesh.quick : mesh.fine;
      const triangles = this.isCoarse && part.coarse ? part.coarse : part.index;
      if (!part.is_outline && mesh.geometry.index !== triangles) mesh.geometry.setIndex(triangles);
    }));
  }

  /** The mesh of an actor's part, or null. */
  find(actor, name) {
    return this.meshes[actor]?.find((mesh) => mesh?.name === name) ?? null;
  }

  dispose() {
    this.group.parent?.remove(this.group);
    for (const mesh of this.meshes.flat()) mesh?.geometry.dispose();
  }
}

/** Where vertex `i` of a shape lies, mm, into `into` (x, y, z). */
export function findVertex(shape, i, step_mm, into) {
  for (let k = 0; k < 3; ++k) into[k] = step_mm * shape.places[4 * i + k];
  return into;
}
