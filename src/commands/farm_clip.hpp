// `mien render --engine slurm`: a clip that the machines of a cluster trace.
#pragma once

#include <vector>

#include "clip/cast.hpp"
#include "clip/trace.hpp"
#include "commands/sketch_clip.hpp"
#include "options.hpp"

namespace mien {

// Submits one array over parts of what is missing and one job that makes the clip when the array has ended,
// and tells what there is until both have ended. Jobs of an earlier call that do the same are waited for,
// others cancelled. Throws RunError if the clip was not made, and Interrupted, with the jobs going on.
void farm_clip(const Options& options, const ClipParts& planned, const std::vector<Cast>& casts,
               const Resources& resources);

// What a task of the array does: --part I/N.
void farm_part(const Options& options, const ClipParts& planned, const std::vector<Cast>& casts,
               const Resources& resources);

// What the last job does before it traces anything: throws RunError if more is missing than one task traces.
void check_gathered(const TraceRun& run, const std::filesystem::path& clip_folder, std::size_t missing);

// And when all is done: who waits for it is told.
void tell_gathered(const std::filesystem::path& clip_folder);

}  // namespace mien
