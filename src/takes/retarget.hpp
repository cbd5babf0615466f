// A take of another program's face as moves of ours, and what is lost on the way.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "import/take.hpp"
#include "takes/mapping.hpp"

namespace mien {

// What our moves may be, and which of them turn the eyes.
struct MoveRange {
  double low = -1, high = 1;
};
struct GazeMove {
  std::size_t move = 0;
  bool is_up = false;  // else to the character's left
};
struct TakeReach {
  std::vector<MoveRange> ranges;
  std::vector<GazeMove> gaze;
  std::array<double, 3> gaze_deg{30, 25, 30};           // to a side, up and down at 1
  std::map<std::string, MappedMove, std::less<>> ways;  // "lid.left.shut": what it is at its end
};

// What of a unit our areas cannot do.
struct UnitLoss {
  std::string unit;
  double moved_mm2 = 0, lost_mm2 = 0;  // the mean over the take's rows; a tongue moves no skin
  double most = 0;                     // its highest value,
  double most_s = 0;                   // when,
  double from_s = 0, to_s = 0;         // and how long around it it is half as high at least
};

// A move that was asked for more than its limit.
struct TakeHeld {
  std::size_t move = 0;
  double most = 0, most_s = 0;  // asked for
  int rows = 0;
};

// No row with a face between two times: bridged straight.
struct TakeGap {
  double from_s = 0, to_s = 0;
};

struct TakeReport {
  double moved_mm2 = 0, lost_mm2 = 0;  // the mean over the take's rows
  // The second of which most is lost, of it, mm2.
  double worst_s = 0, worst_mm2 = 0;
  std::vector<UnitLoss> losses;  // the most lost first; all that a take uses and loses a hundredth of
  std::vector<TakeHeld> held;
  std::vector<TakeGap> gaps;
  std::vector<std::string> passed;  // channels of an animation that are no units of a face

  double lost_percent() const { return moved_mm2 > 0 ? 100 * lost_mm2 / moved_mm2 : 0; }
};

// Rows of moves, by time.
struct TakeMoves {
  std::size_t width = 0;  // of a row: all our moves
  std::vector<double> at_s;
  std::vector<float> values;                   // row by row
  std::vector<std::array<float, 3>> turn_deg;  // as of Take
  TakeReport report;
};

// Motion adds up unit by unit, as if no two moved one point: an estimate; our own ways do not count. Throws
// InputError at the place of a unit that the mapping lacks, and of an animation that has none at all.
TakeMoves retarget_take(const Take& take, const Mapping& mapping, const TakeReach& table);

}  // namespace mien
