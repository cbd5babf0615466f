// Numbers with a unit, as an author writes them: "1.5s", "36f", "80mm", "20deg", "#dcae8f", "480x600".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

namespace mien {

// A unit's name and what its numbers are multiplied with and divided by to come to the base unit.
struct Unit {
  std::string_view name;
  double times = 1, over = 1;
};

// A kind of quantity. A bare number is in the base unit, the first one.
struct Measure {
  std::string_view noun;     // "a time"
  std::string_view example;  // "1.5s, 36f or 500ms"
  std::vector<Unit> units;
  std::string note = {};  // said after a range: " (100000 frames)"
};

Measure build_time_measure(int fps);  // s, ms, f: frames of 1 / fps
Measure build_seconds_measure();      // s, ms: of what has no frames
Measure build_length_measure();       // mm, cm
Measure build_angle_measure();        // deg

// Each is empty if the text, as a whole, is not of that form; a number is finite.
std::optional<double> parse_number(std::string_view text);
std::optional<double> parse_quantity(std::string_view text, const Measure& measure);
std::optional<glm::vec3> parse_colour(std::string_view text);  // srgb 0..1
std::optional<std::pair<int, int>> parse_size(
    std::string_view text);  // width, height; digits only, below 1e9

// "1.5s": a value in the base unit, as messages show it.
std::string format_quantity(double value, const Measure& measure);

}  // namespace mien
