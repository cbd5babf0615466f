#include "scene/povray_stage.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "scene/povray.hpp"
#include "scene/povray_quality.hpp"

namespace mien {

namespace {

// Of a scene whose frames say nothing of lights.
const char* get_own_lights(Style style) { return style == Style::ink ? "ink" : "studio"; }
constexpr int kShareDecimals = 6, kAngleDecimals = 4, kColourDecimals = 4;

std::string format_srgb(const glm::vec3& srgb) {
  return fmt::format("srgb <{}, {}, {}>", format_number(srgb.x, kColourDecimals),
                     format_number(srgb.y, kColourDecimals), format_number(srgb.z, kColourDecimals));
}

// Those of the style; the studio has no use for the others.
std::string list_materials(const Templates& templates, const RenderSpec& render) {
  std::string materials = find_template(templates, "povray/materials.inc").text;
  if (render.style != Style::studio) materials += find_template(templates, "povray/materials_drawn.inc").text;
  if (render.style == Style::ink && render.ink.shade)
    materials += fmt::format("#declare Shade_tint = {};\n", format_srgb(*render.ink.shade));
  return materials;
}

// templates/povray/light_moon.inc and the like.
const std::string& find_named(const Templates& templates, const char* kind, const std::string& name) {
  const std::string file = fmt::format("povray/{}_{}.inc", kind, name);
  const auto found = templates.find(file);
  if (found == templates.end())
    throw RunError(fmt::format("unknown {} '{}': templates/{} does not exist", kind, name, file));
  return found->second.text;
}

// The inside of a pigment.
std::string format_background(const BackgroundShare& background) {
  if (!background.colour) return fmt::format("background_{}(Location, Look_at)", background.name);
  return "color " + format_srgb(*background.colour);
}

}  // namespace

std::string build_povray_stage(const std::string& parts, const RenderSpec& render, const Templates& templates,
                               const StageSets& sets) {
  std::set<std::string> grounds = sets.backgrounds, lights = sets.lights;
  grounds.insert(render.background);
  lights.insert(get_own_lights(render.style));
  std::string light_sets = find_template(templates, "povray/lights.inc").text, backgrounds;
  for (const std::string& name : lights) light_sets += find_named(templates, "light", name);
  for (const std::string& name : grounds) backgrounds += find_named(templates, "background", name);
  const PovrayQuality settings = find_povray_quality(render.quality);
  return fill_template(templates, "povray/head.inc",
                       {{"key_samples", std::to_string(settings.light_samples)},
                        {"key_depth", std::to_string(settings.key_depth)},
                        {"materials", list_materials(templates, render)},
                        {"lights", light_sets},
                        {"background", backgrounds},
                        {"light", get_own_lights(render.style)},
                        {"ground", render.background},
                        {"parts", parts}});
}

// Their Turn goes to the picture's left, an author's angle to the character's.
void append_povray_lights(std::string& text, const std::vector<LightShare>& lights) {
  if (lights.empty()) return;
  text += "#macro frame_lights(Turn)\n";
  for (const LightShare& light : lights)
    text +=
        fmt::format("  light_{}(Turn + {}, {})\n", light.set, format_number(-light.angle_deg, kAngleDecimals),
                    format_number(light.bright, kShareDecimals));
  text += "#end\n";
}

void append_povray_background(std::string& text, const std::vector<BackgroundShare>& backgrounds) {
  if (backgrounds.empty()) return;
  text += "#macro frame_background(Location, Look_at)\n";
  if (backgrounds.size() == 1) {
    text += fmt::format("  {}\n", format_background(backgrounds.front()));
  } else {
    text += "  average pigment_map {\n";
    for (const BackgroundShare& background : backgrounds)
      text += fmt::format("    [{} {}]\n", format_number(background.share, kShareDecimals),
                          format_background(background));
    text += "  }\n";
  }
  text += "#end\n";
}

}  // namespace mien
