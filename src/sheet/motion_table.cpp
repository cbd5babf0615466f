#include "sheet/motion_table.hpp"

#include <fmt/format.h>

#include "frames/skin_motion.hpp"

namespace mien {

std::vector<SheetField> list_motion_headings(const std::string& likeness) {
  std::vector<SheetField> fields;
  for (const std::string_view region : kSkinRegions) fields.push_back({fmt::format("{}, mm", region)});
  fields.push_back({likeness});
  return fields;
}

std::vector<SheetField> list_motion_fields() { return std::vector<SheetField>(kSkinRegions.size() + 1); }

void fill_motions(const Figure& figure, SheetPlan& plan) {
  for (SheetBlock& block : plan.blocks)
    for (std::size_t row = 0; row < block.table.motions.size(); ++row) {
      const auto& motion = block.table.motions[row];
      if (!motion) continue;
      const SkinMotion moved = measure_motion(figure, motion->first);
      SheetField* field =
          &*(block.table.rows[row].end() - static_cast<std::ptrdiff_t>(kSkinRegions.size() + 1));
      for (const double mean_mm : moved.mean_mm) (field++)->words = fmt::format("{:.1f}", mean_mm);
      field->words = fmt::format("{:.2f}", compute_likeness(moved, measure_motion(figure, motion->second)));
    }
}

}  // namespace mien
