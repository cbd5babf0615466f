// How mistakes are told on the error stream.
#pragma once

#include <vector>

#include "core/error.hpp"

namespace mien {

// A paragraph each (format_diagnostic), and of several how many errors there are; or an object of JSON a
// line.
void write_diagnostics(const std::vector<Diagnostic>& diagnostics, bool is_json);

}  // namespace mien
