#include "scene/povray_stage.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "scene/povray.hpp"
#include "scene/povray_quality.hpp"

namespace mien {

namespace {

constexpr const char* kOwnLights = "studio";  // of a scene whose frames say nothing of lights
constexpr int kShareDecimals = 6, kAngleDecimals = 4, kColourDecimals = 4;

// templates/povray/light_moon.inc and the like.
std::string read_named(const std::filesystem::path& folder, const char* kind, const std::string& name) {
  const std::filesystem::path file = folder / fmt::format("{}_{}.inc", kind, name);
  if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") != std::string::npos ||
      !std::filesystem::exists(file))
    throw RunError(fmt::format("unknown {} '{}': {} does not exist", kind, name, file.string()));
  return read_file(file);
}

// The inside of a pigment.
std::string format_background(const BackgroundShare& background) {
  if (!background.colour) return fmt::format("background_{}(Location, Look_at)", background.name);
  const glm::vec3& srgb = *background.colour;
  return fmt::format("color srgb <{}, {}, {}>", format_number(srgb.x, kColourDecimals),
                     format_number(srgb.y, kColourDecimals), format_number(srgb.z, kColourDecimals));
}

}  // namespace

std::string build_povray_stage(const std::string& parts, const RenderSpec& render,
                               const std::filesystem::path& templates_folder, const StageSets& sets) {
  const std::filesystem::path folder = templates_folder / "povray";
  std::set<std::string> grounds = sets.backgrounds, lights = sets.lights;
  grounds.insert(render.background);
  lights.insert(kOwnLights);
  std::string light_sets = read_file(folder / "lights.inc"), backgrounds;
  for (const std::string& name : lights) light_sets += read_named(folder, "light", name);
  for (const std::string& name : grounds) backgrounds += read_named(folder, "background", name);
  const PovrayQuality settings = find_povray_quality(render.quality);
  const std::filesystem::path frame = folder / "head.inc";
  return fill_template(read_file(frame),
                       {{"key_samples", std::to_string(settings.light_samples)},
                        {"key_depth", std::to_string(settings.key_depth)},
                        {"materials", read_file(folder / "materials.inc")},
                        {"lights", light_sets},
                        {"background", backgrounds},
                        {"light", kOwnLights},
                        {"ground", render.background},
                        {"parts", parts}},
                       frame.string());
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
