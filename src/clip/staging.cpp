#include "clip/staging.hpp"

#include "clip/ink_lamp.hpp"
#include "frames/drawn_gaze.hpp"
#include "frames/place.hpp"
#include "timeline/head_turn.hpp"
#include "timeline/parts.hpp"

namespace mien {

std::vector<Held> list_still_held(const Heads& heads, const Still& still) {
  std::vector<Held> all;
  for (const Performance& performance : heads.performances) {
    if (still.pose) break;
    const std::vector<Held> held = list_held_at(performance, still.time_s);
    all.insert(all.end(), held.begin(), held.end());
  }
  return all;
}

StageSets list_sets(const ClipSpec& clip) {
  StageSets sets;
  for (const LightKey& key : clip.light) sets.lights.insert(key.set);
  for (const BackgroundKey& key : clip.background)
    if (!key.colour) sets.backgrounds.insert(key.name);
  return sets;
}

FrameStart build_start(const Clip& clip, const Cast& cast, const CameraKey& camera,
                       const StageMoment& stage) {
  FrameStart start;
  start.backgrounds = stage.backgrounds;
  start.view = compute_view(cast.framing, camera, stage, clip.spec.render);
  if (clip.spec.render.style == Style::ink)
    start.lamp = find_ink_lamp(stage.lights, start.view);
  else
    start.lights = stage.lights;
  return start;
}

glm::dmat4 find_actor_place(const Heads& heads, std::size_t actor, const Moment& moment) {
  if (!moment.place) return heads.places[actor];
  const PlaceKey& first = heads.performances[actor].clip.place.front();
  return find_motion({first.to_mm, first.turn_deg}, {moment.place->to_mm, moment.place->turn_deg}) *
         heads.places[actor];
}

void draw_actor(const Heads& heads, std::size_t actor, double time_s, const std::optional<Pose>& pose,
                const InkView& view, DrawBuffers& buffers, Drawing& drawing) {
  Moment moment{};
  if (pose)
    moment.pose = *pose;
  else
    moment = sample_performance(heads.performances[actor], time_s);
  draw_actor(heads, actor, moment, view, buffers, drawing);
}

void draw_actor(const Heads& heads, std::size_t actor, const Moment& asked, const InkView& view,
                DrawBuffers& buffers, Drawing& drawing) {
  const DrawnFigure& figure = *heads.figures[actor];
  Moment moment = asked;
  drawing.is_away = !moment.is_there;
  const glm::dmat4 place = find_actor_place(heads, actor, moment);
  if (figure.ink)
    moment.pose = turn_gaze_to_camera(
        figure, moment.pose, place * compute_turn(figure.face.turn_pivot, moment.turn, 1), view.camera_mm);
  deform_figure(figure, moment.pose, moment.turn, buffers.deform, drawing);
  place_drawing(place, drawing);
  if (figure.ink) draw_ink(*figure.ink, moment.pose, view, buffers.ink, drawing);
}

}  // namespace mien
