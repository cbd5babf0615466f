// The values of options, from what was typed to Options.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "options.hpp"

namespace mien {

// By an option's long name; a flag's value is empty.
using TypedValues = std::map<std::string, std::string>;

// Under this name all values of --output, with kBetweenOutputs between them.
inline constexpr std::string_view kAllOutputs = "outputs";
inline constexpr char kBetweenOutputs = '\0';

// A mistake with no place but the command line.
void add_mistake(std::vector<Diagnostic>& mistakes, std::string message);

// The nearest of `names` as "; did you mean 'NAME'?"; empty if none is near.
std::string suggest(const std::string& word, const std::vector<std::string>& names);

// Every value understood. A wrong one is left as it was and told in `mistakes`.
Options build_options(const TypedValues& typed, std::vector<Diagnostic>& mistakes);

}  // namespace mien
