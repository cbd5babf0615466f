#include "pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "bust_files.hpp"
#include "busts.hpp"
#include "clip.hpp"
#include "clip_scenes.hpp"
#include "config/load_spec.hpp"
#include "config/schema.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "explain.hpp"
#include "head/landmarks.hpp"
#include "head/own_half.hpp"
#include "render/driver.hpp"
#include "render/process.hpp"
#include "render/progress.hpp"
#include "render/video.hpp"
#include "render/work_folder.hpp"
#include "scene/mesh_files.hpp"
#include "scene/wavefront.hpp"
#include "sheet/sheet.hpp"
#include "sheet_strip.hpp"
#include "starter.hpp"
#include "timeline/drawings.hpp"
#include "timeline/parts.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

// One result a line: its path, or {"clip": "out/hello/hello.mp4"}.
void tell_result(const Options& options, const std::string& kind, const fs::path& path) {
  if (options.is_json)
    fmt::print("{}\n", nlohmann::json{{kind, path.string()}}.dump());
  else if (!options.is_quiet)
    fmt::print("{:<7} {}\n", kind, path.string());
}

// The pose that --express asks for, else the actor's at --at or at the clip's beginning; `held` becomes what
// limits hold back of it.
Moment find_moment(const Options& options, const Clip& clip, const Actor& actor, const Figure& figure,
                   std::vector<Held>& held) {
  if (options.express) {
    const Expression expression = take_expression(clip.spec, *options.express);
    held = expression.held;
    return {expression.pose, {}, {}};
  }
  Performance performance = actor.performance;
  performance.idle.eyes = find_eyes(figure, clip.spec.render);
  held = list_held_at(performance, find_time_s(clip, options));
  return sample_performance(performance, find_time_s(clip, options));
}

// Of the whole clip, however few of its frames are asked for.
void tell_clip_held(const Options& options, const Clip& clip, const Cast& cast, const fs::path& data) {
  if (options.is_quiet) return;
  std::vector<Rehearsal> rehearsals;
  for (const Performance& performance : list_performances(clip, cast, data))
    rehearsals.push_back(rehearse(performance));
  tell_held(options, list_held(clip.spec, rehearsals));
}

Drawing draw_moment(const Figure& figure, const Moment& moment, bool has_folds = true) {
  DeformBuffers buffers;
  buffers.has_folds = has_folds;
  Drawing drawing;
  deform_figure(figure, moment.pose, moment.turn, buffers, drawing);
  return drawing;
}

// The clip of all frames, or NAME_A-B.mp4 of those asked for.
fs::path find_clip_path(const Clip& clip) {
  const auto& frames = clip.plan.frames;
  const bool is_whole = static_cast<int>(frames.size()) == clip.frame_count;
  return clip.files.folder /
         (is_whole ? clip.files.name + ".mp4"
                   : fmt::format("{}_{}-{}.mp4", clip.files.name, frames.front(), frames.back()));
}

void write_clip(const Clip& clip, const Options& options) {
  std::vector<fs::path> pictures;
  for (const int frame : clip.plan.frames) pictures.push_back(clip.files.picture(frame));
  const fs::path path = find_clip_path(clip);
  write_video(pictures, clip.spec.clip.fps, path);
  tell_result(options, "clip", path);

  const int poster =
      std::clamp(find_poster_frame(clip.spec.clip) + 1, clip.plan.frames.front(), clip.plan.frames.back());
  write_file(clip.files.folder / "poster.png", read_file(clip.files.picture(poster)));
  tell_result(options, "poster", clip.files.folder / "poster.png");
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

BustSpec build_bust_spec(Expression expression) {
  BustSpec bust;
  bust.expression = std::move(expression);
  return bust;
}

// The busts of the file, or the one that --express names or --at shows.
std::vector<BustSpec> find_busts(const Options& options, const Clip& clip, const Actor& actor,
                                 const Figure& figure) {
  const Spec& spec = clip.spec;
  if (options.express) return {build_bust_spec(take_expression(spec, *options.express))};
  if (options.at_s || options.at_frames) {
    Expression moment{fmt::format("{:.4g}s", find_time_s(clip, options)), "", {}, 1, {}};
    moment.pose = find_moment(options, clip, actor, figure, moment.held).pose;
    return {build_bust_spec(std::move(moment))};
  }
  if (spec.busts.empty()) return {build_bust_spec(find_expression(spec, "neutral"))};
  return spec.busts;
}

// The neutral head's left half as people edit it, for `head: {mesh: FILE}`.
void write_half(const Options& options, const HeadSpec& head, const fs::path& data, const fs::path& path) {
  const HeadStock stock = load_head_stock(data);
  std::string text;
  append_wavefront(
      text, find_half_places(stock, build_form(stock, head).points), find_half_quads(stock), "half",
      {"The left half of a head (x >= 0): millimetres; x to the character's left, y up, z forward.",
       "Move its points, keep their order and the faces, and name the file: head: {mesh: my_half.obj}"});
  write_file(path, text);
  tell_result(options, "half", path);
}

}  // namespace

