#include "config/load_areas.hpp"

#include "config/ledger.hpp"

namespace mien {

namespace {

// The moves of an area: those of one of its sides if it has two.
Names list_moves(const AreaKey& key) {
  const Side side = key.is_both ? Side::left : key.side;
  Names moves;
  for (const MoveInfo& info : kMoves)
    if (info.area == key.area && info.side == side) moves.emplace_back(info.move);
  return moves;
}

void load_area(const YamlValue& value, const AreaKey& key, AreaValues& areas) {
  const YamlMapping moves = load_mapping(value, list_moves(key), "moves such as {up: 0.5}", "move");
  for (const YamlEntry& entry : moves)
    for (const Side side : {Side::none, Side::left, Side::right}) {
      if (key.is_both ? side == Side::none : side != key.side) continue;
      const std::size_t move = *find_move(key.area, side, entry.key);
      const MoveInfo& info = kMoves[move];
      double number = 0;
      if (!load_number(entry.value, info.low * kMaxExaggerate, info.high * kMaxExaggerate, number,
                       "times its limit"))
        break;
      areas.values[move] = number;
      areas.places.erase(move);  // of a plural key that this one overrides
      if (number < info.low || number > info.high)
        areas.places[move] = find_place(entry.value.document->source, entry.value.spot);
    }
}

}  // namespace

Names list_area_keys() {
  Names keys;
  for (const AreaKey& key : kAreaKeys) keys.emplace_back(key.key);
  return keys;
}

AreaValues load_areas(const YamlValue& value) {
  return load_areas(load_mapping(value, list_area_keys(), "areas such as {brows: {up: 0.5}}", "area"));
}

AreaValues load_areas(const YamlMapping& entries) {
  AreaValues areas;
  for (const bool is_plural_pass : {true, false})
    for (const AreaKey& key : kAreaKeys)
      if (const YamlValue* value = find_value(entries, key.key);
          value != nullptr && key.is_both == is_plural_pass)
        load_area(*value, key, areas);
  return areas;
}

}  // namespace mien
