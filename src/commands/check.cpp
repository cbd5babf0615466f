// `mien check`: what a right file holds, how it moves, and what will not read well.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "clip/cast.hpp"
#include "clip/outputs.hpp"
#include "clip/reach.hpp"
#include "commands/report.hpp"
#include "commands/table.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "face/thesis_rules.hpp"
#include "head/cloud.hpp"
#include "head/form.hpp"
#include "import/mesh_faults.hpp"
#include "render/terminal.hpp"
#include "timeline/advice.hpp"
#include "timeline/chart.hpp"
#include "timeline/drawings.hpp"

namespace mien {

namespace {

constexpr int kPlainWidth = 80;    // columns, of a pipe or a file
constexpr int kWidestChart = 200;  // wider, the rows are hard to follow

// A line each: "file:line:col: warning: ..." or JSON.
void report_advice(const Options& options, const Performance& performance, const Rehearsal& rehearsal,
                   const Figure& figure) {
  for (const Diagnostic& advice : advise_clip(performance.clip, rehearsal, compute_reach(figure)))
    report_warning(options, advice);
}

// What the brows' rectangles hold, the worst of each brow and limit with its moment.
void report_brow_holds(const Options& options, const ClipSpec& clip, const Rehearsal& rehearsal,
                       const Figure& figure) {
  std::map<std::pair<Side, bool>, std::pair<BrowHold, std::size_t>> worst;
  for (std::size_t i = 0; i < rehearsal.shown.size(); ++i)
    for (const BrowHold& hold : find_brow_holds(figure.face, figure.limits, rehearsal.shown[i].pose)) {
      const auto [at, is_new] = worst.try_emplace({hold.side, hold.is_top}, hold, i);
      const BrowHold& known = at->second.first;
      if (!is_new && std::abs(hold.asked_up - hold.held_up) > std::abs(known.asked_up - known.held_up))
        at->second = {hold, i};
    }
  for (const auto& [limit, found] : worst) {
    const double at_s = static_cast<double>(found.second) / clip.fps;
    const std::string text = fmt::format("at {:.4g} s {}", at_s, describe_hold(found.first));
    if (options.is_json)
      fmt::print("{}\n", format_object(nlohmann::ordered_json{{"kind", "note"},
                                                              {"file", options.file.string()},
                                                              {"at_s", round_to(at_s, 6)},
                                                              {"message", text}}));
    else
      fmt::print("{}: note: {}\n", options.file.string(), text);
  }
}

// What scans do not show, a line each; of mixed heads, of each.
void report_kept(const Options& options, const HeadSpec& head, const HeadStock& stock) {
  for (const StartNote& note : list_start_notes(stock, head))
    for (const std::string& part : note.kept) {
      const auto& [path, place] = note.file;
      const std::string text =
          fmt::format("scan '{}' has no {}: kept from the shipped head", path.filename().string(), part);
      if (options.is_json)
        fmt::print("{}\n", format_object(nlohmann::ordered_json{{"kind", "note"},
                                                                {"file", place.file},
                                                                {"line", place.line},
                                                                {"column", place.column},
                                                                {"kept", part},
                                                                {"message", text}}));
      else
        fmt::print("{}:{}:{}: note: {}\n", place.file, place.line, place.column, text);
    }
}

// As wide as the terminal and in its letters; plain ASCII in 80 columns into a pipe or a file, since nobody
// knows what will read it and the same clip shall be the same text.
void report_chart(const ClipSpec& clip, const Rehearsal& rehearsal) {
  ChartStyle style{kPlainWidth, true};
  if (is_terminal(stdout)) style = {compute_terminal_width(stdout, kWidestChart), !has_utf8()};
  fmt::print("\n{}", build_chart(clip, rehearsal.shown, style));
}

// As plan_clip finds them.
std::vector<int> compute_clip_drawings(const Clip& clip, const std::vector<Rehearsal>& rehearsals) {
  std::vector<std::vector<std::string>> keys;
  for (const Rehearsal& rehearsal : rehearsals) keys.push_back(rehearsal.drawings);
  if (!clip.spec.actors.empty()) keys.push_back(list_drawing_keys(clip.performance));
  return compute_drawings(clip.spec.clip, keys);
}

// What the file holds, in one line.
void report_summary(const Options& options, const Clip& clip) {
  const RenderSpec& render = clip.spec.render;
  if (!options.is_json) {
    fmt::print("{}: good; {} frames at {} a second, {} drawings, {}x{}, {} bust{}\n", options.file.string(),
               clip.frame_count, clip.spec.clip.fps, clip.plan.drawings.size(), render.width_px,
               render.height_px, clip.spec.busts.size(), clip.spec.busts.size() == 1 ? "" : "s");
    return;
  }
  nlohmann::json summary{
      {"file", options.file.string()},  {"frames", clip.frame_count}, {"drawings", clip.plan.drawings.size()},
      {"fps", clip.spec.clip.fps},      {"width", render.width_px},   {"height", render.height_px},
      {"busts", clip.spec.busts.size()}};
  for (const ActorSpec& actor : clip.spec.actors) summary["actors"].push_back(actor.name);
  fmt::print("{}\n", format_object(nlohmann::ordered_json(summary)));
}

std::string count_things(std::size_t count, const char* thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

// A mesh instead of a file of ours: its faults, each a line.
void check_mesh(const Options& options) {
  const Polygons mesh = load_polygons(options.file, options.faults ? Faces::needed : Faces::optional);
  check_cloud_size(mesh);
  const bool is_cloud = mesh.face_count() == 0;
  const MeshReport report = is_cloud ? MeshReport{} : find_mesh_faults(mesh);
  if (!options.is_quiet)
    for (const Diagnostic& warning : mesh.warnings) report_warning(options, warning);
  if (options.faults) {
    check_ending({"--faults", *options.faults}, "mesh", {".ply"});
    check_output_files({{"--faults", *options.faults}}, {});
    write_file(*options.faults, draw_mesh_faults(mesh, report));
    report_result(options, "faults", *options.faults);
  }
  std::vector<Diagnostic> faults;
  for (const MeshFault& fault : report.faults) {
    const Diagnostic told{Place{options.file.string(), fault.line, 0}, fault.message, "", fault.is_warning};
    if (!fault.is_warning)
      faults.push_back(told);
    else if (!options.is_quiet)
      report_warning(options, told);
  }
  if (!faults.empty()) throw InputError(faults);
  if (options.is_quiet) return;
  const std::string rims = is_cloud           ? ""
                           : report.rims == 0 ? "closed"
                                              : fmt::format("{} of {}", count_things(report.rims, "open rim"),
                                                            count_things(report.open_edges, "edge"));
  const std::string made = mesh.surfaces > 0 ? "; of " + count_things(mesh.surfaces, "surface")
                           : mesh.slices > 0 ? "; of " + count_things(mesh.slices, "slice")
                                             : "";
  const std::string summary =
      is_cloud ? fmt::format("a cloud of {}{}", count_things(mesh.positions.size(), "point"), made)
               : fmt::format("{}, {}, {}{}", count_things(mesh.positions.size(), "point"),
                             count_things(mesh.face_count(), "polygon"), rims, made);
  if (options.is_json)
    fmt::print("{}\n", format_object(nlohmann::ordered_json{{"file", options.file.string()},
                                                            {"points", mesh.positions.size()},
                                                            {"polygons", mesh.face_count()},
                                                            {"rims", report.rims},
                                                            {"open_edges", report.open_edges}}));
  else
    fmt::print("{}: good; {}\n", options.file.string(), summary);
}

// What is wrong with the meshes that heads are made from, as warnings.
void report_mesh_faults(const Options& options, const HeadSpec& head) {
  constexpr std::size_t kFew = 3;
  for (const auto& file : {head.mesh, head.scan}) {
    if (!file) continue;
    const Polygons mesh = load_polygons(file->path, Faces::optional);
    if (mesh.face_count() == 0) continue;
    for (const MeshFault& fault : find_mesh_faults(mesh, kFew).faults)
      report_warning(options, {Place{file->path.string(), fault.line, 0}, fault.message, "", true});
  }
  for (const HeadShare& share : head.mix) report_mesh_faults(options, share.head);
}

void run_check(const Options& options) {
  if (is_geometry_name(options.file)) return check_mesh(options);
  if (options.faults) throw InputError("--faults draws what is wrong with a mesh; expected one as the FILE");
  const std::filesystem::path data = find_data_folder();
  const LanguagePointer language = load_language(data);
  Clip clip = open_clip(options, *language);  // first: a wrong file is told before any head is made
  const HeadStock stock = build_head_stock(load_head_data(data, language->words));
  clip.frame_count = count_frames(clip.spec.clip);
  // What is wrong with a head, such as a file that it names or guide lines that cross, is known when it is
  // built.
  const Cast cast = build_cast(clip, stock);
  std::vector<FigurePointer> figures = cast.figures;
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (!figures[i])
      figures[i] =
          std::make_shared<const DrawnFigure>(build_drawn_figure(stock, clip.actors[i].head, RenderSpec{}));
  const std::vector<Performance> performances = list_performances(clip, cast, stock);
  std::vector<Rehearsal> rehearsals;
  for (const Performance& performance : performances) rehearsals.push_back(rehearse(performance));
  clip.plan = plan_frames(compute_clip_drawings(clip, rehearsals), options.frames);
  report_held(options, list_held(clip.spec, rehearsals));
  if (options.is_quiet) return;
  for (const Actor& actor : clip.actors) report_kept(options, actor.head, stock);
  report_starts(options, list_heads(clip), stock);
  for (const Actor& actor : clip.actors) report_mesh_faults(options, actor.head);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    report_brow_holds(options, performances[i].clip, rehearsals[i], *figures[i]);
    report_advice(options, performances[i], rehearsals[i], *figures[i]);
  }
  report_summary(options, clip);
  if (options.is_json) return;
  for (std::size_t i = 0; i < performances.size(); ++i) {
    if (!clip.actors[i].name.empty()) fmt::print("\n{}:", clip.actors[i].name);
    report_chart(performances[i].clip, rehearsals[i]);
  }
}

}  // namespace

const CommandInfo command_check{
    "check",
    "The file",
    "FILE",
    "every mistake in the file; writes nothing",
    "Reads and judges the file, warns of what will not read well (holds too short, skin that jumps,\n"
    "faces never drawn in full) and draws the clip as a chart: areas by time, as wide as the\n"
    "terminal, in plain ASCII into a pipe or a file. Writes nothing. Of a mesh or a cloud of points (.obj,\n"
    ".ply, .stl, .glb, .gltf, .xyz, .pts, .asc, .csv) it tells polygons that are not flat or without area,\n"
    "edges with more than two polygons, points on fewer than two edges, what is there twice and what hangs\n"
    "on nothing, each with its line and place.",
    "faults",
    "mien check configs/hello.yaml\n"
    "mien check scan.obj --faults faults.ply",
    run_check};

}  // namespace mien
