#include "sheet/clip_sheets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "clip/outputs.hpp"
#include "clip/pictures.hpp"
#include "clip/scenes.hpp"
#include "clip/view.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "render/driver.hpp"
#include "render/process.hpp"
#include "render/progress.hpp"
#include "render/work_folder.hpp"
#include "scene/strip.hpp"
#include "sheet/contact.hpp"
#include "sheet/plans.hpp"
#include "timeline/chart.hpp"
#include "timeline/exposure.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPictures = 24;    // three lines of them; more are a film, not a sheet
constexpr std::size_t kFewestPictures = 16;  // unless the clip has fewer drawings: two lines
constexpr int kPictureWidth_px = 160;        // eight in a line are as wide as a page

fs::path find_path(const Options& options, const Spec& spec, const std::string& name) {
  const OutputFile file = find_output_file(options, fs::path("out") / spec.name / name);
  check_ending(file, "sheet", {find_ending(name)});
  check_output_files({file}, spec);
  return file.path;
}

// Frames from 0, each the first of its drawing.
struct StripFrames {
  std::set<int> keys, between;
};

// The first frame of the drawing that shows a moment.
int find_first_frame(const ClipSpec& clip, double time_s) {
  const double drawing_s = compute_drawing_time_s(clip, compute_key_frame(clip, time_s));
  return static_cast<int>(std::lround(drawing_s * clip.fps));
}

// Every key's drawing, if they are too many evenly some of them; then drawings half way along the longest
// gaps until two lines are full.
StripFrames choose_frames(const ClipSpec& clip) {
  StripFrames frames;
  const std::vector<PoseKey>& keys = clip.keys;
  const std::size_t count = std::min(keys.size(), kMostPictures);
  for (std::size_t i = 0; i < count; ++i)
    frames.keys.insert(find_first_frame(clip, keys[i * keys.size() / count].at_s));
  std::set<int> all = frames.keys;
  all.insert(find_first_frame(clip, clip.length_s));
  while (all.size() < kFewestPictures) {
    auto widest = all.begin();
    for (auto from = all.begin(); std::next(from) != all.end(); ++from)
      if (*std::next(from) - *from > *std::next(widest) - *widest) widest = from;
    if (std::next(widest) == all.end()) break;
    const int middle = find_first_frame(clip, 0.5 * (*widest + *std::next(widest)) / clip.fps);
    if (!all.insert(middle).second) break;  // no drawing lies between
  }
  std::ranges::set_difference(all, frames.keys, std::inserter(frames.between, frames.between.begin()));
  return frames;
}

std::string find_label(const ClipSpec& clip, int frame) {
  std::string label;
  for (const PoseKey& key : clip.keys)
    if (find_first_frame(clip, key.at_s) == frame) label = key.label;
  return label;
}

void fill_rows(const Performance& performance, StripPage& page) {
  for (ChartRow& row : list_chart_rows(rehearse(performance).shown))
    page.rows.push_back({std::move(row.name), std::move(row.moves), std::move(row.values)});
  for (const PoseKey& key : performance.clip.keys) page.keys.push_back({key.at_s, key.label});
  for (const Blink& blink : performance.idle.blinks) page.blinks_s.push_back(blink.at_s);
}

// The pictures of `page.pictures`, rendered in a folder that goes again.
void render_pictures(const Performance& performance, const Figure& figure, const RenderSpec& render,
                     const fs::path& folder, const Options& options, const Templates& templates,
                     StripPage& page) {
  const WorkFolder work(folder);
  write_file(work.path / "head.inc", build_povray_include(figure.model, render, templates));
  write_part_pictures(figure.model, work.path);
  DeformBuffers buffers;
  Drawing drawing;
  std::vector<FrameJob> jobs;
  for (const StripPicture& picture : page.pictures) {
    throw_if_interrupted();
    const Moment moment = sample_performance(performance, picture.time_s);
    deform_figure(figure, moment.pose, moment.turn, buffers, drawing);
    std::string scene;
    append_povray_frame(scene, figure.model, drawing, compute_view(figure, moment.camera, render));
    const std::string name = fmt::format("f{}", picture.frame);
    write_file(work.path / (name + ".pov"), scene);
    jobs.push_back({picture.frame, work.path / (name + ".pov"), work.path / (name + ".png"), ""});
  }
  Progress progress(stderr, compute_progress_style(stderr, options.is_quiet, options.is_json), "drawings",
                    static_cast<int>(jobs.size()));
  render_frames(jobs, list_settings(render, {work.path}, count_jobs(options)),
                {[&](int frame, bool was_kept) { progress.advance(was_kept, frame); }});
  progress.finish();
  for (std::size_t i = 0; i < jobs.size(); ++i) page.pictures[i].png = read_file(jobs[i].picture);
}

StripPage build_page(const Spec& spec, const Performance& performance, const RenderSpec& render) {
  const ClipSpec& clip = spec.clip;
  StripPage page;
  page.title = spec.title.empty() ? spec.name : spec.title;
  page.fps = clip.fps;
  page.frame_count = count_frames(clip);
  page.note = fmt::format("{} frames at {} a second; red: keys, grey: blinks; dashed: an area's limits",
                          page.frame_count, page.fps);
  page.picture_width_px = render.width_px;
  page.picture_height_px = render.height_px;
  const StripFrames frames = choose_frames(clip);
  std::set<int> all = frames.keys;
  all.insert(frames.between.begin(), frames.between.end());
  for (const int frame : all)
    page.pictures.push_back({"", find_label(clip, frame), compute_drawing_time_s(clip, frame), frame + 1,
                             frames.keys.contains(frame)});
  fill_rows(performance, page);
  return page;
}

fs::path write_strip(const Options& options, const Resources& resources) {
  const Spec spec = load_actor_request(options, *resources.stock.language);
  const fs::path path = find_path(options, spec, "strip.svg");
  RenderSpec render = spec.render;
  if (!options.size_px) {
    render.height_px = std::clamp(kPictureWidth_px * render.height_px / render.width_px, kPictureWidth_px / 4,
                                  kPictureWidth_px * 4);
    render.width_px = kPictureWidth_px;
  }
  const Figure figure = build_figure(resources.heads, spec.head);
  require_programs({{"povray", "povray"}});
  Performance performance = build_performance(spec.clip);
  performance.idle.eyes = compute_eyes(figure, render);
  StripPage page = build_page(spec, performance, render);
  render_pictures(performance, figure, render, path.has_parent_path() ? path.parent_path() : ".", options,
                  resources.stock.templates, page);
  remove_left_parts_of(path);
  write_file(path, build_strip_svg(page));
  return path;
}

fs::path write_exposure(const Options& options, const Resources& resources) {
  const Spec spec = load_actor_request(options, *resources.stock.language);
  const fs::path path = find_path(options, spec, "exposure.csv");
  Performance performance = build_performance(spec.clip);
  performance.idle.eyes = compute_eyes(build_figure(resources.heads, spec.head), spec.render);
  remove_left_parts_of(path);
  write_file(path, build_exposure_csv(build_exposure(performance)));
  return path;
}

}  // namespace

bool is_clip_sheet(const std::string& kind) {
  return std::ranges::find(kClipSheets, kind) != kClipSheets.end();
}

std::filesystem::path write_clip_sheet(const Options& options, const Resources& resources) {
  if (options.kind == "contact") return write_contact_sheet(options, resources);
  return options.kind == "strip" ? write_strip(options, resources) : write_exposure(options, resources);
}

}  // namespace mien
