// Takes of other programs as tables of moves.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "config/clip_spec.hpp"
#include "config/load_clip.hpp"
#include "config/mapping_data.hpp"
#include "import/take.hpp"
#include "takes/smooth.hpp"

namespace mien {

inline constexpr double kMostSmooth_hz = 30;  // half of a camera's 60 a second: nothing quicker is there
inline constexpr double kMostTakeRate = 240;  // frames a second of the quickest phones

// A take's moves, with the head's turn.
struct TakeTable {
  TimeTable table;
  std::vector<TurnKey> turn;
};

// How a take is read.
struct TakeReading {
  double smooth_hz = SmoothSpec{}.cutoff_hz;
  double fps = 0;  // 0: the file's own
};

// What is read where nobody says how: an animation has no noise of a camera's.
TakeReading find_usual_reading(std::optional<TakeKind> kind);

// `smooth:` and `fps:` of a track of such a take.
TakeReading load_take_reading(const YamlMapping& track, std::optional<TakeKind> kind);

// Which kind of take a track's key names: "live_link", "arkit", "openface", "openfacefx", "vrma", "gltf".
std::optional<TakeKind> find_take_key(std::string_view key);

// The take's rows as moves, smoothed, with what is lost. Throws InputError at each unit that nobody knows.
TakeMoves build_take_moves(const Take& take, const TakeReading& reading, const MappingData& data);

// The head's turn as keys: straight ways between as few of them as follow it to `tolerance_deg`.
std::vector<TurnKey> build_turn_keys(const TakeMoves& moves, double tolerance_deg);

// The take that a track names, from the library if it was read for another one. Empty, with mistakes told, if
// it is wrong.
std::shared_ptr<const TakeTable> find_take(const YamlEntry& named, const TakeReading& reading,
                                           const std::filesystem::path& file, Between between,
                                           const ClipReader& reader);

}  // namespace mien
