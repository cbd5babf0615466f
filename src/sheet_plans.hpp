// The kinds of sheets as plans: plain data that says which heads are seen from where. What makes pictures of
// a plan is the same for all kinds.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "config/spec.hpp"

namespace mien {

// What a cell's camera, which sees without perspective, takes in.
struct SheetFraming {
  // Landmarks, or points of the cage, in whose middle it looks; none: the head from chin to crown.
  std::vector<std::string> around;
  // With landmarks: the frame's side is `spread` times the longest way between two of them, and `margin`
  // heights of the head more.
  double spread = 1, margin = 0;
  double wide = 1;           // without: the frame's width in heights of the head
  std::size_t scale_of = 0;  // the head that decides; one before the cell's own, or that itself
};

struct SheetCell {
  std::string caption;
  std::size_t head = 0;  // of SheetPlan::heads
  Pose pose{};
  double angle_deg = 0, height_deg = 0;  // of the camera, as in CameraKey
  SheetFraming framing{};
  bool has_guides = false;    // the guide lines are drawn over
  bool has_frame = false;     // and Loomis' frame of units around the head
  bool tells_height = false;  // behind the caption: ", 228 mm", from chin to crown
};

// Cells in a row under a heading.
struct SheetBlock {
  std::string heading, note;  // may be empty
  std::vector<SheetCell> cells;
};

struct SheetPlan {
  std::string subject;                    // "Views": under the title
  std::pair<int, int> cell_px{400, 500};  // a cell's size unless --size says another
  std::size_t across = 1;                 // blocks side by side
  std::vector<HeadSpec> heads;
  std::vector<SheetBlock> blocks;  // each with as many cells as the first
};

// The plan of one kind of sheet for the head of `spec`. Throws InputError "unknown kind 'vews'; did you mean
// 'views'?".
SheetPlan build_sheet_plan(const std::string& kind, const Spec& spec,
                           const std::filesystem::path& data_folder);

// Throws InputError as build_sheet_plan does for a word that is no kind.
void check_sheet_kind(const std::string& kind);

}  // namespace mien
