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

// Each part with its `colours`, `indices`, `pieces` if there are some and, of a rigid one, `rest`; `end`: where its bytes end.
function takeModel(head, buffer, begin) {
  let at = begin;
  const actors = head.actors.map((actor) => ({
    name: actor.name,
    parts: actor.parts.map((part) => {
      const colours = part.is_outline ? 1 : part.vertices;
      const read = {...part, colours: new Uint8Array(buffer, at, 4 * colours)};
      at += kColour_bytes * colours;
      read.indices = new Uint32Array(buffer, at, 3 * part.triangles);
      at += kTriangle_bytes * part.triangles;
      read.pieces = part.pieces > 0 ? new Uint32Array(buffer, at, 3 * part.pieces) : null;
      at += kTriangle_bytes * part.pieces;
      if (part.is_rigid) {
        read.rest = takeVertices(buffer, at, part.vertices);
        at = read.rest.end;
      }
      return read;
    }),
  }));
  return {model: {key: head.model, step_mm: head.step_mm, actors}, end: at};
}

/**
 * One drawing, of the model that the answer brings or else of one of `models`, by their keys: for each part `transform`,
 * or `places` and `normals`, of an outline `indices` too.
 */
export function readShapes(buffer, models) {
  const {head, at: begin} = openAnswer(buffer);
  const {model, end} = head.fresh ? takeModel(head.fresh, buffer, begin) : {model: models.get(head.model), end: begin};
  let at = end, outline = 0;
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
  return {model, shapes: {stage: head.stage, actors, bytes: buffer.byteLength}};
}
