// Texts with placeholders that mien ships: each with the name that messages give it.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace mien {

struct Template {
  std::string origin;  // "templates/povray/head.inc"
  std::string text;
};

// By path in templates/: "povray/head.inc".
using Templates = std::map<std::string, Template, std::less<>>;

// Throws RunError "templates/NAME is missing" for one that is not there.
const Template& find_template(const Templates& templates, std::string_view name);

// The text of one with its placeholders filled; see fill_template in core/text.hpp.
std::string fill_template(const Templates& templates, std::string_view name,
                          const std::map<std::string, std::string>& values);

}  // namespace mien