void render_clip(const Options& options) {
  const fs::path data = find_data_folder();
  const Clip clip = plan_clip(options, data);
  require_programs({{"povray", "povray"}, {"ffmpeg", "ffmpeg"}, {"ffprobe", "ffmpeg"}});
  const Cast cast = build_cast(clip, data);
  tell_clip_held(options, clip, cast, data);
  const std::vector<std::string> keys = write_scenes(clip, cast, options, data);
  render_pictures(clip, keys, options);
  write_file(clip.files.folder / "manifest.json", build_manifest(clip, keys));
  write_clip(clip, options);
}

void write_frames(const Options& options) {
  const fs::path data = find_data_folder();
  const Clip clip = plan_clip(options, data);
  const Cast cast = build_cast(clip, data);
  tell_clip_held(options, clip, cast, data);
  write_scenes(clip, cast, options, data);
  tell_result(options, "scenes", clip.files.scenes());
}

void render_still(const Options& options) {
  const fs::path data = find_data_folder();
  Clip clip = open_clip(options, data);
  const Spec& spec = clip.spec;
  Still still{find_time_s(clip, options), {}, {}, {}};
  still.camera = sample_performance(clip.performance, still.time_s).camera;
  still.stage = sample_stage(spec.clip, still.time_s);
  if (options.actor || options.express) {  // one alone, in the middle
    Actor actor = find_actor(clip, options);
    if (options.express) {
      actor.performance.clip.head.clear();
      still.camera = {};
      still.stage = {};
    }
    actor.place = {};
    still.stage.aims.clear();
    clip.actors = {std::move(actor)};
  }
  if (options.camera_angle_deg) still.camera.angle_deg = *options.camera_angle_deg;
  std::vector<Held> held;
  if (options.express) {
    const Expression expression = take_expression(spec, *options.express);
    still.pose = expression.pose;
    held = expression.held;
  }
  require_programs({{"povray", "povray"}});
  const Cast cast = build_cast(clip, data);
  const fs::path picture = options.output.value_or(fs::path("out") / spec.name / "still.png");
  const WorkFolder work(picture.has_parent_path() ? picture.parent_path() : ".");
  const StillScene scene = build_still_scene(clip, cast, still, data);
  held.insert(held.end(), scene.held.begin(), scene.held.end());
  tell_held(options, std::move(held));
  write_file(work.path / "still.pov", scene.text);
  write_file(work.path / "head.inc", scene.include);

  RenderSettings settings;
  settings.width_px = spec.render.width_px;
  settings.height_px = spec.render.height_px;
  settings.povray_options = list_quality_options(spec.render.quality);
  settings.libraries = {work.path};
  render_frames({{1, work.path / "still.pov", picture, ""}}, settings, [](int, bool) {});
  tell_result(options, "picture", picture);
}

void render_sheet(const std::string& kind, const Options& options) {
  tell_result(options, "sheet",
              is_clip_sheet(kind) ? write_clip_sheet(kind, options) : write_sheet(kind, options));
}

