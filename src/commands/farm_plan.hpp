// A clip shared out over a cluster: which task traces what, and the scripts that say it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "clip/farm.hpp"
#include "commands/sketch_clip.hpp"
#include "options.hpp"
#include "render/slurm.hpp"

namespace mien {

// What is submitted, ready to be.
struct Farm {
  FarmFiles files;
  PartPlan plan;
  std::size_t missing = 0;
  SlurmScript tasks, clip;
};

// The clip, or those beside each other, each with its cast.
std::vector<FarmClip> list_farm_clips(const ClipParts& planned, const std::vector<Cast>& casts);

// Parts that take as long as --chunk says, as earlier drawings of the kind took; at most `most_tasks` of
// them.
Farm plan_farm(const Options& options, const ClipParts& planned, const std::vector<FarmDrawing>& drawings,
               std::size_t most_tasks);

// "8 tasks of 6 drawings", "3 tasks of 3 to 4 drawings".
std::string describe_parts(const PartPlan& plan);

// The scripts on stdout, and how they are submitted: --dry-run.
void print_farm(const Farm& farm);

// Whether what lies in the folder shares out the same.
bool is_same_plan(const Farm& farm);

// The plan and the scripts into the folder; logs and the end of an earlier call go.
void write_farm(const Farm& farm);

// Removes what tasks that were killed left half-made.
void remove_work(const FarmFiles& files, std::size_t parts);

// Whether the last job has made the clip.
bool has_ended_well(const Farm& farm);

}  // namespace mien
