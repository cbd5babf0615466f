// The lines of folds laid on the adult's skin: how far from them a place lies, and how high a fold is there.
#pragma once

#include <array>
#include <vector>

#include "config/fold_data.hpp"
#include "head/fine_skin.hpp"

namespace mien {

// A line of a set on the adult: points at even steps.
struct Track {
  const FoldSet* set = nullptr;
  std::vector<glm::vec3> points;
  std::vector<glm::vec3> normals;  // of the skin
  std::vector<float> depths;       // shares
  const FoldUnevenness* uneven = nullptr;
  std::uint32_t series = 0;  // of its own chances
  float step_mm = 1;         // between points
  float reach_mm = 0;
  Box box;  // of all that is in reach
};

// All lines of `data`, which must outlive them. `adult` is the adult's skin on the cage of `head`. Throws
// RunError "FILE:LINE: ..." for a point that the cage does not have.
std::vector<Track> build_tracks(const NeutralHead& head, const Mesh& adult, const FoldData& data);

// The height of a set's whole folds at a place of the left half and at its mirror image, mm; negative in a
// groove. They differ as `uneven` says, and on the mid-line not at all.
std::array<double, 2> compute_heights_mm(const std::vector<Track>& tracks, const FoldSet& set,
                                         const glm::vec3& place);

// How long edges may be: short in a groove, longer in the softer swellings beside it. `tracks` must outlive
// it.
EdgeLimit limit_edges(const std::vector<Track>& tracks, double edge);

}  // namespace mien
