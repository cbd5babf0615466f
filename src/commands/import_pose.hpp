// `mien import` of expressions: one face.
#pragma once

#include "options.hpp"

namespace mien {

// Writes an expression of MPFB or MakeHuman as one of ours and tells what of it is lost. Throws InputError,
// with nothing written, if that is more than --strict allows.
void import_pose(const Options& options);

}  // namespace mien
