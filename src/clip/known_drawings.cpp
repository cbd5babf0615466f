#include "clip/known_drawings.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "timeline/bytes.hpp"
#include "timeline/drawings.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

// Of this program and of all that it reads of its own.
std::string hash_program() {
  std::error_code ignored;
  std::string all = hash_hex(read_file("/proc/self/exe"));  // there even if the file has been replaced
  std::vector<fs::path> files;
  for (const char* folder : {"templates", "configs/expressions"})
    for (const auto& entry : fs::recursive_directory_iterator(find_data_folder() / folder, ignored))
      if (entry.is_regular_file(ignored)) files.push_back(entry.path());
  std::ranges::sort(files);
  for (const fs::path& file : files) all += file.filename().string() + hash_hex(read_file(file));
  return hash_hex(all);
}

std::string describe_framing(const Framing& framing) {
  std::string bytes;
  for (const double value : {framing.chin_mm, framing.crown_mm, framing.top_mm, framing.floor_mm})
    append_bytes(bytes, value);
  for (const glm::vec3& point : framing.points) append_bytes(bytes, point);
  for (const auto& [name, place] : framing.places) {
    bytes += name.first + '/' + name.second + ' ';
    for (int axis = 0; axis < 3; ++axis) append_bytes(bytes, place[axis]);
  }
  return hash_hex(bytes);
}

std::string describe_place(const PlaceSpec& place) {
  std::string bytes;
  for (int axis = 0; axis < 3; ++axis) append_bytes(bytes, place.at_mm[axis]);
  append_bytes(bytes, place.turn_deg);
  return bytes;
}

// What all of the clip's drawings are made from.
std::string describe_clip(const SceneRun& run) {
  static const std::string kProgram = hash_program();
  const RenderSpec& render = run.clip.spec.render;
  std::string all = kProgram + run.key + describe_framing(run.cast.framing);
  append_bytes(all, render.line);
  for (const Actor& actor : run.clip.actors) all += describe_place(actor.place);
  return all;
}

// A line of the file: both, and what the two of them are told by.
std::string describe_known_drawing(const std::string& origin, const std::string& key) {
  const std::string both = origin + " " + key;
  return both + " " + hash_hex(both) + "\n";
}

}  // namespace

std::vector<std::string> list_origins(const SceneRun& run) {
  const Clip& clip = run.clip;
  const std::string of_clip = describe_clip(run);
  std::vector<std::vector<std::string>> everybody;  // frame by frame
  for (const Performance* performance : list_players(clip))
    everybody.push_back(list_drawing_keys(*performance));
  std::map<std::size_t, std::string> heads;  // by group
  std::vector<std::string> origins;
  for (std::size_t drawing = 0; drawing < clip.plan.drawings.size(); ++drawing) {
    const int frame = clip.plan.drawings[drawing] - 1;
    const double time_s = compute_drawing_time_s(clip.spec.clip, frame);
    std::string& head = heads[run.groups.group[drawing]];
    if (head.empty())
      for (const Actor& actor : clip.actors)
        head += compute_figure_key(compute_head(actor, time_s), clip.spec.render, actor.name);
    std::string all = of_clip + head + compute_stage_key(sample_stage(clip.spec.clip, time_s));
    for (const std::vector<std::string>& keys : everybody) all += keys.at(static_cast<std::size_t>(frame));
    origins.push_back(hash_hex(all));
  }
  return origins;
}

KnownDrawings read_known_drawings(const PictureStore& store) {
  KnownDrawings known;
  std::error_code ignored;
  const fs::path file = store.folder / kKnownDrawings;
  if (!fs::is_regular_file(file, ignored)) return known;
  std::istringstream lines;
  try {
    lines.str(read_file(file));
  } catch (const RunError&) {
    return known;
  }
  // A line that is not word for word what would be written is damaged: it might name another's picture.
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string origin, key;
    words >> origin >> key;
    if (is_stored_file(origin + ".png") && is_stored_file(key + ".png") &&
        line + "\n" == describe_known_drawing(origin, key))
      known[origin] = key;
  }
  return known;
}

void write_known_drawings(const PictureStore& store, const KnownDrawings& known,
                          const std::vector<std::string>& in_use) {
  if (known.empty()) return;
  const std::set<std::string> used(in_use.begin(), in_use.end());
  std::string text;
  std::error_code ignored;
  for (const auto& [origin, key] : known)
    if (used.contains(key) || fs::exists(store.picture(key), ignored))
      text += describe_known_drawing(origin, key);
  const fs::path file = store.folder / kKnownDrawings;
  if (fs::is_regular_file(file, ignored) && read_file(file) == text) return;
  try {
    write_file(file, text);
  } catch (const RunError&) {
  }
}

}  // namespace mien
