#include "core/yaml_file.hpp"

#include <fmt/format.h>

#include "core/text.hpp"

namespace mien {

RunError build_yaml_error(const std::filesystem::path& file, const YAML::Exception& problem) {
  const YAML::Mark& at = problem.mark;
  if (at.is_null()) return RunError(fmt::format("{}: {}", file.string(), problem.msg));
  return RunError(fmt::format("{}:{}:{}: {}", file.string(), at.line + 1, at.column + 1, problem.msg));
}

YAML::Node load_yaml_file(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& problem) {
    throw build_yaml_error(file, problem);
  }
}

}  // namespace mien
