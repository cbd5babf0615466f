#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/law_numbers.hpp"
#include "config/load_areas.hpp"
#include "config/load_clip.hpp"
#include "core/ticks.hpp"

namespace mien {

namespace {

constexpr std::size_t kMaxTrackLaws = 200;  // of a clip: each is compared with each, number by number

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

// A number of a track in its unit.
bool load_law_number(const YamlValue& value, LawUnit unit, double low, double high, double& into) {
  if (unit == LawUnit::plain) return load_number(value, low, high, into);
  const Measure measure = unit == LawUnit::angle ? build_angle_measure() : build_length_measure();
  return load_quantity(value, measure, low, high, into);
}

bool is_law_formula(const YamlValue& value, LawUnit unit) {
  if (unit == LawUnit::plain) return is_formula(value);
  return is_formula(value, unit == LawUnit::angle ? build_angle_measure() : build_length_measure());
}

// `range: [-1, 1]`.
void load_range(const YamlMapping& entries, LawUnit unit, double& low, double& high) {
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
  if (!load_law_number(items[0], unit, low, high, least) || !load_law_number(items[1], unit, low, high, most))
    return;
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
template <typename Law>
void load_times(const YamlMapping& entries, const ClipReader& reader, Law& cue) {
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

// Which of the tracks the law is of; empty: an area's, or with `is_wrong` of none that stands here.
std::optional<LawTrack> find_track(const YamlMapping& entries, const YamlValue& item,
                                   const ClipReader& reader, bool& is_wrong) {
  std::optional<std::size_t> found;
  std::string_view first = find_value(entries, "area") != nullptr ? "area" : "";
  for (std::size_t i = 0; i < kLawTracks.size(); ++i) {
    const YamlValue* value = find_value(entries, kLawTracks[i]);
    if (value == nullptr) continue;
    if (!first.empty()) {
      add_mistake(*value,
                  fmt::format("'{}' and '{}' stand in one law; expected one of them", first, kLawTracks[i]));
      is_wrong = true;
    }
    first = kLawTracks[i];
    found = i;
  }
  if (!found && find_value(entries, "area") == nullptr && find_value(entries, "move") == nullptr &&
      find_node(item).kind == NodeKind::mapping) {
    add_mistake(item, fmt::format("{} moves nothing; expected 'area', 'camera', 'turn', 'light' or 'place'",
                                  describe_subject(item)));
    is_wrong = true;
  }
  if (const YamlValue* move = find_value(entries, "move"); found && move != nullptr && first != "area")
    add_mistake(*move, fmt::format("'move' is of an area; expected none beside '{}'", first));
  const YamlValue* at = found ? find_value(entries, kLawTracks[*found]) : find_value(entries, "area");
  if (is_wrong || at == nullptr) return {};
  const auto track = found ? std::optional(static_cast<LawTrack>(*found)) : std::nullopt;
  const bool is_shared = track == LawTrack::camera || track == LawTrack::light;
  const std::string_view name = found ? kLawTracks[*found] : "area";
  is_wrong = true;
  if (!reader.scripts.empty() && track && track != LawTrack::turn)
    add_mistake(*at, fmt::format("'{}' stands in a script; expected it in the clip's own 'laws'", name));
  else if (reader.of == ClipOf::actor && is_shared)
    add_mistake(
        *at, fmt::format("'{}' concerns all actors; it belongs in the 'clip' at the top of the file", name));
  else if (reader.of == ClipOf::everybody && !is_shared)
    add_mistake(*at, fmt::format("'{}' stands beside 'actors'; expected it in an actor's own 'clip'", name));
  else if (reader.of == ClipOf::one && track == LawTrack::place)
    add_mistake(*at, "'place' moves an actor; expected it in the 'clip' of one of 'actors'");
  else
    is_wrong = false;
  return track;
}

void load_track_law(const YamlMapping& entries, const YamlValue& item, const ClipReader& reader,
                    LawTrack track, std::vector<TrackLaw>& into) {
  if (into.size() == kMaxTrackLaws)
    return add_mistake(item, fmt::format("more than {} laws of camera, turn, light and place; expected fewer",
                                         kMaxTrackLaws));
  TrackLaw law;
  law.track = track;
  law.from_s = reader.clock.start_s;
  law.place = find_place(item.document->source, item.spot);
  load_rule(entries, law.rule);
  load_times(entries, reader, law);
  const YamlValue* value = find_required(entries, "value", item, "a formula such as \"20*sin(t)\"");
  std::string name;
  const std::string_view key = kLawTracks[static_cast<std::size_t>(track)];
  if (!load_name(*find_value(entries, key), name) || value == nullptr) return;
  const auto numbers = list_law_numbers(track);
  const auto number = std::ranges::find(numbers, name, &LawNumber::name);
  law.number = static_cast<std::size_t>(number - numbers.begin());
  law.range = number->bounds;
  load_range(entries, number->unit, law.range.low, law.range.high);
  if (is_law_formula(*value, number->unit))
    law.value.formula = load_formula(*value, reader.formulas);
  else
    load_law_number(*value, number->unit, number->bounds.low, number->bounds.high, law.value.value);
  law.label = fmt::format("law of {}.{}", key, name);
  into.push_back(std::move(law));
}

}  // namespace

void load_laws(const YamlMapping& clip, const ClipReader& reader, ClipSpec& into) {
  const YamlValue* list = find_value(clip, "laws");
  if (list == nullptr) return;
  constexpr const char* kExample = "{area: brows, move: up, value: \"0.3*sin(t)\"}";
  for (const YamlValue& item : load_list(*list, fmt::format("a list of laws such as [{}]", kExample))) {
    if (!count_part(item, reader)) break;
    const YamlMapping entries = load_section(item);
    bool is_wrong = false;
    const std::optional<LawTrack> track = find_track(entries, item, reader, is_wrong);
    if (is_wrong) continue;
    if (track) {
      load_track_law(entries, item, reader, *track, into.laws);
      continue;
    }
    CueSpec cue;
    cue.layer = Layer::law;
    cue.has_lead = false;
    cue.from_s = reader.clock.start_s;
    cue.what.place = find_place(item.document->source, item.spot);
    const std::vector<std::size_t> moves = load_moves(entries, item);
    load_rule(entries, cue.rule);
    load_times(entries, reader, cue);
    const YamlValue* value = find_required(entries, "value", item, "a formula such as \"0.3*sin(t)\"");
    double low = moves.empty() ? -1 : kMoves[moves[0]].low, high = moves.empty() ? 1 : kMoves[moves[0]].high;
    const double least = low, most = high;
    load_range(entries, LawUnit::plain, low, high);
    auto live = std::make_shared<LivePose>();
    double number = 0;
    FormulaPointer formula;
    if (value != nullptr && is_formula(*value))
      formula = load_formula(*value, reader.formulas);
    else if (value != nullptr)
      load_number(*value, least, most, number);
    if (moves.empty() || value == nullptr) continue;
    for (const std::size_t move : moves) {
      cue.owns.set(move);
      if (formula)
        live->values.push_back({move, formula, low, high, cue.what.place});
      else
        live->areas.values[move] = std::clamp(number, low, high);
    }
    cue.what.label = fmt::format("law of {}.{}", kMoves[moves[0]].area, kMoves[moves[0]].move);
    cue.what.live = std::move(live);
    into.cues.push_back(std::move(cue));
  }
}

}  // namespace mien
