#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "config/constants.hpp"
#include "config/expressions.hpp"
#include "config/load_spec.hpp"
#include "config/sections.hpp"

namespace mien {

namespace {

// "6x2mm": two lengths with one unit behind.
bool load_two_lengths(const YamlValue& value, std::string_view example, glm::dvec2& into) {
  const auto [low, high] =
      std::pair(find_form(value, FormKind::two_lengths).low, find_form(value, FormKind::two_lengths).high);
  const std::string expected = fmt::format("two lengths from {}mm to {}mm such as {}", low, high, example);
  if (is_two_constants(value)) {
    const auto both = load_two_constants(value);
    const bool is_right =
        both && std::min(both->first, both->second) >= low && std::max(both->first, both->second) <= high;
    if (is_right) into = {both->first, both->second};
    if (both && !is_right)
      add_mistake(value, fmt::format("{} is the formula '{}', which comes to {:.7g}x{:.7g}mm; expected {}",
                                     describe_subject(value), show_word(find_node(value).text), both->first,
                                     both->second, expected));
    return is_right;
  }
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

// What stands on the base of an expression's bust: "doubt_left" is "doubt L", as a base has little room.
std::string build_label(const std::string& name) {
  std::string label = name;
  for (const auto& [word, letter] : {std::pair{"_left", " L"}, std::pair{"_right", " R"}})
    if (label.ends_with(word)) label.replace(label.rfind('_'), std::string::npos, letter);
  std::replace(label.begin(), label.end(), '_', ' ');
  return label;
}

// What `all` stands for: a library's expressions, or those that a list names.
std::vector<Expression> load_bust_names(const YamlValue& value, const ExpressionBook& book) {
  std::vector<Expression> chosen;
  if (find_node(value).kind == NodeKind::list) {
    constexpr const char* kExpected = "a list of expressions such as [smile, anger]";
    const std::vector<YamlValue> items = load_list(value, kExpected);
    if (items.empty()) add_mistake(value, describe_subject(value) + " is empty; expected " + kExpected);
    for (const YamlValue& item : items) {
      if (find_node(item).kind != NodeKind::text) {
        add_unexpected(item, "an expression's name");
        continue;
      }
      for (const ExpressShare& share : load_express(item, book).shares)
        chosen.push_back(book.expressions[share.expression]);
    }
    return chosen;
  }
  if (find_node(value).kind != NodeKind::text) {
    add_unexpected(value, "a library such as tezuka, or a list of expressions such as [smile, anger]");
    return chosen;
  }
  std::set<std::string> libraries;
  for (const Expression& expression : book.expressions)
    if (!expression.library.empty()) libraries.insert(expression.library);
  const std::string& word = find_node(value).text;
  if (!libraries.contains(word) && find_expression(book, word)) {
    add_mistake(value, fmt::format("{0} is '{1}', an expression; expected a library such as tezuka, or a "
                                   "list such as [{1}]",
                                   describe_subject(value), show_word(word)));
    return chosen;
  }
  std::string library;
  if (!load_name(value, "library", Names(libraries.begin(), libraries.end()), library)) return chosen;
  for (const Expression& expression : book.expressions)
    if (expression.library == library) chosen.push_back(expression);
  return chosen;
}

// {all: tezuka, height: 60mm, plate: 220x220mm}
void load_bust_set(const YamlValue& value, const ExpressionBook& book, Spec& spec) {
  const YamlMapping entries = load_section(value);
  BustSpec pattern;
  load_print(entries, pattern);
  double strength = 1, exaggerate = book.exaggerate;
  if (const YamlValue* number = find_value(entries, "strength")) load_number(*number, strength);
  load_exaggerate(entries, exaggerate);
  if (const YamlValue* plate = find_value(entries, "plate"))
    load_two_lengths(*plate, "220x220mm", spec.plate_mm);
  const YamlValue* all = find_required(entries, "all", value, "the name of a library such as {all: tezuka}");
  if (all == nullptr) return;
  for (const Expression& expression : load_bust_names(*all, book)) {
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

// The label of a bust that the file does not list: what all the others bear in common, else its own name if
// each of them bears a label. That of a single one is taken for its expression's.
std::string find_asked_label(const std::vector<BustSpec>& listed, const std::string& name) {
  const auto bears = [&](const std::string& label) {
    return std::ranges::all_of(listed, [&](const BustSpec& bust) { return bust.label == label; });
  };
  if (listed.size() > 1 && bears(listed.front().label)) return listed.front().label;
  const bool is_each_labelled =
      std::ranges::none_of(listed, [](const BustSpec& bust) { return bust.label.empty(); });
  return is_each_labelled ? build_label(name) : "";
}

}  // namespace

BustSpec build_asked_bust(const Spec& spec, Expression expression) {
  const std::vector<BustSpec>& listed = spec.busts;
  const auto own = std::ranges::find_if(listed, [&](const BustSpec& bust) {
    return bust.expression.name == expression.name && bust.expression.library == expression.library;
  });
  BustSpec asked;
  if (own != listed.end()) {
    asked = *own;
  } else if (!listed.empty()) {
    const auto take_shared = [&](auto BustSpec::*option) {
      const auto& first = listed.front().*option;
      if (std::ranges::all_of(listed, [&](const BustSpec& bust) { return bust.*option == first; }))
        asked.*option = first;
    };
    take_shared(&BustSpec::height_mm);
    take_shared(&BustSpec::base);
    take_shared(&BustSpec::is_hollow);
    take_shared(&BustSpec::wall_mm);
    take_shared(&BustSpec::drain_mm);
    take_shared(&BustSpec::magnet_mm);
    take_shared(&BustSpec::triangles);
    asked.label = find_asked_label(listed, expression.name);
  }
  asked.expression = std::move(expression);
  return asked;
}

void load_busts(const YamlValue& value, const ExpressionBook& book, Spec& spec) {
  if (find_node(value).kind == NodeKind::mapping)
    load_bust_set(value, book, spec);
  else
    load_bust_list(value, book, spec);
}

}  // namespace mien
