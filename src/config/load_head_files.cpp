#include <fmt/format.h>
#include <algorithm>

#include "config/constants.hpp"
#include "config/head_files.hpp"
#include "config/named_file.hpp"
#include "config/sections.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

// "a.yaml mixes b.yaml mixes a.yaml", from where the circle begins.
std::string describe_circle(const std::vector<fs::path>& chain, const fs::path& again) {
  std::string circle;
  for (auto file = std::ranges::find(chain, again); file != chain.end(); ++file)
    circle += file->filename().string() + " mixes ";
  return circle + again.filename().string();
}

// The head of the file that `name` names at `spot`. Its other sections are not looked at.
bool load_other_head(const YamlValue& value, const std::string& name, Spot spot, const HeadSource& source,
                     HeadSpec& head) {
  const auto report = [&](const std::string& message) {
    add_mistake(*value.findings, value.document->source, spot, message);
    return false;
  };
  fs::path path;
  const std::string fault = find_file_fault(name, find_folder(value), kYamlEndings, path);
  if (!fault.empty()) return report(fault);
  HeadSource inner = source;
  inner.chain.push_back(find_canonical(path));
  if (std::ranges::find(source.chain, inner.chain.back()) != source.chain.end())
    return report(fmt::format("heads mix each other in a circle: {}; expected none",
                              describe_circle(source.chain, inner.chain.back())));
  if (inner.chain.size() > static_cast<std::size_t>(kMaxMixDepth) + 1)
    return report(fmt::format("heads are mixed more than {} deep; expected fewer", kMaxMixDepth));
  if (++source.counts->mixed > kMaxMixedHeads)
    return report(fmt::format("more than {} heads are mixed; expected fewer", kMaxMixedHeads));
  Findings& findings = *value.findings;
  if (!has_room(value, spot, path)) return false;
  auto text = load_named_source(path, kMienFile, findings);
  const auto document = text ? scan_document(std::move(*text), findings) : std::nullopt;
  if (!document) return false;
  YamlValue root = find_root(*document, findings);
  root.constants = build_file_constants(root, {});
  const YamlMapping entries = load_section(root, find_sections().file);
  check_version(root, entries);
  if (const YamlValue* other = find_value(entries, "head")) head = load_head(*other, inner);
  return true;
}

void mix_looks(HeadSpec& head) {
  Look sum;
  sum.skin = sum.iris = sum.brow = sum.hair = glm::vec3(0);
  glm::vec3 lips{0};
  float lips_weight = 0;
  for (const auto& [other, share] : head.mix) {
    const auto weight = static_cast<float>(share);
    sum.skin += weight * other.look.skin;
    sum.iris += weight * other.look.iris;
    const Look aged = compute_aged_look(other.look, other.age);
    sum.brow += weight * aged.brow;
    sum.hair += weight * aged.hair;
    sum.is_brow_given = sum.is_brow_given || aged.is_brow_given;
    sum.is_hair_given = sum.is_hair_given || aged.is_hair_given;
    sum.are_age_spots_given = sum.are_age_spots_given || aged.are_age_spots_given;
    sum.freckles += share * other.look.freckles;
    sum.age_spots += share * aged.age_spots;
    if (!other.look.lips) continue;  // made from the skin's colour then, which is mixed
    lips += weight * *other.look.lips;
    lips_weight += weight;
  }
  // Whoever has most of it says whether there is a beard, and a painted skin.
  const auto most = std::ranges::max_element(head.mix, {}, &HeadShare::weight);
  if (most != head.mix.end()) {
    sum.beard = most->head.look.beard;
    sum.texture = most->head.look.texture;
  }
  if (lips_weight > 0) sum.lips = lips / lips_weight;
  head.look = sum;
}

// A head that says nothing of a limit has its own.
void mix_limits(HeadSpec& head) {
  for (const HeadShare& named : head.mix)
    for (const auto& [name, ignored] : named.head.limits) {
      double sum = 0;
      for (const auto& [other, share] : head.mix) {
        const auto limit = other.limits.find(name);
        sum += share * (limit == other.limits.end() ? 1 : limit->second);
      }
      head.limits[name] = sum;
    }
  // Lengths are those of whoever has most of it.
  const auto most = std::ranges::max_element(head.mix, {}, &HeadShare::weight);
  if (most != head.mix.end()) {
    head.limit_lengths = most->head.limit_lengths;
    head.match_level = most->head.match_level;
  }
}

// "ch_l" to "ch"; false if no such place is known.
bool find_bare_place(const HeadWords& words, std::string& place, bool& is_middle) {
  is_middle = std::ranges::find(words.middle, place) != words.middle.end();
  if (is_middle || std::ranges::find(words.sided, place) != words.sided.end()) return true;
  if (!place.ends_with("_l") && !place.ends_with("_r")) return false;
  const std::string bare = place.substr(0, place.size() - 2);
  if (std::ranges::find(words.sided, bare) == words.sided.end()) return false;
  place = bare;
  return true;
}

// Notes that the landmarks beside a mesh will be read; false if there are none.
bool note_landmark_file(const YamlValue& value, const fs::path& mesh) {
  const auto landmarks = find_landmark_file(mesh);
  if (landmarks) value.findings->files.push_back(*landmarks);
  return landmarks.has_value();
}

