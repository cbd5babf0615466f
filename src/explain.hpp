// What the limits held back, told to who runs the program.
#pragma once

#include "config/spec.hpp"
#include "pipeline.hpp"
#include "timeline/performance.hpp"

namespace mien {

// One line a note of the file's ledger and of what its people are held back from in time, to standard output,
// with --json one object; with --quiet nothing.
void tell_held(const Options& options, const Spec& spec, const std::vector<Performance>& performances);

}  // namespace mien
