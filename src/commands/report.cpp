#include "commands/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "config/areas.hpp"
#include "head/form.hpp"

namespace mien {

namespace {

std::string name_side(const HeldNote& note) {
  const MoveInfo& info = kChannels[note.held.move];
  if (info.side == Side::none) return "none";
  if (note.name.starts_with(fmt::format("{}.", find_area(info.of).plural))) return "both";
  return info.side == Side::left ? "left" : "right";
}

}  // namespace

void report_result(const Options& options, const std::string& kind, const std::filesystem::path& path) {
  if (options.is_json)
    fmt::print("{}\n", format_object(nlohmann::ordered_json{{kind, path.string()}}));
  else if (!options.is_quiet)
    fmt::print("{:<7} {}\n", kind, path.string());
}

void report_held(const Options& options, std::vector<Held> ledger) {
  if (options.is_quiet) return;
  sort_ledger(ledger);
  for (const HeldNote& note : build_notes(ledger))
    fmt::print("{}\n", options.is_json ? format_json(note) : format_note(note));
}

void report_clip_held(const Options& options, const Clip& clip, const Cast& cast, const HeadStock& stock) {
  if (options.is_quiet) return;
  std::vector<Rehearsal> rehearsals;
  for (const Performance& performance : list_performances(clip, cast, stock))
    rehearsals.push_back(rehearse(performance));
  report_held(options, list_held(clip.spec, rehearsals));
}

void report_starts(const Options& options, const std::vector<HeadSpec>& heads, const HeadStock& stock) {
  if (options.is_quiet) return;
  std::set<std::string> told;
  for (const HeadSpec& head : heads)
    for (const StartNote& note : list_start_notes(stock, head))
      for (const Diagnostic& warning : note.warnings)
        if (told.insert(format_diagnostic(warning)).second) report_warning(options, warning);
}

std::vector<HeadSpec> list_heads(const Clip& clip) {
  std::vector<HeadSpec> heads;
  for (const Actor& actor : clip.actors) heads.push_back(actor.head);
  return heads;
}

void report_warning(const Options& options, const Diagnostic& warning) {
  if (!options.is_json) return fmt::print("{}\n", format_diagnostic(warning));
  nlohmann::ordered_json object{{"kind", "warning"}, {"file", warning.place.file}};
  if (warning.place.line > 0) object["line"] = warning.place.line;
  if (warning.place.column > 0) object["column"] = warning.place.column;
  object["message"] = warning.message;
  fmt::print("{}\n", format_object(object));
}

std::string format_json(const HeldNote& note) {
  const Held& held = note.held;
  return format_object(nlohmann::ordered_json{{"kind", "note"},
                                              {"file", held.place.file},
                                              {"line", held.place.line},
                                              {"column", held.place.column},
                                              {"area", kChannels[held.move].area},
                                              {"side", name_side(note)},
                                              {"move", kChannels[held.move].move},
                                              {"asked", round_to(held.asked, 6)},
                                              {"held", round_to(held.held, 6)},
                                              {"by", held.by},
                                              {"message", note.text}});
}

std::string format_object(const nlohmann::ordered_json& object) {
  return object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

double round_to(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale + 0.0;
}

Progress start_progress(const Options& options, const char* label, std::size_t total) {
  return Progress(stderr, compute_progress_style(stderr, options.is_quiet, options.is_json), label,
                  static_cast<int>(total));
}

}  // namespace mien
