// How a program that failed is told: what, with which command, and its last words.
#pragma once

#include <string>
#include <vector>

namespace mien {

// The command as one would type it: arguments quoted for a POSIX shell where they need it.
std::string quote_command(const std::vector<std::string>& command);

// "povray failed (exit status 1)", "povray was ended by signal 11 (Segmentation fault)".
std::string describe_end(const std::string& program, int exit_code);

// The message of a RunError about a program: `what`, then "command: ..." and the last lines of the output
// that say something, each on a line of its own, two blanks in; before them how many lines are left out.
// Control characters are left out, and the rest of a very long line.
std::string format_failure(const std::string& what, const std::string& command, const std::string& output);

}  // namespace mien
