#include "config/edit_time.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/constants.hpp"
#include "config/edit_entries.hpp"
#include "config/edit_tree.hpp"
#include "config/load_spec.hpp"
#include "core/text.hpp"
#include "core/ticks.hpp"
#include "core/utf8.hpp"

namespace mien {

namespace {

// How far before its frame a time in seconds may lie, in frames: further, and the key is not at its pose
// there.
constexpr double kEarly = 0.1;

constexpr const char* kTime = "a time such as 1.5s, 36f or 500ms";

std::vector<NamedClip> load_named_clips(const YamlValue& root) {
  const YamlMapping file = load_section(root, find_sections().file);
  const auto load = [](const YamlValue* clip) {
    return clip == nullptr ? YamlMapping{} : load_section(*clip);
  };
  std::vector<NamedClip> clips{{"", load(find_value(file, "clip"))}};
  if (const YamlValue* actors = find_value(file, "actors"))
    for (YamlEntry actor : load_free_mapping(*actors, "")) {
      actor.value.constants = build_actor_constants(actor.value);
      const YamlMapping entries = load_free_mapping(actor.value, "");
      clips.push_back({actor.key, load(find_value(entries, "clip"))});
    }
  return clips;
}

std::string describe_frame(std::int64_t frame, int fps) { return format_frame(frame, fps, "s"); }

// What stands at a place: an item of a list that has a time.
struct TimedItem {
  YamlPath path;
  std::uint32_t list = 0;
  std::vector<std::size_t> entries;  // to the list
  std::size_t entry = 0;             // of it
};

std::size_t find_place_byte(const EditText& text, int line, int column) {
  const SourceText& source = text.document.source;
  if (line < 1)
    throw InputError(
        "it has no place in this text, but comes from another file or from mien itself; expected a key or "
        "cue of this text");
  if (text.is_empty || line > static_cast<int>(source.line_starts.size()))
    throw InputError(fmt::format("there is no line {}; expected the place of a key or cue", line));
  const std::string_view words = find_line(source, line);
  std::size_t byte = 0;
  for (int seen = 0; byte < words.size(); ++byte)
    if (is_first_of_character(words[byte]) && ++seen == column) break;
  return source.line_starts[static_cast<std::size_t>(line - 1)] + byte;
}

bool has_entry(const EditText& text, std::uint32_t node, std::string_view key) {
  const YamlNode& owner = text.document.nodes[node];
  if (owner.kind != NodeKind::mapping) return false;
  for (std::size_t i = 0; i < owner.children.size(); i += 2)
    if (text.document.nodes[owner.children[i]].text == key) return true;
  return false;
}

bool is_timed(const EditText& text, const YamlPath& path, std::uint32_t item) {
  const auto* list = path.size() < 2 ? nullptr : std::get_if<std::string>(&path[path.size() - 2]);
  if (text.document.nodes[item].kind == NodeKind::alias) return true;  // told when it is to be changed
  return has_entry(text, item, "at") || has_entry(text, item, "from") ||
         (list != nullptr && *list == "blinks");
}

// The innermost one.
std::optional<TimedItem> find_timed_item(const EditText& text, std::size_t at) {
  std::optional<TimedItem> found;
  YamlPath path;
  std::vector<std::size_t> entries;
  for (std::uint32_t node = text.document.root;;) {
    const NodeKind kind = text.document.nodes[node].kind;
    if (kind != NodeKind::list && kind != NodeKind::mapping) return found;
    const std::size_t count = count_entries(text, node);
    std::size_t entry = 0;
    while (entry < count &&
           !(find_entry(text, node, entry).begin <= at && at < find_entry(text, node, entry).end))
      ++entry;
    if (entry == count) return found;
    const std::uint32_t value = find_entry_value(text, node, entry);
    if (kind == NodeKind::list)
      path.emplace_back(entry);
    else
      path.emplace_back(text.document.nodes[text.document.nodes[node].children[2 * entry]].text);
    if (kind == NodeKind::list && is_timed(text, path, value)) found = TimedItem{path, node, entries, entry};
    entries.push_back(entry);
    node = value;
  }
}

// The new word for a time that stands in the text, in quotes if that is.
std::string find_new_time(const EditText& text, std::uint32_t node, const YamlPath& path,
                          const TimeMove& move) {
  const YamlNode& value = text.document.nodes[node];
  if (value.kind == NodeKind::mapping)
    throw InputError(fmt::format("{} waits for another key; expected {}", describe_path(path), kTime));
  const auto unit = value.kind == NodeKind::text ? find_time_unit(value.text) : std::nullopt;
  if (value.is_quoted && (!unit || unit->empty()))
    throw InputError(fmt::format("{} is the formula '{}'; expected {}, which can be moved",
                                 describe_path(path), show_word(value.text), kTime));
  if (!unit)
    throw InputError(
        fmt::format("{} is '{}'; expected {}", describe_path(path), show_word(value.text), kTime));
  const std::string word = format_frame(find_frame(move.to_s, move.fps), move.fps, *unit);
  const char quote = text.document.source.text[text.ranges[node].begin];
  return value.is_quoted && (quote == '"' || quote == '\'') ? quote + word + quote : word;
}

// A cue goes after it comes.
void check_span(const EditText& text, const TimedItem& item, const TimeMove& move) {
  const bool is_from = move.member == "from";
  if (!is_from && move.member != "to") return;
  YamlPath path = item.path;
  path.emplace_back(is_from ? "to" : "from");
  const Trail trail = find_trail(text, path);
  if (trail.nodes.size() <= path.size()) return;
  const auto other_s =
      parse_quantity(text.document.nodes[trail.nodes.back()].text, build_time_measure(move.fps));
  if (!other_s) return;
  const std::int64_t frame = find_frame(move.to_s, move.fps);
  const double at_s = static_cast<double>(frame) / move.fps;
  if (is_from && at_s >= *other_s)
    throw InputError(fmt::format("'from' would be {}, not before 'to', {:.7g}s; expected an earlier time",
                                 describe_frame(frame, move.fps), *other_s));
  if (!is_from && at_s <= *other_s)
    throw InputError(fmt::format("'to' would be {}, not after 'from', {:.7g}s; expected a later time",
                                 describe_frame(frame, move.fps), *other_s));
}

// Whether the times of a list must rise, as its items stand.
bool must_rise(const TimedItem& item, const TimeMove& move) {
  const auto* list = std::get_if<std::string>(&item.path[item.path.size() - 2]);
  return move.member == "at" && list != nullptr && *list != "tracks" && *list != "include" &&
         *list != "blinks";
}

std::string find_actor(const YamlPath& path) {
  const auto* first = std::get_if<std::string>(&path.front());
  const auto* second = path.size() < 2 ? nullptr : std::get_if<std::string>(&path[1]);
  return first != nullptr && *first == "actors" && second != nullptr ? *second : "";
}

// Puts an item to where its new time belongs among the others.
std::string sort_item(const std::string& bytes, const TimedItem& item, const TimeMove& move) {
  const EditText text = open_text(bytes);
  YamlPath path = item.path;
  path.pop_back();
  const std::uint32_t list = find_trail(text, path).nodes.back();
  const auto times_s = list_item_times(text, list, find_actor(path), move.fps);
  const std::optional<double> at_s = times_s[item.entry];
  std::size_t before = 0;
  bool is_in_order = true;
  for (std::size_t i = 0; i < times_s.size() && at_s; ++i) {
    if (i == item.entry || !times_s[i]) continue;
    if (*times_s[i] == *at_s)
      throw InputError(fmt::format("another item of {} stands at {:.7g}s already; expected another time",
                                   describe_path(path), *at_s));
    if (*times_s[i] < *at_s) before = i + 1;
    if ((*times_s[i] < *at_s) != (i < item.entry)) is_in_order = false;
  }
  if (is_in_order) return bytes;
  const Splice splice = move_item(text, list, item.entry, before);
  Tree expected = build_tree(text);
  std::vector<Tree>& items = find_branch(expected, item.entries).children;
  const auto from = items.begin() + static_cast<std::ptrdiff_t>(item.entry);
  const auto to = items.begin() + static_cast<std::ptrdiff_t>(before);
  if (to > from)
    std::rotate(from, from + 1, to);
  else
    std::rotate(to, from, from + 1);
  return check_edit(replace_range(text, splice.range, splice.words), expected, path);
}

}  // namespace

std::optional<std::string> find_time_unit(const std::string& word) {
  if (!parse_quantity(word, build_time_measure(ClipSpec{}.fps))) return {};
  for (const char* unit : {"ms", "s", "f"})
    if (word.ends_with(unit)) return unit;
  return "";
}

std::string format_frame(std::int64_t frame, int fps, const std::string& unit) {
  if (unit == "f") return std::to_string(frame) + unit;
  const bool is_ms = unit == "ms";
  const double exact = static_cast<double>(frame) / fps * (is_ms ? 1000 : 1);
  const double most = kEarly / fps * (is_ms ? 1000 : 1);
  constexpr double kRoundOff = 1e-9;
  for (int decimals = 0; decimals < 9; ++decimals) {
    const double scale = std::pow(10.0, decimals);
    const double value = std::floor(exact * scale + kRoundOff) / scale;
    if (exact - value <= most) return format_number(value, decimals) + unit;
  }
  return format_number(exact, 9) + unit;
}

std::int64_t find_frame(double time_s, int fps) { return std::llround(time_s * fps); }

std::vector<std::optional<double>> list_item_times(const EditText& text, std::uint32_t list,
                                                   const std::string& actor, int fps) {
  Findings silent;  // whoever reads the file tells them
  YamlValue value = find_root(text.document, silent);
  value.constants = build_file_constants(value, {});
  const std::vector<NamedClip> clips = load_named_clips(value);
  const std::vector<NamedTimes> named = load_named_times(clips, fps);
  std::size_t clip = 0;
  for (std::size_t i = 0; i < clips.size(); ++i)
    if (clips[i].actor == actor) clip = i;
  const ClipClock clock = build_clip_clock(fps, &named[clip]);
  if (!clips[clip].entries.empty()) value.constants = clips[clip].entries.front().value.constants;
  value.node = list;
  std::vector<std::optional<double>> times_s;
  for (const YamlValue& item : load_list(value, "")) {
    const YamlMapping entries = load_free_mapping(item, "");
    const YamlValue* at = find_value(entries, "at");
    double at_s = 0;
    times_s.push_back(load_time(at == nullptr ? item : *at, clock, at_s) ? std::optional(at_s)
                                                                         : std::nullopt);
  }
  return times_s;
}

std::string move_time(const std::string& bytes, const TimeMove& move) {
  const EditText text = open_text(bytes);
  const std::size_t at = find_place_byte(text, move.line, move.column);
  const std::optional<TimedItem> item = find_timed_item(text, at);
  if (!item)
    throw InputError(fmt::format("no key or cue stands on line {}, column {}; expected one with a time",
                                 move.line, move.column));
  if (std::ranges::find(item->path, PathStep("scripts")) != item->path.end())
    throw InputError(
        fmt::format("{} is in a script, whose times count from its own beginning; expected a key or cue "
                    "of the clip",
                    describe_path(item->path)));
  const std::int64_t frame = find_frame(move.to_s, move.fps);
  if (frame < 0 || frame > kMaxFrames)
    throw InputError(fmt::format("the time would be {:.7g}s; expected one from 0s to {:.7g}s", move.to_s,
                                 static_cast<double>(kMaxFrames) / move.fps));
  YamlPath path = item->path;
  const Trail to_item = find_trail(text, path);
  const std::uint32_t own = to_item.nodes.back();
  const bool is_bare = move.member == "at" &&
                       (text.document.nodes[own].kind == NodeKind::text || has_entry(text, own, "after"));
  if (!is_bare) path.emplace_back(move.member);
  const Trail trail = find_trail(text, path);
  if (trail.nodes.size() <= path.size())
    throw InputError(fmt::format("there is no {}; expected a key or cue that has it", describe_path(path)));
  const std::uint32_t node = trail.nodes.back();
  check_unrepeated(text, text.ranges[node], path);
  const std::string word = find_new_time(text, node, path, move);
  check_span(text, *item, move);
  Tree expected = build_tree(text);
  find_branch(expected, trail.entries).text =
      word.starts_with('"') || word.starts_with('\'') ? word.substr(1, word.size() - 2) : word;
  std::string moved = check_edit(replace_range(text, text.ranges[node], word), expected, path);
  return must_rise(*item, move) ? sort_item(moved, *item, move) : moved;
}

}  // namespace mien
