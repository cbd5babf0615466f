// How often tests throw dice: as often as they say themselves, or as MIEN_FUZZ_ROUNDS says, with
// MIEN_FUZZ_SEED.
#pragma once

#include <cstdlib>
#include <string>

namespace mien {

inline int count_fuzz_rounds(int usual) {
  const char* said = std::getenv("MIEN_FUZZ_ROUNDS");
  return said == nullptr ? usual : std::stoi(said);
}

inline unsigned find_fuzz_seed(unsigned usual) {
  const char* said = std::getenv("MIEN_FUZZ_SEED");
  return said == nullptr ? usual : static_cast<unsigned>(std::stoul(said));
}

}  // namespace mien
