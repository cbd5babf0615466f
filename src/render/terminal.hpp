// The terminal that a stream may lead to.
#pragma once

#include <cstdio>

namespace mien {

bool is_terminal(std::FILE* stream);

// Columns that can be written without wrapping: the terminal's less one, `widest` at most and where the
// stream is no terminal.
int compute_terminal_width(std::FILE* stream, int widest);

// Whether the user's locale says that UTF-8 is shown.
bool has_utf8();

}  // namespace mien
