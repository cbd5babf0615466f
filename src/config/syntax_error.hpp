// yaml-cpp's syntax errors in an author's words, at the place an author would look at.
#pragma once

#include <optional>
#include <string>

#include "config/source.hpp"

namespace mien {

// Adds the mistake for yaml-cpp's `reason` at `spot`, where its parser stood when it gave up.
void add_syntax_error(Findings& findings, const SourceText& source, Spot spot, const std::string& reason);

// The quote that is still open at the end of the text, as far as a look at its letters tells.
std::optional<Spot> find_open_quote(const SourceText& source);

}  // namespace mien
