#include "core/table.hpp"

#include <fmt/format.h>

#include <charconv>
#include <fstream>

#include "core/error.hpp"

namespace mien {

namespace {

Fields split_line(const std::string& line) {
  Fields fields(1);
  for (const char c : line)
    if (c == ',')
      fields.emplace_back();
    else if (c != '\r')
      fields.back() += c;
  return fields;
}

}  // namespace

void read_table(const std::filesystem::path& file, std::size_t columns, bool has_heading,
                const std::function<std::string(const Fields&)>& use) {
  std::ifstream stream(file);
  if (!stream) throw RunError(fmt::format("cannot read {}", file.string()));
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.empty() || line.front() == '#') continue;
    if (has_heading) {
      has_heading = false;
      continue;
    }
    const Fields fields = split_line(line);
    std::string mistake = fields.size() == columns
                              ? use(fields)
                              : fmt::format("{} fields; expected {}", fields.size(), columns);
    if (!mistake.empty()) throw RunError(fmt::format("{}:{}: {}", file.string(), number, mistake));
  }
}

std::optional<double> parse_field(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string parse_vector(const Fields& fields, std::size_t first, glm::dvec3& into) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string& text = fields[first + static_cast<std::size_t>(axis)];
    const auto value = parse_field(text);
    if (!value) return fmt::format("'{}' is not a number", text);
    into[axis] = *value;
  }
  return {};
}

}  // namespace mien