// Different scans only: one that several heads name is wrapped once.
void count_scan(const YamlValue& value, const HeadSource& source, const fs::path& mesh) {
  source.counts->scans.insert(find_canonical(mesh));
  if (source.counts->scans.size() == kMaxScans + 1)
    add_mistake(value, fmt::format("more than {} different scans; expected fewer", kMaxScans));
}

}  // namespace

std::optional<fs::path> find_landmark_file(const fs::path& mesh) {
  for (const char* ending : {".landmarks.yaml", ".yaml"}) {
    const fs::path file = fs::path(mesh).replace_extension(ending);
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored)) return file;
  }
  return std::nullopt;
}

std::string describe_mesh_state(const fs::path& mesh) {
  const auto describe = [](const fs::path& file) {
    std::error_code error;
    const auto written = fs::last_write_time(file, error).time_since_epoch().count();
    const fs::path canonical = fs::weakly_canonical(file, error);
    return fmt::format("{}\n{} {}\n", canonical.string(), fs::file_size(file, error), written);
  };
  const auto landmarks = find_landmark_file(mesh);
  return describe(mesh) + (landmarks ? describe(*landmarks) : "");
}

void load_mesh(const YamlValue& value, const HeadSource& source, std::optional<FileReference>& into) {
  if (load_file(value, into) && note_landmark_file(value, into->path)) count_scan(value, source, into->path);
}

void load_scan(const YamlValue& value, const HeadSource& source, std::optional<FileReference>& into) {
  if (!load_file(value, into)) return;
  if (note_landmark_file(value, into->path)) return count_scan(value, source, into->path);
  add_mistake(
      value,
      fmt::format("'{}' has no landmarks beside it; expected a file '{}' such as landmarks: {{prn: [x, "
                  "y, z], ...}}",
                  show_word(into->path.filename().string()),
                  show_word(fs::path(into->path).replace_extension(".yaml").filename().string())));
}

bool load_head_file(const YamlValue& value, const HeadSource& source, HeadSpec& head) {
  std::string name;
  return load_text(value, "a file that ends in .yaml", name) &&
         load_other_head(value, name, value.spot, source, head);
}

void load_head_mix(const YamlValue& value, const HeadSource& source, HeadSpec& head) {
  constexpr const char* kExpected = "files and weights such as {anna.yaml: 0.5, bert.yaml: 0.5}";
  const YamlMapping entries = load_free_mapping(value, kExpected);
  if (find_node(value).kind == NodeKind::mapping && entries.empty())
    add_mistake(value, fmt::format("{} names no file; expected {}", describe_subject(value), kExpected));
  double sum = 0;
  for (const YamlEntry& entry : entries) {
    HeadShare share;
    const bool is_file = load_other_head(entry.value, entry.key, entry.spot, source, share.head);
    if (!load_number(entry.value, share.weight)) continue;
    if (share.weight == 0)
      add_mistake(entry.value,
                  describe_subject(entry.value) + " is 0; expected a weight above 0, or no such key");
    if (!is_file || share.weight == 0) continue;
    sum += share.weight;
    head.mix.push_back(std::move(share));
  }
  if (head.mix.empty()) return;
  for (HeadShare& share : head.mix) share.weight /= sum;
  mix_looks(head);
  mix_limits(head);
}

void load_sculpt(const YamlValue& value, const HeadSource& source, std::vector<SculptStroke>& into) {
  const HeadWords& words = *source.words;
  for (const YamlValue& item : load_list(value, "a list such as [{at: chin, move: [0, -2mm, 3mm]}]")) {
    if (++source.counts->strokes > kMaxStrokes)
      return add_mistake(item, fmt::format("more than {} strokes of 'sculpt'; expected fewer", kMaxStrokes));
    const YamlMapping entries = load_section(item);
    SculptStroke stroke;
    const YamlValue* at = find_required(entries, "at", item, "a place of the head such as chin");
    const YamlValue* move = find_value(entries, "move");
    const YamlValue* turn = find_value(entries, "turn");
    const YamlValue* about = find_value(entries, "about");
    if (find_node(item).kind == NodeKind::mapping && move == nullptr && turn == nullptr &&
        find_value(entries, "scale") == nullptr)
      add_mistake(item, "the stroke does nothing; expected one of move, scale and turn");
    bool is_middle = false;
    if (at != nullptr && load_text(*at, "a place of the head such as chin", stroke.at) &&
        !find_bare_place(words, stroke.at, is_middle))
      add_mistake(*at, describe_unknown("place", stroke.at, list_places(words)));
    if (move != nullptr && load_lengths(*move, stroke.move_mm) && is_middle && stroke.move_mm.x != 0)
      add_mistake(*move,
                  fmt::format("'{}' lies in the middle and moves {:.7g}mm aside; expected 0, as one half "
                              "is the mirror image of the other",
                              stroke.at, stroke.move_mm.x));
    if (const YamlValue* scale = find_value(entries, "scale")) load_number(*scale, stroke.scale);
    if (turn != nullptr) load_angle(*turn, stroke.turn_deg);
    if (about != nullptr && turn == nullptr)
      add_mistake(*about, "'about' stands without 'turn'; expected both");
    if (about != nullptr && load_name(*about, stroke.about) && is_middle && stroke.about != "x")
      add_mistake(
          *about,
          fmt::format(
              "'{}' lies in the middle and turns about {}; expected x, as one half is the mirror image "
              "of the other",
              stroke.at, stroke.about));
    if (const YamlValue* radius = find_value(entries, "radius")) load_length(*radius, stroke.radius_mm);
    into.push_back(std::move(stroke));
  }
}

}  // namespace mien
