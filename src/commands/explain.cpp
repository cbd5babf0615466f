// `mien explain`: one face told in full.

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "clip/clip.hpp"
#include "clip/view.hpp"
#include "commands/report.hpp"
#include "commands/table.hpp"
#include "config/load_areas.hpp"
#include "core/data.hpp"
#include "face/thesis_rules.hpp"
#include "frames/resources.hpp"
#include "head/landmarks.hpp"
#include "timeline/blinks.hpp"
#include "timeline/parts.hpp"

namespace mien {

namespace {

using Json = nlohmann::ordered_json;
using Places = std::map<std::string, glm::dvec3>;

constexpr double kLeastMove_mm = 0.05;  // a row's landmark that moved less has not moved for the eye

// One moment of the face: what asks for it and what it comes to.
struct Story {
  std::string title;  // "hello.yaml at 1.2s"
  std::vector<MomentPart> parts;
  double blink = 0;      // how far a blink has shut the lids: 0..1
  double breath_mm = 0;  // how far a breath has lifted the shoulders
  double reach = 1;      // `exaggerate`
  Pose pose;
  std::vector<Held> held;
  std::vector<BrowHold> brows;  // that their rectangles hold
};

// One move of one area.
struct Row {
  std::size_t move = 0;
  double value = 0;
  const Limit* limit = nullptr;  // of the value's way; null for a lid that shuts
  const Held* held = nullptr;
  std::string landmark;
  glm::dvec3 moved_mm{0};
};

Story build_story(const Spec& spec, const std::string& name) {
  const Expression expression = take_expression(spec, name);
  const std::string library = expression.library.empty() ? "" : expression.library + "/";
  Story story{fmt::format("{}: {}{}", spec.file.string(), library, expression.name),
              {},
              0,
              0,
              expression.reach,
              expression.pose,
              expression.held,
              {}};
  return story;
}

// `performance` has the eyes of whoever is asked for.
Story build_story(const Spec& spec, const Performance& performance, double at_s) {
  Story story{fmt::format("{} at {:.4g}s", spec.file.string(), at_s), {}, 0, 0, 1, {}, {}, {}};
  const Moment moment = sample_performance(performance, at_s);
  story.pose = moment.pose;
  story.breath_mm = moment.turn.breath_mm;
  story.blink = compute_blink_closure(performance.idle.blinks, at_s);
  story.parts = list_parts(performance, at_s);
  for (const MomentPart& part : story.parts) story.reach = std::max(story.reach, part.reach);
  story.held = list_held_at(performance, at_s);
  return story;
}

// Where a move is measured, by the names of templates/head/landmarks.yaml.
std::string find_landmark_of(const MoveInfo& info) {
  const std::string name(info.landmark);
  return info.side == Side::none ? name : name + (info.side == Side::left ? "_l" : "_r");
}

Places measure_pose(const Figure& figure, const std::vector<Landmark>& landmarks, const Pose& pose) {
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(figure, pose, {}, buffers, drawing);
  return measure_landmarks(figure.head, landmarks, figure.model, drawing);
}

bool is_asked(const MoveInfo& info, const std::string& area) {
  const auto key = std::ranges::find_if(kAreaKeys, [&](const AreaKey& k) { return k.key == area; });
  return info.area == key->area && (key->is_both || info.side == key->side);
}

// The moves of the area, or all that move.
std::vector<Row> build_rows(const Story& story, const std::vector<Limit>& limits, const Places& rest,
                            const Places& now, const std::optional<std::string>& area) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    Row row{i, story.pose.values[i], nullptr, nullptr, find_landmark_of(kMoves[i]), glm::dvec3(0)};
    if (area ? !is_asked(kMoves[i], *area) : row.value == 0) continue;
    row.moved_mm = now.at(row.landmark) - rest.at(row.landmark);
    const int sign = row.value < 0 ? -1 : 1;
    for (const Limit& limit : limits)
      if (limit.name->move == i && limit.name->sign == sign) row.limit = &limit;
    for (const Held& held : story.held)
      if (held.move == i) row.held = &held;
    rows.push_back(row);
  }
  return rows;
}

