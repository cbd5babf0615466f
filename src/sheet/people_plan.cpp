// Twelve people: one sheet's look at how heads differ.
#include <fmt/format.h>

#include <algorithm>

#include "config/head_words.hpp"
#include "core/seeded.hpp"
#include "sheet/plan_kinds.hpp"

namespace mien {

namespace {

constexpr int kPeople = 12;
constexpr std::size_t kInARow = 4;
constexpr double kTurned_deg = 22;  // the profile of nose and cheek shows, and both eyes are whole
constexpr double kWide = 0.92;      // of the head's height: hair has room

}  // namespace

SheetPlan plan_people(const SheetSubject& subject, const HeadData& data) {
  SheetPlan plan;
  plan.cell_px = {400, 440};
  SheetBlock& block = plan.blocks.emplace_back();
  block.note = "each is what head: {random: SEED} and mien new NAME --random-head SEED make";
  block.columns = kInARow;
  const int first = std::min(subject.seed, kMaxSeed - kPeople + 1);
  block.heading = fmt::format("Seeds {} to {}", first, first + kPeople - 1);
  for (int seed = first; seed < first + kPeople; ++seed) {
    SheetCell cell{fmt::format("{}", seed), plan.heads.size()};
    cell.angle_deg = kTurned_deg;
    cell.framing.wide = kWide;
    cell.framing.scale_of = cell.head;  // tall hair on a tall head has room too
    block.cells.push_back(cell);
    HeadSpec& head = plan.heads.emplace_back(subject.spec.head);
    draw_person(data.words.people, static_cast<std::uint64_t>(seed), head);
    set_greying(data.words.greying, head.look);
  }
  return plan;
}

}  // namespace mien
