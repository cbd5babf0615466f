// The clip's camera, and one that goes round the heads.
import {Camera, Matrix4, Vector3} from "./lib/three.module.js";

const kNear_mm = 450, kFar_mm = 700;  // before and behind what is looked at
const kLeastNear_mm = 20;
const kSteepest_deg = 85;
const kRadians = Math.PI / 180;

const length = (v) => Math.hypot(v[0], v[1], v[2]);

/** Sets a three.js camera to what a stage says (api/shapes). Returns its place, and whether it sees without perspective. */
export function setCamera(camera, said, orbit) {
  const place = orbit ? turnCamera(said, orbit) : said;
  const right = new Vector3().fromArray(place.right), up = new Vector3().fromArray(place.up);
  const forward = new Vector3().fromArray(place.forward), at = new Vector3().fromArray(place.at);
  const wide = right.length(), high = up.length(), ahead = forward.length();
  const x = right.normalize(), y = up.normalize(), z = forward.normalize().negate();
  camera.matrixAutoUpdate = false;
  camera.matrix.makeBasis(x, y, z).setPosition(at);
  camera.updateMatrixWorld(true);
  camera.matrixWorldInverse.getInverse(camera.matrixWorld);
  const along = at.distanceTo(new Vector3().fromArray(place.look_at));
  const near = Math.max(along - kNear_mm, kLeastNear_mm), far = along + kFar_mm;
  if (place.is_flat) {
    camera.projectionMatrix.makeOrthographic(-wide / 2, wide / 2, high / 2, -high / 2, near, far);
  } else {
    const share = near / ahead / 2;
    camera.projectionMatrix.makePerspective(-wide * share, wide * share, high * share, -high * share, near, far);
  }
  camera.projectionMatrixInverse.getInverse(camera.projectionMatrix);
  return {eye: place.is_flat ? z.clone() : at, isFlat: place.is_flat};
}

export const createCamera = () => new Camera();

// The same lens from another side.
function turnCamera(said, orbit) {
  const along = length(said.at.map((x, i) => x - said.look_at[i])) / said.distance * orbit.distance;
  const a = orbit.angle * kRadians, h = orbit.height * kRadians;
  const toward = new Vector3(Math.sin(a) * Math.cos(h), Math.sin(h), Math.cos(a) * Math.cos(h));
  const right = new Vector3(Math.cos(a), 0, -Math.sin(a)), up = new Vector3().crossVectors(toward, right);
  const look = new Vector3().fromArray(said.look_at).addScaledVector(right, -(orbit.aside ?? 0)).addScaledVector(up, -(orbit.above ?? 0));
  const scale = said.is_flat ? orbit.distance / said.distance : 1;
  return {
    ...said,
    at: look.clone().addScaledVector(toward, along).toArray(),
    forward: toward.clone().multiplyScalar(-length(said.forward)).toArray(),
    right: right.multiplyScalar(scale * length(said.right)).toArray(),
    up: up.multiplyScalar(scale * length(said.up)).toArray(),
    look_at: look.toArray(),
  };
}

/** A place of the world in the picture: x and y from 0 (left, top) to 1, and whether it lies before the camera. */
export function project(camera, place) {
  const p = new Vector3().fromArray(place).applyMatrix4(camera.matrixWorldInverse);
  const isBefore = p.z < 0;
  p.applyMatrix4(camera.projectionMatrix);
  return {x: (p.x + 1) / 2, y: (1 - p.y) / 2, isBefore};
}

/** Camera of a lamp that sees a ball about `middle`; returns {near, far} mm. */
export function setLampCamera(camera, at, middle, radius_mm) {
  const from = new Vector3().fromArray(at), to = middle;
  const along = Math.max(from.distanceTo(to), 1.5 * radius_mm);
  const z = from.clone().sub(to).normalize();
  const x = new Vector3(0, 1, 0).cross(z).normalize(), y = new Vector3().crossVectors(z, x);
  camera.matrixAutoUpdate = false;
  camera.matrix.copy(new Matrix4().makeBasis(x, y, z).setPosition(to.clone().addScaledVector(z, along)));
  camera.updateMatrixWorld(true);
  camera.matrixWorldInverse.getInverse(camera.matrixWorld);
  const near = along - radius_mm, far = along + radius_mm;
  const share = near * radius_mm / Math.sqrt(along * along - radius_mm * radius_mm);
  camera.projectionMatrix.makePerspective(-share, share, share, -share, near, far);
  return {near, far, wide_mm: 2 * share / near * along};
}

/** The orbit after a drag of dx, dy (shares of the view's height). */
export function dragOrbit(orbit, dx, dy) {
  const height = Math.min(Math.max(orbit.height + 120 * dy, -kSteepest_deg), kSteepest_deg);
  return {...orbit, angle: orbit.angle - 180 * dx, height};
}
