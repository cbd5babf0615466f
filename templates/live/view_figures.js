// Everybody of a model as meshes, and what they look like in a drawing.
import {BufferAttribute, BufferGeometry, Group, Matrix4, Mesh} from "./lib/three.module.js";
import {createSurface} from "./view_shading.js";

/** Layers of meshes: what is seen, and what casts the shadow. */
export const kSeen = 0, kCasting = 1;

/** The attributes that all copies of a model share. */
export function prepareModel(model) {
  for (const actor of model.actors)
    for (const part of actor.parts) {
      if (part.is_outline) continue;
      part.index = new BufferAttribute(part.indices, 1);
      part.colour = new BufferAttribute(part.colours, 4, true);
      if (!part.rest) continue;
      part.restPlaces = new BufferAttribute(part.rest.places, 4);
      part.restNormals = new BufferAttribute(part.rest.normals, 4, true);
    }
  return model;
}

/** Gives `model` the coarse triangles of an older one, where its parts have the same mesh: until its own are there. */
export function takeCoarse(older, model) {
  model.actors.forEach((actor, a) => actor.parts.forEach((part) => {
    const known = older.actors[a]?.parts.find((one) => one.name === part.name);
    if (!part.coarse && known?.coarse && known.vertices === part.vertices && known.triangles === part.triangles) part.coarse = known.coarse;
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
  geometry.setAttribute("colour", part.colour);
  if (part.is_rigid) {
    geometry.setAttribute("position", part.restPlaces);
    geometry.setAttribute("normal", part.restNormals);
  }
  return geometry;
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
    this.meshes = model.actors.map((actor) => actor.parts.map((part) => {
      if (names && !names.includes(part.name)) return null;
      const mesh = new Mesh(buildGeometry(part), material ?? createSurface(light, part));
      mesh.frustumCulled = false;
      mesh.matrixAutoUpdate = false;
      mesh.matrix.copy(this.scale);
      mesh.renderOrder = part.is_clear ? 1 : 0;
      mesh.name = part.name;
      mesh.layers.disable(kSeen);
      if (part.is_seen || material) mesh.layers.enable(kSeen);
      if (part.has_shadow && !material) mesh.layers.enable(kCasting);
      this.group.add(mesh);
      return mesh;
    }));
    this.shapes = null;
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
    this.meshes.forEach((meshes, actor) => meshes.forEach((mesh, i) => {
      const part = this.model.actors[actor].parts[i];
      if (!mesh) return;
      mesh.fine = mesh.fine ?? mesh.material;
      mesh.quick = mesh.quick ?? createSurface(this.light, part, true);
      mesh.material = isCoarse ? mesh.quick : mesh.fine;
      mesh.material.wireframe = mesh.fine.wireframe;
      if (!part.is_outline) mesh.geometry.setIndex(isCoarse && part.coarse ? part.coarse : part.index);
    }));
  }

  /** The mesh of an actor's part, or null. */
  find(actor, name) {
    return this.meshes[actor]?.find((mesh) => mesh?.name === name) ?? null;
  }

  dispose() {
    this.group.parent?.remove(this.group);
    for (const mesh of this.meshes.flat()) {
      if (!mesh) continue;
      mesh.geometry.dispose();
      for (const material of [mesh.material, mesh.fine, mesh.quick]) material?.dispose();
    }
  }
}

/** Where vertex `i` of a shape lies, mm, into `into` (x, y, z). */
export function findVertex(shape, i, step_mm, into) {
  for (let k = 0; k < 3; ++k) into[k] = step_mm * shape.places[4 * i + k];
  return into;
}