// "5.4 mm at brow_mid_l: 5.3 up, 0.7 back".
std::string describe_way(const Row& row) {
  const MoveInfo& info = kMoves[row.move];
  const double length = glm::length(row.moved_mm);
  if (length < kLeastMove_mm) return fmt::format("at rest at {}", row.landmark);
  const double side = info.side == Side::right ? -1 : 1;
  const bool is_sided = info.side != Side::none;
  std::string text = fmt::format("{:.1f} mm at {}:", length, row.landmark);
  const auto add = [&](double mm, const char* plus, const char* minus) {
    if (std::abs(mm) < kLeastMove_mm) return;
    text += fmt::format("{} {:.1f} {}", text.back() == ':' ? "" : ",", std::abs(mm), mm > 0 ? plus : minus);
  };
  add(row.moved_mm.y, "up", "down");
  add(side * row.moved_mm.x, is_sided ? "out" : "left", is_sided ? "in" : "right");
  add(row.moved_mm.z, "forward", "back");
  return text;
}

std::string describe_limit(const Row& row) {
  if (row.limit == nullptr) {
    const MoveInfo& info = kMoves[row.move];
    return std::string((row.value < 0 ? info.minus : info.plus).meets);
  }
  if (row.limit->axis >= 0) return fmt::format("{:.1f} mm", row.limit->mm);
  return fmt::format("{:.3g} deg, {:.1f} mm", row.limit->value, row.limit->mm);
}

// Muscles and units, which have no limit of the head's and no landmark of their own.
void print_doctrines(const Pose& pose) {
  for (std::size_t i = kMoveCount; i < kChannelCount; ++i)
    if (pose.values[i] != 0)
      fmt::print("{}: {:+.2f}, {}\n", name_move(i), pose.values[i], kChannels[i].meaning);
}

void print_rows(const std::vector<Row>& rows) {
  constexpr std::size_t kAreaWidth = kLongestAreaKey + 1;
  fmt::print("\n{:<{}}{:<7}{:>6}  {:<16} {:<13}{}\n", "area", kAreaWidth, "move", "value", "limit", "held",
             "moved");
  std::string area, landmark;
  for (const Row& row : rows) {
    const MoveInfo& info = kMoves[row.move];
    const std::string name(find_area_key(info));
    const bool is_new = name != area || row.landmark != landmark;
    fmt::print("{:<{}}{:<7}{:>+6.2f}  {:<16} {:<13}{}\n", name == area ? "" : name, kAreaWidth, info.move,
               row.value, describe_limit(row), row.held ? fmt::format("asked {:+.3g}", row.held->asked) : "-",
               is_new ? describe_way(row) : "\"");
    area = name;
    landmark = row.landmark;
  }
}

void print_story(const Story& story, const std::vector<Row>& rows) {
  fmt::print("{}\n", story.title);
  for (const MomentPart& part : story.parts) {
    fmt::print("  {:3.0f} % {} ({} {:.4g}s{})\n", 100 * part.share, part.label,
               part.is_cue ? "cue from" : "key at", part.at_s,
               part.is_endless ? ", to the clip's end: it has no 'hold' or 'to'" : "");
    for (const auto& [area, off] : part.released) fmt::print("        {} off by {:.0f} %\n", area, 100 * off);
    if (!part.order.empty()) fmt::print("        {}\n", part.order);
  }
  if (story.breath_mm > 0) fmt::print("  a breath has lifted the shoulders by {:.1f} mm\n", story.breath_mm);
  if (story.blink > 0) fmt::print("  a blink has shut the lids by {:.0f} %\n", 100 * story.blink);
  if (story.reach > 1) fmt::print("  limits lifted {:.3g} times by 'exaggerate'\n", story.reach);
  if (has_doctrine(story.pose)) fmt::print("\n");
  print_doctrines(story.pose);
  if (!rows.empty())
    print_rows(rows);
  else if (!has_doctrine(story.pose))
    return fmt::print("\nnothing moves: every area is at rest\n");
  const std::vector<HeldNote> notes = build_notes(story.held);
  if (!notes.empty() || !story.brows.empty()) fmt::print("\n");
  for (const HeldNote& note : notes) fmt::print("{}\n", format_note(note));
  for (const BrowHold& hold : story.brows) fmt::print("note: {}\n", describe_hold(hold));
}

