#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/load_areas.hpp"
#include "config/load_clip.hpp"
#include "core/ticks.hpp"

namespace mien {

namespace {

// `area` and `move` as moves of kMoves; empty with a mistake told.
std::vector<std::size_t> load_moves(const YamlMapping& entries, const YamlValue& item) {
  const YamlValue* area = find_required(entries, "area", item, "an area such as brow.left");
  const YamlValue* move = find_required(entries, "move", item, "a move of the area such as up");
  std::string area_name, move_name;
  if (area == nullptr || move == nullptr || !load_name(*area, area_name)) return {};
  std::vector<std::size_t> moves = list_moves_of(*std::ranges::find(kAreaKeys, area_name, &AreaKey::key));
  Names names;
  for (const std::size_t each : moves)
    if (std::ranges::find(names, kMoves[each].move) == names.end()) names.emplace_back(kMoves[each].move);
  if (!load_name(*move, "move", names, move_name)) return {};
  std::erase_if(moves, [&](std::size_t each) { return kMoves[each].move != move_name; });
  if (!moves.empty() && !check_nine(*move, move->spot, moves.front())) return {};
  return moves;
}

// `range: [-1, 1]`.
void load_range(const YamlMapping& entries, double& low, double& high) {
  const YamlValue* value = find_value(entries, "range");
  if (value == nullptr) return;
  const std::vector<YamlValue> items = load_list(*value, "two numbers such as [-0.5, 1]");
  double least = low, most = high;
  if (items.size() != 2) {
    if (find_node(*value).kind == NodeKind::list)
      add_mistake(*value, fmt::format("{} has {} item{}; expected two numbers such as [-0.5, 1]",
                                      describe_subject(*value), items.size(), items.size() == 1 ? "" : "s"));
    return;
  }
  if (!load_number(items[0], low, high, least) || !load_number(items[1], low, high, most)) return;
  if (least > most) {
    add_mistake(*value, fmt::format("{} ends below its beginning; expected the lower number first",
                                    describe_subject(*value)));
    return;
  }
  low = least;
  high = most;
}

// `from` and `to`, and what is asked to fade within them; without one of them the law is there from the
// start, or for good.
void load_times(const YamlMapping& entries, const ClipReader& reader, CueSpec& cue) {
  const YamlValue *from = find_value(entries, "from"), *to = find_value(entries, "to");
  double attack_s = 0, release_s = 0;
  if (from != nullptr) load_time(*from, reader.clock, cue.from_s);
  double to_s = kForever_s;
  if (to != nullptr && load_time(*to, reader.clock, to_s) && to_s <= cue.from_s) {
    add_mistake(*to, fmt::format("{} is {}, not after 'from', {}; expected a later time",
                                 describe_subject(*to), format_quantity(to_s, reader.clock.measure),
                                 format_quantity(cue.from_s, reader.clock.measure)));
    to_s = kForever_s;
  }
  load_duration(entries, "attack", reader.clock, attack_s);
  load_duration(entries, "release", reader.clock, release_s);
  const double fades_s = attack_s + release_s,
               share = fades_s > to_s - cue.from_s ? (to_s - cue.from_s) / fades_s : 1;
  cue.full_s = compute_seconds(compute_ticks(cue.from_s + share * attack_s));
  cue.end_s = to_s;
  cue.ebb_s = std::isfinite(to_s) ? compute_seconds(compute_ticks(to_s - share * release_s)) : to_s;
}

}  // namespace

void load_laws(const YamlMapping& clip, const ClipReader& reader, std::vector<CueSpec>& into) {
  const YamlValue* list = find_value(clip, "laws");
  if (list == nullptr) return;
  constexpr const char* kExample = "{area: brows, move: up, value: \"0.3*sin(t)\"}";
  for (const YamlValue& item : load_list(*list, fmt::format("a list of laws such as [{}]", kExample))) {
    if (!count_part(item, reader)) break;
    const YamlMapping entries = load_section(item);
    CueSpec cue;
    cue.layer = Layer::law;
    cue.has_lead = false;
    cue.from_s = reader.clock.start_s;
    cue.what.place = find_place(item.document->source, item.spot);
    const std::vector<std::size_t> moves = load_moves(entries, item);
    load_rule(entries, cue.rule);
    load_times(entries, reader, cue);
    const YamlValue* value = find_required(entries, "value", item, "a formula such as \"0.3*sin(t)\"");
    if (moves.empty() || value == nullptr) continue;
    double low = kMoves[moves[0]].low, high = kMoves[moves[0]].high;
    load_range(entries, low, high);
    auto live = std::make_shared<LivePose>();
    double number = 0;
    FormulaPointer formula;
    if (is_formula(*value))
      formula = load_formula(*value, reader.formulas);
    else
      load_number(*value, kMoves[moves[0]].low, kMoves[moves[0]].high, number);
    for (const std::size_t move : moves) {
      cue.owns.set(move);
      if (formula)
        live->values.push_back({move, formula, low, high, cue.what.place});
      else
        live->areas.values[move] = std::clamp(number, low, high);
    }
    cue.what.label = fmt::format("law of {}.{}", kMoves[moves[0]].area, kMoves[moves[0]].move);
    cue.what.live = std::move(live);
    into.push_back(std::move(cue));
  }
}

}  // namespace mien
