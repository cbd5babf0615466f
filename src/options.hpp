// What the command line asked. Empty means "as the file says".
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/spec.hpp"

namespace mien {

// Who renders: this machine, or a farm.
enum class Engine { local, slurm };

// How a farm renders. Empty means "as the cluster says".
struct FarmOptions {
  Engine engine = Engine::local;            // --engine
  std::string partition;                    // --partition
  std::string time_limit;                   // --time, as Slurm has it: "30", "2:00:00", "1-12"
  std::optional<double> chunk_s;            // --chunk 5m: how long a task should take
  std::optional<int> chunk_drawings;        // --chunk 20: how many drawings a task traces
  bool has_wait = true;                     // --no-wait
  bool is_dry_run = false;                  // --dry-run
  std::optional<std::pair<int, int>> part;  // --part I/N: this part of the plan that was submitted
  bool is_gathering = false;                // --part gather: when all parts have ended
};

// How the frames of a clip are put into its files.
struct VideoOptions {
  int rounds = 1;             // --loop: how often a film shows them
  int plays = 0;              // --loop=N: how often .gif, .webp and .apng are to play; 0: for ever
  bool is_boomerang = false;  // --boomerang: forth and back
  bool has_slate = false;     // --slate: what each shows is written on it
};

// How a take is imported.
struct TakeOptions {
  std::optional<double> keys_mm;         // --keys 0.5mm: how far the skin may be from the take
  std::optional<double> strict_percent;  // --strict 10: how much of the motion may be lost
  std::optional<double> smooth_hz;       // --smooth 1.5
  std::optional<double> fps;             // --fps 59.94: of a file that does not say its rate
};

// What a line drawing shows.
struct WireOptions {
  bool is_on = false;       // --wire, for still: instead of a picture
  bool has_cage = false;    // --cage: the control cage instead of the skin
  bool has_guides = false;  // --guides: Loomis' guide lines
  bool has_limits = false;  // --limits: how far each area may go
};

struct Options {
  std::string kind;             // the word before the file: what `list` lists, which sheet
  std::filesystem::path other;  // the second FILE of `sheet compare`
  std::filesystem::path file;   // the YAML file (for `new`: the name of the file to make)
  std::optional<std::filesystem::path>
      output;  // -o: a folder for render, frames and bust; a file for still and mesh
  std::vector<std::filesystem::path> outputs;  // every -o, in their order; the last is `output`
  std::vector<std::filesystem::path> videos;   // those of them that are clips, for render (take_videos)
  std::optional<std::pair<int, int>> frames;   // --frames A-B: first and last frame, counted from 1
  std::optional<std::pair<int, int>> size_px;  // --size WxH
  std::optional<Quality> quality;              // --quality
  int jobs = 0;                                // --jobs: processes or threads at once; 0: as many as cores
  bool is_quiet = false;                       // --quiet: errors only
  bool is_json = false;                        // --json: one JSON object a line instead of words
  std::optional<double> at_s;                  // --at, for still, mesh, bust and explain
  std::optional<double> at_frames;             // --at in frames of the clip, as in 36f; then at_s is empty
  std::optional<std::string> express;          // --express NAME, for still, mesh and bust
  std::optional<std::string> actor;            // --actor NAME, for still, mesh, bust and explain
  std::optional<std::string> area;             // --area brow.left, for explain
  std::optional<double> camera_angle_deg;      // --angle, for still
  std::vector<std::string> beside;             // --beside real,comic, for render
  bool has_scenes = false;                     // --keep-scenes, for render
  std::optional<std::uintmax_t> store_bytes;  // --store, for render: what pictures beyond the clip's may take
  FarmOptions farm;                           // for render
  VideoOptions video;                         // for render
  TakeOptions take;                           // for import
  WireOptions wire;                           // for still and sheet wire
  std::optional<int> nice;                    // --nice, for render: as nice(1) has it
  std::optional<int> every;                   // --every N, for sheet contact: of so many drawings one
  std::optional<std::filesystem::path> landmarks;                   // --landmarks face.json, for mesh
  std::optional<double> height_mm;                                  // --height, for bust
  bool has_stl = true;                                              // --no-stl, for bust
  bool has_3mf = false, has_preview = false, has_openscad = false;  // for bust
  bool is_half = false;                                             // --half, for mesh
  bool is_exact = false;                                            // --exact, for export
  std::optional<std::filesystem::path> faults;                      // --faults faults.ply, for check
  std::optional<std::filesystem::path> uv;                          // --uv uv.png, for export
  std::string targets = "moves";                                    // --targets, for export
  int port = 0;                                                     // --port, for live; 0: any that is free
  bool is_opened = false, is_read_only = false;                     // --open, --read-only, for live
  std::optional<int> seed;         // --seed, of the first head, for sheet people
  std::optional<int> random_head;  // --random-head SEED, for new
};

}  // namespace mien
