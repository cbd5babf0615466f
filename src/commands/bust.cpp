// `mien bust`.
#include <fmt/format.h>
#include <cstdio>
#include <map>

#include "bust/write_bust.hpp"
#include "clip/moment.hpp"
#include "clip/outputs.hpp"
#include "commands/hold.hpp"
#include "commands/report.hpp"
#include "commands/table.hpp"
#include "core/data.hpp"
#include "core/streams.hpp"
#include "render/process.hpp"

namespace mien {

namespace {

bool has_time(const Options& options) { return options.at_s || options.at_frames; }

// The busts of the file, or the one that --express names or --at shows; with --height so high.
std::vector<BustSpec> find_busts(const Options& options, const Clip& clip, const Actor& actor,
                                 const Figure& figure) {
  const Spec& spec = clip.spec;
  std::vector<BustSpec> busts = spec.busts;
  if (options.express) {
    busts = {build_asked_bust(spec, take_expression(spec, *options.express))};
  } else if (has_time(options)) {
    Expression moment{fmt::format("{:.4g}s", compute_time_s(clip, options)), "", {}, 1, {}};
    moment.pose = compute_moment(options, clip, actor, figure, moment.held).pose;
    busts = {build_asked_bust(spec, std::move(moment))};
  } else if (busts.empty()) {
    busts = {build_asked_bust(spec, find_expression(spec, "neutral"))};
  }
  for (BustSpec& bust : busts) bust.height_mm = options.height_mm.value_or(bust.height_mm);
  return busts;
}

std::vector<Held> list_held(const std::vector<BustSpec>& busts) {
  std::vector<Held> held;
  for (const BustSpec& bust : busts)
    held.insert(held.end(), bust.expression.held.begin(), bust.expression.held.end());
  return held;
}

// "bust_laugh", and "bust_laugh_2" for the file's second one of that name.
std::vector<std::string> name_busts(const std::vector<BustSpec>& busts) {
  std::map<std::string, int> seen;
  std::vector<std::string> stems;
  for (const BustSpec& bust : busts) {
    const int number = ++seen[bust.expression.name];
    stems.push_back("bust_" + bust.expression.name + (number > 1 ? fmt::format("_{}", number) : ""));
  }
  return stems;
}

// What holds for all busts of the head, once.
void report_note(const Options& options, const Spec& spec, const std::string& note) {
  if (options.is_quiet || note.empty()) return;
  if (options.is_json)
    fmt::print("{}\n", format_object(nlohmann::ordered_json{
                           {"kind", "note"}, {"file", spec.file.string()}, {"message", note}}));
  else
    fmt::print("{}: note: {}\n", spec.file.string(), note);
}

// What the report of a bust warns of, under its files, but for `known`, which was told before.
void report_warnings(const Options& options, const Spec& spec, const MadeBust& made,
                     const std::string& known) {
  if (options.is_quiet) return;
  for (const std::string& warning : made.report.warnings) {
    if (warning == known) continue;
    if (options.is_json)
      fmt::print(
          "{}\n",
          format_object(nlohmann::ordered_json{
              {"kind", "warning"}, {"file", spec.file.string()}, {"bust", made.stem}, {"message", warning}}));
    else
      fmt::print("        {}\n", warning);
  }
}

void run_bust(const Options& options) {
  const Resources resources = load_resources(find_data_folder());
  const Clip clip = open_clip(options, *resources.stock.language);
  const Actor& actor = find_actor(clip, options);
  if (options.has_openscad) require_programs({{"openscad", "openscad"}});
  if (options.has_preview) require_programs({{"povray", "povray"}});
  const HeadSpec head = has_time(options) ? find_asked_head(clip, actor, options) : actor.head;
  const Figure figure = build_figure(resources.heads, head, FigureUse::print);
  const std::vector<BustSpec> busts = find_busts(options, clip, actor, figure);
  const Templates& templates = resources.stock.templates;
  BustCache cache{figure, list_bust_menu(clip.spec, busts),
                  clip.spec.title.empty() ? clip.spec.name : clip.spec.title, find_letters(templates)};
  const std::vector<std::string> stems = name_busts(busts);
  const std::filesystem::path folder = find_output(options, clip.spec);
  check_output_folder(options, folder, list_bust_files(stems, clip.spec.plate_mm.x > 0, options), clip.spec);
  const FolderLock lock = hold_folder(options, folder);
  const auto count = static_cast<std::size_t>(count_bust_files(options));
  report_starts(options, {head}, resources.heads);
  report_held(options, list_held(busts));
  const std::string hair = describe_unprinted_hair(figure.model, wears_hair(figure));
  report_note(options, clip.spec, hair);
  Progress progress = start_progress(options, "files", busts.size() * count);
  const auto report_file = [&](const std::string& kind, const std::filesystem::path& path) {
    progress.clear();
    report_result(options, kind, path);
    flush_stream(stdout);  // nobody who cannot be told waits for the other busts
    progress.advance(false);
  };
  bool are_printable = true;
  std::vector<Mesh> meshes;
  for (std::size_t i = 0; i < busts.size(); ++i) {
    throw_if_interrupted();
    MadeBust made = make_bust(cache, busts[i]);
    made.stem = stems[i];
    write_bust(made, folder, templates, options, report_file);
    progress.clear();
    report_warnings(options, clip.spec, made, hair);
    if (!is_printable(made.report)) are_printable = false;
    if (clip.spec.plate_mm.x > 0) meshes.push_back(std::move(made.mesh));
  }
  progress.clear();
  if (!meshes.empty())
    write_plates(build_plates(meshes, clip.spec.plate_mm), folder,
                 [&](const std::string& kind, const auto& path) { report_result(options, kind, path); });
  if (!are_printable) throw RunError("not every bust is printable; the reports say why");
}

}  // namespace

const CommandInfo command_bust{
    "bust",
    "Shapes",
    "FILE",
    "OpenSCAD source, STL, 3MF and print report",
    "Writes each bust of the file, or one with the expression or of the time that is given (its face: a\n"
    "bust looks ahead, however the head is turned), printed as the file's busts are: the STL, ready for the\n"
    "slicer, in millimetres; an OpenSCAD source that needs nothing else, whose Customizer poses the face,\n"
    "hollows and labels it; and a report of what a printer will make of it. Exit status 1 if one is not\n"
    "printable.",
    "at express actor height stl no-stl 3mf preview openscad",
    "mien bust configs/hello.yaml --express laugh --height 60mm -o busts\n"
    "mien bust configs/busts.yaml --3mf --preview",
    run_bust};

}  // namespace mien
