#include "clip.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "config/findings.hpp"
#include "config/load_spec.hpp"
#include "config/words.hpp"
#include "core/pool.hpp"
#include "core/text.hpp"
#include "render/driver.hpp"
#include "render/process.hpp"
#include "render/progress.hpp"
#include "scene/povray.hpp"
#include "timeline/drawings.hpp"
#include "timeline/head_track.hpp"

namespace mien {

namespace fs = std::filesystem;

int count_jobs(const Options& options) { return options.jobs > 0 ? options.jobs : count_cores(); }

Spec load_request(const Options& options, const fs::path& data_folder) {
  Spec spec = load_spec(options.file, data_folder);
  if (options.size_px) std::tie(spec.render.width_px, spec.render.height_px) = *options.size_px;
  if (options.quality) spec.render.quality = *options.quality;
  return spec;
}

fs::path find_output(const Options& options, const Spec& spec) {
  return options.output.value_or(fs::path("out") / spec.name);
}

Clip open_clip(const Options& options, const fs::path& data_folder) {
  Clip clip;
  clip.spec = load_request(options, data_folder);
  clip.performance = build_performance(clip.spec.clip);
  for (const ActorSpec& actor : list_actors(clip.spec))
    clip.actors.push_back({actor.name, actor.head, actor.place, build_performance(actor.clip)});
  return clip;
}

std::vector<const Performance*> list_players(const Clip& clip) {
  std::vector<const Performance*> players{&clip.performance};
  if (clip.spec.actors.empty()) return players;  // the only one, who plays the clip itself
  for (const Actor& actor : clip.actors) players.push_back(&actor.performance);
  return players;
}

Clip plan_clip(const Options& options, const fs::path& data_folder) {
  Clip clip = open_clip(options, data_folder);
  std::vector<std::vector<std::string>> keys;
  for (const Performance* performance : list_players(clip)) keys.push_back(list_drawing_keys(*performance));
  clip.plan = plan_frames(find_drawings(clip.spec.clip, keys), options.frames);
  clip.files = {find_output(options, clip.spec), clip.spec.name};
  clip.frame_count = count_frames(clip.spec.clip);
  return clip;
}

const Actor& find_actor(const Clip& clip, const Options& options) {
  Names names;
  for (const Actor& actor : clip.actors) names.push_back(actor.name);
  const bool has_names = !clip.spec.actors.empty();
  if (!options.actor && clip.actors.size() == 1) return clip.actors.front();
  if (!options.actor)
    throw InputError(fmt::format("{} has several actors; expected --actor with one of: {}",
                                 clip.spec.file.string(), join_names(names)));
  if (!has_names)
    throw InputError(fmt::format("--actor {}: {} has no actors; expected none to be named",
                                 show_word(*options.actor), clip.spec.file.string()));
  const auto found = std::ranges::find(clip.actors, *options.actor, &Actor::name);
  if (found == clip.actors.end())
    throw InputError("--actor: " + describe_unknown("actor", *options.actor, names));
  return *found;
}

Spec load_actor_request(const Options& options, const fs::path& data_folder) {
  const Clip clip = open_clip(options, data_folder);
  const Actor& actor = find_actor(clip, options);
  Spec spec = clip.spec;
  spec.head = actor.head;
  spec.clip = actor.performance.clip;
  return spec;
}

double find_time_s(const Clip& clip, const Options& options) {
  return options.at_frames ? *options.at_frames / clip.spec.clip.fps : options.at_s.value_or(0);
}

HeadSpec find_head(const Actor& actor, double time_s) {
  const std::vector<HeadKey>& keys = actor.performance.clip.head;
  return keys.empty() ? actor.head : sample_head(keys, time_s);
}

HeadSpec find_asked_head(const Clip& clip, const Actor& actor, const Options& options) {
  return options.express ? actor.head : find_head(actor, find_time_s(clip, options));
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
