// Sheets of the nine areas: each move with arrows, and the limits drawn on the face. Which places an area has
// is told here; how far they go is measured on the head.
//
// Points of the cage: E1_0..15 an eye's rim (0 inner corner, 1..7 upper lid, 8 outer corner, 9..15 lower
// lid), E5_2..6 the brow, M1 and M3 the lips' contact and border (0 the upper lip's middle, 6 corner, 12 the
// lower's).
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "config/limits.hpp"
#include "sheet/plan_kinds.hpp"

namespace mien {

namespace {

using Places = std::vector<std::string>;

// "E1_8" to "E1_15"; downward if `last` is less.
Places list_ring(const char* ring, int first, int last) {
  Places places;
  for (int i = first; i != last; i += last > first ? 1 : -1) places.push_back(fmt::format("{}_{}", ring, i));
  places.push_back(fmt::format("{}_{}", ring, last));
  return places;
}

Places join(Places places, const Places& more) {
  places.insert(places.end(), more.begin(), more.end());
  return places;
}

// The same places on the character's right.
Places mirror(Places places) {
  for (std::string& place : places)
    if (place.ends_with("_l"))
      place.back() = 'r';
    else
      place.insert(0, "R:");
  return places;
}

const Places kBrow = list_ring("E5", 2, 6);
const Places kUpperLid = list_ring("E1", 0, 8), kLowerLid = join(list_ring("E1", 8, 15), {"E1_0"});
const Places kUpperLip = join(mirror(list_ring("M3", 6, 1)), list_ring("M3", 0, 6));
const Places kLowerLip = join(mirror(list_ring("M3", 6, 11)), list_ring("M3", 12, 6));
const Places kContact = join(mirror(list_ring("M1", 6, 1)), list_ring("M1", 0, 6));
const Places kJaw = join(mirror(list_ring("M6", 8, 11)), list_ring("M6", 12, 8));

// Both sides' moves of an area at `value`.
Pose build_pose(std::string_view area, std::string_view move, double value) {
  Pose pose;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (kMoves[i].area == area && kMoves[i].move == move) pose.values[i] = value;
  return pose;
}

// How a move is looked at.
struct AreaView {
  const char* area;
  SheetFraming framing;
  std::vector<Places> outlines;  // where they lie at rest
};

const AreaView& find_area_view(std::string_view area) {
  static const std::vector<AreaView> views{
      {"brow", {{"en_l", "ex_l", "brow_inner_l", "brow_outer_l", "brow_mid_l"}, 1.45}, {kBrow}},
      {"lid", {{"en_l", "ex_l"}, 1.35}, {kUpperLid, kLowerLid}},
      {"eye", {{"en_l", "ex_l"}, 1.35}, {}},
      {"lips", {{"ch_l", "ch_r"}, 1.3}, {kUpperLip, kLowerLip}},
      {"corner", {{"ch_l", "ch_r"}, 1.5}, {kUpperLip, kLowerLip}},
      {"chin", {{"li", "gn"}, 3.2}, {kJaw}}};
  return *std::ranges::find(views, area, &AreaView::area);
}

// Whose ways are drawn.
Places list_arrows(const MoveInfo& info) {
  const bool is_upper = info.move == "upper";
  if (info.area == "brow" && info.move == "turn") return {"E5_2", "E5_3", "E5_5", "E5_6"};
  if (info.area == "brow") return {"brow_mid_l", "brow_inner_l", "brow_outer_l"};
  if (info.area == "lid")
    return is_upper ? Places{"E1_4", "E1_2", "E1_6"} : Places{"E1_12", "E1_10", "E1_14"};
  if (info.area == "eye") return {"pupil_l"};
  if (info.move == "press") return {"M3_12", "M3_0"};
  if (info.area == "lips")
    return is_upper ? Places{"M3_0", "M3_3", "R:M3_3"} : Places{"M3_12", "M3_9", "R:M3_9"};
  if (info.area == "corner") return {"ch_l", "ch_r"};
  return {"pg", "M6_9", "R:M6_9"};
}

SheetMark build_line(const Places& places, const Pose& pose = {}) {
  return {MarkShape::line, places, {pose}, pose == Pose{}, {}};
}

SheetCell build_move_cell(const MoveInfo& info, double value) {
  const AreaView& view = find_area_view(info.area);
  SheetCell cell{value == 0 ? "0" : fmt::format("{:+}", value), 0, build_pose(info.area, info.move, value)};
  cell.framing = view.framing;
  if (value == 0) return cell;
  for (const Places& outline : view.outlines) cell.marks.push_back(build_line(outline));
  cell.marks.push_back({MarkShape::arrow, list_arrows(info), {Pose{}, cell.pose}, false, {}});
  return cell;
}

// The four ways of two moves as the rectangle that they bound, on both sides of the face.
void append_boxes(const char* area, const char* aside, const Places& left, SheetCell& cell) {
  const std::vector<Pose> poses{build_pose(area, "up", 1), build_pose(area, "up", -1),
                                build_pose(area, aside, 1), build_pose(area, aside, -1)};
  const bool is_eye = std::string_view(area) == "eye";
  cell.marks.push_back({MarkShape::box,
                        left,
                        poses,
                        false,
                        {"up", "down", is_eye ? "to right" : "in", is_eye ? "to left" : "out"}});
  cell.marks.push_back({MarkShape::box,
                        mirror(left),
                        poses,
                        false,
                        {"up", "down", is_eye ? "to right" : "out", is_eye ? "to left" : "in"}});
}

void append_lines(const Places& left, const Pose& pose, SheetCell& cell) {
  cell.marks.push_back(build_line(left, pose));
  cell.marks.push_back(build_line(mirror(left), pose));
}

SheetMark build_level(const char* place, const Pose& pose, const char* word) {
  return {MarkShape::level, {place}, {pose}, pose == Pose{}, {word}};
}

SheetCell draw_brow_limits() {
  SheetCell cell;
  cell.framing = {{"ex_l", "ex_r", "brow_mid_l", "brow_mid_r"}, 0.98};
  append_lines(kBrow, {}, cell);
  for (const double turn : {1, -1}) append_lines(kBrow, build_pose("brow", "turn", turn), cell);
  append_boxes("brow", "out", kBrow, cell);
  return cell;
}

SheetCell draw_corner_limits() {
  SheetCell cell;
  cell.framing = {{"ch_l", "ch_r"}, 1.35};
  for (const Places& lip : {kUpperLip, kLowerLip}) cell.marks.push_back(build_line(lip));
  append_boxes("corner", "out", {"ch_l"}, cell);
  return cell;
}

// One eye with its lids at rest: beside two there is no room for words.
SheetCell draw_one_eye() {
  SheetCell cell;
  cell.framing = {{"en_l", "ex_l"}, 1.35};
  for (const Places& lid : {kUpperLid, kLowerLid}) append_lines(lid, {}, cell);
  return cell;
}

SheetCell draw_eye_limits() {
  SheetCell cell = draw_one_eye();
  append_boxes("eye", "side", {"pupil_l"}, cell);
  return cell;
}

SheetCell draw_lid_limits() {
  SheetCell cell = draw_one_eye();
  append_lines(kUpperLid, build_pose("lid", "upper", 1), cell);
  append_lines(kLowerLid, build_pose("lid", "lower", 1), cell);
  cell.marks.push_back(build_level("E1_4", build_pose("lid", "upper", 1), "upper"));
  cell.marks.push_back(build_level("E1_12", build_pose("lid", "lower", 1), "lower"));
  cell.marks.push_back(build_level("E1_12", {}, "where both end below"));
  return cell;
}

SheetCell draw_lips_limits() {
  SheetCell cell;
  cell.framing = {{"ch_l", "ch_r"}, 1.35};
  for (const Places& lip : {kUpperLip, kLowerLip}) cell.marks.push_back(build_line(lip));
  const Pose up = build_pose("lips", "upper", 1), down = build_pose("lips", "lower", -1);
  cell.marks.push_back(build_line(kUpperLip, up));
  cell.marks.push_back(build_line(kLowerLip, down));
  cell.marks.push_back(build_level("M3_0", up, "upper up"));
  cell.marks.push_back(build_level("M1_0", {}, "match level"));
  cell.marks.push_back(build_level("M3_12", down, "lower down"));
  return cell;
}

SheetCell draw_chin_limits() {
  SheetCell cell;
  cell.framing = {{"li", "gn"}, 3.4};
  const Pose down = build_pose("chin", "down", 1), up = build_pose("chin", "up", 1);
  for (const Pose& pose : {Pose{}, up, down}) cell.marks.push_back(build_line(kJaw, pose));
  cell.marks.push_back(build_level("M6_12", up, "up"));
  cell.marks.push_back(build_level("M6_12", {}, "at rest"));
  cell.marks.push_back(build_level("M6_12", down, "down"));
  return cell;
}

struct LimitView {
  const char* area;
  const char* heading;
  const char* caption;
  SheetCell (*draw)();
};
constexpr std::array kLimitViews{
    LimitView{"brow", "Eyebrows", "each stays in its rectangle, and between its two turns", draw_brow_limits},
    LimitView{"corner", "Mouth corners", "each stays in its rectangle", draw_corner_limits},
    LimitView{"eye", "Eyeballs", "each pupil stays in its rectangle", draw_eye_limits},
    LimitView{"lips", "Lips", "both stop where they meet, at the match level", draw_lips_limits},
    LimitView{"lid", "Eyelids", "both end below where the lower lid rests", draw_lid_limits},
    LimitView{"chin", "Chin", "turns about the jaw's axis; stops above where the lips meet",
              draw_chin_limits}};

SheetTable build_limit_table(std::string_view area) {
  SheetTable table;
  table.tells_limits = table.has_header = true;
  table.columns = {{0.22, 0}, {0.42, 0}, {0.24, 0}, {0.12, 1}};
  table.rows.push_back({{"limit"}, {"in the thesis"}, {"value"}, {"skin, mm"}});
  for (const LimitName& limit : list_limits())
    if (kMoves[limit.move].area == area)
      table.rows.push_back({{limit.name}, {limit.thesis.empty() ? "-" : limit.thesis}, {""}, {""}});
  return table;
}

}  // namespace

SheetPlan plan_areas(const SheetSubject& subject, const HeadData&) {
  SheetPlan plan;
  plan.cell_px = {360, 300};
  plan.across = 2;
  plan.heads = {subject.spec.head};
  for (const MoveInfo& info : kMoves) {
    if (info.side == Side::right) continue;
    SheetBlock& block = plan.blocks.emplace_back();
    block.heading = fmt::format("{}: {}", info.area, info.move);
    block.note = info.meaning;
    block.skipped = info.low < 0 ? 0 : 1;  // what has no way back has no picture of it
    for (const double value : {-1, 0, 1})
      if (value >= info.low) block.cells.push_back(build_move_cell(info, value));
  }
  return plan;
}

SheetPlan plan_limits(const SheetSubject& subject, const HeadData&) {
  SheetPlan plan;
  plan.cell_px = {800, 600};
  plan.across = 3;
  plan.heads = {subject.spec.head};
  for (const LimitView& view : kLimitViews) {
    plan.blocks.push_back({view.heading, "", {view.draw()}, 0, 0, build_limit_table(view.area)});
    plan.blocks.back().cells.front().caption = view.caption;
  }
  return plan;
}

}  // namespace mien
