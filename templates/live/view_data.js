// The bytes of api/model and api/shapes as arrays, without a copy of what is large.

const kPlace_bytes = 8, kNormal_bytes = 4, kColour_bytes = 4, kTriangle_bytes = 12, kTransform_bytes = 64;

/** The JSON object that an answer begins with, and where its bytes begin. */
export function openAnswer(buffer) {
  const size = new DataView(buffer).getUint32(0, true);
  const text = new TextDecoder().decode(new Uint8Array(buffer, 4, size));
  return {head: JSON.parse(text), at: 4 + size};
}

function takeVertices(buffer, at, count) {
  return {
    places: new Int16Array(buffer, at, 4 * count),
    normals: new Int8Array(buffer, at + kPlace_bytes * count, 4 * count),
    end: at + (kPlace_bytes + kNormal_bytes) * count,
  };
}

/** Each part with its `colours`, `indices` and, of a rigid one, `rest`. */
export function readModel(buffer) {
  const {head, at: begin} = openAnswer(buffer);
  let at = begin;
  const actors = head.actors.map((actor) => ({
    name: actor.name,
    parts: actor.parts.map((part) => {
      const colours = part.is_outline ? 1 : part.vertices;
      const read = {...part, colours: new Uint8Array(buffer, at, 4 * colours)};
      at += kColour_bytes * colours;
      read.indices = new Uint32Array(buffer, at, 3 * part.triangles);
      at += kTriangle_bytes * part.triangles;
      if (part.is_rigid) {
        read.rest = takeVertices(buffer, at, part.vertices);
        at = read.rest.end;
      }
      return read;
    }),
  }));
  return {key: head.model, step_mm: head.step_mm, actors};
}

/** One drawing of `model`: for each part `transform`, or `places` and `normals`, of an outline `indices` too. */
export function readShapes(buffer, model) {
  const {head, at: begin} = openAnswer(buffer);
  if (head.model !== model.key) return {key: head.model};
  let at = begin, outline = 0;
  const actors = model.actors.map((actor) => actor.parts.map((part) => {
    if (part.is_rigid) {
      const transform = new Float32Array(buffer, at, 16);
      at += kTransform_bytes;
      return {transform};
    }
    const [vertices, triangles] = part.is_outline ? head.outlines[outline++] : [part.vertices, 0];
    const shape = takeVertices(buffer, at, vertices);
    at = shape.end;
    if (part.is_outline) {
      shape.indices = new Uint32Array(buffer, at, 3 * triangles);
      at += kTriangle_bytes * triangles;
    }
    return shape;
  }));
  return {key: head.model, stage: head.stage, actors, bytes: buffer.byteLength};
}
