// A head that can be posed and drawn: the only place where geometry and time meet.
#pragma once

#include <string>
#include <vector>

#include "config/spec.hpp"
#include "core/model.hpp"
#include "face/face.hpp"
#include "face/folds.hpp"
#include "face/limits.hpp"
#include "frames/redraw.hpp"
#include "frames/tongue.hpp"
#include "head/form.hpp"
#include "head/head.hpp"

namespace mien {

// All that a clip needs of one head. Built once, shared read-only by all threads.
struct Figure {
  NeutralHead head;
  Face face;
  Folds folds;
  LimitShares limits;            // of `head.limits`
  std::vector<HeadPart> parts;   // their `part` is moved into `model`: parts[i] carries model.parts[i]
  std::vector<HairRoots> roots;  // of parts[i]'s bindings, at rest
  Model model;
  std::string hair = "none";      // the cut that it wears
  bool has_still_hair = false;    // of a drawing: no brow and no lid moves it
  Redraw redraw;                  // of a design; then the parts of eyes and jaw are no rigid ones,
  std::vector<Mesh> undistorted;  // and this is what each of them was before, empty for the others
  TongueRig tongue;
};

// The buffers of one thread; contents mean nothing between calls. Without `has_folds` the skin stays smooth.
struct DeformBuffers {
  bool has_folds = true;
  FoldBuffers folds;
  std::vector<glm::dvec3> points;
  Mesh tongue;  // bent, in the jaw's rest space
  std::vector<Twin> point_pairs, place_pairs, normal_pairs;
};

enum class FigureUse {
  picture,
  ink,    // the eyes are flat, lashes and brows are none: strokes stand for them (frames/ink.hpp)
  print,  // the skin is smooth and of one colour: no folds, no grain and no shade are made
};

// About 0.2 s on two cores, half of it for a print. Throws InputError for broken files that
// `spec` names.
Figure build_figure(const HeadStock& stock, const HeadSpec& spec, FigureUse use = FigureUse::picture);

// The pose as this head takes it: within its own limits, and with what muscles and units do by moves of the
// areas.
Pose limit_pose(const Figure& figure, const Pose& asked);

// What a part of this mount does within the head, which does not turn: world from rest.
glm::dmat4 compute_motion(const Figure& figure, Mount mount, const Pose& pose);

// The figure in `pose` with its head turned, into `drawing` (resized). The neutral pose without a turn gives
// the rest meshes bit for bit.
void deform_figure(const Figure& figure, const Pose& pose, const TurnKey& turn, DeformBuffers& buffers,
                   Drawing& drawing);

// The same for the skin alone, smooth and without the vertices that folds add. `surface` is the head's, or
// what select_vertices left of it.
void deform_skin(const Figure& figure, const Surface& surface, const Pose& pose, const TurnKey& turn,
                 DeformBuffers& buffers, PartShape& skin);

}  // namespace mien
