#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "config/expressions.hpp"
#include "config/sections.hpp"

namespace mien {

namespace {

// "6x2mm": two lengths with one unit behind.
bool load_two_lengths(const YamlValue& value, std::string_view example, glm::dvec2& into) {
  const auto [low, high] =
      std::pair(find_form(value, FormKind::two_lengths).low, find_form(value, FormKind::two_lengths).high);
  const std::string expected = fmt::format("two lengths from {}mm to {}mm such as {}", low, high, example);
  const YamlNode& node = find_node(value);
  const std::size_t cross = node.kind == NodeKind::text ? node.text.find('x') : std::string::npos;
  if (cross == std::string::npos) {
    add_unexpected(value, expected);
    return false;
  }
  const auto second = parse_quantity(node.text.substr(cross + 1), build_length_measure());
  // The first one takes the second one's unit.
  const std::size_t letter = node.text.find_first_not_of("0123456789.", cross + 1);
  const std::string unit = letter == std::string::npos ? "" : node.text.substr(letter);
  const auto first = parse_quantity(node.text.substr(0, cross) + unit, build_length_measure());
  if (!first || !second || std::min(*first, *second) < low || std::max(*first, *second) > high) {
    add_unexpected(value, expected);
    return false;
  }
  into = {*first, *second};
  return true;
}

// What a label may hold: letters that the file's own glyphs know are drawn, others become a box.
void load_label(const YamlValue& value, std::string& label) {
  std::string text;
  if (!load_text(value, "the text on the base", text)) return;
  if (text.size() > kMaxLabelLength ||
      std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < ' '; })) {
    add_unexpected(value, fmt::format("one line of {} bytes at most", kMaxLabelLength));
    return;
  }
  label = text;
}

void load_print(const YamlMapping& entries, BustSpec& bust) {
  const auto load = [&](std::string_view key, double& into_mm) {
    if (const YamlValue* value = find_value(entries, key)) load_length(*value, into_mm);
  };
  load("height", bust.height_mm);
  if (const YamlValue* base = find_value(entries, "base")) load_name(*base, bust.base);
  if (const YamlValue* label = find_value(entries, "label")) load_label(*label, bust.label);
  if (const YamlValue* value = find_value(entries, "hollow")) load_yes_no(*value, bust.is_hollow);
  load("wall", bust.wall_mm);
  load("drain", bust.drain_mm);
  if (const YamlValue* magnet = find_value(entries, "magnet"))
    load_two_lengths(*magnet, "6x2mm", bust.magnet_mm);
  if (const YamlValue* triangles = find_value(entries, "triangles")) load_whole(*triangles, bust.triangles);
}

void load_bust_list(const YamlValue& value, const ExpressionBook& book, Spec& spec) {
  for (const YamlValue& item : load_list(value, "a list such as [{express: laugh, height: 80mm}]")) {
    const YamlMapping entries = load_section(item);
    const Express express = load_posed(entries, book);
    BustSpec bust;
    bust.expression = {express.name, express.library, express.pose, express.reach, express.held};
    load_print(entries, bust);
    spec.busts.push_back(std::move(bust));
  }
}

// {all: tezuka, height: 60mm, plate: 220x220mm}
// What stands on the base of an expression's bust: "doubt_left" is "doubt L", as a base has little room.
std::string build_label(const std::string& name) {
  std::string label = name;
  for (const auto& [word, letter] : {std::pair{"_left", " L"}, std::pair{"_right", " R"}})
    if (label.ends_with(word)) label.replace(label.rfind('_'), std::string::npos, letter);
  std::replace(label.begin(), label.end(), '_', ' ');
  return label;
}

void load_bust_set(const YamlValue& value, const ExpressionBook& book, Spec& spec) {
  const YamlMapping entries = load_section(value);
  BustSpec pattern;
  load_print(entries, pattern);
  double strength = 1, exaggerate = book.exaggerate;
  if (const YamlValue* number = find_value(entries, "strength")) load_number(*number, strength);
  load_exaggerate(entries, exaggerate);
  if (const YamlValue* plate = find_value(entries, "plate"))
    load_two_lengths(*plate, "220x220mm", spec.plate_mm);
  std::set<std::string> libraries;
  for (const Expression& expression : book.expressions)
    if (!expression.library.empty()) libraries.insert(expression.library);
  std::string library;
  const YamlValue* all = find_required(entries, "all", value, "the name of a library such as {all: tezuka}");
  if (all == nullptr || !load_name(*all, "library", Names(libraries.begin(), libraries.end()), library))
    return;
  for (const Expression& expression : book.expressions) {
    if (expression.library != library) continue;
    BustSpec bust = pattern;
    bust.expression = expression;
    if (strength != 1 || exaggerate != 1) {
      const HeldPose posed = hold_pose({mix_poses({{1, expression.pose, expression.manner}}, strength),
                                        expression.reach,
                                        strength,
                                        {},
                                        exaggerate});
      bust.expression.pose = posed.pose;
      bust.expression.reach = posed.reach;
    }
    if (bust.label.empty() && bust.base != "none") bust.label = build_label(expression.name);
    spec.busts.push_back(std::move(bust));
  }
}

}  // namespace

void load_busts(const YamlValue& value, const ExpressionBook& book, Spec& spec) {
  if (find_node(value).kind == NodeKind::mapping)
    load_bust_set(value, book, spec);
  else
    load_bust_list(value, book, spec);
}

}  // namespace mien
