// Hair by hair: what brows and lashes have in common. Each hair is a small rigid tube bound to the skin at
// its root.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "config/part_numbers.hpp"
#include "head/binding.hpp"
#include "head/head.hpp"

namespace mien {

inline constexpr int kHairSides = 3;   // a hair is thinner than a pixel
inline constexpr int kHairShades = 6;  // of one head of hair, dark to light

HeadPart make_hair_part(const std::string& name);

// kHairShades of one colour from dark to light, a little warmer as they lighten.
std::vector<Shade> make_hair_palette(const glm::vec3& colour, float spread, float gloss);

// Binds the vertices that `part` gained since its last binding, and gives them `shade`: a ring of kHairSides
// vertices to each place, what is left to the last one. A hair that stands has one place, its root; one that
// lies on the skin has one a ring and bends with it.
void finish_hair(HeadPart& part, const std::vector<SkinPlace>& places, std::uint16_t shade);

// A flat hair that ends in a point, with one normal: two vertices at its foot, two half way, one at its tip.
// Returns the first one's index.
std::uint32_t append_blade(const std::array<glm::vec3, 5>& places, const glm::vec3& normal, Mesh& mesh);

// The left ones; `youth` is 0 for an adult's hair, 1 for an infant's down.
HeadPart build_brow(const NeutralHead& head, const BrowNumbers& numbers, const Look& look, double youth);
// What both brows are from afar: how dense, 0..1 a vertex of the skin; mirror images have the same.
std::vector<float> paint_brows(const NeutralHead& head, const BrowNumbers& numbers);
HeadPart build_lashes(const NeutralHead& head, const PartNumbers& numbers, const Look& look, double youth);

}  // namespace mien
