// Where ink is light and where it is dark: the directions of the skin, smoothed so far that the border
// between its two tones is one calm line. They spread like heat for a while over the cage (Desbrun et al.,
// "Implicit Fairing of Irregular Meshes", 1999: one step, however fine the rings about eyes and mouth are)
// and come back to the skin as the subdivision surface of what the cage has then.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "frames/figure.hpp"

namespace mien {

struct InkTone;  // of one figure at rest; built once
using InkTonePointer = std::shared_ptr<const InkTone>;

struct InkToneBuffers {
  std::vector<Float4> points;
};

// Whether a point of the cage is one of the nose's bridge between the eyes, which neither has a tone of its
// own nor casts a shadow: below it the nose has one shade, of one form in every expression.
bool is_bridge(std::string_view point);

// How far the nose's tip stands out over the lip at rest, in mm of an adult's head. One that stands out less
// than that is a button, which has no shade and casts none.
inline constexpr float kButtonNose_mm = 7.4f;
float measure_nose_mm(const Figure& figure);

InkTonePointer build_ink_tone(const Figure& figure);

// For every vertex of the fine skin, whose unit normals are given: the direction that its tone is told by, of
// length 1. `turned` is 0 where the face is seen and 1 where one of its sides is, and a cheek behind a nose.
void compute_tones(const InkTone& tone, double turned, const std::vector<glm::vec3>& normals,
                   InkToneBuffers& buffers, std::vector<glm::vec3>& tones);

}  // namespace mien
