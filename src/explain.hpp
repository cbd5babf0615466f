// What the limits held back, told to who runs the program.
#pragma once

#include "config/spec.hpp"
#include "pipeline.hpp"
#include "timeline/rehearsal.hpp"

namespace mien {

// One line a note of a ledger in any order, to standard output, with --json one object; with --quiet nothing.
void tell_held(const Options& options, std::vector<Held> ledger);

// The file's whole ledger, with what its people are held back from in time.
std::vector<Held> list_held(const Spec& spec, const std::vector<Rehearsal>& rehearsals);

}  // namespace mien
