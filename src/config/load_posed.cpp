#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/expressions.hpp"
#include "config/load_areas.hpp"

namespace mien {

namespace {

// The line of a mix that asks most of a move.
Place find_asking_place(const YamlValue& value, const Express& express, const ExpressionBook& book,
                        const Held& held) {
  Spot spot = value.spot;
  double most = 0;
  for (const ExpressShare& share : express.shares) {
    const double asked = share.weight * book.expressions[share.expression].pose.values[held.move];
    if (asked * held.asked > 0 && std::abs(asked) > most) {
      most = std::abs(asked);
      spot = share.spot;
    }
  }
  return find_place(value.document->source, spot);
}

std::shared_ptr<const LivePose> build_live_pose(const Express& express, const ExpressionBook& book,
                                                const Number& strength, const AreaValues& areas,
                                                std::vector<LivePose::Value> values, double exaggerate) {
  auto live = std::make_shared<LivePose>();
  for (const ExpressShare& share : express.shares) {
    const Expression& expression = book.expressions[share.expression];
    live->shares.push_back({{share.weight, share.formula}, expression.pose, expression.manner});
  }
  if (express.shares.empty()) live->shares.push_back({{1, {}}, express.pose});
  live->reach = express.reach;
  live->strength = strength;
  live->areas = areas;
  live->values = std::move(values);
  live->exaggerate = exaggerate;
  return live;
}

}  // namespace

Express load_posed(const YamlMapping& entries, const ExpressionBook& book, const FormulaReader* formulas) {
  Express express;
  const YamlValue* named = find_value(entries, "express");
  if (named != nullptr) {
    express = load_express(*named, book, formulas);
    check_nine(*named, express.pose);
  } else {
    express.label = express.name = "neutral";
    if (const auto neutral = find_expression(book, "neutral")) {
      express.library = book.expressions[*neutral].library;
      express.pose = book.expressions[*neutral].pose;
    }
  }
  double strength = 1;
  FormulaPointer live_strength;
  if (const YamlValue* value = find_value(entries, "strength")) {
    if (formulas != nullptr && is_formula(*value))
      live_strength = load_formula(*value, *formulas);
    else
      load_number(*value, strength);
    if (named == nullptr)
      add_mistake(*value, "'strength' weakens nothing here; expected 'express' beside it");
    const bool is_mix = express.label.find('+') != std::string::npos;
    if (strength != 1 && is_mix) express.label = fmt::format("({})", express.label);
    if (strength != 1) express.label += fmt::format(" {:.3g}", strength);
  }
  double exaggerate = book.exaggerate;
  load_exaggerate(entries, exaggerate);
  AreaValues areas;
  LiveAreas live_areas{formulas, {}};
  if (const YamlValue* value = find_value(entries, "areas"))
    areas = load_areas(*value, formulas != nullptr ? &live_areas : nullptr);
  const bool is_live_mix =
      std::ranges::any_of(express.shares, [](const ExpressShare& share) { return share.formula != nullptr; });
  if (live_strength || is_live_mix || !live_areas.values.empty()) {
    express.live = build_live_pose(express, book, {strength, live_strength}, areas,
                                   std::move(live_areas.values), exaggerate);
    const HeldPose now = evaluate_pose(*express.live, 0);
    express.pose = now.pose;
    express.reach = now.reach;
    return express;
  }
  if (named != nullptr) express.pose = mix_poses(list_shares(express.shares, book), strength);
  const HeldPose posed = hold_pose({express.pose, express.reach, strength, areas, exaggerate});
  express.pose = posed.pose;
  express.reach = posed.reach;
  for (Held held : posed.held) {
    if (!areas.values[held.move]) {
      held.place = find_asking_place(*named, express, book, held);
      held.by = express.label;
    }
    express.held.push_back(std::move(held));
  }
  return express;
}

}  // namespace mien
