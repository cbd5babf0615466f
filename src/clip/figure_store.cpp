#include "clip/figure_store.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "config/head_files.hpp"
#include "core/text.hpp"
#include "timeline/head_track.hpp"

namespace mien {

namespace {

// Where it is named belongs to it: messages say so.
std::string describe_file(const FileReference& file) {
  return fmt::format("{} {}:{};", describe_mesh_state(file.path), file.place.line, file.place.column);
}

std::string describe_head(const HeadSpec& head) {
  std::string all = compute_head_key(head) + head.hair + ';';
  for (const auto& [name, share] : head.limits) all += fmt::format("{} {};", name, share);
  for (const auto& [name, length] : head.limit_lengths)
    all += fmt::format("{} {}{} {}:{};", name, length.value, length.unit, length.place.line,
                       length.place.column);
  if (head.match_level) all += fmt::format("level {}{};", head.match_level->value, head.match_level->unit);
  if (head.follows_thesis) all += "rules thesis;";
  for (const SculptStroke& stroke : head.sculpt)
    all += fmt::format("{} {} {} {} {} {} {}{};", stroke.at, stroke.move_mm.x, stroke.move_mm.y,
                       stroke.move_mm.z, stroke.radius_mm, stroke.scale, stroke.turn_deg, stroke.about);
  const Look& look = head.look;
  all += fmt::format("{}{}{};", look.is_brow_given, look.is_hair_given, look.are_age_spots_given);
  if (look.texture) all += "texture " + describe_file(*look.texture);
  if (head.mesh) all += "mesh " + describe_file(*head.mesh);
  if (head.scan) all += "scan " + describe_file(*head.scan);
  for (const HeadShare& share : head.mix)
    all += fmt::format("({} {})", share.weight, describe_head(share.head));
  return all;
}

std::string describe_colours(const InkColours& ink) {
  std::string all;
  for (const glm::vec3& colour : {ink.line, ink.cavity, ink.flesh, ink.bone,
                                  ink.shade.value_or(glm::vec3(-1)), ink.blush.value_or(glm::vec3(-1))})
    all += fmt::format("{},{},{};", colour.r, colour.g, colour.b);
  return all;
}

}  // namespace

std::string compute_figure_key(const HeadSpec& head, const RenderSpec& render, const std::string& actor) {
  return hash_hex(fmt::format("{} {} {} {}", describe_head(head), static_cast<int>(render.style),
                              describe_colours(render.ink), actor));
}

FigurePointer take_figure(FigureStore& store, const std::string& key,
                          const std::function<FigurePointer()>& build) {
  {
    const std::lock_guard lock(store.mutex);
    const auto found = std::ranges::find(store.kept, key, &FigureStore::Kept::key);
    if (found != store.kept.end()) {
      store.kept.splice(store.kept.begin(), store.kept, found);
      return store.kept.front().figure;
    }
  }
  FigurePointer figure = build();
  const std::lock_guard lock(store.mutex);
  if (std::ranges::find(store.kept, key, &FigureStore::Kept::key) == store.kept.end())
    store.kept.push_front({key, figure});
  while (store.kept.size() > store.most) store.kept.pop_back();
  return figure;
}

}  // namespace mien
