#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "config/expressions.hpp"
#include "config/sections.hpp"

namespace mien {

namespace {

constexpr double kLowestBust_mm = 20;    // lower, eyelids are thinner than a nozzle's line
constexpr double kHighestBust_mm = 400;  // higher than any common printer
constexpr int kFewestTriangles = 8000, kMostTriangles = 80000;  // the eyes and the mouth alone have 6000

// "6x2mm": two lengths with one unit behind.
bool load_two_lengths(const YamlValue& value, double low, double high, std::string_view example,
                      glm::dvec2& into) {
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
  constexpr std::size_t kMostBytes = 200;  // far more than any base has room for
  std::string text;
  if (!load_text(value, "the text on the base", text)) return;
  if (text.size() > kMostBytes ||
      std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < ' '; })) {
    add_unexpected(value, fmt::format("one line of {} bytes at most", kMostBytes));
    return;
  }
  label = text;
}

void load_print(const YamlMapping& entries, BustSpec& bust) {
  const Measure length = build_length_measure();
  const auto load = [&](std::string_view key, double low, double high, double& into) {
    if (const YamlValue* value = find_value(entries, key)) load_quantity(*value, length, low, high, into);
  };
  load("height", kLowestBust_mm, kHighestBust_mm, bust.height_mm);
  if (const YamlValue* base = find_value(entries, "base")) load_name(*base, "base", kBases, bust.base);
  if (const YamlValue* label = find_value(entries, "label")) load_label(*label, bust.label);
  std::string hollow = "false";
  if (const YamlValue* value = find_value(entries, "hollow")) load_name(*value, "answer", kYesNo, hollow);
  bust.is_hollow = hollow == "true";
  load("wall", 0.8, 20, bust.wall_mm);
  load("drain", 0, 20, bust.drain_mm);
  if (const YamlValue* magnet = find_value(entries, "magnet"))
    load_two_lengths(*magnet, 1, 40, "6x2mm", bust.magnet_mm);
  if (const YamlValue* triangles = find_value(entries, "triangles"))
    load_whole(*triangles, kFewestTriangles, kMostTriangles, bust.triangles, "triangles");
}

void load_bust_list(const YamlValue& value, const ExpressionBook& book, Spec& spec) {
  for (const YamlValue& item : load_list(value, "a list such as [{express: laugh, height: 80mm}]")) {
    const YamlMapping entries =
        load_mapping(item, kBustKeys, "a mapping such as {express: laugh, height: 80mm}");
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
  const YamlMapping entries =
      load_mapping(value, kBustSetKeys, "a mapping such as {all: tezuka, height: 60mm}");
  BustSpec pattern;
  load_print(entries, pattern);
  if (const YamlValue* plate = find_value(entries, "plate"))
    load_two_lengths(*plate, 40, 2000, "220x220mm", spec.plate_mm);
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
