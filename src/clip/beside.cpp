#include "clip/beside.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "clip/pictures.hpp"
#include "config/findings.hpp"
#include "config/words.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "render/picture.hpp"
#include "render/process.hpp"

namespace mien {

Clip redesign_clip(const Clip& clip, const std::string& name, const std::vector<Design>& designs) {
  std::vector<std::string> names{kReal};
  for (const Design& design : designs) names.push_back(design.name);
  if (std::ranges::find(names, name) == names.end())
    throw InputError("--beside: " + describe_unknown("design", name, names));
  Clip part = clip;
  const Mix mix{{name, 1.0}};
  part.spec.head.design = mix;
  for (ActorSpec& actor : part.spec.actors) actor.head.design = mix;
  for (Actor& actor : part.actors) {
    actor.head.design = mix;
    for (HeadKey& key : actor.performance.clip.head) key.head.design = mix;
  }
  const auto design = std::ranges::find(designs, name, &Design::name);
  RenderSpec& render = part.spec.render;
  if (!render.is_style_given) render.style = design == designs.end() ? Style::studio : design->style;
  if (!render.is_background_given)
    render.background = render.style == Style::ink ? kInkGround : RenderSpec{}.background;
  part.files.folder = clip.files.folder / name;
  return part;
}

Clip widen_clip(const Clip& clip, std::size_t count) {
  Clip whole = clip;
  whole.spec.render.width_px *= static_cast<int>(count);
  return whole;
}

std::vector<std::string> join_keys(const std::vector<std::vector<std::string>>& parts) {
  std::vector<std::string> keys(parts.front().size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (const std::vector<std::string>& part : parts) keys[i] += part[i];
    keys[i] = hash_hex(keys[i]);
  }
  return keys;
}

void join_pictures(const std::vector<Clip>& parts, const Clip& whole, const std::vector<std::string>& keys) {
  const FramePlan& plan = whole.plan;
  const RenderSpec& render = whole.spec.render;
  for (std::size_t i = 0; i < plan.drawings.size(); ++i) {
    throw_if_interrupted();
    const int frame = plan.drawings[i];
    if (read_picture_key(whole.files.picture(frame)) == keys[i]) continue;
    Pixels page = make_pixels({render.width_px, render.height_px});
    int left_px = 0;
    for (const Clip& part : parts) {
      paste_pixels(page, read_pixels(part.files.picture(frame)), left_px, 0);
      left_px += part.spec.render.width_px;
    }
    write_file(whole.files.picture(frame), mark_picture(build_png(page), keys[i]));
  }
  repeat_pictures(whole);
}

}  // namespace mien
