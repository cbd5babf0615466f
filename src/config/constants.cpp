#include "config/constants.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "config/load_clip.hpp"

namespace mien {

namespace {

constexpr std::string_view kCross = " x ";   // between two formulas; an input may be called x
constexpr std::size_t kMaxConstants = 4000;  // each makes a parser: some fifty microseconds

void note_use(const YamlValue& value, bool may_decide, RuntimeUse& use) {
  if (use.place.line > 0 && (use.may_decide || !may_decide)) return;
  use.place = find_place(value.document->source, value.spot);
  use.subject = describe_subject(value);
  use.line = find_line(value.document->source, value.spot.line);
  use.may_decide = may_decide;
}

// Without a mistake told: who loads the inputs tells it. What is wrong has no number.
Input read_input(const YamlEntry& entry, const Inputs& before, const FormulaWords& words) {
  Input input{entry.key, std::numeric_limits<double>::quiet_NaN(), {}};
  const YamlNode& node = find_node(entry.value);
  FormulaFault ignored;
  FormulaWords own = words;
  own.has_time = true;
  own.use = nullptr;
  if (node.kind == NodeKind::mapping)
    input.formula = build_formula("t", {}, 0, ignored, own);
  else if (node.kind == NodeKind::text && node.is_quoted)
    input.formula = build_formula(node.text, before, 0, ignored, own);
  else if (const auto number = node.kind == NodeKind::text ? parse_number(node.text) : std::nullopt)
    input.value = *number;
  return input;
}

Inputs read_inputs(const YamlMapping& clip, const Constants& outer, const FormulaWords& words) {
  Inputs inputs = outer.inputs;
  const YamlValue* value = find_value(clip, "inputs");
  if (value == nullptr || find_node(*value).kind != NodeKind::mapping) return inputs;
  for (const YamlEntry& entry : load_free_mapping(*value, ""))
    if (is_input_name(entry.key) && std::ranges::find(inputs, entry.key, &Input::name) == inputs.end() &&
        inputs.size() < outer.inputs.size() + kMaxInputs)
      inputs.push_back(read_input(entry, inputs, words));
  return inputs;
}

// A copy of an entry's value that may use `constants`, and whose mistakes nobody hears.
YamlValue take_silent(const YamlValue& value, const Constants& constants, Findings& silent) {
  YamlValue own = value;
  own.findings = &silent;
  own.constants = std::make_shared<const Constants>(constants);
  return own;
}

}  // namespace

FormulaPointer build_noted_formula(const YamlValue& value, const std::string& text, const Inputs& inputs,
                                   double start_s, FormulaFault& fault, const FormulaWords& words,
                                   bool may_decide) {
  RuntimeUse use;
  FormulaWords own = words;
  own.use = &use;
  FormulaPointer formula = build_formula(text, inputs, start_s, fault, own);
  if (words.use != nullptr && use.is_asked) {
    words.use->is_asked = true;
    note_use(value, may_decide, *words.use);
  }
  return formula;
}

bool is_constant(const YamlValue& value) {
  const YamlNode& node = find_node(value);
  return value.constants != nullptr && node.kind == NodeKind::text && node.is_quoted;
}

bool is_constant(const YamlValue& value, const Measure& measure) {
  const std::string& text = find_node(value).text;
  return is_constant(value) && (parse_number(text) || !parse_quantity(text, measure));
}

bool is_word(const YamlValue& value) {
  const YamlNode& node = find_node(value);
  if (node.kind != NodeKind::text || parse_number(node.text)) return false;
  const Form* form = value.forms == nullptr ? nullptr : find_form(*value.forms, FormKind::word);
  return !is_constant(value) ||
         (form != nullptr && std::ranges::find(form->words, node.text, &Word::name) != form->words.end());
}

namespace {

// The number of a part of the text that stands there, from a byte on.
std::optional<double> load_part(const YamlValue& value, const std::string& text, std::size_t begin,
                                bool may_decide) {
  const Constants& constants = *value.constants;
  if (++value.findings->constants > kMaxConstants) {
    if (value.findings->constants == kMaxConstants + 1)
      add_mistake(
          value,
          fmt::format("more than {} formulas stand in place of plain numbers; expected fewer (those of "
                      "a script count for each set of parameters that it is played with)",
                      kMaxConstants));
    return {};
  }
  FormulaWords words = constants.words;
  words.has_time = false;
  FormulaFault fault;
  const FormulaPointer formula =
      build_noted_formula(value, text, constants.inputs, 0, fault, words, may_decide);
  const auto report = [&](const std::string& message, std::size_t byte) -> std::optional<double> {
    add_formula_fault(value, message, begin + byte);
    return {};
  };
  if (formula == nullptr) return report(fault.message, fault.byte);
  if (const std::string word = find_changing_word(*formula); !word.empty())
    return report(
        fmt::format("'{}' changes with time; expected what does not, as one number stands here", word),
        find_word(text, word));
  const double number = evaluate(*formula, 0);
  if (std::isfinite(number)) return number;
  if (const std::string word = find_unknown_input(*formula); !word.empty())
    return report(fmt::format("'{}' is not known here", word), find_word(text, word));
  return report("it has no value; expected a number", 0);
}

}  // namespace

std::optional<double> load_constant(const YamlValue& value, bool may_decide) {
  return load_part(value, find_node(value).text, 0, may_decide);
}

std::optional<std::pair<double, double>> load_two_constants(const YamlValue& value) {
  const std::string& text = find_node(value).text;
  const std::size_t cross = text.find(kCross);
  if (cross == std::string::npos) return {};
  const auto first = load_part(value, text.substr(0, cross), 0, false);
  const std::size_t second_begin = cross + kCross.size();
  const auto second = load_part(value, text.substr(second_begin), second_begin, false);
  if (!first || !second) return {};
  return std::pair(*first, *second);
}

bool is_two_constants(const YamlValue& value) {
  return is_constant(value) && find_node(value).text.find(kCross) != std::string::npos;
}

ConstantsPointer build_own_constants(const YamlMapping& clip, const Constants& outer) {
  auto constants = std::make_shared<Constants>(outer);
  constants->inputs = read_inputs(clip, outer, outer.words);
  return constants;
}

ConstantsPointer build_constants(const YamlMapping& clip, const Constants& outer) {
  Findings silent;
  Constants constants = outer;
  const YamlValue* fps = find_value(clip, "fps");
  const YamlValue* length = find_value(clip, "length");
  constants.words.use = nullptr;
  constants.words.fps = constants.words.runtime_s = {};
  constants.inputs = read_inputs(clip, outer, constants.words);
  int rate = ClipSpec{}.fps;
  if (fps != nullptr) load_whole(take_silent(*fps, constants, silent), rate);
  constants.words.fps = rate;
  constants.inputs = read_inputs(clip, outer, constants.words);
  double length_s = 0;
  if (length == nullptr)
    constants.words.runtime_s = outer.words.runtime_s;
  else if (load_duration(take_silent(*length, constants, silent), build_clip_clock(rate), length_s))
    constants.words.runtime_s = length_s;
  if (!constants.words.runtime_s && length == nullptr) constants.words.use = outer.words.use;
  constants.inputs = read_inputs(clip, outer, constants.words);
  return std::make_shared<const Constants>(std::move(constants));
}

ConstantsPointer build_file_constants(const YamlValue& root, std::optional<double> runtime_s,
                                      RuntimeUse* use) {
  Findings silent;
  YamlValue own = root;
  own.findings = &silent;
  YamlMapping clip;
  if (find_node(own).kind == NodeKind::mapping) {
    const YamlMapping file = load_section(own, find_sections().file);
    if (const YamlValue* value = find_value(file, "clip");
        value != nullptr && find_node(*value).kind == NodeKind::mapping)
      clip = load_section(*value, find_sections().clip);
  }
  Constants outer;
  outer.words.runtime_s = runtime_s;
  outer.words.use = use;
  return build_constants(clip, outer);
}

ConstantsPointer build_actor_constants(const YamlValue& actor) {
  if (actor.constants == nullptr || find_node(actor).kind != NodeKind::mapping) return actor.constants;
  const YamlMapping entries = load_free_mapping(actor, "");
  const YamlValue* clip = find_value(entries, "clip");
  if (clip == nullptr || find_node(*clip).kind != NodeKind::mapping) return actor.constants;
  return build_own_constants(load_free_mapping(*clip, ""), *actor.constants);
}

bool mentions_runtime(const YamlDocument& document) {
  return std::ranges::any_of(document.nodes, [](const YamlNode& node) {
    return node.is_quoted && node.text.find("runtime") != std::string::npos;
  });
}

void set_constants(const ConstantsPointer& constants, YamlMapping& entries) {
  for (YamlEntry& entry : entries) entry.value.constants = constants;
}

YamlValue find_deciding(const YamlValue& value, bool is_fps) {
  if (value.constants == nullptr) return value;
  auto constants = std::make_shared<Constants>(*value.constants);
  constants->words.runtime_s = {};
  if (is_fps) constants->words.fps = {};
  for (Input& input : constants->inputs)
    if (input.formula &&
        (uses_word(*input.formula, "runtime") || (is_fps && uses_word(*input.formula, "fps"))))
      input = {input.name, std::numeric_limits<double>::quiet_NaN(), {}};
  constants->words.missing = "is what it decides itself; expected a formula without it";
  constants->words.use = nullptr;
  YamlValue own = value;
  own.constants = std::move(constants);
  return own;
}

}  // namespace mien
