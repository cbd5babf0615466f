// A clip's way from a file to its frames: what every command about moving pictures shares.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/load_spec.hpp"
#include "config/spec.hpp"
#include "options.hpp"
#include "render/plan.hpp"
#include "timeline/performance.hpp"

namespace mien {

// The file as the command line wants it. Throws InputError with every mistake of the file.
Spec load_request(const Options& options, const Language& language);

// The same with the head and the clip of the one whom --actor names.
Spec load_actor_request(const Options& options, const Language& language);

// Where a command's files go: -o, else out/NAME.
std::filesystem::path find_output(const Options& options, const Spec& spec);

// How many threads or processes at once.
int count_jobs(const Options& options);

// One who plays.
struct Actor {
  std::string name;  // empty: the only one
  HeadSpec head;
  PlaceSpec place;
  Performance performance;
};

// A clip planned: everything but work.
struct Clip {
  Spec spec;
  Performance performance;  // of `spec.clip`: its camera is everybody's
  std::vector<Actor> actors;
  FramePlan plan;
  ClipFiles files;
  int frame_count = 0;                             // of the whole clip, whatever --frames says
  std::vector<std::filesystem::path> videos = {};  // that -o names; none: NAME.mp4 in the folder
  VideoOptions video = {};
};

// The people of a file that was read, without a plan of frames: for one moment.
Clip build_clip(Spec spec);
Clip open_clip(const Options& options, const Language& language);

// Whose drawings the clip's frames are: the clip itself, which has the camera, and its actors.
std::vector<const Performance*> list_players(const Clip& clip);

Clip plan_clip(const Options& options, const Language& language);

// Plans what was opened; `frames` as --frames has them.
void plan_drawings(Clip& clip, const std::optional<std::pair<int, int>>& frames = {});

// The one whom --actor names, else the only one. Throws InputError if there are several and none is named.
const Actor& find_actor(const Clip& clip, const Options& options);

// --at in seconds, else the clip's beginning.
double compute_time_s(const Clip& clip, const Options& options);

// The head of an actor at a time; a head that does not change is the same at every time.
HeadSpec compute_head(const Actor& actor, double time_s);

// The head that a command about one moment is for: that of the moment, or with --express the file's own.
HeadSpec find_asked_head(const Clip& clip, const Actor& actor, const Options& options);

}  // namespace mien
