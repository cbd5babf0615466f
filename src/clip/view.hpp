// What the camera takes in: one head or all that are on the stage, whatever they become in the clip.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/spec.hpp"
#include "frames/figure.hpp"
#include "frames/ink.hpp"
#include "scene/povray.hpp"
#include "timeline/gaze.hpp"
#include "timeline/stage_track.hpp"

namespace mien {

// Everything that a picture at distance 1 must hold, in the world's millimetres.
struct Framing {
  double chin_mm = 0, crown_mm = 0;                                  // of the lowest and the highest head
  double top_mm = 0;                                                 // of the highest hair
  double floor_mm = 0;                                               // down to here every neck is whole
  std::vector<glm::vec3> points;                                     // all that lies above the chins
  std::map<std::pair<std::string, std::string>, glm::dvec3> places;  // of landmarks, by actor and name
};

// Adds a figure in its neutral shape where it stands.
void add_figure(const Figure& figure, const glm::dmat4& world_from_figure, Framing& framing);

// Adds one who is all of these figures in turn: the camera stays where it is, and the head is seen to grow.
// Where necks end is the longest one's affair; the others are lowered (compute_lowering_mm).
void add_growing_figure(const std::vector<const Figure*>& figures, const glm::dmat4& world_from_figure,
                        Framing& framing);

// How far a head of one who grows must be lowered, so that its neck does not end inside the picture: 0 or
// less. An infant has hardly a neck; it stands lower in the picture than the adult that it becomes.
double compute_lowering_mm(const Figure& figure, const glm::dmat4& world_from_figure, const Framing& framing,
                           const RenderSpec& render);

// The camera of one moment. Distance 1 frames whole faces and necks, whatever their size and whatever the
// angle: a long head from the side is framed wider than from the front. Between two angles the frame changes
// as smoothly as they do.
CameraView compute_view(const Framing& framing, const CameraKey& camera, const RenderSpec& render);

// The same through the lens of a moment and with its own aim: the frame keeps its size and is shifted.
CameraView compute_view(const Framing& framing, const CameraKey& camera, const StageMoment& stage,
                        const RenderSpec& render);

// A direction of length 1: so far from straight ahead of a head to its left, and up.
glm::dvec3 find_direction(double angle_deg, double up_deg);

// Toward ink's own lamp, as templates/povray/light_ink.inc has it; + brings it to the character's left.
glm::dvec3 find_own_lamp(const CameraView& view, double angle_deg);

// What ink must know of the camera and of its lamp; without one it is its own.
InkView compute_ink_view(const CameraView& view, const RenderSpec& render,
                         const std::optional<InkLamp>& lamp = {});

// What a gaze must know of a figure where it stands and of the camera that looks at the stage.
EyeRig compute_eyes(const Figure& figure, const glm::dmat4& world_from_figure, const Framing& framing,
                    const RenderSpec& render);

// The same of one figure alone.
EyeRig compute_eyes(const Figure& figure, const RenderSpec& render);

// Where a landmark or everyday word of templates/head/landmarks.yaml lies on the neutral figure, mm; of a
// sided one without _l or _r the middle between both.
glm::dvec3 compute_resting_place(const NeutralHead& head, const std::string& name);

// The same for one figure alone.
CameraView compute_view(const Figure& figure, const CameraKey& camera, const RenderSpec& render);

}  // namespace mien
