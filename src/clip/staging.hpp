// What a picture of a clip is staged with, whoever draws it: lights, ground and camera of a moment, and
// everybody's drawing.
#pragma once

#include <optional>

#include "clip/cast.hpp"
#include "scene/povray.hpp"

namespace mien {

// One picture: the heads of a time, what they do, and the camera.
struct Still {
  double time_s = 0;
  std::optional<Pose> pose;  // instead of what they do then
  CameraKey camera;
  StageMoment stage;
};

// What limits hold back in a still: not of its `pose`.
std::vector<Held> list_still_held(const Heads& heads, const Still& still);

// What of templates/povray the clip's keys name.
StageSets list_sets(const ClipSpec& clip);

FrameStart build_start(const Clip& clip, const Cast& cast, const CameraKey& camera, const StageMoment& stage);

// The buffers of one thread; contents mean nothing between calls.
struct DrawBuffers {
  DeformBuffers deform;
  InkBuffers ink;
};

// Where one of `heads` stands at a moment that is its own: world from figure.
glm::dmat4 find_actor_place(const Heads& heads, std::size_t actor, const Moment& moment);

// One of `heads` at a time, as `view` sees them; with `pose` doing that instead. The drawing is one of the
// figure's drawn model.
void draw_actor(const Heads& heads, std::size_t actor, double time_s, const std::optional<Pose>& pose,
                const InkView& view, DrawBuffers& buffers, Drawing& drawing);
void draw_actor(const Heads& heads, std::size_t actor, const Moment& moment, const InkView& view,
                DrawBuffers& buffers, Drawing& drawing);

}  // namespace mien
