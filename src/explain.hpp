// What the limits held back, told to who runs the program.
#pragma once

#include "config/spec.hpp"
#include "pipeline.hpp"

namespace mien {

// One line a note of the file's ledger to standard output, with --json one object; with --quiet nothing.
void tell_held(const Options& options, const Spec& spec);

}  // namespace mien
