// The head's own expressions on every design of it, each in its own style.
#include <algorithm>
#include <array>

#include "config/design_data.hpp"
#include "config/load_spec.hpp"
#include "config/words.hpp"
#include "sheet/plan_kinds.hpp"

namespace mien {

SheetPlan plan_designs(const SheetSubject& subject, const HeadData& data) {
  constexpr std::array kFaces{"neutral", "smile", "surprise", "anger", "sadness"};
  SheetPlan plan;
  plan.cell_px = {300, 375};
  std::vector<std::pair<std::string, Style>> columns{{kReal, Style::studio}};
  for (const Design& design : data.designs) columns.emplace_back(design.name, design.style);
  for (const auto& [name, style] : columns) {
    plan.heads.push_back(subject.spec.head);
    plan.heads.back().design = {{name, 1.0}};
    plan.styles.push_back(style);
  }
  for (const char* face : kFaces) {
    SheetBlock& block = plan.blocks.emplace_back();
    block.heading = build_caption(face);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      SheetCell cell{build_caption(columns[i].first), i};
      cell.pose = find_expression(subject.spec, face).pose;
      block.cells.push_back(cell);
    }
  }
  return plan;
}

}  // namespace mien
