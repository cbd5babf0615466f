// A take written as a file of ours: keys that one can read and change.
#pragma once

#include <string>

#include "config/mapping_data.hpp"

namespace mien {

struct TakeTextSpec {
  std::string name;           // of the file, without its ending
  std::string source;         // the take's file, told in the first line
  std::string track;          // the key of a track that follows the file itself: "live_link"
  double tolerance_mm = 0.5;  // how far the skin may be from the take: higher is fewer keys
};

struct TakeText {
  std::string text;
  std::size_t key_count = 0;
};

// A YAML file with a script for each area that the take moves (each has keys of its own times), a cue that
// plays it, and the head's turn.
TakeText build_take_text(const TakeMoves& moves, const MappingData& data, const TakeTextSpec& spec);

// "brows: {up: 0.25}, lid.left: {upper: -1}": two sides in one where they do the same; values to a hundredth,
// those at rest left out.
std::string build_moves_text(const Pose& pose);

}  // namespace mien
