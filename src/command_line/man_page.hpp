// The manual page, from the tables of commands and options.
#pragma once

#include <string>

namespace mien {

// mien.1 in the language of man(7): every command with its own options and examples, the options that many
// commands take, the exit status. It has no date, so that the same tables give the same bytes.
std::string build_man_page();

}  // namespace mien
