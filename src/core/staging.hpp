// How a picture is staged: what a writer of pictures is told besides the figures. config/ fills these in.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace mien {

enum class Quality { sketch, draft, good, best };

// How a picture is drawn: lit as in a studio, in ink, or as a plaster cast.
enum class Style { studio, ink, plaster };

// Ink's colours, srgb 0..1.
struct InkColours {
  glm::vec3 line{0.10f, 0.06f, 0.07f};
  glm::vec3 cavity{0.36f, 0.07f, 0.09f};  // within the mouth: dark, gums and all
  glm::vec3 flesh{0.80f, 0.30f, 0.30f};   // the tongue
  glm::vec3 bone{1, 0.985f, 0.95f};       // the teeth
  std::optional<glm::vec3> shade;         // what the lamp does not reach has its own colour times this
  std::optional<glm::vec3> blush;         // without one it is made from the skin's colour, as the design says
};

struct RenderSpec {
  int width_px = 480, height_px = 600;
  Quality quality = Quality::good;
  std::string background = "studio";  // a background of templates/povray
  Style style = Style::studio;
  double line = 1;  // how thick ink's lines are
  InkColours ink;
  bool is_background_given = false, is_style_given = false;
};

// Whether mien draws it itself instead of POV-Ray.
inline bool is_sketch(const RenderSpec& render) { return render.quality == Quality::sketch; }

// What lies behind ink where nothing is said of it.
inline constexpr const char* kInkGround = "sun";

// The background of pictures that are transparent where nobody is.
inline constexpr const char* kNoBackground = "none";
inline bool has_alpha(const RenderSpec& render) { return render.background == kNoBackground; }

// A lens for 24 x 36 film. Distance 1 frames the same with each: a short one comes near, so that the nose
// grows; a long one flattens the face.
inline constexpr double kPortraitLens_mm = 100;

// So much of a light set or background at a moment: of two, where one is faded into the other.
struct LightShare {
  std::string set = "studio";
  double bright = 1;     // brightness times share
  double angle_deg = 0;  // + brings the light round to the character's left
};
// What of a moment's lights ink takes: one lamp far off, and the colours that tones have by it, linear.
struct InkLamp {
  glm::dvec3 to_light{0, 0, 1};  // of length 1
  glm::vec3 lit{1}, dark{1};     // times what it reaches, and what it does not
  glm::vec3 flat{1};             // times what has one tone: eyes, teeth, tongue
};

struct BackgroundShare {
  std::string name = "studio";
  std::optional<glm::vec3> colour;  // instead of a named one; srgb 0..1
  double share = 1;                 // of all, which sum to 1
};

}  // namespace mien
