#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/edit.hpp"
#include "config/edit_pose.hpp"
#include "config/edit_steps.hpp"
#include "config/edit_time.hpp"
#include "config/load_spec.hpp"

namespace mien {

namespace {

// Where a key of an actor stands.
YamlPath find_keys_path(const YamlValue& root, const std::string& actor) {
  const YamlMapping file = load_section(root, find_sections().file);
  const YamlValue* actors = find_value(file, "actors");
  Names names;
  if (actors != nullptr)
    for (const YamlEntry& entry : load_free_mapping(*actors, "")) names.push_back(entry.key);
  if (actor.empty() && names.empty()) return {"clip", "keys"};
  if (actor.empty() && names.size() > 1)
    throw InputError(fmt::format("no actor is named; expected one of: {}", join_names(names)));
  const std::string name = actor.empty() ? names.front() : actor;
  if (std::ranges::find(names, name) == names.end())
    throw InputError(
        names.empty()
            ? fmt::format("there is no actor '{}'; expected none, as the file has no actors", show_word(name))
            : describe_unknown("actor", name, names));
  return {"actors", name, "clip", "keys"};
}

// A list of keys as an edit sees it.
struct KeyList {
  std::vector<YamlMapping> items;
  std::vector<bool> is_block;  // written in lines
  std::vector<std::optional<double>> times_s;
};

KeyList load_key_list(const EditText& text, const YamlPath& path, const KeyEdit& edit, Findings& silent) {
  KeyList list;
  const Trail trail = find_trail(text, path);
  const std::uint32_t node = trail.nodes.back();
  if (trail.entries.size() < path.size() || text.document.nodes[node].kind != NodeKind::list) return list;
  const auto* actor = std::get_if<std::string>(&path[1]);
  list.times_s = list_item_times(text, node, path.size() > 2 ? *actor : "", edit.fps);
  YamlValue value = find_root(text.document, silent);
  value.node = node;
  for (const YamlValue& item : load_list(value, "")) {
    list.is_block.push_back(find_node(item).kind == NodeKind::mapping && !is_in_brackets(text, item.node));
    list.items.push_back(load_section(item, find_sections().pose_key));
  }
  return list;
}

std::optional<std::size_t> find_key_at(const KeyList& list, std::int64_t frame, const KeyEdit& edit) {
  std::optional<std::size_t> nearest;
  const auto distance = [&](std::size_t i) { return std::abs(*list.times_s[i] - edit.at_s); };
  for (std::size_t i = 0; i < list.items.size(); ++i)
    if (list.times_s[i] && find_frame(*list.times_s[i], edit.fps) == frame &&
        (!nearest || distance(i) < distance(*nearest)))
      nearest = i;
  return nearest;
}

// The unit of the neighbours' times.
std::string find_unit(const KeyList& list, std::size_t place) {
  std::vector<std::size_t> order;
  for (std::size_t i = place; i-- > 0;) order.push_back(i);
  for (std::size_t i = place; i < list.items.size(); ++i) order.push_back(i);
  for (const std::size_t i : order)
    if (const YamlValue* at = find_value(list.items[i], "at");
        at != nullptr && find_node(*at).kind == NodeKind::text)
      if (const auto unit = find_time_unit(find_node(*at).text)) return *unit;
  return "s";
}

std::string change_key(std::string text, const YamlPath& item, const YamlMapping& key,
                       const PoseWords& words) {
  const auto change = [&](const char* name, const std::string& value) {
    YamlPath path = item;
    path.emplace_back(name);
    if (!value.empty())
      text = set_value(text, path, value);
    else if (find_value(key, name) != nullptr)
      text = remove_value(text, path);
  };
  if (!words.keeps_express) {
    change("strength", "");
    change("express", "");
    if (!words.exaggerate.empty()) change("exaggerate", words.exaggerate);
  }
  change("areas", words.areas.empty() ? "" : "{" + words.areas + "}");
  return text;
}

NewValue build_key(const std::string& at, const PoseWords& words, bool is_block) {
  std::vector<std::string> lines{"at: " + at};
  if (!words.exaggerate.empty()) lines.push_back("exaggerate: " + words.exaggerate);
  if (!words.areas.empty()) lines.push_back("areas: {" + words.areas + "}");
  NewValue value;
  for (const std::string& line : lines) value.flow += (value.flow.empty() ? "" : ", ") + line;
  value.flow = "{" + value.flow + "}";
  value.block = is_block ? lines : std::vector{value.flow};
  return value;
}

bool is_expression_name(const std::string& name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && name.size() <= kMaxExpressionName && is_letter(name.front()) &&
         std::ranges::all_of(
             name, [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-'; });
}

}  // namespace

std::string write_key(const std::string& bytes, const KeyEdit& edit, const Language& language) {
  const std::int64_t frame = find_frame(edit.at_s, edit.fps);
  if (frame < 0 || frame > kMaxFrames)
    throw InputError(fmt::format("the key would stand at {:.7g}s; expected a time from 0s to {:.7g}s",
                                 edit.at_s, static_cast<double>(kMaxFrames) / edit.fps));
  const EditText text = open_text(bytes);
  Findings silent;  // whoever reads the file tells them
  KeyList list;
  YamlPath path{"clip", "keys"};
  ExpressionBook book = language.libraries;
  if (!text.is_empty) {
    const YamlValue root = find_root(text.document, silent);
    path = find_keys_path(root, edit.actor);
    book = load_book(root, language);
    list = load_key_list(text, path, edit, silent);
  }
  if (const auto there = find_key_at(list, frame, edit)) {
    path.emplace_back(*there);
    return change_key(bytes, path, list.items[*there], find_pose_words(list.items[*there], book, edit.pose));
  }
  std::size_t place = 0;
  for (std::size_t i = 0; i < list.items.size(); ++i)
    if (list.times_s[i] && *list.times_s[i] < edit.at_s) place = i + 1;
  const std::string at = format_frame(frame, edit.fps, find_unit(list, place));
  const bool is_block = !list.items.empty() && list.is_block[place > 0 ? place - 1 : 0];
  path.emplace_back(place);
  return put_value(bytes, path, build_key(at, find_pose_words({}, book, edit.pose), is_block), true);
}

std::string write_expression(const std::string& text, const std::string& name, const Pose& pose) {
  if (!is_expression_name(name))
    throw InputError(fmt::format(
        "'{}' cannot name an expression; expected a letter, then letters, digits, '_' or '-', {} at most",
        show_word(name), kMaxExpressionName));
  return set_value(text, {"expressions", name}, format_expression(pose));
}

std::string format_expression(const Pose& pose) {
  ExpressionBook plain;
  const PoseWords words = find_pose_words({}, plain, pose);
  if (words.exaggerate.empty()) return "{" + words.areas + "}";
  return fmt::format("{{{}, exaggerate: {}}}", words.areas, words.exaggerate);
}

}  // namespace mien
