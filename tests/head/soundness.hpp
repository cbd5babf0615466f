// What is measured on a head to say that its skin is sound.
#pragma once

#include <string>
#include <vector>

#include "head/head.hpp"

namespace mien {

// The worst of one measure on a head, and where.
struct Worst {
  double value = 0;
  std::string place;  // the cage's nearest point, and what else helps to find it
};

struct Soundness {
  bool has_adults_triangles = false;
  std::size_t crossings = 0;   // pairs of triangles
  std::string first_crossing;  // where
  std::size_t inverted = 0;    // triangles that are turned over against the adult's, the local turn apart
  std::string first_inverted;
  Worst angle_deg;              // smallest angle of a visible triangle
  Worst area_mm2;               // smallest area of a visible triangle
  Worst fold_deg;               // largest turn of the normal between neighbouring visible triangles
  Worst into_eye_mm;            // how far the lids' margin goes into ball or cornea
  Worst off_eye_mm;             // how far it stands off them, between the corners
  Worst lids_mm;                // smallest height of the upper lid above the lower one, between the corners
  Worst lips_mm;                // smallest height of the upper lip's inner rows above the lower one's
  std::size_t mirror_bits = 0;  // numbers of positions and normals that differ from their mirror image's
};

Soundness measure_soundness(const NeutralHead& head, const NeutralHead& adult);

// The vertices that can be seen while the mouth is shut: not the back of the lids and lips, not the inside of
// the nostrils, nor the very corner of the mouth, which is one shut fold.
std::vector<bool> find_visible(const NeutralHead& head);

// Whether each vertex is the middle of one fan of triangles, whole or, on a border, open.
bool is_manifold(const Mesh& mesh);

// The point of the cage that a vertex of the skin follows most.
std::string find_nearest_name(const NeutralHead& head, std::uint32_t vertex);

}  // namespace mien
