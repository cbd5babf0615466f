// The mouths of speech: what a lip reader sees of each sound.
#include "sheet/plan_kinds.hpp"

namespace mien {

namespace {

constexpr std::size_t kMouthsInARow = 4;
constexpr double kFromTheSide_deg = 90;

// "as in pay - bay - may", of "lips shut, as in pay - bay - may".
std::string find_sample(const Viseme& viseme) {
  const std::size_t at = viseme.meaning.find("as in ");
  return at == std::string::npos ? viseme.meaning : viseme.meaning.substr(at);
}

}  // namespace

SheetPlan plan_mouths(const SheetSubject& subject, const HeadData&) {
  SheetPlan plan;
  plan.cell_px = {240, 200};
  plan.heads = {subject.spec.head};
  SheetBlock block;
  block.heading = "Each mouth from the front and the side";  // a note alone would have no line of its own
  block.note = "mien list mouths tells the sounds";
  block.columns = 2 * kMouthsInARow;
  for (const Viseme& viseme : subject.speech->visemes) {
    SheetCell cell{viseme.name, 0, viseme.pose};
    cell.framing.around = {"sn", "gn"};
    cell.framing.spread = 1.35;
    block.cells.push_back(cell);
    cell.caption = find_sample(viseme);
    cell.angle_deg = kFromTheSide_deg;
    block.cells.push_back(cell);
  }
  plan.blocks.push_back(std::move(block));
  return plan;
}

}  // namespace mien