void write_mesh(const Options& options) {
  const fs::path data = find_data_folder();
  const Clip clip = open_clip(options, data);
  const Spec& spec = clip.spec;
  const Actor& actor = find_actor(clip, options);
  const HeadSpec head = find_asked_head(clip, actor, options);
  const fs::path path = options.output.value_or(fs::path("out") / spec.name / "mesh.obj");
  const std::string ending = path.extension().string();
  if (options.is_half ? ending != ".obj" : !is_mesh_ending(ending))
    throw InputError(fmt::format("-o {}: unknown kind of mesh '{}'; expected a name that ends in {}",
                                 path.string(), ending, options.is_half ? ".obj" : ".obj, .ply or .stl"));
  if (options.is_half) return write_half(options, head, data, path);
  const Figure figure = build_figure(head, data);
  std::vector<Held> held;
  const Drawing drawing = draw_moment(figure, find_moment(options, clip, actor, figure, held));
  tell_held(options, std::move(held));
  write_file(path,
             build_mesh_file(ending, figure.model, drawing, spec.title.empty() ? spec.name : spec.title));
  tell_result(options, "mesh", path);
  if (!options.landmarks) return;
  const std::vector<Landmark> landmarks = find_landmarks(figure.head, data / "templates/head/landmarks.yaml");
  write_file(*options.landmarks,
             build_landmarks_json(measure_landmarks(figure.head, landmarks, figure.model, drawing)));
  tell_result(options, "landmarks", *options.landmarks);
}

void write_busts(const Options& options) {
  const fs::path data = find_data_folder();
  const Clip clip = open_clip(options, data);
  const Actor& actor = find_actor(clip, options);
  if (options.has_openscad) require_programs({{"openscad", "openscad"}});
  if (options.has_preview) require_programs({{"povray", "povray"}});
  const bool has_time = options.at_s || options.at_frames;
  const Figure figure =
      build_figure(has_time ? find_asked_head(clip, actor, options) : actor.head, data, FigureUse::print);
  std::vector<BustSpec> busts = find_busts(options, clip, actor, figure);
  for (BustSpec& bust : busts) bust.height_mm = options.height_mm.value_or(bust.height_mm);
  std::vector<Held> held;
  for (const BustSpec& bust : busts)
    held.insert(held.end(), bust.expression.held.begin(), bust.expression.held.end());
  tell_held(options, std::move(held));
  const std::vector<std::string> stems = name_busts(busts);
  BustShop shop{figure, list_bust_menu(clip.spec, busts),
                clip.spec.title.empty() ? clip.spec.name : clip.spec.title, load_letters(data)};
  const fs::path folder = find_output(options, clip.spec);
  Progress progress(stderr, find_progress_style(stderr, options.is_quiet, options.is_json), "files",
                    static_cast<int>(busts.size()) * count_bust_files(options));
  const auto tell = [&](const std::string& kind, const fs::path& path) {
    progress.clear();
    tell_result(options, kind, path);
    std::fflush(stdout);
    progress.advance(false);
  };
  bool are_printable = true;
  std::vector<Mesh> meshes;
  for (std::size_t i = 0; i < busts.size(); ++i) {
    throw_if_interrupted();
    MadeBust made = make_bust(shop, busts[i]);
    made.stem = stems[i];
    write_bust(made, folder, data, options, tell);
    progress.clear();
    if (!options.is_quiet && !options.is_json)
      for (const std::string& warning : made.report.warnings) fmt::print("        {}\n", warning);
    if (!is_printable(made.report)) are_printable = false;
    if (clip.spec.plate_mm.x > 0) meshes.push_back(std::move(made.mesh));
  }
  progress.clear();
  if (!meshes.empty())
    write_plates(build_plates(meshes, clip.spec.plate_mm), folder,
                 [&](const std::string& kind, const fs::path& path) { tell_result(options, kind, path); });
  if (!are_printable) throw RunError("not every bust is printable; the reports say why");
}

void write_starter(const Options& options) {
  fs::path path = options.output.value_or(options.file);
  if (path.extension() != ".yaml" && path.extension() != ".yml") path += ".yaml";
  if (fs::exists(path))
    throw InputError(fmt::format("{} exists; expected the name of a new file", path.string()));
  write_file(path, build_starter(build_name(path), options.random_head, find_data_folder()));
  tell_result(options, "file", path);
}

void print_schema() { fmt::print("{}", build_schema(load_data_words(find_data_folder()))); }

}  // namespace mien
