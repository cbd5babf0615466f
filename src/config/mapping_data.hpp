// The vocabularies of other programs in moves of ours (configs/mappings).
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "config/areas.hpp"
#include "config/findings.hpp"
#include "takes/mapping.hpp"
#include "takes/retarget.hpp"

namespace mien {

struct ExpressionBook;

// A combination of action units that an emotion is known by.
struct KnownNotation {
  std::string notation;    // "AU6+AU12"
  std::string expression;  // "emfacs/joy"
  Pose pose;
};

struct MappingData {
  std::map<std::string, Mapping, std::less<>> mappings;  // "arkit", "facs", "makehuman", "vrm"
  std::vector<KnownNotation> known;
  // How far each move takes the skin at its limit, mm, on the mean of scanned people; of an eye its surface.
  std::array<double, kMoveCount> ways_mm{};
  TakeReach moves;  // the ranges of kMoves
};
using MappingDataPointer = std::shared_ptr<const MappingData>;

// Throws RunError if the data have no such vocabulary.
const Mapping& find_mapping(const MappingData& data, std::string_view name);

// Tells mistakes as findings at their places. `libraries` are the expressions that a unit may be. A data
// folder without configs/mappings has no vocabularies.
MappingDataPointer load_mapping_data(const std::filesystem::path& data_folder,
                                     const ExpressionBook& libraries, Findings& findings);

}  // namespace mien
