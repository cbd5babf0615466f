#include "config/load_areas.hpp"

#include <fmt/format.h>

#include "config/ledger.hpp"

namespace mien {

namespace {

// A formula instead of a number; false if there is none.
bool load_live_value(const YamlValue& value, const std::vector<std::size_t>& moves, AreaValues& areas,
                     LiveAreas* live) {
  if (live == nullptr || !is_formula(value)) return false;
  const FormulaPointer formula = load_formula(value, *live->formulas);
  for (const std::size_t move : moves) {
    const MoveInfo& info = kMoves[move];
    areas.values[move].reset();
    areas.places.erase(move);
    std::erase_if(live->values, [&](const LivePose::Value& other) { return other.move == move; });
    if (formula)
      live->values.push_back({move, formula, info.low * kMaxExaggerate, info.high * kMaxExaggerate,
                              find_place(value.document->source, value.spot)});
  }
  return true;
}

void load_area(const YamlValue& value, const AreaKey& key, AreaValues& areas, LiveAreas* live) {
  const YamlMapping moves = load_section(value);
  for (const YamlEntry& entry : moves) {
    std::vector<std::size_t> meant = list_moves_of(key);
    std::erase_if(meant, [&](std::size_t move) { return kMoves[move].move != entry.key; });
    if (!meant.empty() && !check_nine(entry.value, entry.spot, meant.front())) continue;
    if (load_live_value(entry.value, meant, areas, live)) continue;
    for (const std::size_t move : meant) {
      const MoveInfo& info = kMoves[move];
      double number = 0;
      if (!load_number(entry.value, number)) break;
      areas.values[move] = number;
      areas.places.erase(move);  // of a plural key that this one overrides
      if (live != nullptr)
        std::erase_if(live->values, [&](const LivePose::Value& other) { return other.move == move; });
      if (number < info.low || number > info.high)
        areas.places[move] = find_place(entry.value.document->source, entry.value.spot);
    }
  }
}

}  // namespace

bool check_nine(const YamlValue& value, const Spot& spot, std::size_t move) {
  if (!value.findings->keeps_to_nine || !kMoves[move].is_beyond) return true;
  add_mistake(
      *value.findings, value.document->source, spot,
      fmt::format("'{}.{}' is beyond the nine areas, which 'head' says with 'areas: nine'; expected one "
                  "of them, or 'areas: all'",
                  kMoves[move].area, kMoves[move].move));
  return false;
}

bool check_nine(const YamlValue& value, const Pose& pose) {
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (pose.values[i] != 0 && !check_nine(value, value.spot, i)) return false;
  return true;
}

Names list_area_keys() { return list_keys(find_sections().areas); }

std::vector<std::size_t> list_moves_of(const AreaKey& key) {
  std::vector<std::size_t> moves;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (kMoves[i].area == key.area && (key.is_both || kMoves[i].side == key.side)) moves.push_back(i);
  return moves;
}

AreaValues load_areas(const YamlValue& value, LiveAreas* live) {
  return load_areas(load_section(value), live);
}

AreaValues load_areas(const YamlMapping& entries, LiveAreas* live) {
  AreaValues areas;
  for (const bool is_plural_pass : {true, false})
    for (const AreaKey& key : kAreaKeys)
      if (const YamlValue* value = find_value(entries, key.key);
          value != nullptr && key.is_both == is_plural_pass)
        load_area(*value, key, areas, live);
  return areas;
}

AreaNumbers load_area_numbers(const YamlValue& value) {
  AreaNumbers numbers;
  const YamlMapping entries = load_section(value);
  for (const bool is_plural_pass : {true, false})
    for (const AreaKey& key : kAreaKeys) {
      const YamlValue* entry = key.is_both == is_plural_pass ? find_value(entries, key.key) : nullptr;
      double number = 0;
      if (entry == nullptr || !load_number(*entry, number)) continue;
      for (const std::size_t move : list_moves_of(key)) numbers[move] = number;
    }
  return numbers;
}

}  // namespace mien
