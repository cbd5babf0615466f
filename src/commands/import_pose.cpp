#include "commands/import_pose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "commands/import_take.hpp"
#include "commands/report.hpp"
#include "config/load_spec.hpp"
#include "config/take_text.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "import/unit_pose.hpp"
#include "render/work_folder.hpp"

namespace mien {

namespace {

void print_pose_report(const TakeReport& report) {
  fmt::print("lost: {:.1f} % of the motion, {:.3g} of {:.3g} mm2\n", report.lost_percent(), report.lost_mm2,
             report.moved_mm2);
  for (const UnitLoss& loss : report.losses)
    fmt::print("  {:18} {:.3g} of {:.3g} mm2\n", loss.unit, loss.lost_mm2, loss.moved_mm2);
  for (const TakeHeld& held : report.held)
    fmt::print("  {:18} asked for {:.2f}; held at its limit\n", name_move(held.move), held.most);
}

}  // namespace

std::string build_expression_word(std::string word) {
  for (char& c : word)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
  if (word.empty() || std::isalpha(static_cast<unsigned char>(word.front())) == 0) word.insert(0, "face_");
  word.resize(std::min(word.size(), kMaxExpressionName));
  return word;
}

void import_pose(const Options& options) {
  const std::filesystem::path output = find_import_output(options);
  const LanguagePointer language = load_language(find_data_folder());
  const MappingData& data = *language->libraries.mappings;
  const UnitPose pose = load_unit_pose(options.file);
  const TakeMoves moves = retarget_take(build_unit_take(pose), find_mapping(data, pose.mapping), data.moves);
  if (const auto most = options.take.strict_percent; most && moves.report.lost_percent() > *most)
    throw InputError(
        fmt::format("{}: {:.1f} % of the motion is lost; expected {:g} % at most, as --strict says",
                    options.file.string(), moves.report.lost_percent(), *most));
  Pose posed;
  for (std::size_t i = 0; i < kMoveCount; ++i) posed.values[i] = static_cast<double>(moves.values[i]);
  const std::string word = build_expression_word(pose.name.empty() ? build_name(options.file) : pose.name);
  const std::string text = fmt::format(
      "# An expression of another program, {}, in our areas.\nmien: 1\ntitle: {}\nexpressions:\n  {}: "
      "{{{}}}\n"
      "clip:\n  keys:\n    - {{at: 0s, express: neutral}}\n    - {{at: 0.6s, express: {}}}\n",
      show_word(options.file.filename().string()), build_name(output), word, build_moves_text(posed), word);
  remove_left_parts_of(output);
  write_file(output, text);
  if (options.is_json) {
    nlohmann::ordered_json object{{"kind", "pose"},
                                  {"file", options.file.string()},
                                  {"expression", word},
                                  {"moved_mm2", round_to(moves.report.moved_mm2, 4)},
                                  {"lost_mm2", round_to(moves.report.lost_mm2, 4)},
                                  {"lost_percent", round_to(moves.report.lost_percent(), 2)}};
    fmt::print("{}\n", format_object(object));
  } else if (!options.is_quiet) {
    print_pose_report(moves.report);
  }
  report_result(options, "file", output);
}

}  // namespace mien
