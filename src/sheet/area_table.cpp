#include "sheet/area_table.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "config/limits.hpp"
#include "core/conventions.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

// In half heights of a row.
constexpr double kLeast = 0.24, kMore = 0.46;  // an arrow's length: always, and at the limit that much more
constexpr double kApart = 0.45;                // arrows that stand side by side, from the middle
constexpr double kCornersApart = 0.9;
constexpr double kOffMiddle = 0.12;   // where a lid's or a lip's arrow begins
constexpr double kBrow = 0.5;         // half of a brow's length
constexpr double kFullTurn_deg = 25;  // of a brow: steeper than a brow is, to be seen
constexpr double kNameShare = 0.1;    // of the table's width

// The nine areas, as one sees them: the character's right is on the viewer's left.
struct Column {
  const char* heading;
  const char* area;
  Side side;
};
constexpr std::array kColumns{
    Column{"right brow", "brow", Side::right},   Column{"left brow", "brow", Side::left},
    Column{"right lids", "lid", Side::right},    Column{"left lids", "lid", Side::left},
    Column{"right eyeball", "eye", Side::right}, Column{"left eyeball", "eye", Side::left},
    Column{"lips", "lips", Side::none},          Column{"mouth corners", "corner", Side::none},
    Column{"chin", "chin", Side::none}};

double find_value(const Pose& pose, std::string_view area, Side side, std::string_view move) {
  const auto index = find_move(area, side, move);
  return index ? pose.values[*index] : 0;
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

void append_brow(const Pose& pose, Side side, std::vector<PlateLine>& strokes) {
  const double outward = side == Side::left ? 1 : -1;
  const double turn = find_value(pose, "brow", side, "turn");
  const glm::dvec2 way{outward * find_value(pose, "brow", side, "out"), find_value(pose, "brow", side, "up")};
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

void append_vector(const Pose& pose, const char* area, Side side, double x, std::vector<PlateLine>& strokes) {
  const bool is_eye = std::string_view(area) == "eye";
  const double aside = find_value(pose, area, side, is_eye ? "side" : "out");
  const double outward = is_eye || side == Side::left ? 1 : -1;
  const glm::dvec2 way{outward * aside, find_value(pose, area, side, "up")};
  if (glm::length(way) > 0)
    append_arrow({x - glm::normalize(way).x * kMore / 2, -glm::normalize(way).y * kMore / 2}, way, strokes);
}

std::vector<PlateLine> draw_area(const Pose& pose, const Column& column) {
  const std::string_view area = column.area;
  std::vector<PlateLine> strokes;
  const auto value = [&](const char* move) { return find_value(pose, area, column.side, move); };
  if (area == "brow") append_brow(pose, column.side, strokes);
  if (area == "lid" || area == "lips") append_pair(value("upper"), value("lower"), strokes);
  if (area == "eye") append_vector(pose, "eye", column.side, 0, strokes);
  if (area == "corner")
    for (const Side side : {Side::right, Side::left})
      append_vector(pose, "corner", side, side == Side::left ? kCornersApart : -kCornersApart, strokes);
  if (area == "chin")
    append_arrow({0, value("down") > 0 ? kMore : -kMore}, {0, value("up") - value("down")}, strokes);
  if (const double press = value("press"); press > 0)
    for (const double y : {kMore + kOffMiddle, -kMore - kOffMiddle})
      append_arrow({0, y * (kLeast + kMore * press + kOffMiddle) / (kMore + kOffMiddle)},
                   {0, -std::copysign(press, y)}, strokes);
  return strokes;
}

// "up 0.8, in 0.5": the ways by the last words of the limits' names; a lid that shuts has none.
std::string tell_moves(const Pose& pose, std::string_view area, Side side) {
  std::string words;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const double value = pose.values[i];
    if (value == 0 || kMoves[i].area != area || kMoves[i].side != side) continue;
    std::string way = "shut";
    for (const LimitName& limit : list_limits())
      if (limit.move == i && limit.sign * value > 0) way = limit.name.substr(limit.name.rfind('.') + 1);
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", build_caption(way),
                         format_number(std::abs(value), 2));
  }
  return words;
}

std::string tell_area(const Pose& pose, const Column& column) {
  if (std::string_view(column.area) != "corner") return tell_moves(pose, column.area, column.side);
  const std::string right = tell_moves(pose, "corner", Side::right);
  const std::string left = tell_moves(pose, "corner", Side::left);
  if (left == right) return left;
  return (right.empty() ? "" : "right " + right) + (right.empty() || left.empty() ? "" : "; ") +
         (left.empty() ? "" : "left " + left);
}

}  // namespace

SheetTable build_area_table(const std::vector<Expression>& expressions) {
  SheetTable table;
  table.is_tall = table.has_header = true;
  table.columns.emplace_back(kNameShare, 0);
  table.rows.push_back({{""}});
  for (const Column& column : kColumns) {
    table.columns.emplace_back((1 - kNameShare) / kColumns.size(), 0.5);
    table.rows.front().push_back({column.heading});
  }
  for (const Expression& expression : expressions) {
    if (expression.pose == Pose{}) continue;
    std::vector<SheetField>& row = table.rows.emplace_back();
    row.push_back({build_caption(expression.name)});
    for (const Column& column : kColumns)
      row.push_back({tell_area(expression.pose, column), draw_area(expression.pose, column)});
  }
  return table;
}

}  // namespace mien
