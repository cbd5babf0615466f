#include "head/patterns.hpp"

#include <fmt/format.h>
#include <cctype>
#include <charconv>

#include "core/error.hpp"
#include "head/cage.hpp"

namespace mien {

namespace {

// Takes a run of digits off the front of `text`; false if there is none.
bool take_number(std::string_view& text, int& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isdigit(static_cast<unsigned char>(text.front()))) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

// Takes "a..b" off the front of `pattern`; false (and nothing taken) if it does not stand there.
bool take_range(std::string_view& pattern, int& low, int& high) {
  std::string_view rest = pattern;
  if (rest.empty() || !take_number(rest, low) || !rest.starts_with("..")) return false;
  rest.remove_prefix(2);
  if (rest.empty() || !take_number(rest, high)) return false;
  pattern = rest;
  return true;
}

}  // namespace

bool is_match(std::string_view pattern, std::string_view name) {
  while (!pattern.empty()) {
    if (pattern.front() == '*') {
      pattern.remove_prefix(1);
      for (std::size_t skip = 0; skip <= name.size(); ++skip)
        if (is_match(pattern, name.substr(skip))) return true;
      return false;
    }
    int low = 0, high = 0, number = 0;
    if (take_range(pattern, low, high)) {
      if (name.empty() || !take_number(name, number) || number < low || number > high) return false;
      continue;
    }
    if (name.empty() || name.front() != pattern.front()) return false;
    pattern.remove_prefix(1);
    name.remove_prefix(1);
  }
  return name.empty();
}

std::vector<bool> find_points(const Cage& cage, const std::vector<std::string>& patterns) {
  std::vector<bool> found(cage.points.size(), false);
  for (std::string_view pattern : patterns) {
    const bool takes_out = pattern.starts_with('!');
    if (takes_out) pattern.remove_prefix(1);
    bool fits = false;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (!is_match(pattern, strip_side(cage.names[i]))) continue;
      found[i] = !takes_out;
      fits = true;
    }
    if (!fits) throw RunError(fmt::format("pattern '{}' fits no point of the head", pattern));
  }
  return found;
}

}  // namespace mien
