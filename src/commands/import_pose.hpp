// `mien import` of expressions: one face.
#pragma once

#include <string>

#include "options.hpp"

namespace mien {

// Writes an expression of MPFB or MakeHuman as one of ours and tells what of it is lost. Throws InputError,
// with nothing written, if that is more than --strict allows.
void import_pose(const Options& options);

// Writes what an avatar of VRM can do with its face as expressions of ours, each by what its shapes are
// called (ARKit's units) or else by its own name, and tells those that are neither. As above.
void import_avatar(const Options& options);

// A word that can name an expression of ours.
std::string build_expression_word(std::string name);

}  // namespace mien
