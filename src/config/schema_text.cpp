#include "config/schema_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr const char* kDigits = "([0-9]+\\.?[0-9]*|\\.[0-9]+)";

std::string find_unit(FormKind kind) {
  switch (kind) {
    case FormKind::duration:
    case FormKind::seconds:
      return "s";
    case FormKind::length:
    case FormKind::lengths:
    case FormKind::two_lengths:
      return "mm";
    case FormKind::angle:
      return "deg";
    case FormKind::size:
      return " pixels";
    default:
      return "";
  }
}

}  // namespace

Measure find_measure(FormKind kind) {
  if (kind == FormKind::length || kind == FormKind::lengths) return build_length_measure();
  if (kind == FormKind::angle) return build_angle_measure();
  if (kind == FormKind::seconds) return build_seconds_measure();
  return build_time_measure(24);
}

std::string build_quantity_pattern(const std::vector<Unit>& units, bool has_sign) {
  std::string names;
  for (const Unit& unit : units) names += fmt::format("{}{}", names.empty() ? "" : "|", unit.name);
  return fmt::format("^{}{}([eE][-+]?[0-9]+)?({})$", has_sign ? "[-+]?" : "\\+?", kDigits, names);
}

std::string build_constant_pattern() {
  return fmt::format("^(?![-+]?{0} *[A-Za-z]*$|{0}x{0} *[A-Za-z]*$)[ !#-~]+$", kDigits);
}

std::string build_two_constants_pattern() {
  return fmt::format("^(?!{0} x {0} *[A-Za-z]*$)[ !#-~]+ x [ !#-~]+$", kDigits);
}

std::string build_two_lengths_pattern() { return fmt::format("^{0}x{0}(mm|cm)?$", kDigits); }

std::string build_size_pattern(int low_px, int high_px) {
  const auto count = [](int side_px) { return fmt::format("{}", side_px).size(); };
  return fmt::format("^[0-9]{{{0},{1}}}x[0-9]{{{0},{1}}}$", count(low_px), count(high_px));
}

std::string describe_range(const Form& form) {
  const std::string unit = find_unit(form.kind);
  if (!std::isfinite(form.low) && !std::isfinite(form.high)) return "";
  if (!std::isfinite(form.high)) return form.low == 0 ? "" : fmt::format("{:.10g}{} or more", form.low, unit);
  if (form.is_above_low) return fmt::format("above {:.10g}, to {:.10g}{}", form.low, form.high, unit);
  return fmt::format("from {:.10g}{} to {:.10g}{}", form.low, unit == " pixels" ? "" : unit, form.high, unit);
}

std::string describe_ranges(const Forms& forms) {
  std::string text;
  for (const Form& form : forms) {
    const bool has_unit = !find_unit(form.kind).empty();
    const std::string range = has_unit ? describe_range(form) : "";
    if (!range.empty()) text = fmt::format("F{}.", range.substr(1));
  }
  return text;
}

std::string find_meaning(const DataWords& data, const std::string& list, std::string_view name) {
  const auto words = data.find(list);
  if (words == data.end()) return "";
  const auto word = std::ranges::find(words->second, name, &DataWord::name);
  return word == words->second.end() ? "" : word->meaning;
}

}  // namespace mien
