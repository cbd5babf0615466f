// Naming many points of the cage at once: "E5_9..15", "*_C2", "s3..9_L*".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "head/head.hpp"

namespace mien {

// Whether `name` fits `pattern`: `*` stands for any text, `a..b` for one whole number from a to b, all else
// for itself.
bool is_match(std::string_view pattern, std::string_view name);

// For each point of the cage (both sides alike) whether some pattern fits; a pattern after '!' takes points
// out again, later ones win. Throws RunError for a pattern that fits nothing: it is a typing mistake.
std::vector<bool> find_points(const Cage& cage, const std::vector<std::string>& patterns);

}  // namespace mien
