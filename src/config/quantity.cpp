#include "config/quantity.hpp"

#include <fmt/format.h>
#include <charconv>
#include <cmath>

namespace mien {

namespace {

// The number that `text` begins with, which is taken off it.
std::optional<double> take_number(std::string_view& text) {
  const std::string_view whole = text;
  if (text.starts_with('+')) text.remove_prefix(1);
  const std::string_view digits =
      text.starts_with('-') && text.size() == whole.size() ? text.substr(1) : text;
  // from_chars would take "inf" and "nan", too.
  if (digits.empty() || (digits[0] != '.' && (digits[0] < '0' || digits[0] > '9'))) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

std::optional<int> parse_digits(std::string_view text, int base) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (text.empty() || text[0] == '-' || text.size() > 9 || error != std::errc() ||
      end != text.data() + text.size())
    return std::nullopt;
  return value;
}

}  // namespace

Measure build_time_measure(int fps) {
  return {"a time", "1.5s, 36f or 500ms", {{"s"}, {"ms", 1, 1000}, {"f", 1, static_cast<double>(fps)}}, {}};
}

Measure build_seconds_measure() { return {"a time", "0.6s or 600ms", {{"s"}, {"ms", 1, 1000}}, {}}; }

Measure build_length_measure() { return {"a length", "80mm or 8cm", {{"mm"}, {"cm", 10, 1}}, {}}; }

Measure build_angle_measure() { return {"an angle", "20deg", {{"deg"}}, {}}; }

std::optional<double> parse_number(std::string_view text) {
  const auto value = take_number(text);
  return text.empty() ? value : std::nullopt;
}

std::optional<double> parse_quantity(std::string_view text, const Measure& measure) {
  const auto value = take_number(text);
  if (!value || text.empty()) return value;
  for (const Unit& unit : measure.units)
    if (text == unit.name) {
      const double base = *value * unit.times / unit.over;
      return std::isfinite(base) ? std::optional(base) : std::nullopt;
    }
  return std::nullopt;
}

std::optional<glm::vec3> parse_colour(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  glm::vec3 colour{0};
  for (int i = 0; i < 3; ++i) {
    const auto channel = parse_digits(text.substr(static_cast<std::size_t>(1 + 2 * i), 2), 16);
    if (!channel) return std::nullopt;
    colour[i] = static_cast<float>(*channel) / 255.0f;
  }
  return colour;
}

std::optional<std::pair<int, int>> parse_size(std::string_view text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto width = parse_digits(text.substr(0, cross), 10);
  const auto height = parse_digits(text.substr(cross + 1), 10);
  if (!width || !height) return std::nullopt;
  return std::pair(*width, *height);
}

std::string format_quantity(double value, const Measure& measure) {
  // %g and not format_number: a wrong value may be of any size.
  return fmt::format("{:.7g}{}", value, measure.units.front().name);
}

}  // namespace mien
