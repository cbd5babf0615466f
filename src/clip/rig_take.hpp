// A performance as a rig plays it: joints and weights in time, with as many corrections as it takes to be the
// face itself.
//
// The targets of single moves add up where the face has moves push each other: lips that meet, lids under a
// raised cheek, a neck that turns. What is missing is measured at every frame, and targets of it are added
// ("correct.1", ...): that of the frame which is worst off first, freed of those before it, until no vertex
// is further from its place than asked (a greedy reduced basis; Gram and Schmidt). Times between frames are
// added where straight lines between frames are not near enough.
#pragma once

#include <string>

#include "core/rig.hpp"
#include "frames/figure_rig.hpp"
#include "timeline/performance.hpp"

namespace mien {

struct RigTakeRequest {
  double tolerance_mm = 0.05;  // how far a vertex may be from its place at a frame
  double between_mm = 0.1;     // and between frames
  int most_corrections = 96;
  std::vector<TargetPose> poses = {};  // targets of these instead of moves
  int neck_steps = 0;                  // joints of the neck; 0: as many as it takes
  bool is_exact = false;               // a target a frame instead of all others: no error but that of numbers
  double fps = 24;
  double from_s = 0;  // where the take's time 0 is
  int frames = 1;     // one pose for a still
};

// How far vertices are from where deform_figure has them, at every time of the take and between each two.
struct RigError {
  double worst_mm = 0, mean_mm = 0;  // the mean over all vertices that bend, of the frames
  double worst_s = 0;                // when, in the take
  std::string worst_part;            // empty: nothing is off at all
  double between_mm = 0;             // the worst half-way between two times
  double uncorrected_mm = 0;         // the worst with the targets of moves alone
};

struct RiggedClip {
  Rig rig;
  RigTake take;
  RigError error;
  int corrections = 0;
};

// Throws Interrupted.
RiggedClip build_rigged_clip(const Figure& figure, const Performance& performance,
                             const RigTakeRequest& request);

}  // namespace mien
