// Times in the notation of those that stand there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/edit_text.hpp"
#include "config/load_clip.hpp"

namespace mien {

// The unit of a time as it is written: "s", "ms", "f", or none of a bare number. Empty if it is no time.
std::optional<std::string> find_time_unit(const std::string& word);

// The beginning of a frame in a unit, never later than it: 7 frames of 24 a second are "0.29s", "291ms",
// "7f".
std::string format_frame(std::int64_t frame, int fps, const std::string& unit);

std::int64_t find_frame(double time_s, int fps);

// The times of a list's items as the clip has them, those that wait for others too; an item without `at` is a
// time itself. None where it has no time.
std::vector<std::optional<double>> list_item_times(const EditText& text, std::uint32_t list,
                                                   const std::string& actor, int fps);

}  // namespace mien
