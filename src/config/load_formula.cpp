#include "config/load_formula.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/constants.hpp"
#include "config/load_clip.hpp"
#include "config/series.hpp"

namespace mien {

namespace {

// Of a clip, those of its scripts once for each set of parameters. Each keeps a parser for each thread, some
// ten kilobytes.
constexpr std::size_t kMaxFormulas = 4000;

// The place of a byte of the formula. A text with escapes or on several lines is told of at its beginning.
Spot find_spot(const YamlValue& value, std::size_t byte) {
  const std::string& text = find_node(value).text;
  const std::string_view line = find_line(value.document->source, value.spot.line);
  const auto begin = static_cast<std::size_t>(value.spot.byte) + 1;  // behind the quote
  Spot spot = value.spot;
  if (begin <= line.size() && line.substr(begin).starts_with(text))
    spot.byte = static_cast<int>(begin + byte);
  return spot;
}

std::size_t count_named(const Inputs& inputs) {
  return static_cast<std::size_t>(
      std::ranges::count_if(inputs, [](const Input& input) { return !input.name.empty(); }));
}

// " (frame 25)"; nothing between two frames.
std::string name_frame(double time_s, int fps) {
  constexpr double kSame = 1e-6;  // of a frame
  const double frame = time_s * fps;
  return fps > 0 && std::abs(frame - std::round(frame)) < kSame
             ? fmt::format(" (frame {})", std::lround(frame) + 1)
             : "";
}

}  // namespace

void add_formula_fault(const YamlValue& value, const std::string& message, std::size_t byte) {
  if (find_node(value).kind == NodeKind::broken) return;
  add_mistake(*value.findings, value.document->source, find_spot(value, byte),
              fmt::format("in the formula of {}: {}", describe_subject(value), message));
}

bool is_formula(const YamlValue& value) {
  const YamlNode& node = find_node(value);
  return node.kind == NodeKind::text && node.is_quoted;
}

bool is_formula(const YamlValue& value, const Measure& measure) {
  const std::string& text = find_node(value).text;
  return is_formula(value) && (parse_number(text) || !parse_quantity(text, measure));
}

FormulaPointer load_formula(const YamlValue& value, const FormulaReader& reader) {
  if (reader.count != nullptr && ++*reader.count > kMaxFormulas) {
    if (*reader.count == kMaxFormulas + 1)
      add_mistake(value,
                  fmt::format("more than {} formulas; expected fewer (those of a script count for each "
                              "set of parameters that it is played with)",
                              kMaxFormulas));
    return {};
  }
  FormulaFault fault;
  FormulaPointer formula = build_noted_formula(value, find_node(value).text, reader.inputs, reader.start_s,
                                               fault, reader.words, false);
  if (formula == nullptr)
    add_formula_fault(value, fault.message, fault.byte);
  else if (reader.found != nullptr)
    reader.found->emplace_back(formula, value);
  return formula;
}

ConstantsPointer build_constants(const FormulaReader& reader) {
  return std::make_shared<const Constants>(Constants{reader.inputs, reader.words});
}

void check_formula(const FormulaPointer& formula, const FormulaReader& reader,
                   const std::vector<double>& times_s) {
  const double* time_s = find_undefined(*formula, times_s);
  if (time_s == nullptr || reader.found == nullptr) return;
  const auto found = std::ranges::find(*reader.found, formula, [](const auto& pair) { return pair.first; });
  if (found != reader.found->end())
    add_formula_fault(found->second,
                      fmt::format("it has no value at t = {:.7g}{}; expected a number at every time",
                                  *time_s - compute_start_s(*formula), name_frame(*time_s, reader.fps)),
                      0);
}

void load_inputs(const YamlValue& value, const Inputs& given, const ClipClock& clock, FormulaReader& reader) {
  for (const YamlEntry& entry : load_free_mapping(value, "names and numbers such as {mood: 0.5}")) {
    if (!is_input_name(entry.key)) {
      add_mistake(
          *value.findings, value.document->source, entry.spot,
          fmt::format("'{}' cannot name a number; expected a letter, then letters, digits or '_', and no "
                      "word of formulas such as t or sin",
                      show_word(entry.key)));
      continue;
    }
    Input input{entry.key, 0, {}};
    YamlValue own = entry.value;
    own.constants = build_constants(reader);
    if (find_node(own).kind == NodeKind::mapping && own.forms != nullptr &&
        find_form(*own.forms, FormKind::section) != nullptr)
      input.series = load_series(own, clock);
    else if (is_formula(entry.value))
      input.formula = load_formula(entry.value, reader);
    else
      load_number(entry.value, input.value);
    if (const auto other = std::ranges::find(given, input.name, &Input::name); other != given.end())
      input = *other;
    if (std::ranges::find(reader.inputs, input.name, &Input::name) != reader.inputs.end()) {
      add_mistake(*value.findings, value.document->source, entry.spot,
                  fmt::format("'{}' is an input already; expected another name", input.name));
    } else if (count_named(reader.inputs) < kMaxInputs) {
      reader.inputs.push_back(input);
    } else {
      add_mistake(entry.value, fmt::format("more than {} inputs; expected fewer", kMaxInputs));
      return;
    }
  }
}

}  // namespace mien
