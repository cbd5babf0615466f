// A clip as a chart: areas by time. What a terminal shows of it, and the rows that other charts draw.
#pragma once

#include <string>
#include <vector>

#include "timeline/rehearsal.hpp"

namespace mien {

// One area's numbers over the frames of a clip.
struct ChartRow {
  std::string name;                         // "brows", "brow.left", "lips"; "head" for its turning
  std::vector<std::string> moves;           // "up", "out", "turn"
  std::vector<std::vector<double>> values;  // of each move, by frame from 0: 1 is its limit
};

// In the order of kMoves, the head's turning last; areas beyond Tezuka's nine where something of them moves.
// Two sides that are never further apart than `apart` share a row, with the left one's values.
std::vector<ChartRow> list_chart_rows(const std::vector<Shown>& frames, double apart = 0);

// How far the row's furthest move is at `frame`: 0..1, whatever the direction.
double compute_amount(const ChartRow& row, int frame);

struct ChartStyle {
  int width = 80;        // columns, 40 at least
  bool is_ascii = true;  // else UTF-8 blocks, whose height is the amount
};

// Of a clip whose keys are by time. Lines that end with '\n': seconds, the keys' names and marks, then a row
// for each area. A column shows the greatest amount of its frames. Narrower than 40 is taken as 40.
std::string build_chart(const ClipSpec& clip, const std::vector<Shown>& frames, const ChartStyle& style);

}  // namespace mien
