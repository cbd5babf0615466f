// `mien import` of takes: what a face did when.
#pragma once

#include "import/take.hpp"
#include "options.hpp"

namespace mien {

// Writes the take as keys of ours and tells what of it is lost. Throws InputError, with nothing written, if
// that is more than --strict allows.
void import_take(const Options& options, TakeKind kind);

// Where an import goes: what -o names, which is no file yet and ends in .yaml.
std::filesystem::path find_import_output(const Options& options);

}  // namespace mien
