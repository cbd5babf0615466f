// Freckles and age spots: soft brown patches that lie on the skin like decals and take of the light beneath
// them.
#pragma once

#include <string>
#include <vector>

#include "config/head_spec.hpp"
#include "head/binding.hpp"
#include "head/head.hpp"

namespace mien {

// One part "spots" (Mount::strands, material "spot", not printed), or none if both dials of `look` are 0. Its
// palette is what of the light a spot's middle lets through, in srgb; its grain is the way from there to the
// edge, 1 long, where all light passes. Each vertex is bound to its own place of the skin and lies
// kSpotLift_mm above it. Places are drawn on the adult, from a fixed seed
// and without mirror symmetry: a spot stays at its place of the skin on every head, and a higher dial adds
// spots to those of a lower one and darkens them. About 0.1 s. In ink freckles are few, round and all alike
// (material "ink_spot"), and age spots are none.
std::vector<HeadPart> build_skin_spots(const NeutralHead& head, const Look& look, bool is_ink = false);

// Spots of one kind where they lie on every head of a stock: what takes the time.
struct SpotPlaces {
  struct Spot {
    double strength = 1;
    std::vector<SkinPlace> places;  // of its vertices: the middle, then ring by ring
  };
  struct Kind {
    std::vector<Spot> spots;  // as many as a dial shows
  };
  std::vector<Kind> kinds;
};

// The places that a look's dials show; `name_spot_places` is the same for looks that have the same.
SpotPlaces list_spot_places(const NeutralHead& head, const Look& look, bool is_ink);
std::string name_spot_places(const Look& look, bool is_ink);

// The part on them.
std::vector<HeadPart> build_skin_spots(const SpotPlaces& places, const NeutralHead& head, const Look& look,
                                       bool is_ink);

// Lower and the smooth skin's facets come through on the nose, higher and a spot shows beside the silhouette.
inline constexpr float kSpotLift_mm = 0.10f;

}  // namespace mien
