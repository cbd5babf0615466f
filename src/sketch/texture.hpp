// Materials of templates/povray as numbers: what a texture { } gives at a place of a surface.
//
// Source: POV-Ray 3.7 reference manual, 3.4.6 (pigments, finishes, patterns).
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "sketch/sdl.hpp"

namespace mien {

// Linear. Of what lies behind, `filter` comes through in the colour and `transmit` as it is.
struct SketchColour {
  glm::vec3 rgb{0};
  float filter = 0, transmit = 0;
};

// A place that a pattern is asked at: of a surface, or a direction of the sky.
struct SketchPlace {
  glm::vec3 at{0};     // in POV-Ray's space
  glm::vec2 grain{0};  // mm on the skin or hair; of a part without one 0
  glm::vec3 normal{0};
};

enum class SketchPattern { plain, gradient, bozo, spherical, slope, function, average };

struct SketchPigment;

struct SketchStop {
  float at = 0;  // a value of the pattern; of `average` a weight
  SketchColour colour;
  std::shared_ptr<const SketchPigment> pigment;  // instead of the colour; or null
};

struct SketchPigment {
  SketchPattern pattern = SketchPattern::plain;
  SketchColour colour;  // of a plain one
  glm::vec3 axis{0};
  float low = 0, high = 1;  // of slope
  SdlFunction function;
  std::vector<SketchStop> stops;
  bool is_on_grain = false;
  glm::mat4x3 pattern_from_place{1};
};

struct SketchFinish {
  float diffuse = 0, brilliance = 1, specular = 0, roughness = 0.05f, phong = 0, phong_size = 40,
        metallic = 0, reflection = 0;
  glm::vec3 emission{0};
};

// Small hills that only bend light.
struct SketchBumps {
  float depth = 0;
  bool is_on_grain = false;
  glm::mat4x3 pattern_from_place{1};
};

struct SketchTexture {
  SketchPigment pigment;
  SketchFinish finish;
  SketchBumps bumps;
  // Instead of all that: others, by a pattern, each from its value on.
  SketchPigment choice;
  std::vector<float> from;
  std::vector<SketchTexture> others;
};

// "scale", "translate" or "rotate" (degrees; about x, then y, then z) by a vector.
glm::dmat4 build_transform(std::string_view word, const glm::dvec3& v);

// Of texture { }, pigment { } as they were read. Throw RunError on a word that is not known here.
SketchTexture build_sketch_texture(const SdlBlock& block);
SketchPigment build_sketch_pigment(const SdlBlock& block);

SketchColour sample_pigment(const SketchPigment& pigment, const SketchPlace& place);

// The texture that holds at a place: itself, or one of the others.
const SketchTexture& find_texture(const SketchTexture& texture, const SketchPlace& place);

// The normal as bumps bend it; of unit length.
glm::vec3 bend_normal(const SketchBumps& bumps, const SketchPlace& place);

}  // namespace mien
