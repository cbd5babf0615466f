#include "core/templates.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

const Template& find_template(const Templates& templates, std::string_view name) {
  const auto found = templates.find(name);
  if (found == templates.end()) throw RunError(fmt::format("templates/{} is missing", name));
  return found->second;
}

std::string fill_template(const Templates& templates, std::string_view name,
                          const std::map<std::string, std::string>& values) {
  const Template& found = find_template(templates, name);
  return fill_template(found.text, values, found.origin);
}

}  // namespace mien
