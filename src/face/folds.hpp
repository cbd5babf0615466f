// Folds of the skin: grooves and the swellings beside them, pressed into the fine skin by what the face does.
//
// A fold is a height over the smooth skin, a sum of sets each of which grows with its drive. Normals follow
// from the height's slope, so a groove is as crisp as the mesh allows.
#pragma once

#include <vector>

#include "config/areas.hpp"
#include "config/fold_data.hpp"
#include "head/fine_skin.hpp"

namespace mien {

// How high a vertex of the left half (or the mid-plane) and its mirror image lie in a set's whole folds, mm:
// of those of its own side and of the other's.
struct FoldedVertex {
  std::uint32_t slot = 0;  // in Folds::vertices
  float near_mm = 0, far_mm = 0;
  float image_near_mm = 0, image_far_mm = 0;
};

struct FoldField {
  std::vector<FoldDrive> drives;
  double from = 0, to = 1;
  double rest = 0;                   // how much of the folds there is when nothing moves
  std::vector<FoldDrive> stretched;  // summed: what pulls them flat, from 0 to 1
  std::vector<FoldedVertex> vertices;
};

// Folds of one head; built once.
struct Folds {
  FineSkin skin;
  std::vector<FoldField> fields;
  std::vector<Triangle> triangles;     // left ones with a vertex in any fold; slots of `vertices`
  std::vector<MirrorPair> vertices;    // of those, both sides; of `skin`
  std::vector<std::uint32_t> slots;    // of those in skin.pairs
  std::vector<std::uint32_t> middles;  // the places in `vertices` of those on the mid-plane
};

using FoldBuffers = FoldPlaces;

// Solves templates/head/folds.yaml for this head; `spec` tells its age and character. Throws RunError for
// data that do not fit it.
Folds build_folds(const NeutralHead& head, const HeadSpec& spec);

// How deep a head's folds are against an adult's, by its age and character.
double compute_fold_strength(const FoldData& data, const HeadSpec& spec);

// How much of a set's folds there is on one side: from what is there at rest to 1, of slope 0 where it begins
// and ends.
double compute_fold_amount(const FoldField& field, const Pose& pose, Side side);

// Folds the skin of `pose`: `places` and `normals` are those of the slots of folds.skin, smooth. Nothing is
// changed where there is no fold, nor anything at all in the neutral pose of a head without lines at rest.
// Where folds are not uneven, mirrored poses give mirrored skins bit for bit.
void press_folds(const Folds& folds, const Pose& pose, FoldBuffers& buffers, std::vector<Twin>& places,
                 std::vector<Twin>& normals);

}  // namespace mien
