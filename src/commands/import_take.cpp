#include "commands/import_take.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "clip/outputs.hpp"
#include "commands/report.hpp"
#include "config/ledger.hpp"
#include "config/load_spec.hpp"
#include "config/load_takes.hpp"
#include "config/take_text.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "render/work_folder.hpp"

namespace mien {

namespace {

constexpr double kKeys_mm = 0.5;        // what an eye sees of a head on a screen
constexpr std::size_t kMostLines = 12;  // of a list in a report; more are counted

std::string_view find_take_track(TakeKind kind) {
  for (const std::string_view key : {"live_link", "arkit", "openface", "openfacefx", "vrma", "gltf"})
    if (find_take_key(key) == kind) return key;
  return "";
}

std::string format_time(double at_s) { return fmt::format("{:.2f}s", at_s); }

// "cheekPuff   4.1 %  up to 0.9 at 3.20s, from 3.05s to 3.90s".
std::string describe_loss(const UnitLoss& loss, const TakeReport& report) {
  const std::string share =
      loss.moved_mm2 > 0
          ? fmt::format("{:5.1f} %", report.moved_mm2 > 0 ? 100 * loss.lost_mm2 / report.moved_mm2 : 0)
          : "no skin";
  return fmt::format("  {:18} {}  up to {:.2f} at {}, from {} to {}", loss.unit, share, loss.most,
                     format_time(loss.most_s), format_time(loss.from_s), format_time(loss.to_s));
}

template <typename Things, typename Describe>
void print_lines(const Things& things, const Describe& describe) {
  for (std::size_t i = 0; i < std::min(things.size(), kMostLines); ++i)
    fmt::print("{}\n", describe(things[i]));
  if (things.size() > kMostLines) fmt::print("  and {} more\n", things.size() - kMostLines);
}

void print_report(const Options& options, const Take& take, const TakeMoves& moves, std::size_t key_count,
                  double keys_mm) {
  const TakeReport& report = moves.report;
  fmt::print("{}: {} rows, {}{}; {} keys, {:.2g} mm from it at most\n", options.file.string(), take.row_count,
             format_time(take.end_s), take.start.empty() ? "" : " from " + take.start, key_count, keys_mm);
  if (report.moved_mm2 > 0)
    fmt::print("lost: {:.1f} % of the motion, {:.3g} of {:.3g} mm2", report.lost_percent(), report.lost_mm2,
               report.moved_mm2);
  else
    fmt::print("lost: nothing of the skin's motion");
  if (report.worst_mm2 > 0)
    fmt::print("; most from {} on, {:.3g} mm2", format_time(report.worst_s), report.worst_mm2);
  fmt::print("\n");
  print_lines(report.losses, [&](const UnitLoss& loss) { return describe_loss(loss, report); });
  if (!report.held.empty()) fmt::print("held at their limits:\n");
  print_lines(report.held, [](const TakeHeld& held) {
    return fmt::format("  {:18} asked for {:.2f} at {}, {} row{}", name_move(held.move), held.most,
                       format_time(held.most_s), held.rows, held.rows == 1 ? "" : "s");
  });
  if (!report.gaps.empty() || take.unseen_count > 0)
    fmt::print("bridged: {} gap{}, {} row{} without a face\n", report.gaps.size(),
               report.gaps.size() == 1 ? "" : "s", take.unseen_count, take.unseen_count == 1 ? "" : "s");
  print_lines(report.gaps, [](const TakeGap& gap) {
    return fmt::format("  from {} to {}", format_time(gap.from_s), format_time(gap.to_s));
  });
  if (!report.passed.empty()) fmt::print("passed, no units of a face:\n");
  print_lines(report.passed, [](const std::string& name) { return "  " + show_word(name); });
  if (take.repeated_count > 0)
    fmt::print("passed: {} rows at the time of the one before\n", take.repeated_count);
}

void print_json(const Options& options, const Take& take, const TakeMoves& moves, std::size_t key_count,
                double keys_mm) {
  const TakeReport& report = moves.report;
  nlohmann::ordered_json object{{"kind", "take"},
                                {"file", options.file.string()},
                                {"rows", take.row_count},
                                {"seconds", round_to(take.end_s, 3)},
                                {"keys", key_count},
                                {"keys_mm", round_to(keys_mm, 3)},
                                {"moved_mm2", round_to(report.moved_mm2, 4)},
                                {"lost_mm2", round_to(report.lost_mm2, 4)},
                                {"lost_percent", round_to(report.lost_percent(), 2)},
                                {"worst_s", round_to(report.worst_s, 3)},
                                {"unseen", take.unseen_count},
                                {"repeated", take.repeated_count},
                                {"passed", report.passed}};
  object["losses"] = object["held"] = object["gaps"] = nlohmann::ordered_json::array();
  for (const UnitLoss& loss : report.losses)
    object["losses"].push_back({{"unit", loss.unit},
                                {"moved_mm2", round_to(loss.moved_mm2, 4)},
                                {"lost_mm2", round_to(loss.lost_mm2, 4)},
                                {"most", round_to(loss.most, 3)},
                                {"at_s", round_to(loss.most_s, 3)},
                                {"from_s", round_to(loss.from_s, 3)},
                                {"to_s", round_to(loss.to_s, 3)}});
  for (const TakeHeld& held : report.held)
    object["held"].push_back({{"move", name_move(held.move)},
                              {"asked", round_to(held.most, 3)},
                              {"at_s", round_to(held.most_s, 3)},
                              {"rows", held.rows}});
  for (const TakeGap& gap : report.gaps)
    object["gaps"].push_back({{"from_s", round_to(gap.from_s, 3)}, {"to_s", round_to(gap.to_s, 3)}});
  fmt::print("{}\n", format_object(object));
}

// A take that mien reads again: at the tolerance that is asked for, or, if none is, at the least from
// kKeys_mm on that leaves few enough keys.
TakeText write_take(const Options& options, const TakeMoves& moves, const MappingData& data,
                    TakeTextSpec& spec) {
  constexpr double kCoarser = 1.4, kCoarsest_mm = 10;
  const auto is_right = [](const TakeText& built) {
    return built.key_count <= kMaxParts && built.text.size() <= kMaxFileBytes;
  };
  spec.tolerance_mm = options.take.keys_mm.value_or(kKeys_mm);
  TakeText built = build_take_text(moves, data, spec);
  while (!options.take.keys_mm && !is_right(built) && spec.tolerance_mm < kCoarsest_mm) {
    spec.tolerance_mm *= kCoarser;
    built = build_take_text(moves, data, spec);
  }
  if (is_right(built)) return built;
  throw InputError(
      fmt::format("{}: {} keys of {} bytes at --keys {:g}mm; expected {} keys and {} bytes at most: a larger "
                  "--keys, or a track that follows the file itself",
                  options.file.string(), built.key_count, built.text.size(), spec.tolerance_mm, kMaxParts,
                  kMaxFileBytes));
}

}  // namespace

std::filesystem::path find_import_output(const Options& options) {
  const OutputFile output = find_output_file(options, build_name(options.file) + ".yaml");
  check_ending(output, "file", {".yaml", ".yml"});
  std::error_code ignored;
  if (std::filesystem::exists(std::filesystem::symlink_status(output.path, ignored)))
    throw InputError(fmt::format("{} exists; expected the name of a new file", output.path.string()));
  check_output_files({output}, {});
  return output.path;
}

void import_take(const Options& options, TakeKind kind) {
  const std::filesystem::path output = find_import_output(options);
  const LanguagePointer language = load_language(find_data_folder());
  const MappingData& data = *language->libraries.mappings;
  TakeReading reading = find_usual_reading(kind);
  if (options.take.smooth_hz) reading.smooth_hz = *options.take.smooth_hz;
  reading.fps = options.take.fps.value_or(0);
  const Take take = load_take(options.file, kind, reading.fps);
  const TakeMoves moves = build_take_moves(take, reading, data);
  TakeTextSpec spec{build_name(output), options.file.filename().string(), std::string(find_take_track(kind))};
  const TakeText built = write_take(options, moves, data, spec);
  if (const auto most = options.take.strict_percent; most && moves.report.lost_percent() > *most)
    throw InputError(
        fmt::format("{}: {:.1f} % of the motion is lost; expected {:g} % at most, as --strict says",
                    options.file.string(), moves.report.lost_percent(), *most));
  remove_left_parts_of(output);
  write_file(output, built.text);
  if (options.is_json)
    print_json(options, take, moves, built.key_count, spec.tolerance_mm);
  else if (!options.is_quiet)
    print_report(options, take, moves, built.key_count, spec.tolerance_mm);
  report_result(options, "file", output);
}

}  // namespace mien
