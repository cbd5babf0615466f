#include "sheet/area_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/areas.hpp"
#include "core/conventions.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

// In half heights of a row.
constexpr double kLeast = 0.24, kMore = 0.46;  // an arrow's length: always, and at the limit that much more
constexpr double kApart = 0.45;                // arrows that stand side by side, from the middle
constexpr double kSidesApart = 0.9;
constexpr double kOffMiddle = 0.12;   // where a lid's or a lip's arrow begins
constexpr double kBrow = 0.5;         // half of a brow's length
constexpr double kFullTurn_deg = 25;  // of a brow: steeper than a brow is, to be seen
constexpr double kNameShare = 0.1;    // of the table's width

// The nine areas, and others that somebody moves, as one sees them: the character's right is on the viewer's
// left.
struct Column {
  std::string heading;  // "right brow", "mouth corners"
  const AreaInfo* area;
  std::vector<Side> sides;  // whose values it shows
};
bool is_moved(const std::vector<Expression>& expressions, Area area) {
  return std::ranges::any_of(expressions, [&](const Expression& expression) {
    for (std::size_t i = 0; i < kMoveCount; ++i)
      if (kMoves[i].of == area && expression.pose.values[i] != 0) return true;
    return false;
  });
}

std::vector<Column> list_columns(const std::vector<Expression>& expressions) {
  std::vector<Column> columns;
  for (const AreaInfo& area : kAreas) {
    if (is_beyond(area) && !is_moved(expressions, area.area)) continue;
    const std::string title(area.title);
    if (!area.has_sides())
      columns.push_back({title, &area, {Side::none}});
    else if (area.is_one_column)
      columns.push_back({title, &area, {Side::right, Side::left}});
    else
      for (const Side side : {Side::right, Side::left})
        columns.push_back({(side == Side::left ? "left " : "right ") + title, &area, {side}});
  }
  return columns;
}

double find_value(const Pose& pose, const AreaInfo& area, Side side, std::string_view move) {
  const auto index = find_move(area.area, side, move);
  return index ? pose.values[*index] : 0;
}

// Up or down and aside, as the viewer sees it.
glm::dvec2 compute_way(const Pose& pose, const AreaInfo& area, Side side) {
  const auto aside = find_move(area.area, side, area.aside);
  const double mirror = aside && kMoves[*aside].is_outward && side == Side::right ? -1 : 1;
  return {mirror * find_value(pose, area, side, area.aside), find_value(pose, area, side, "up")};
}

// An arrow that begins at (x, y) and goes the way of `value`.
void append_arrow(glm::dvec2 from, glm::dvec2 value, std::vector<PlateLine>& strokes) {
  const double length = glm::length(value);
  if (length == 0) return;
  const glm::dvec2 to = from + value / length * (kLeast + kMore * std::min(length, 1.0));
  strokes.push_back({from.x, from.y, to.x, to.y, 1, 1, true});
}

// A lid or lip above and one below, beside each other so that they may pass.
void append_pair(double upper, double lower, std::vector<PlateLine>& strokes) {
  append_arrow({-kApart, upper < 0 ? kMore : kOffMiddle}, {0, upper}, strokes);
  append_arrow({kApart, lower > 0 ? -kMore : -kOffMiddle}, {0, lower}, strokes);
}

void append_turned(const Pose& pose, const AreaInfo& area, Side side, std::vector<PlateLine>& strokes) {
  const double outward = side == Side::left ? 1 : -1;
  const double turn = find_value(pose, area, side, "turn");
  const glm::dvec2 way = compute_way(pose, area, side);
  const bool has_both = turn != 0 && glm::length(way) > 0;
  const glm::dvec2 middle_of_way = glm::length(way) > 0 ? glm::normalize(way) * (kMore / 2) : glm::dvec2(0);
  append_arrow(glm::dvec2(has_both ? -2 * kApart : 0, 0) - middle_of_way, way, strokes);
  if (turn == 0) return;
  const double angle = turn * kFullTurn_deg * kRadiansPerDegree;
  const glm::dvec2 inner = kBrow * glm::dvec2(-outward * std::cos(angle), std::sin(angle));
  const double x = has_both ? kApart : 0;
  strokes.push_back({x - kBrow, 0, x + kBrow, 0, 0.5, 0.35});
  strokes.push_back({x + inner.x, inner.y, x - inner.x, -inner.y, 1.5, 1});
}

