#include "clip/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "clip/slate.hpp"
#include "clip/sound.hpp"
#include "core/error.hpp"
#include "core/pool.hpp"
#include "core/text.hpp"
#include "render/picture_store.hpp"
#include "render/process.hpp"
#include "render/video.hpp"
#include "render/work_folder.hpp"
#include "scene/povray.hpp"
#include "timeline/drawings.hpp"

namespace mien {

namespace fs = std::filesystem;

namespace {

// A held frame that is right already is left untouched.
void repeat_picture(const fs::path& drawn, const fs::path& held) {
  std::error_code ignored;
  if (fs::equivalent(drawn, held, ignored)) return;
  const std::string key = read_picture_key(drawn);
  if (key.empty() || read_picture_key(held) != key) show_picture(drawn, held);
}

}  // namespace

RenderSettings list_settings(const RenderSpec& render, std::vector<fs::path> libraries, int jobs) {
  RenderSettings settings;
  settings.width_px = render.width_px;
  settings.height_px = render.height_px;
  settings.povray_options = list_quality_options(render);
  settings.libraries = std::move(libraries);
  settings.jobs = jobs;
  return settings;
}

void repeat_pictures(const Clip& clip) {
  const FramePlan& plan = clip.plan;
  for (std::size_t i = 0; i < plan.frames.size(); ++i)
    if (plan.frames[i] != plan.drawn_as[i])
      repeat_picture(clip.files.picture(plan.drawn_as[i]), clip.files.picture(plan.frames[i]));
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

namespace {

std::string name_clip(const Clip& clip) {
  const std::vector<int>& frames = clip.plan.frames;
  const bool is_whole = static_cast<int>(frames.size()) == clip.frame_count;
  const std::string name = clip.files.name + (is_sketch(clip.spec.render) ? "_sketch" : "");
  return is_whole ? name : fmt::format("{}_{}-{}", name, frames.front(), frames.back());
}

// What is done with the frames.
std::string name_shown(const VideoOptions& video) {
  return fmt::format("{}{}{}", video.is_boomerang ? "_boomerang" : "",
                     video.rounds > 1 ? fmt::format("_loop{}", video.rounds) : "",
                     video.has_slate ? "_slate" : "");
}

}  // namespace

std::vector<fs::path> list_video_paths(const Clip& clip) {
  if (!clip.videos.empty()) return clip.videos;
  return {clip.files.folder / (name_clip(clip) + name_shown(clip.video) + ".mp4")};
}

fs::path find_preview_path(const Clip& clip) {
  return clip.files.folder / (name_clip(clip) + "_preview.mp4");
}

namespace {

// Forth, or forth and back without showing either end twice.
std::size_t count_round(const Clip& clip) {
  const std::size_t count = clip.plan.frames.size();
  return clip.video.is_boomerang && count > 2 ? 2 * count - 2 : count;
}

// A picture of its own for each frame, in `folder`, by the plan's frames.
std::vector<fs::path> write_slated(const Clip& clip, const Letters& letters, const fs::path& folder) {
  std::vector<fs::path> pictures(clip.plan.frames.size());
  for_each_index(pictures.size(), count_workers(), [&](std::size_t i, int) {
    throw_if_interrupted();
    const int frame = clip.plan.frames[i];
    Pixels picture = read_pixels(clip.files.picture(frame));
    draw_slate(picture, build_slate(clip, frame), letters);
    pictures[i] = folder / (name_frame(frame) + ".png");
    write_file(pictures[i], build_png(picture));
  });
  return pictures;
}

}  // namespace

std::vector<std::size_t> list_shown_frames(const Clip& clip, const fs::path& video) {
  const std::size_t count = clip.plan.frames.size(), round = count_round(clip);
  const int rounds = is_film(video) ? clip.video.rounds : 1;
  std::vector<std::size_t> shown;
  for (int i = 0; i < rounds; ++i)
    for (std::size_t k = 0; k < round; ++k) shown.push_back(k < count ? k : round - k);
  return shown;
}

std::optional<Sound> find_shown_sound(const Clip& clip, const fs::path& video) {
  std::optional<Sound> sound = find_sound(clip);
  const double fps = clip.spec.clip.fps;
  if (!sound || (!clip.video.is_boomerang && clip.video.rounds == 1) || !is_film(video)) return sound;
  sound->rounds = clip.video.rounds;
  sound->round_s = static_cast<double>(count_round(clip)) / fps;
  sound->heard_s = static_cast<double>(clip.plan.frames.size()) / fps;
  return sound;
}

void write_clip_videos(const Clip& clip, const Letters& letters) {
  std::vector<fs::path> pictures;
  std::optional<WorkFolder> work;
  if (clip.video.has_slate) {
    work.emplace(clip.files.folder);
    pictures = write_slated(clip, letters, work->path);
  } else {
    for (const int frame : clip.plan.frames) pictures.push_back(clip.files.picture(frame));
  }
  for (const fs::path& video : list_video_paths(clip)) {
    std::vector<fs::path> shown;
    for (const std::size_t i : list_shown_frames(clip, video)) shown.push_back(pictures[i]);
    write_video(shown, clip.spec.clip.fps, video, find_shown_sound(clip, video), clip.video.plays);
  }
}

int find_poster_drawing(const Clip& clip) {
  const FramePlan& plan = clip.plan;
  const int poster =
      std::clamp(find_poster_frame(clip.spec.clip) + 1, plan.frames.front(), plan.frames.back());
  return plan.drawn_as[static_cast<std::size_t>(poster - plan.frames.front())];
}

void write_poster(const Clip& clip, const fs::path& path) {
  write_file(path, read_file(clip.files.picture(find_poster_drawing(clip))));
}

void write_preview(const Clip& clip, const std::vector<bool>& is_there) {
  const FramePlan& plan = clip.plan;
  std::vector<fs::path> pictures;
  for (const int drawn_as : plan.drawn_as) {
    const auto own = std::ranges::lower_bound(plan.drawings, drawn_as);
    std::size_t shown = static_cast<std::size_t>(own - plan.drawings.begin());
    while (shown > 0 && !is_there[shown]) --shown;  // the newest before it, else the first that there is
    while (shown + 1 < is_there.size() && !is_there[shown]) ++shown;
    pictures.push_back(clip.files.picture(plan.drawings[shown]));
  }
  write_video(pictures, clip.spec.clip.fps, find_preview_path(clip), find_sound(clip));
}

}  // namespace mien
