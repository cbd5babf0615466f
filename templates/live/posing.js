// A face posed by hand: what the sliders say, shown instead of what the clip does.
import {emit, findActor, say, state} from "./state.js";
import {keepNewest} from "./newest.js";
import {askOfDocument, checkNow, edit} from "./document.js";

let view = null;

/** The view that shows the pose; null while there is none. */
export function setView(value) {
  view = value;
}

const show = keepNewest((actor, values) => view?.showPose(actor, values));

/** Poses the chosen actor. `name`: the expression that this is, untouched. */
export function setPose(values, name = "") {
  state.pose = {actor: findActor()?.name ?? "", values, name};
  show(state.pose.actor, values);
  emit("pose");
}

/** The clip's own face again. */
export function dropPose() {
  if (!state.pose) return;
  const {actor} = state.pose;
  state.pose = null;
  emit("pose");
  show(actor, null);
}

/** The pose once more, to a view that has a new head. */
export function showAgain() {
  if (state.pose) show(state.pose.actor, state.pose.values);
}

/** The chosen actor's values at the frame that is shown. */
export async function askPose() {
  const answer = await askOfDocument("api/pose_at", {frame: state.frame, actor: findActor()?.name ?? ""});
  return answer.values;
}

/** The values of an expression, at a strength from 0 to 1. */
export async function askExpression(name, strength) {
  const answer = await askOfDocument("api/expression", {name, strength});
  if (answer.strength !== undefined) return answer.values;  // the server has taken the strength itself
  return mapValues(answer.values, (value) => value * strength);
}

/** The same moves with other numbers. */
export function mapValues(values, change) {
  return Object.fromEntries(Object.entries(values).map(([area, moves]) =>
    [area, Object.fromEntries(Object.entries(moves).map(([move, value]) => [move, change(value, area, move)]))]));
}

const round = (values) => mapValues(values, (value) => Math.round(value * 100) / 100);

/** The pose as a key of the clip where the playhead is. */
export async function writeKey(values) {
  const {fps} = state.clip;
  const isDone = await edit({do: "write_key", at_s: state.frame / fps, fps, values: round(values), actor: findActor()?.name ?? ""});
  if (!isDone) return;
  await checkNow();
  say(`Written as a key at ${(state.frame / fps).toFixed(2)} s`);
  dropPose();
}

/** The pose as an expression of the file. Whether it is there. */
export async function writeExpression(name, values) {
  const isDone = await edit({do: "write_expression", name, values: round(values)});
  if (isDone) say(`Written as the expression ${name}`);
  return isDone;
}
