#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "commands/import_pose.hpp"
#include "commands/import_take.hpp"
#include "commands/report.hpp"
#include "config/load_spec.hpp"
#include "config/take_text.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "import/take_reading.hpp"
#include "import/vrm_avatar.hpp"
#include "render/work_folder.hpp"

namespace mien {

namespace {

// One of the avatar's expressions in our areas.
struct AvatarFace {
  std::string word;
  Pose pose;
  std::string aside;  // what of it we have no word for
};

struct AvatarFaces {
  std::vector<AvatarFace> faces;
  std::vector<std::string> unknown;  // neither by shape nor by name
  double moved_mm2 = 0, lost_mm2 = 0;

  double lost_percent() const { return moved_mm2 > 0 ? 100 * lost_mm2 / moved_mm2 : 0; }
};

// One row: what takes are judged by, it is judged by, too.
Take build_face_take(const VrmAvatar& avatar, std::string_view mapping) {
  Take take;
  take.file = avatar.file;
  take.mapping = mapping;
  take.at_s = {0};
  take.row_count = 1;
  return take;
}

void add_channel(Take& take, const std::string& name, double weight) {
  take.channels.push_back({name, 0, 0});
  take.values.push_back(static_cast<float>(weight));
}

// By its shapes where one of them at least is ARKit's, else by its own name; nothing for one that is neither.
std::optional<Take> build_expression_take(const VrmAvatar& avatar, const VrmExpression& expression,
                                          const MappingData& data) {
  Take by_shapes = build_face_take(avatar, "arkit");
  for (const VrmBind& bind : expression.binds) {
    const std::string name = build_arkit_name(bind.target);
    const bool is_new =
        std::ranges::find(by_shapes.channels, name, &TakeChannel::name) == by_shapes.channels.end();
    if (is_new && find_unit(find_mapping(data, "arkit"), name)) add_channel(by_shapes, name, bind.weight);
  }
  if (!by_shapes.channels.empty()) return by_shapes;
  const std::string name = expression.is_custom ? build_arkit_name(expression.name) : expression.name;
  if (!find_unit(find_mapping(data, "vrm"), name)) return std::nullopt;
  Take by_name = build_face_take(avatar, "vrm");
  add_channel(by_name, name, 1);
  return by_name;
}

std::string describe_aside(const VrmExpression& expression) {
  std::vector<std::string> words;
  for (const std::string& override : expression.overrides) words.push_back(override);
  if (expression.is_binary) words.emplace_back("nothing or all");
  return words.empty() ? "" : fmt::format("  # there: {}", fmt::join(words, ", "));
}

AvatarFaces build_faces(const VrmAvatar& avatar, const MappingData& data) {
  AvatarFaces faces;
  std::set<std::string> words{"neutral"};
  for (const VrmExpression& expression : avatar.expressions) {
    const auto take = build_expression_take(avatar, expression, data);
    if (!take) {
      faces.unknown.push_back(show_word(expression.name));
      continue;
    }
    const TakeMoves moves = retarget_take(*take, find_mapping(data, take->mapping), data.moves);
    faces.moved_mm2 += moves.report.moved_mm2;
    faces.lost_mm2 += moves.report.lost_mm2;
    AvatarFace face{build_expression_word(expression.name), {}, describe_aside(expression)};
    for (std::size_t i = 0; i < kMoveCount; ++i) face.pose.values[i] = static_cast<double>(moves.values[i]);
    if (words.insert(face.word).second) faces.faces.push_back(std::move(face));
  }
  return faces;
}

std::string build_faces_text(const AvatarFaces& faces, const Options& options,
                             const std::filesystem::path& output) {
  std::string text = fmt::format(
      "# What an avatar of VRM, {}, does with its face, in our areas.\nmien: 1\ntitle: {}\nexpressions:\n",
      show_word(options.file.filename().string()), build_name(output));
  for (const AvatarFace& face : faces.faces)
    text += fmt::format("  {}: {{{}}}{}\n", face.word, build_moves_text(face.pose), face.aside);
  text += "clip:\n  keys:\n    - {at: 0s, express: neutral}\n";
  for (std::size_t i = 0; i < faces.faces.size(); ++i)
    text += fmt::format("    - {{at: {}s, express: {}}}\n", i + 1, faces.faces[i].word);
  return text;
}

}  // namespace

void import_avatar(const Options& options) {
  const std::filesystem::path output = find_import_output(options);
  const LanguagePointer language = load_language(find_data_folder());
  const AvatarFaces faces = build_faces(load_vrm_avatar(options.file), *language->libraries.mappings);
  if (faces.faces.empty())
    throw InputError(
        fmt::format("{}: none of its expressions has a name or a shape that is known; expected "
                    "VRM's presets or ARKit's units",
                    options.file.string()));
  if (const auto most = options.take.strict_percent; most && faces.lost_percent() > *most)
    throw InputError(
        fmt::format("{}: {:.1f} % of the motion is lost; expected {:g} % at most, as --strict says",
                    options.file.string(), faces.lost_percent(), *most));
  remove_left_parts_of(output);
  write_file(output, build_faces_text(faces, options, output));
  if (options.is_json) {
    nlohmann::ordered_json object{{"kind", "avatar"},
                                  {"file", options.file.string()},
                                  {"expressions", faces.faces.size()},
                                  {"unknown", faces.unknown},
                                  {"moved_mm2", round_to(faces.moved_mm2, 4)},
                                  {"lost_mm2", round_to(faces.lost_mm2, 4)},
                                  {"lost_percent", round_to(faces.lost_percent(), 2)}};
    fmt::print("{}\n", format_object(object));
  } else if (!options.is_quiet) {
    fmt::print("{} expressions; lost: {:.1f} % of the motion, {:.3g} of {:.3g} mm2\n", faces.faces.size(),
               faces.lost_percent(), faces.lost_mm2, faces.moved_mm2);
    if (!faces.unknown.empty())
      fmt::print("not known, neither by name nor by shape: {}\n", fmt::join(faces.unknown, ", "));
  }
  report_result(options, "file", output);
}

}  // namespace mien
