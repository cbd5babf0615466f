// The mouth of a print: a hollow behind the lips in which teeth and tongue stand as relief, without
// undercuts. The same formula, with the same numbers (core/print_numbers.hpp), stands in
// templates/openscad/bust.scad.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "core/model.hpp"
#include "core/print.hpp"
#include "frames/bust_patch.hpp"

namespace mien {

inline constexpr int kToothSamples = 91;     // across both cheeks' sides, x rising
inline constexpr float kToothReach_mm = 27;  // the first at -27 mm, the last at 27

// The biting edge of a row of teeth at each sample, and a place of their front a little further to the gums.
struct ToothRow {
  std::array<glm::vec2, kToothSamples> edge{}, front{};  // y and z, mm; z is kNoTooth_mm where there is none
};

// A tongue as an ellipsoid, in the jaw's rest place.
struct TongueMound {
  glm::vec3 centre{0}, radius{0};  // radius 0: none
};

struct CarvedMouth {
  ToothRow upper, lower;  // at rest
  TongueMound tongue;
  float line_mm = 2;  // depth of closed lips' line
};

// Teeth and tongue of the figure's parts at rest.
CarvedMouth build_carved_mouth(const Model& model);

// The mouth with its jaw moved: `jaw` is world from rest, a turn about an axis along x and a shift in the
// mid-plane.
CarvedMouth move_jaw(const CarvedMouth& mouth, const glm::mat4& jaw);

// A vertex of the mouth's patch.
glm::vec3 place_in_mouth(const CarvedMouth& mouth, const PatchPlace& at);

}  // namespace mien
