// The jobs of a clip on a cluster: found, submitted, waited for.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "commands/farm_plan.hpp"

namespace mien {

// A line on stderr, as words or as JSON, unless --quiet.
void say_event(const Options& options, const nlohmann::ordered_json& event, const std::string& words);

// How to look, to cancel and to go on.
std::string describe_going_on(const SlurmJobs& jobs);

// The jobs that make this clip: those of an earlier call, or new ones; those that do something else are
// cancelled. Throws RunError with Slurm's words.
SlurmJobs ensure_jobs(const Options& options, const Farm& farm);

// Tells what comes into the stores until the jobs have ended. Throws RunError if the clip was not made, and
// Interrupted.
void await_clip(const Options& options, const Farm& farm, const std::vector<FarmClip>& clips,
                std::vector<FarmDrawing>& drawings, const SlurmJobs& jobs);

}  // namespace mien
