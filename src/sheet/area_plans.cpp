// Sheets of the nine areas: each move with arrows, and the limits drawn on the face. Which places an area has
// is told by the table of areas (config/areas.hpp); how far they go is measured on the head.
#include <fmt/format.h>

#include <algorithm>

#include "config/limits.hpp"
#include "sheet/plan_kinds.hpp"

namespace mien {

namespace {

using Places = std::vector<std::string>;

// What a PlaceText says: "E1_8..15" is "E1_8" to "E1_15", "q11_C3..6" is "q11_C3" to "q11_C6".
Places list_places(PlaceText text) {
  Places places;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    const std::size_t dots = word.find("..");
    if (dots == word.npos) {
      places.emplace_back(word);
      continue;
    }
    const std::size_t number = word.find_last_not_of("0123456789", dots - 1) + 1;
    const int first = std::stoi(std::string(word.substr(number, dots - number)));
    const int last = std::stoi(std::string(word.substr(dots + 2)));
    const int step = last > first ? 1 : -1;
    for (int i = first; i != last + step; i += step)
      places.push_back(fmt::format("{}{}", word.substr(0, number), i));
  }
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

SheetFraming build_framing(const AreaFraming& framing) {
  return {list_places(framing.around), framing.spread};
}

// Of the pictures of an area's moves: a mouth as far open as shows them.
Pose build_ground(Area area, std::string_view move) {
  double open = find_area(area).open;
  for (const MoveInfo& info : kMoves)
    if (info.of == area && info.move == move) open = std::max(open, info.open);
  Pose pose;
  if (open > 0) pose.values[*find_move(Area::chin, Side::none, "down")] = open;
  return pose;
}

// Both sides' moves of an area at `value`.
Pose build_pose(Area area, std::string_view move, double value) {
  Pose pose = build_ground(area, move);
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (kMoves[i].of == area && kMoves[i].move == move) pose.values[i] = value;
  return pose;
}

SheetMark build_line(const Places& places, const Pose& pose = {}) {
  return {MarkShape::line, places, {pose}, pose == Pose{}, {}};
}

SheetCell build_move_cell(const MoveInfo& info, double value) {
  const AreaInfo& area = find_area(info.of);
  SheetCell cell{value == 0 ? "0" : fmt::format("{:+}", value), 0, build_pose(info.of, info.move, value)};
  cell.framing = build_framing(area.framing);
  if (value == 0) return cell;
  for (const PlaceText outline : area.outlines)
    if (!outline.empty()) cell.marks.push_back(build_line(list_places(outline)));
  cell.marks.push_back(
      {MarkShape::arrow, list_places(info.arrows), {build_ground(info.of, info.move), cell.pose}, false, {}});
  return cell;
}

const MoveInfo& find_left_move(const AreaInfo& area, std::string_view move) {
  return kMoves[find_move(area.area, area.has_sides() ? Side::left : Side::none, move).value()];
}

// The four ways of two moves as the rectangle that they bound, on both sides of the face.
void append_boxes(const AreaInfo& area, std::string_view aside, const Places& left, SheetCell& cell) {
  const std::vector<Pose> poses{build_pose(area.area, "up", 1), build_pose(area.area, "up", -1),
                                build_pose(area.area, aside, 1), build_pose(area.area, aside, -1)};
  const MoveInfo& up = find_left_move(area, "up");
  const MoveInfo& across = find_left_move(area, aside);
  const auto word = [](const MoveWay& way) { return build_caption(std::string(way.name)); };
  std::vector<std::string> words{word(up.plus), word(up.minus), word(across.minus), word(across.plus)};
  cell.marks.push_back({MarkShape::box, left, poses, false, words});
  if (across.is_outward) std::swap(words[2], words[3]);
  cell.marks.push_back({MarkShape::box, mirror(left), poses, false, words});
}

void append_limit(const AreaInfo& area, const LimitMark& mark, SheetCell& cell) {
  const Places places = list_places(mark.places);
  const Pose pose = build_pose(area.area, mark.move, mark.value);
  switch (mark.shape) {
    case LimitShape::line:
      return cell.marks.push_back(build_line(places, pose));
    case LimitShape::lines:
      cell.marks.push_back(build_line(places, pose));
      return cell.marks.push_back(build_line(mirror(places), pose));
    case LimitShape::box:
      return append_boxes(area, mark.move, places, cell);
    case LimitShape::level:
      return cell.marks.push_back(
          {MarkShape::level, places, {pose}, pose == Pose{}, {std::string(mark.word)}});
  }
}

SheetCell build_limit_cell(const AreaInfo& area) {
  SheetCell cell{std::string(area.limits.caption)};
  cell.framing = build_framing(area.limits.framing);
  for (const LimitMark& mark : area.limits.marks) append_limit(area, mark, cell);
  return cell;
}

SheetTable build_limit_table(Area area) {
  SheetTable table;
  table.shows_limits = table.has_header = true;
  table.columns = {{0.22, 0}, {0.42, 0}, {0.24, 0}, {0.12, 1}};
  table.rows.push_back({{"limit"}, {"in the thesis"}, {"value"}, {"skin, mm"}});
  for (const LimitName& limit : list_limits())
    if (kMoves[limit.move].of == area)
      table.rows.push_back({{limit.name}, {limit.thesis.empty() ? "-" : limit.thesis}, {""}, {""}});
  return table;
}

}  // namespace

std::vector<SheetMark> list_limit_marks() {
  std::vector<SheetMark> marks;
  for (const AreaInfo& area : kAreas)
    for (SheetMark& mark : build_limit_cell(area).marks)
      if (!mark.is_rest && mark.shape != MarkShape::level) marks.push_back(std::move(mark));
  return marks;
}

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
  std::vector<const AreaInfo*> areas;
  for (const AreaInfo& area : kAreas) areas.push_back(&area);
  std::ranges::sort(areas, {}, [](const AreaInfo* area) { return area->limits.order; });
  for (const AreaInfo* area : areas)
    plan.blocks.push_back({std::string(area->limits.heading),
                           "",
                           {build_limit_cell(*area)},
                           0,
                           0,
                           build_limit_table(area->area)});
  return plan;
}

}  // namespace mien
