#include "clip.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "config/load_spec.hpp"
#include "core/conventions.hpp"
#include "core/parallel.hpp"
#include "core/text.hpp"
#include "render/driver.hpp"
#include "render/process.hpp"
#include "render/progress.hpp"
#include "timeline/drawings.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

// Around the head, as shares of its height from chin to crown: air above, the neck below, ears and air at the
// sides.
constexpr double kAbove = 0.10, kBelow = 0.25, kWide = 1.08;
constexpr double kAside = 1.08;    // from one side of the head to the other, with the least air at the sides
constexpr double kNeckEnd = 0.08;  // above its lowest place the neck is still whole

int count_jobs(const Options& options) { return options.jobs > 0 ? options.jobs : count_cores(); }

// What the pixels of every frame depend on besides its own scene.
std::string key_of_settings(const std::string& include, const RenderSpec& render) {
  std::string text = fmt::format("{} {}x{}", MIEN_VERSION, render.width_px, render.height_px);
  for (const std::string& option : list_quality_options(render.quality)) text += " " + option;
  return hash_hex(text + "\n" + include);
}

struct SceneBuffers {
  DeformBuffers deform;
  Drawing drawing;
  std::string text;
};

// One drawing's scene, into `buffers.text`.
void draw_frame(const Clip& clip, const Performance& performance, const Figure& figure, int frame,
                SceneBuffers& buffers) {
  const double time_s = find_drawing_time_s(clip.spec.clip, frame - 1);
  const Moment moment = sample_performance(performance, time_s);
  deform_figure(figure, moment.pose, moment.turn, buffers.deform, buffers.drawing);
  buffers.text.clear();
  append_povray_frame(buffers.text, figure.model, buffers.drawing,
                      find_view(figure, moment.camera, clip.spec.render));
}

// The picture's own x.
glm::dvec3 find_right(const CameraView& view) {
  const double angle = view.angle_deg * kRadiansPerDegree;
  return {std::cos(angle), 0, -std::sin(angle)};
}

// How far all that lies above `lowest_mm` reaches to the left (below 0) and to the right of the picture's
// middle, mm in the plane of the middle: what is nearer to the camera counts for more.
glm::dvec2 find_reach(const Model& model, double lowest_mm, const CameraView& view) {
  const glm::dvec3 right = find_right(view);
  const double height = view.height_deg * kRadiansPerDegree;
  const glm::dvec3 level = glm::cross(right, glm::dvec3(0, 1, 0));  // toward the camera, were it level
  const glm::dvec3 toward = level * std::cos(height) + glm::dvec3(0, std::sin(height), 0);
  const double distance_mm = find_camera_distance_mm(view);
  glm::dvec2 reach(0);
  for (const Part& part : model.parts)
    for (const glm::vec3& vertex : part.rest.positions) {
      if (vertex.y < lowest_mm) continue;
      const glm::dvec3 p = glm::dvec3(vertex) - glm::dvec3(view.look_at);
      const double nearness = distance_mm / (distance_mm - glm::dot(p, toward));
      const double x = glm::dot(p, right) * nearness;
      reach = {std::min(reach.x, x), std::max(reach.y, x)};
    }
  return reach;
}

void write_held_frames(const Clip& clip) {
  for (std::size_t i = 0; i < clip.plan.frames.size(); ++i) {
    const int frame = clip.plan.frames[i], drawn_as = clip.plan.drawn_as[i];
    if (frame == drawn_as) continue;
    write_file(clip.files.scene(frame), fmt::format("// holds the drawing of frame {}\n#include \"{}.pov\"\n",
                                                    drawn_as, name_frame(drawn_as)));
  }
}

}  // namespace

Spec load_request(const Options& options, const fs::path& data_folder) {
  Spec spec = load_spec(options.file, data_folder);
  if (options.size_px) std::tie(spec.render.width_px, spec.render.height_px) = *options.size_px;
  if (options.quality) spec.render.quality = *options.quality;
  return spec;
}

fs::path find_output(const Options& options, const Spec& spec) {
  return options.output.value_or(fs::path("out") / spec.name);
}

Clip plan_clip(const Options& options, const fs::path& data_folder) {
  Clip clip;
  clip.spec = load_request(options, data_folder);
  clip.performance = build_performance(clip.spec.clip);
  clip.plan = plan_frames(find_drawings(clip.performance), options.frames);
  clip.files = {find_output(options, clip.spec), clip.spec.name};
  clip.frame_count = count_frames(clip.spec.clip);
  return clip;
}

EyeRig find_eyes(const Figure& figure, const RenderSpec& render) {
  EyeRig rig;
  rig.left_mm = figure.head.eye.centre;
  rig.pivot_mm = figure.face.turn_pivot;
  const auto find_reach = [&](Side side) {
    const std::size_t across = *find_move("eye", side, "side"), up = *find_move("eye", side, "up");
    const Face& face = figure.face;
    return EyeReach{figure.limits.plus[across] * face.eye_side_rad / kRadiansPerDegree,
                    figure.limits.minus[across] * face.eye_side_rad / kRadiansPerDegree,
                    figure.limits.plus[up] * face.eye_up_rad / kRadiansPerDegree,
                    figure.limits.minus[up] * face.eye_down_rad / kRadiansPerDegree};
  };
  rig.left = find_reach(Side::left);
  rig.right = find_reach(Side::right);
  const CameraView view = find_view(figure, {}, render);
  rig.camera_target_mm = view.look_at;
  rig.camera_mm = find_camera_distance_mm(view);
  return rig;
}

