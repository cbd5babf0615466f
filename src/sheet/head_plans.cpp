// Sheets that compare heads, one function each: which heads, seen from where.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "config/words.hpp"
#include "head/shapes.hpp"
#include "sheet/plan_kinds.hpp"

namespace mien {

namespace {

constexpr double kThreeQuarter_deg = 35;  // both eyes are still whole, and the far cheek is a line
constexpr double kSide_deg = 90, kBack_deg = 180;

struct View {
  const char* caption;
  double angle_deg;
};
constexpr std::array kViews{View{"front", 0}, View{"three-quarter", kThreeQuarter_deg},
                            View{"side", kSide_deg}, View{"back", kBack_deg}};

double compute_angle(const std::string& view) {
  return view == "front" ? 0 : view == "side" ? kSide_deg : kThreeQuarter_deg;
}

// What a feature moves, with as much of the face around it as tells where it is. Seen across the face the
// near half is enough.
SheetFraming frame_feature(const FeatureInfo& feature) {
  SheetFraming framing{feature.around};
  framing.margin = 0.24;
  if (feature.view == "front")
    for (const std::string& name : feature.around)
      framing.around.push_back(name.ends_with("_l") ? name.substr(0, name.size() - 1) + "r" : "R:" + name);
  return framing;
}

}  // namespace

SheetPlan plan_views(const SheetSubject& subject, const HeadData&) {
  constexpr double kWide =
      1.52;  // Loomis' square seen from the side is as wide as high; words stand beside it
  SheetPlan plan;
  plan.cell_px = {540, 475};
  plan.heads = {subject.spec.head};
  plan.blocks.resize(2);
  for (const View& view : kViews) {
    SheetCell cell{view.caption};
    cell.angle_deg = view.angle_deg;
    cell.framing.wide = kWide;
    cell.pose = subject.pose;
    plan.blocks[0].cells.push_back(cell);
    cell.has_guides = cell.has_frame = true;
    plan.blocks[1].cells.push_back(cell);
  }
  plan.blocks[0].heading = subject.words.empty() ? "From all sides" : "From all sides: " + subject.words;
  plan.blocks[1].heading = "With its guide lines";
  return plan;
}

SheetPlan plan_details(const SheetSubject& subject, const HeadData&) {
  SheetPlan plan;
  plan.cell_px = {480, 400};
  plan.across = 2;
  plan.heads = {subject.spec.head};
  const auto add = [&](const char* heading, const SheetFraming& framing,
                       const std::array<SheetCell, 2>& cells) {
    plan.blocks.push_back({heading, "", {cells.begin(), cells.end()}});
    for (SheetCell& cell : plan.blocks.back().cells) cell.framing = framing;
  };
  const auto view = [](const char* caption, double angle_deg, double height_deg) {
    SheetCell cell{caption};
    cell.angle_deg = angle_deg;
    cell.height_deg = height_deg;
    return cell;
  };
  constexpr double kFromBelow_deg = -50;     // the nostrils are seen whole
  constexpr double kBehindTheEar_deg = 130;  // how far the ear stands off
  add("Eye", {{"en_l", "ex_l", "brow_mid_l"}, 1.7},
      {view("front", 0, 0), view("three-quarter", kThreeQuarter_deg, 0)});
  add("Mouth", {{"ch_l", "ch_r"}, 1.6}, {view("front", 0, 0), view("three-quarter", kThreeQuarter_deg, 0)});
  add("Nose", {{"n", "sn", "al_l", "al_r"}, 1.5},
      {view("three-quarter", kThreeQuarter_deg, 0), view("from below", 0, kFromBelow_deg)});
  add("Ear", {{"sa_l", "sba_l"}, 1.5},
      {view("side", kSide_deg, 0), view("three-quarter from behind", kBehindTheEar_deg, 0)});
  return plan;
}

SheetPlan plan_ages(const SheetSubject& subject, const HeadData&) {
  SheetPlan plan;
  plan.cell_px = {460, 500};
  plan.blocks.resize(2);
  plan.blocks[0].heading = "To one scale";
  plan.blocks[1].heading = "To one height";
  // The adult comes first among the heads: the others are drawn to its scale.
  Names ages = kAges;
  std::stable_partition(ages.begin(), ages.end(), [](const std::string& age) { return age == kAdult; });
  std::map<std::string, std::size_t> heads;
  for (const std::string& age : ages) {
    heads[age] = plan.heads.size();
    plan.heads.push_back(subject.spec.head);
    plan.heads.back().age = {{age, 1.0}};
    plan.heads.back().guides.clear();  // where an age has its lines is what the sheet is for
  }
  for (const std::string& age : kAges) {
    SheetCell cell{build_caption(age), heads.at(age)};
    cell.shows_height = true;
    cell.framing.scale_of = heads.at(kAdult);
    plan.blocks[0].cells.push_back(cell);
    cell.shows_height = false;
    cell.has_guides = true;
    cell.framing.scale_of = cell.head;
    plan.blocks[1].cells.push_back(cell);
  }
  return plan;
}

SheetPlan plan_skulls(const SheetSubject& subject, const HeadData&) {
  SheetPlan plan;
  plan.cell_px = {400, 480};
  plan.blocks.resize(2);
  for (const std::string& skull : kSkulls) {
    SheetCell cell{build_caption(skull), plan.heads.size()};
    plan.heads.push_back(subject.spec.head);
    plan.heads.back().skull = {{skull, 1.0}};
    plan.blocks[0].cells.push_back(cell);
    cell.angle_deg = kThreeQuarter_deg;
    plan.blocks[1].cells.push_back(cell);
  }
  return plan;
}

SheetPlan plan_features(const SheetSubject& subject, const HeadData& data) {
  SheetPlan plan;
  plan.cell_px = {280, 320};
  plan.heads = {subject.spec.head};
  for (const FeatureInfo& feature : data.shapes.features) {
    SheetBlock& block = plan.blocks.emplace_back();
    block.heading = build_caption(feature.name);
    block.note = "1: " + feature.meaning;
    plan.heads.front().features[feature.name] = 0;
    for (const int value : {-1, 0, 1}) {
      SheetCell cell{value == 0 ? "0" : fmt::format("{:+}", value)};
      if (value != 0) {
        cell.head = plan.heads.size();
        plan.heads.push_back(subject.spec.head);
        plan.heads.back().features[feature.name] = value;
      }
      cell.angle_deg = compute_angle(feature.view);
      cell.framing = frame_feature(feature);
      block.cells.push_back(cell);
    }
  }
  // About as wide as high.
  plan.across = std::max<std::size_t>(1, std::lround(std::sqrt(static_cast<double>(plan.blocks.size()) / 3)));
  return plan;
}

}  // namespace mien
