// A clip's missing pictures shared out among tasks: a plan in a file, so that all tasks agree whatever has
// become of the clip's own file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace mien {

// One picture to trace.
struct PartDrawing {
  int clip = 0;     // which of the clips that are shown side by side, from 0
  int frame = 1;    // of that clip, whose drawing it is
  std::string key;  // of the picture
};

struct PartPlan {
  std::string identity;  // a hash of what was asked for and of all pictures of the clip, missing or not
  std::size_t size = 1;  // drawings of the largest part, had all been missing
  std::vector<std::vector<PartDrawing>> parts;
};

// How many of `count` things each part has: as few parts as have `size` things at most, but no more than
// `most_parts` (1 or more), of nearly one size. None for no things.
std::vector<std::size_t> share_out(std::size_t count, std::size_t size, std::size_t most_parts);

// The plan as text, and from a file. Throws RunError "cannot read PATH: reason" and "PATH is no plan of
// mien's".
std::string build_part_plan(const PartPlan& plan);
PartPlan read_part_plan(const std::filesystem::path& path);

// How long a drawing took a core on the machines of the farm, for pictures of one size and quality: as `kind`
// says. Zero if that is not known.
std::string build_drawing_cost(const std::string& kind, double seconds);
double read_drawing_cost_s(const std::filesystem::path& path, const std::string& kind);

}  // namespace mien