CameraView find_view(const Figure& figure, const CameraKey& camera, const RenderSpec& render) {
  const NeutralHead& head = figure.head;
  const Box skin = find_bounds(head.skin.positions);
  const double crown = skin.high.y;
  const double chin = head.skin.positions[head.cage.index.find("m12_D1")->second].y;
  const double height = crown - chin;
  CameraView view;
  view.angle_deg = camera.angle_deg;
  view.height_deg = camera.height_deg;
  view.distance = camera.distance;
  view.frame_height_mm = height * (1 + kAbove + kBelow);
  view.look_at = glm::vec3(0, crown + height * kAbove - view.frame_height_mm / 2, 0);

  const glm::dvec3 right = find_right(view);
  const glm::dvec2 reach = find_reach(figure.model, chin, view);
  view.look_at += glm::vec3(right * ((reach.x + reach.y) / 2));
  view.frame_width_mm = std::max(height * kWide, (reach.y - reach.x) * kAside);

  // A frame that grew to be wide enough would show where the neck ends.
  const double tall =
      std::max(view.frame_height_mm, view.frame_width_mm * render.height_px / render.width_px);
  const double floor = skin.low.y + height * kNeckEnd;
  view.look_at.y = static_cast<float>(std::max<double>(view.look_at.y, floor + tall / 2));
  return view;
}

std::vector<std::string> write_scenes(const Clip& clip, const Figure& figure, const Options& options,
                                      const fs::path& data_folder) {
  for (const fs::path& stale : find_stale_files(clip.files, clip.frame_count)) fs::remove(stale);
  fs::create_directories(clip.files.folder / "frames");  // POV-Ray alone would not
  const RenderSpec& render = clip.spec.render;
  const std::string include = build_povray_include(figure.model, render, data_folder / "templates");
  const std::string settings_key = key_of_settings(include, render);
  write_file(clip.files.scenes() / "head.inc", include);
  write_file(clip.files.scenes() / "loop.pov", build_povray_loop());
  write_file(clip.files.scenes() / (clip.files.name + ".ini"),
             build_povray_ini(render, clip.files.name, clip.frame_count, clip.files.folder,
                              {clip.plan.frames.front(), clip.plan.frames.back()}));

  const std::vector<int>& drawings = clip.plan.drawings;
  std::vector<std::string> keys(drawings.size());
  Performance performance = clip.performance;
  performance.idle.eyes = find_eyes(figure, render);
  std::vector<SceneBuffers> buffers(count_jobs(options));
  Progress progress(stderr, find_progress_style(stderr, options.is_quiet, options.is_json), "scenes",
                    static_cast<int>(drawings.size()));
  for_each_index(drawings.size(), count_jobs(options), [&](std::size_t i, int worker) {
    throw_if_interrupted();
    draw_frame(clip, performance, figure, drawings[i], buffers[worker]);
    write_file(clip.files.scene(drawings[i]), buffers[worker].text);
    keys[i] = hash_hex(settings_key + buffers[worker].text);
    progress.advance(false, drawings[i]);
  });
  write_held_frames(clip);
  progress.finish();
  return keys;
}

void render_pictures(const Clip& clip, const std::vector<std::string>& keys, const Options& options) {
  const FramePlan& plan = clip.plan;
  std::vector<FrameJob> jobs;
  for (std::size_t i = 0; i < plan.drawings.size(); ++i)
    jobs.push_back({plan.drawings[i], clip.files.scene(plan.drawings[i]),
                    clip.files.picture(plan.drawings[i]), keys[i]});
  RenderSettings settings;
  settings.width_px = clip.spec.render.width_px;
  settings.height_px = clip.spec.render.height_px;
  settings.povray_options = list_quality_options(clip.spec.render.quality);
  settings.libraries = {clip.files.scenes()};
  settings.jobs = count_jobs(options);

  Progress progress(stderr, find_progress_style(stderr, options.is_quiet, options.is_json), "frames",
                    static_cast<int>(jobs.size()));
  render_frames(jobs, settings, [&](int frame, bool was_kept) { progress.advance(was_kept, frame); });
  for (std::size_t i = 0; i < plan.frames.size(); ++i)
    if (plan.frames[i] != plan.drawn_as[i])
      write_file(clip.files.picture(plan.frames[i]), read_file(clip.files.picture(plan.drawn_as[i])));
  progress.finish();
}

std::string build_manifest(const Clip& clip, const std::vector<std::string>& keys) {
  const Spec& spec = clip.spec;
  nlohmann::ordered_json manifest;
  manifest["mien"] = MIEN_VERSION;
  manifest["name"] = clip.files.name;
  manifest["title"] = spec.title;
  manifest["fps"] = spec.clip.fps;
  manifest["frames"] = clip.frame_count;
  manifest["width"] = spec.render.width_px;
  manifest["height"] = spec.render.height_px;
  nlohmann::ordered_json& drawings = manifest["drawings"];
  drawings = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < keys.size(); ++i)
    drawings.push_back({{"frame", clip.plan.drawings[i]},
                        {"picture", "frames/" + name_frame(clip.plan.drawings[i]) + ".png"},
                        {"key", keys[i]}});
  return manifest.dump(1) + "\n";
}

}  // namespace mien