void append_way(const glm::dvec2& way, double x, std::vector<PlateLine>& strokes) {
  if (glm::length(way) > 0)
    append_arrow({x - glm::normalize(way).x * kMore / 2, -glm::normalize(way).y * kMore / 2}, way, strokes);
}

void append_side(const Pose& pose, const AreaInfo& area, Side side, double x,
                 std::vector<PlateLine>& strokes) {
  const auto value = [&](const char* move) { return find_value(pose, area, side, move); };
  switch (area.sign) {
    case AreaSign::way:
      return append_way(compute_way(pose, area, side), x, strokes);
    case AreaSign::turned_way:
      return append_turned(pose, area, side, strokes);
    case AreaSign::pair:
      return append_pair(value("upper"), value("lower"), strokes);
    case AreaSign::lift:
      return append_arrow({0, value("down") > 0 ? kMore : -kMore}, {0, value("up") - value("down")}, strokes);
    case AreaSign::words:
      return;
  }
}

std::vector<PlateLine> draw_area(const Pose& pose, const Column& column) {
  std::vector<PlateLine> strokes;
  for (const Side side : column.sides) {
    const double x = column.sides.size() == 1 ? 0 : side == Side::left ? kSidesApart : -kSidesApart;
    append_side(pose, *column.area, side, x, strokes);
    if (const double press = find_value(pose, *column.area, side, "press"); press > 0)
      for (const double y : {kMore + kOffMiddle, -kMore - kOffMiddle})
        append_arrow({0, y * (kLeast + kMore * press + kOffMiddle) / (kMore + kOffMiddle)},
                     {0, -std::copysign(press, y)}, strokes);
  }
  return strokes;
}

// "up 0.8, in 0.5".
std::string describe_moves(const Pose& pose, const AreaInfo& area, Side side) {
  std::string words;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const double value = pose.values[i];
    if (value == 0 || kMoves[i].of != area.area || kMoves[i].side != side) continue;
    const std::string way((value > 0 ? kMoves[i].plus : kMoves[i].minus).name);
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", build_caption(way),
                         format_number(std::abs(value), 2));
  }
  return words;
}

std::string describe_area(const Pose& pose, const Column& column) {
  if (column.sides.size() == 1) return describe_moves(pose, *column.area, column.sides.front());
  const std::string right = describe_moves(pose, *column.area, Side::right);
  const std::string left = describe_moves(pose, *column.area, Side::left);
  if (left == right) return left;
  return (right.empty() ? "" : "right " + right) + (right.empty() || left.empty() ? "" : "; ") +
         (left.empty() ? "" : "left " + left);
}

}  // namespace

SheetTable build_area_table(const std::vector<Expression>& expressions) {
  SheetTable table;
  table.is_tall = table.has_header = true;
  const std::vector<Column> columns = list_columns(expressions);
  table.columns.emplace_back(kNameShare, 0);
  table.rows.push_back({{""}});
  for (const Column& column : columns) {
    table.columns.emplace_back((1 - kNameShare) / static_cast<double>(columns.size()), 0.5);
    table.rows.front().push_back({column.heading});
  }
  for (const Expression& expression : expressions) {
    if (expression.pose == Pose{}) continue;
    std::vector<SheetField>& row = table.rows.emplace_back();
    row.push_back({build_caption(expression.name)});
    for (const Column& column : columns)
      row.push_back({describe_area(expression.pose, column), draw_area(expression.pose, column)});
  }
  return table;
}

}  // namespace mien
