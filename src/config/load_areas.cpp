#include "config/load_areas.hpp"

#include <fmt/format.h>

#include "config/ledger.hpp"
#include "config/parke.hpp"

namespace mien {

namespace {

// A formula instead of a number; false if there is none.
bool load_live_value(const YamlValue& value, const std::vector<std::size_t>& moves, AreaValues& areas,
                     LiveAreas* live) {
  if (live == nullptr || !is_formula(value)) return false;
  const FormulaPointer formula = load_formula(value, *live->formulas);
  for (const std::size_t move : moves) {
    const MoveInfo& info = kChannels[move];
    areas.values[move].reset();
    areas.places.erase(move);
    std::erase_if(live->values, [&](const LivePose::Value& other) { return other.move == move; });
    if (formula)
      live->values.push_back({move, formula, info.low * kMaxExaggerate, info.high * kMaxExaggerate,
                              find_place(value.document->source, value.spot)});
  }
  return true;
}

// What stands for `meant`, a move of one side or of both.
void load_values(const YamlEntry& entry, const std::vector<std::size_t>& meant, AreaValues& areas,
                 LiveAreas* live) {
  if (!meant.empty() && !check_nine(entry.value, entry.spot, meant.front())) return;
  if (load_live_value(entry.value, meant, areas, live)) return;
  for (const std::size_t move : meant) {
    const MoveInfo& info = kChannels[move];
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

void load_area(const YamlValue& value, const AreaKey& key, AreaValues& areas, LiveAreas* live) {
  const YamlMapping moves = load_section(value);
  for (const YamlEntry& entry : moves) {
    std::vector<std::size_t> meant = list_moves_of(key);
    std::erase_if(meant, [&](std::size_t move) { return kMoves[move].move != entry.key; });
    load_values(entry, meant, areas, live);
  }
}

// "zygomatic_major.left", or "AU10": the channels that it means.
template <std::size_t Count>
std::vector<std::size_t> list_channels_of(std::string_view doctrine,
                                          const std::array<ChannelRow, Count>& rows, std::string_view name) {
  const std::size_t dot = name.find('.');
  const std::string_view stem = name.substr(0, dot);
  const auto row = std::ranges::find_if(rows, [&](const ChannelRow& one) {
    return one.name == stem || (!one.alias.empty() && one.alias == stem);
  });
  std::vector<std::size_t> channels;
  if (row == rows.end()) return channels;
  for (const Side side : {Side::none, Side::left, Side::right})
    if (const auto found = find_channel(doctrine, side, row->name);
        found && (dot == name.npos || name.substr(dot + 1) == (side == Side::left ? "left" : "right")))
      channels.push_back(*found);
  return channels;
}

// Both sides first, then what one side has of its own.
template <std::size_t Count>
void load_channels(const YamlMapping& entries, std::string_view doctrine,
                   const std::array<ChannelRow, Count>& rows, AreaValues& areas, LiveAreas* live) {
  const YamlValue* value = find_value(entries, doctrine);
  if (value == nullptr) return;
  const YamlMapping named = load_section(*value);
  for (const bool is_sided_pass : {false, true})
    for (const YamlEntry& entry : named)
      if ((entry.key.find('.') != std::string::npos) == is_sided_pass)
        load_values(entry, list_channels_of(doctrine, rows, entry.key), areas, live);
}

// The sums of what the parameters do, where no area says otherwise.
void load_parke(const YamlMapping& entries, AreaValues& areas) {
  const YamlValue* value = find_value(entries, kParkeKey);
  if (value == nullptr) return;
  std::array<std::optional<double>, kMoveCount> sums;
  for (const YamlEntry& entry : load_section(*value)) {
    const auto row = std::ranges::find(kParkeRows, entry.key, &ParkeRow::name);
    double number = 0;
    if (row == kParkeRows.end() || !load_number(entry.value, number)) continue;
    for (const ChannelMove& each : number < 0 ? row->minus : row->plus)
      for (const Side side : {Side::none, Side::left, Side::right})
        if (const auto move = find_move(each.area, side, each.move); move && !each.area.empty()) {
          if (!check_nine(entry.value, entry.spot, *move)) return;
          const double before = sums[*move].value_or(areas.values[*move].value_or(0));
          sums[*move] = before + std::abs(number) * each.value;
        }
  }
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (sums[i]) areas.values[i] = std::clamp(*sums[i], kMoves[i].low, kMoves[i].high);
}

}  // namespace

bool check_nine(const YamlValue& value, const Spot& spot, std::size_t move) {
  if (!value.findings->keeps_to_nine || !kChannels[move].is_beyond) return true;
  add_mistake(
      *value.findings, value.document->source, spot,
      fmt::format("'{}.{}' is beyond the nine areas, which 'head' says with 'areas: nine'; expected one "
                  "of them, or 'areas: all'",
                  kChannels[move].area, kChannels[move].move));
  return false;
}

bool check_nine(const YamlValue& value, const Pose& pose) {
  for (std::size_t i = 0; i < kChannelCount; ++i)
    if (pose.values[i] != 0 && !check_nine(value, value.spot, i)) return false;
  return true;
}

Names list_area_keys() {
  Names names;
  for (const AreaKey& key : kAreaKeys) names.emplace_back(key.key);
  return names;
}

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
  load_parke(entries, areas);
  for (const bool is_plural_pass : {true, false})
    for (const AreaKey& key : kAreaKeys)
      if (const YamlValue* value = find_value(entries, key.key);
          value != nullptr && key.is_both == is_plural_pass)
        load_area(*value, key, areas, live);
  load_channels(entries, kMusclesKey, kMuscleRows, areas, live);
  load_channels(entries, kCandideKey, kUnitRows, areas, live);
  return areas;
}

std::size_t count_area_numbers(const YamlMapping& entries) {
  std::size_t count = 0;
  for (const YamlEntry& entry : entries) {
    const bool is_of_face = entry.key == kMusclesKey || entry.key == kCandideKey || entry.key == kParkeKey ||
                            std::ranges::find(kAreaKeys, entry.key, &AreaKey::key) != kAreaKeys.end();
    if (is_of_face && find_node(entry.value).kind == NodeKind::mapping)
      count += load_free_mapping(entry.value, "").size();
  }
  return count;
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
