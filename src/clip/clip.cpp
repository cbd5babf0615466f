#include "clip/clip.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "config/findings.hpp"
#include "config/load_spec.hpp"
#include "config/words.hpp"
#include "core/pool.hpp"
#include "timeline/drawings.hpp"
#include "timeline/head_track.hpp"
#include "voice/speech.hpp"

namespace mien {

namespace fs = std::filesystem;

int count_jobs(const Options& options) { return options.jobs > 0 ? options.jobs : count_cores(); }

Spec load_request(const Options& options, const Language& language) {
  Spec spec = load_spec(options.file, language);
  add_speech(spec, *language.speech);
  if (options.size_px) std::tie(spec.render.width_px, spec.render.height_px) = *options.size_px;
  if (options.quality) spec.render.quality = *options.quality;
  return spec;
}

fs::path find_output(const Options& options, const Spec& spec) {
  return options.output.value_or(fs::path("out") / spec.name);
}

Clip open_clip(const Options& options, const Language& language) {
  return build_clip(load_request(options, language));
}

Clip build_clip(Spec spec) {
  Clip clip;
  clip.spec = std::move(spec);
  clip.performance = build_performance(clip.spec.clip);
  if (clip.spec.actors.empty())  // the only one plays the clip itself
    clip.actors.push_back({"", clip.spec.head, {}, clip.performance});
  for (const ActorSpec& actor : clip.spec.actors)
    clip.actors.push_back({actor.name, actor.head, actor.place, build_performance(actor.clip)});
  return clip;
}

std::vector<const Performance*> list_players(const Clip& clip) {
  std::vector<const Performance*> players{&clip.performance};
  if (clip.spec.actors.empty()) return players;  // the only one, who plays the clip itself
  for (const Actor& actor : clip.actors) players.push_back(&actor.performance);
  return players;
}

Clip plan_clip(const Options& options, const Language& language) {
  Clip clip = open_clip(options, language);
  plan_drawings(clip, options.frames);
  clip.files = {find_output(options, clip.spec), clip.spec.name};
  clip.videos = options.videos;
  clip.video = options.video;
  return clip;
}

void plan_drawings(Clip& clip, const std::optional<std::pair<int, int>>& frames) {
  std::vector<std::vector<std::string>> keys;
  for (const Performance* performance : list_players(clip)) keys.push_back(list_drawing_keys(*performance));
  clip.plan = plan_frames(compute_drawings(clip.spec.clip, keys), frames);
  clip.frame_count = count_frames(clip.spec.clip);
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

Spec load_actor_request(const Options& options, const Language& language) {
  const Clip clip = open_clip(options, language);
  const Actor& actor = find_actor(clip, options);
  Spec spec = clip.spec;
  spec.head = actor.head;
  spec.clip = actor.performance.clip;
  return spec;
}

double compute_time_s(const Clip& clip, const Options& options) {
  return options.at_frames ? *options.at_frames / clip.spec.clip.fps : options.at_s.value_or(0);
}

HeadSpec compute_head(const Actor& actor, double time_s) {
  const std::vector<HeadKey>& keys = actor.performance.clip.head;
  return keys.empty() ? actor.head : sample_head(keys, time_s);
}

HeadSpec find_asked_head(const Clip& clip, const Actor& actor, const Options& options) {
  return options.express ? actor.head : compute_head(actor, compute_time_s(clip, options));
}

}  // namespace mien
