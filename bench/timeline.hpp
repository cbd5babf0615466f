// A performance of an hour: how long it takes to check, and how fast it is sampled.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace mien {

// An hour of 86,400 frames with everything that a clip can have at once: keys, turns, a camera, cues,
// scripts, laws, gaze, blinks, drift, asymmetry and leading areas.
std::string build_hour();

// A line a figure: `print(name, value, remark)`. `check(file)` runs `mien check` on it and returns its wall
// time in seconds.
using PrintRow = std::function<void(const std::string&, const std::string&, const std::string&)>;
void measure_timeline(const std::filesystem::path& data, const std::filesystem::path& folder,
                      const std::function<double(const std::filesystem::path&)>& check,
                      const PrintRow& print);

}  // namespace mien