Json build_json(const Row& row) {
  const MoveInfo& info = kMoves[row.move];
  Json json{{"kind", "move"},
            {"area", find_area_key(info)},
            {"move", info.move},
            {"value", round_to(row.value, 6)}};
  if (row.limit != nullptr)
    json["limit"] = {{"name", row.limit->name->name},
                     {"thesis", row.limit->name->thesis},
                     {"value", round_to(row.limit->value, 6)},
                     {"unit", row.limit->unit},
                     {"mm", round_to(row.limit->mm, 3)}};
  if (row.held != nullptr) json["asked"] = round_to(row.held->asked, 6);
  json["landmark"] = row.landmark;
  json["moved_mm"] = {round_to(row.moved_mm.x, 3), round_to(row.moved_mm.y, 3), round_to(row.moved_mm.z, 3)};
  return json;
}

Json build_json(const BrowHold& hold) {
  const MoveInfo& up = kMoves[*find_move("brow", hold.side, "up")];
  return {{"kind", "note"},
          {"area", "brow"},
          {"side", hold.side == Side::left ? "left" : "right"},
          {"move", up.move},
          {"asked", round_to(hold.asked_up, 6)},
          {"held", round_to(hold.held_up, 6)},
          {"point", kBrowPointWords[hold.point]},
          {"message", describe_hold(hold)}};
}

void print_json(const Story& story, const std::vector<Row>& rows) {
  Json parts = Json::array();
  for (const MomentPart& part : story.parts) {
    Json& told = parts.emplace_back(Json{{"kind", part.is_cue ? "cue" : "key"},
                                         {"express", part.label},
                                         {"at_s", part.at_s},
                                         {"share", round_to(part.share, 6)}});
    for (const auto& [area, off] : part.released) told["released"][area] = round_to(off, 6);
    if (!part.order.empty()) told["order"] = part.order;
    if (part.is_endless) told["endless"] = true;
  }
  fmt::print("{}\n", format_object(Json{{"kind", "moment"},
                                        {"title", story.title},
                                        {"keys", parts},
                                        {"blink", round_to(story.blink, 6)},
                                        {"breath_mm", round_to(story.breath_mm, 3)},
                                        {"exaggerate", story.reach}}));
  for (const Row& row : rows) fmt::print("{}\n", format_object(build_json(row)));
  for (std::size_t i = kMoveCount; i < kChannelCount; ++i)
    if (story.pose.values[i] != 0)
      fmt::print("{}\n", format_object(Json{{"kind", "channel"},
                                            {"name", name_move(i)},
                                            {"value", round_to(story.pose.values[i], 6)}}));
  for (const HeldNote& note : build_notes(story.held)) fmt::print("{}\n", format_json(note));
  for (const BrowHold& hold : story.brows) fmt::print("{}\n", format_object(build_json(hold)));
}

void run_explain(const Options& options) {
  const Resources resources = load_resources(find_data_folder());
  const Clip clip = open_clip(options, *resources.stock.language);
  const Spec& spec = clip.spec;
  const Actor& actor = find_actor(clip, options);
  const Names areas = list_area_keys();
  if (options.area && std::ranges::find(areas, *options.area) == areas.end())
    throw InputError(describe_unknown("area", *options.area, areas));
  const Figure figure = build_figure(resources.heads, find_asked_head(clip, actor, options));
  Performance performance = actor.performance;
  performance.idle.eyes = compute_eyes(figure, spec.render);
  Story story = options.express ? build_story(spec, *options.express)
                                : build_story(spec, performance, compute_time_s(clip, options));
  if (!options.area || options.area->starts_with("brow"))
    story.brows = find_brow_holds(figure.face, figure.limits, story.pose);
  const auto limits = measure_limits(figure.head, figure.face, figure.limits);
  const auto landmarks = find_landmarks(figure.head);
  sort_ledger(story.held);
  if (options.area)
    std::erase_if(story.held,
                  [&](const Held& held) { return !is_asked(kChannels[held.move], *options.area); });
  const auto rows = build_rows(story, limits, measure_pose(figure, landmarks, {}),
                               measure_pose(figure, landmarks, story.pose), options.area);
  if (options.is_json)
    print_json(story, rows);
  else
    print_story(story, rows);
}

}  // namespace

const CommandInfo command_explain{
    "explain",
    "The file",
    "FILE",
    "who moves what, and which limit held it",
    "Tells one moment of the clip, or one expression, in full: the keys it lies between, the value of\n"
    "each area's moves, the limits (and what they held back), and the millimetres that the skin moved\n"
    "at the area's landmark on this head.",
    "at express actor area",
    "mien explain configs/hello.yaml --at 1.2s\n"
    "mien explain configs/hello.yaml --express smile --area corner.left",
    run_explain};

}  // namespace mien
