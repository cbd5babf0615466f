// Six feelings by the areas, by muscles, by units and by parameters, on one head.
#include <fmt/format.h>

#include <array>

#include "config/load_spec.hpp"
#include "config/words.hpp"
#include "sheet/motion_table.hpp"
#include "sheet/plan_kinds.hpp"

namespace mien {

namespace {

// What each doctrine's library calls them; the first stands for joy.
constexpr std::array kSixFeelings{"smile", "anger", "surprise", "fear", "sadness", "disgust"};

struct DoctrineColumn {
  const char* library;
  const char* caption;
};
constexpr std::array kDoctrineColumns{DoctrineColumn{"mien", "areas"}, DoctrineColumn{"muscles", "muscles"},
                                      DoctrineColumn{"candide", "candide"}, DoctrineColumn{"parke", "parke"}};

// The face from hairline to chin.
SheetCell build_doctrine_cell(const std::string& caption, const Pose& pose) {
  SheetCell cell{caption, 0, pose};
  cell.framing.around = {"tr", "gn"};
  cell.framing.spread = 1.3;
  return cell;
}

}  // namespace

SheetPlan plan_doctrines(const SheetSubject& subject, const HeadData&) {
  SheetPlan plan;
  plan.cell_px = {360, 360};
  plan.heads = {subject.spec.head};
  SheetTable table;
  table.has_header = true;
  table.columns = {{0.12, 0}, {0.12, 0}, {0.1, 1}, {0.1, 1}, {0.1, 1},
                   {0.16, 1}, {0.1, 1},  {0.1, 1}, {0.1, 1}};
  table.rows.push_back({{"feeling"}, {"by"}, {"numbers"}});
  for (SheetField& heading : list_motion_headings("as areas")) table.rows[0].push_back(std::move(heading));
  table.motions.emplace_back();
  for (const char* feeling : kSixFeelings) {
    SheetBlock& block = plan.blocks.emplace_back();
    block.heading = feeling == kSixFeelings.front() ? "joy" : feeling;
    block.columns = kDoctrineColumns.size();
    const Pose& ours = find_expression(subject.spec, "mien/" + std::string(feeling)).pose;
    for (const auto& [library, caption] : kDoctrineColumns) {
      const Expression& expression = find_expression(subject.spec, fmt::format("{}/{}", library, feeling));
      block.cells.push_back(build_doctrine_cell(caption, expression.pose));
      table.rows.push_back({{library == kDoctrineColumns.front().library ? block.heading : ""},
                            {caption},
                            {std::to_string(expression.numbers)}});
      for (SheetField& field : list_motion_fields()) table.rows.back().push_back(std::move(field));
      table.motions.emplace_back(std::pair{expression.pose, ours});
    }
  }
  SheetBlock& last = plan.blocks.emplace_back();
  last.heading = "What each moves";
  last.note =
      "numbers: that stand in its text; the mean way of each region's skin; as areas: the cosine with the "
      "first";
  last.table = std::move(table);
  return plan;
}

}  // namespace mien
