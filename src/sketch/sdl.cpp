#include "sketch/sdl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/conventions.hpp"
#include "core/error.hpp"

namespace mien {

namespace {

using Tokens = std::shared_ptr<const std::vector<SdlToken>>;

constexpr std::size_t kDeepest = 200;  // macros within macros; more is one that calls itself

// Where words come from: the text, a macro that was called, or the body of a loop.
struct SdlSource {
  Tokens tokens;
  std::size_t first = 0, at = 0, last = 0;
  bool is_call = false;
  std::string loop;  // its variable; or empty
  double loop_at = 0, loop_last = 0, loop_step = 1;
};

struct SdlReader {
  std::string_view name;
  SdlNames& names;
  std::vector<SdlSource> sources;
  std::vector<std::map<std::string, SdlValue, std::less<>>> scopes;  // of the macros that are being read
  int line = 1;
};

SdlValue make_number(double number) { return {{number, number, number, number, number}, 1}; }
SdlValue make_vector(const glm::dvec3& v) { return {{v.x, v.y, v.z, 0, 0}, 3}; }

[[noreturn]] void fail_sdl(const SdlReader& reader, const std::string& what) {
  throw RunError(fmt::format("{}:{}: {}", reader.name, reader.line, what));
}

const SdlValue* find_name(const SdlReader& reader, std::string_view name) {
  for (auto scope = reader.scopes.rbegin(); scope != reader.scopes.rend(); ++scope)
    if (const auto found = scope->find(name); found != scope->end()) return &found->second;
  const auto found = reader.names.values.find(name);
  return found == reader.names.values.end() ? nullptr : &found->second;
}

void set_local(SdlReader& reader, const std::string& name, const SdlValue& value) {
  (reader.scopes.empty() ? reader.names.values : reader.scopes.back())[name] = value;
}

void run_directive(SdlReader& reader, const std::string& directive);

// The next word, behind all directives; null at the end of all.
const SdlToken* look(SdlReader& reader) {
  while (!reader.sources.empty()) {
    SdlSource& source = reader.sources.back();
    if (source.at < source.last) {
      const SdlToken& token = (*source.tokens)[source.at];
      reader.line = token.line;
      if (token.kind != SdlKind::directive) return &token;
      ++source.at;
      run_directive(reader, token.word);
      continue;
    }
    if (!source.loop.empty() && source.loop_at + source.loop_step <= source.loop_last + 1e-9) {
      source.loop_at += source.loop_step;
      source.at = source.first;
      const std::string variable = source.loop;
      set_local(reader, variable, make_number(source.loop_at));
      continue;
    }
    if (source.is_call) reader.scopes.pop_back();
    reader.sources.pop_back();
  }
  return nullptr;
}

bool is_sign(SdlReader& reader, std::string_view sign) {
  const SdlToken* const token = look(reader);
  return token && token->kind == SdlKind::sign && token->word == sign;
}

SdlToken take(SdlReader& reader) {
  const SdlToken* const token = look(reader);
  if (!token) fail_sdl(reader, "the text ends too soon");
  ++reader.sources.back().at;
  return *token;
}

bool take_if(SdlReader& reader, std::string_view sign) {
  if (!is_sign(reader, sign)) return false;
  ++reader.sources.back().at;
  return true;
}

void expect(SdlReader& reader, std::string_view sign) {
  if (take_if(reader, sign)) return;
  const SdlToken* const token = look(reader);
  fail_sdl(reader, fmt::format("expected '{}', found '{}'", sign, token ? token->word : "the end"));
}

std::string take_word(SdlReader& reader) {
  const SdlToken token = take(reader);
  if (token.kind != SdlKind::word) fail_sdl(reader, fmt::format("expected a name, found '{}'", token.word));
  return token.word;
}

// ---- Expressions: of values, and of functions that are not computed yet.

double bend_srgb(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

using Numeric = double (*)(double, double);
struct NumericRow {
  std::string_view name;
  int count;
  Numeric function;
};
constexpr auto kNumeric = std::to_array<NumericRow>({
    {"abs", 1, [](double a, double) { return std::abs(a); }},
    {"atan2", 2, [](double a, double b) { return std::atan2(a, b); }},
    {"cos", 1, [](double a, double) { return std::cos(a); }},
    {"degrees", 1, [](double a, double) { return a / kRadiansPerDegree; }},
    {"max", 2, [](double a, double b) { return std::max(a, b); }},
    {"min", 2, [](double a, double b) { return std::min(a, b); }},
    {"mod", 2, [](double a, double b) { return std::fmod(a, b); }},
    {"pow", 2, [](double a, double b) { return std::pow(a, b); }},
    {"radians", 1, [](double a, double) { return a * kRadiansPerDegree; }},
    {"sin", 1, [](double a, double) { return std::sin(a); }},
    {"sqrt", 1, [](double a, double) { return std::sqrt(a); }},
});

const NumericRow* find_numeric(std::string_view name) {
  const auto found = std::ranges::find(kNumeric, name, &NumericRow::name);
  return found == kNumeric.end() ? nullptr : found;
}

// About x, then y, then z, as POV-Ray turns.
glm::dvec3 rotate(glm::dvec3 v, const glm::dvec3& degrees) {
  for (int axis = 0; axis < 3; ++axis) {
    const double angle = degrees[axis] * kRadiansPerDegree, c = std::cos(angle), s = std::sin(angle);
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    const double va = v[a], vb = v[b];
    v[a] = va * c - vb * s;
    v[b] = va * s + vb * c;
  }
  return v;
}

bool is_vector_function(std::string_view name) {
  return name == "vrotate" || name == "vnormalize" || name == "vcross" || name == "vlength" || name == "vdot";
}

SdlValue call_vector_function(std::string_view name, const std::vector<SdlValue>& arguments) {
  const glm::dvec3 a = arguments[0].vector(), b = arguments.back().vector();
  if (name == "vrotate") return make_vector(rotate(a, b));
  if (name == "vcross") return make_vector(glm::cross(a, b));
  if (name == "vlength") return make_number(glm::length(a));
  if (name == "vdot") return make_number(glm::dot(a, b));
  const double length = glm::length(a);
  return make_vector(length > 0 ? a / length : a);
}

SdlValue combine(SdlReader&, char sign, const SdlValue& a, const SdlValue& b) {
  SdlValue result{{}, std::max(a.size, b.size)};
  for (std::size_t i = 0; i < result.v.size(); ++i) {
    const double x = a.v[i], y = b.v[i];
    result.v[i] = sign == '+' ? x + y : sign == '-' ? x - y : sign == '*' ? x * y : y != 0 ? x / y : 0;
  }
  return result;
}

SdlFunction combine(SdlReader&, char sign, const SdlFunction& a, const SdlFunction& b) {
  using Node = SdlFunction::Node;
  return {sign == '+'   ? Node::add
          : sign == '-' ? Node::subtract
          : sign == '*' ? Node::multiply
                        : Node::divide,
          0,
          nullptr,
          {a, b}};
}

template <typename T>
T make_constant(double number);
template <>
SdlValue make_constant<SdlValue>(double number) {
  return make_number(number);
}
template <>
SdlFunction make_constant<SdlFunction>(double number) {
  return {SdlFunction::Node::number, number, nullptr, {}};
}

template <typename T>
T parse_sum(SdlReader& reader);
template <typename T>
T parse_word(SdlReader& reader, const std::string& word);

// With comparisons, which are 1 or 0.
SdlValue parse_condition(SdlReader& reader) {
  SdlValue a = parse_sum<SdlValue>(reader);
  for (const char* sign : {">=", "<=", "!=", ">", "<", "="}) {
    if (!take_if(reader, sign)) continue;
    const double x = a.number(), y = parse_sum<SdlValue>(reader).number();
    const std::string_view s(sign);
    return make_number((s == ">=" && x >= y) || (s == "<=" && x <= y) || (s == "!=" && x != y) ||
                       (s == ">" && x > y) || (s == "<" && x < y) || (s == "=" && x == y));
  }
  return a;
}

template <typename T>
std::vector<T> parse_arguments(SdlReader& reader) {
  std::vector<T> arguments;
  expect(reader, "(");
  while (!take_if(reader, ")")) {
    arguments.push_back(parse_sum<T>(reader));
    if (!is_sign(reader, ")")) expect(reader, ",");
  }
  return arguments;
}

// Has the macro's body read next, with its parameters set.
void call_macro(SdlReader& reader, const std::string& name, const SdlMacro& macro) {
  const std::vector<SdlValue> arguments = parse_arguments<SdlValue>(reader);
  if (arguments.size() != macro.parameters.size())
    fail_sdl(reader,
             fmt::format("{} takes {} values, not {}", name, macro.parameters.size(), arguments.size()));
  if (reader.sources.size() > kDeepest) fail_sdl(reader, fmt::format("{} calls itself without end", name));
  reader.scopes.emplace_back();
  for (std::size_t i = 0; i < arguments.size(); ++i) reader.scopes.back()[macro.parameters[i]] = arguments[i];
  reader.sources.push_back({macro.tokens, macro.first, macro.first, macro.last, true, {}});
}

// "Vector.y" and "Colour.green" are not values of functions.
SdlValue parse_component(SdlReader& reader, const SdlValue& value) {
  if (!take_if(reader, ".")) return value;
  const std::string component = take_word(reader);
  constexpr std::array<std::string_view, 6> kComponents{"x", "y", "z", "red", "green", "blue"};
  const auto found = std::ranges::find(kComponents, component);
  if (found == kComponents.end()) fail_sdl(reader, fmt::format("unknown component '{}'", component));
  return make_number(value.v[static_cast<std::size_t>(found - kComponents.begin()) % 3]);
}

template <typename T>
T parse_primary(SdlReader& reader) {
  const SdlToken token = take(reader);
  if (token.kind == SdlKind::number) return make_constant<T>(token.number);
  if (token.kind == SdlKind::word) return parse_word<T>(reader, token.word);
  if (token.word == "-") return combine(reader, '*', make_constant<T>(-1), parse_primary<T>(reader));
  if (token.word == "+") return parse_primary<T>(reader);
  if (token.word == "(") {
    T inner = make_constant<T>(0);
    if constexpr (std::is_same_v<T, SdlValue>)
      inner = parse_condition(reader);
    else
      inner = parse_sum<T>(reader);
    expect(reader, ")");
    if constexpr (std::is_same_v<T, SdlValue>) return parse_component(reader, inner);
    return inner;
  }
  if constexpr (std::is_same_v<T, SdlValue>)
    if (token.word == "<") {
      SdlValue vector{{}, 0};
      do {
        if (vector.size == 5) fail_sdl(reader, "a vector of more than five numbers");
        vector.v[static_cast<std::size_t>(vector.size++)] = parse_sum<SdlValue>(reader).number();
      } while (take_if(reader, ","));
      expect(reader, ">");
      return parse_component(reader, vector);
    }
  fail_sdl(reader, fmt::format("expected a value, found '{}'", token.word));
}

template <>
SdlValue parse_word<SdlValue>(SdlReader& reader, const std::string& word) {
  if (word == "color" || word == "colour") return parse_sum<SdlValue>(reader);
  if (word == "rgb" || word == "srgb") {
    SdlValue colour = parse_sum<SdlValue>(reader);
    if (word == "srgb")
      for (double& channel : colour.v) channel = bend_srgb(channel);
    return {{colour.v[0], colour.v[1], colour.v[2], 0, 0}, 5};
  }
  if (const SdlValue* const known = find_name(reader, word)) {
    const SdlValue value = *known;  // a macro's own names end with its last word, which may be this one
    return parse_component(reader, value);
  }
  if (word.size() == 1 && word[0] >= 'x' && word[0] <= 'z') {
    SdlValue axis{{}, 3};
    axis.v[static_cast<std::size_t>(word[0] - 'x')] = 1;
    return axis;
  }
  if (const auto macro = reader.names.macros.find(word); macro != reader.names.macros.end()) {
    call_macro(reader, word, macro->second);
    return parse_primary<SdlValue>(reader);
  }
  if (const NumericRow* const row = find_numeric(word)) {
    const std::vector<SdlValue> arguments = parse_arguments<SdlValue>(reader);
    if (static_cast<int>(arguments.size()) != row->count)
      fail_sdl(reader, fmt::format("{} takes {} values", word, row->count));
    return make_number(row->function(arguments.front().number(), arguments.back().number()));
  }
  if (is_vector_function(word)) {
    const std::vector<SdlValue> arguments = parse_arguments<SdlValue>(reader);
    if (arguments.empty()) fail_sdl(reader, fmt::format("{} of nothing", word));
    return call_vector_function(word, arguments);
  }
  fail_sdl(reader, fmt::format("unknown name '{}'", word));
}

template <>
SdlFunction parse_word<SdlFunction>(SdlReader& reader, const std::string& word) {
  using Node = SdlFunction::Node;
  if (word.size() == 1 && word[0] >= 'x' && word[0] <= 'z')
    return {word == "x" ? Node::x : word == "y" ? Node::y : Node::z, 0, nullptr, {}};
  if (const SdlValue* const value = find_name(reader, word))
    return make_constant<SdlFunction>(value->number());
  const NumericRow* const row = find_numeric(word);
  if (!row) fail_sdl(reader, fmt::format("unknown name '{}' in a function", word));
  std::vector<SdlFunction> arguments = parse_arguments<SdlFunction>(reader);
  if (static_cast<int>(arguments.size()) != row->count)
    fail_sdl(reader, fmt::format("{} takes {} values", word, row->count));
  return {Node::call, 0, row->function, std::move(arguments)};
}

template <typename T>
T parse_product(SdlReader& reader) {
  T product = parse_primary<T>(reader);
  while (is_sign(reader, "*") || is_sign(reader, "/")) {
    const char sign = take(reader).word[0];
    product = combine(reader, sign, product, parse_primary<T>(reader));
  }
  return product;
}

template <typename T>
T parse_sum(SdlReader& reader) {
  T sum = parse_product<T>(reader);
  while (is_sign(reader, "+") || is_sign(reader, "-")) {
    const char sign = take(reader).word[0];
    sum = combine(reader, sign, sum, parse_product<T>(reader));
  }
  return sum;
}

// ---- Directives.

bool is_opening(const SdlToken& token) {
  return token.word == "if" || token.word == "ifdef" || token.word == "ifndef" || token.word == "for" ||
         token.word == "macro";
}

// Where the part that begins at the source's place ends: the index of its #end, or of its #else where that
// counts.
std::size_t find_end(const SdlReader& reader, bool stops_at_else) {
  const SdlSource& source = reader.sources.back();
  int depth = 0;
  for (std::size_t i = source.at; i < source.last; ++i) {
    const SdlToken& token = (*source.tokens)[i];
    if (token.kind != SdlKind::directive) continue;
    if (depth == 0 && (token.word == "end" || (stops_at_else && token.word == "else"))) return i;
    depth += is_opening(token) ? 1 : token.word == "end" ? -1 : 0;
  }
  fail_sdl(reader, "a part without its #end");
}

void declare(SdlReader& reader, bool is_local) {
  const std::string name = take_word(reader);
  expect(reader, "=");
  const SdlValue value = parse_sum<SdlValue>(reader);
  if (is_local)
    set_local(reader, name, value);
  else
    reader.names.values[name] = value;
  take_if(reader, ";");
}

void declare_macro(SdlReader& reader) {
  const std::string name = take_word(reader);
  SdlMacro macro;
  expect(reader, "(");
  while (!take_if(reader, ")")) {
    macro.parameters.push_back(take_word(reader));
    take_if(reader, ",");
  }
  SdlSource& source = reader.sources.back();
  macro.tokens = source.tokens;
  macro.first = source.at;
  macro.last = find_end(reader, false);
  source.at = macro.last + 1;
  reader.names.macros[name] = std::move(macro);
}

void run_loop(SdlReader& reader) {
  expect(reader, "(");
  SdlSource loop;
  loop.loop = take_word(reader);
  expect(reader, ",");
  loop.loop_at = parse_sum<SdlValue>(reader).number();
  expect(reader, ",");
  loop.loop_last = parse_sum<SdlValue>(reader).number();
  if (take_if(reader, ",")) loop.loop_step = parse_sum<SdlValue>(reader).number();
  expect(reader, ")");
  if (loop.loop_step <= 0) fail_sdl(reader, "a loop that goes down is not known here");
  SdlSource& source = reader.sources.back();
  loop.tokens = source.tokens;
  loop.first = loop.at = source.at;
  loop.last = find_end(reader, false);
  source.at = loop.last + 1;
  if (loop.loop_at > loop.loop_last) return;
  set_local(reader, loop.loop, make_number(loop.loop_at));
  reader.sources.push_back(std::move(loop));
}

void run_condition(SdlReader& reader, const std::string& directive) {
  expect(reader, "(");
  bool holds = false;
  if (directive == "if") {
    holds = parse_condition(reader).number() != 0;
  } else {
    const std::string name = take_word(reader);
    const bool is_known = find_name(reader, name) != nullptr || reader.names.macros.contains(name);
    holds = is_known == (directive == "ifdef");
  }
  expect(reader, ")");
  if (!holds) reader.sources.back().at = find_end(reader, true) + 1;
}

void run_directive(SdlReader& reader, const std::string& directive) {
  if (directive == "end") return;  // of a condition whose part was read
  if (directive == "else") {
    reader.sources.back().at = find_end(reader, false) + 1;
  } else if (directive == "version") {
    while (!take_if(reader, ";")) take(reader);
  } else if (directive == "include") {
    take(reader);  // what it holds has been read
  } else if (directive == "declare" || directive == "local") {
    declare(reader, directive == "local");
  } else if (directive == "macro") {
    declare_macro(reader);
  } else if (directive == "for") {
    run_loop(reader);
  } else if (directive == "if" || directive == "ifdef" || directive == "ifndef") {
    run_condition(reader, directive);
  } else {
    fail_sdl(reader, fmt::format("'#{}' is not known here", directive));
  }
}

// ---- Blocks.

bool begins_value(const SdlReader& reader, const SdlToken& token) {
  if (token.kind == SdlKind::number) return true;
  if (token.kind == SdlKind::sign)
    return token.word == "<" || token.word == "(" || token.word == "-" || token.word == "+";
  const std::string& word = token.word;
  return word == "rgb" || word == "srgb" || word == "color" || word == "colour" ||
         (word.size() == 1 && word[0] >= 'x' && word[0] <= 'z') || find_name(reader, word) ||
         find_numeric(word) || is_vector_function(word);
}

SdlBlock parse_block(SdlReader& reader, std::string name, std::string_view end);

std::vector<double> parse_matrix(SdlReader& reader) {
  constexpr std::size_t kNumbers = 12;
  std::vector<double> numbers;
  expect(reader, "<");
  do numbers.push_back(parse_sum<SdlValue>(reader).number());
  while (take_if(reader, ","));
  expect(reader, ">");
  if (numbers.size() != kNumbers) fail_sdl(reader, "a matrix needs twelve numbers");
  return numbers;
}

void parse_item(SdlReader& reader, SdlBlock& block) {
  const SdlToken token = *look(reader);
  if (token.kind == SdlKind::text) fail_sdl(reader, "a text is not known here");
  if (begins_value(reader, token)) {
    block.items.push_back({"", parse_sum<SdlValue>(reader), nullptr, true, {}});
    return;
  }
  take(reader);
  if (token.word == "," || token.word == ";") return;
  if (token.word == "[") {
    block.items.push_back({"", {}, std::make_shared<SdlBlock>(parse_block(reader, "", "]")), false, {}});
    return;
  }
  if (token.kind != SdlKind::word) fail_sdl(reader, fmt::format("unexpected '{}'", token.word));
  if (const auto macro = reader.names.macros.find(token.word); macro != reader.names.macros.end()) {
    call_macro(reader, token.word, macro->second);
    return;
  }
  if (token.word == "matrix") {
    block.items.push_back({token.word, {}, nullptr, false, parse_matrix(reader)});
    return;
  }
  if (!take_if(reader, "{")) {
    block.items.push_back({token.word, {}, nullptr, false, {}});
    return;
  }
  block.items.push_back(
      {token.word, {}, std::make_shared<SdlBlock>(parse_block(reader, token.word, "}")), false, {}});
}

SdlBlock parse_block(SdlReader& reader, std::string name, std::string_view end) {
  SdlBlock block;
  block.name = std::move(name);
  if (block.name == "function") {
    block.function = parse_sum<SdlFunction>(reader);
    expect(reader, end);
    return block;
  }
  while (!take_if(reader, end)) {
    if (!look(reader)) fail_sdl(reader, fmt::format("'{}' is never closed", block.name));
    parse_item(reader, block);
  }
  return block;
}

}  // namespace

double evaluate(const SdlFunction& function, const glm::dvec3& at) {
  using Node = SdlFunction::Node;
  const auto part = [&](std::size_t i) { return evaluate(function.parts[i], at); };
  switch (function.node) {
    case Node::number:
      return function.number;
    case Node::x:
      return at.x;
    case Node::y:
      return at.y;
    case Node::z:
      return at.z;
    case Node::add:
      return part(0) + part(1);
    case Node::subtract:
      return part(0) - part(1);
    case Node::multiply:
      return part(0) * part(1);
    case Node::divide: {
      const double by = part(1);
      return by != 0 ? part(0) / by : 0;
    }
    case Node::call:
      break;
  }
  const double first = part(0);
  return function.call(first, function.parts.size() > 1 ? part(1) : first);
}

const SdlValue* find_value(const SdlBlock& block, std::string_view word) {
  for (std::size_t i = 0; i + 1 < block.items.size(); ++i)
    if (block.items[i].word == word && block.items[i + 1].is_value) return &block.items[i + 1].value;
  return nullptr;
}

bool has_word(const SdlBlock& block, std::string_view word) {
  return std::ranges::find(block.items, word, &SdlItem::word) != block.items.end();
}

const SdlBlock* find_block(const SdlBlock& block, std::string_view name) {
  for (const SdlItem& item : block.items)
    if (item.block && item.word == name) return item.block.get();
  return nullptr;
}

SdlBlock read_sdl(std::string_view text, std::string_view name, SdlNames& names) {
  SdlReader reader{name, names, {}, {}, 1};
  const Tokens tokens = std::make_shared<const std::vector<SdlToken>>(list_sdl_tokens(text, name));
  reader.sources.push_back({tokens, 0, 0, tokens->size(), false, {}});
  SdlBlock all;
  while (look(reader)) parse_item(reader, all);
  return all;
}

}  // namespace mien
