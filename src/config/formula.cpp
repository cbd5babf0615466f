#include "config/formula.hpp"

#include <fmt/format.h>
#include <muParser.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <thread>

#include "config/findings.hpp"
#include "config/language.hpp"
#include "config/series.hpp"

namespace mien {

namespace {

double clamp_between(double value, double low, double high) { return std::min(std::max(value, low), high); }
double compute_remainder(double value, double period) { return value - period * std::floor(value / period); }

// The words that stand for numbers, but for `pi` and the inputs.
constexpr std::array<std::string_view, 3> kWords{"t", "runtime", "fps"};

// One reader of a formula: muParser keeps its variables and its stack in the object, so that each thread that
// evaluates needs its own.
struct Reader {
  mu::Parser parser;
  std::vector<double> values;  // those of kWords, then the inputs

  Reader(const std::string& text, const Inputs& inputs, const std::array<double, 2>& clip)
      : values(inputs.size() + kWords.size(), 0) {
    std::ranges::copy(clip, values.begin() + 1);
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineFun("clamp", clamp_between);
    parser.DefineFun("mod", compute_remainder);
    for (std::size_t i = 0; i < kWords.size(); ++i) parser.DefineVar(std::string(kWords[i]), &values[i]);
    for (std::size_t i = 0; i < inputs.size(); ++i)
      if (!inputs[i].name.empty()) parser.DefineVar(inputs[i].name, &values[i + kWords.size()]);
    parser.SetExpr(text);
  }
};

const Names& list_words() {
  static const Names words = [] {
    mu::Parser parser;
    Names names{"pi", "clamp", "mod"};
    for (const std::string_view word : kWords) names.emplace_back(word);
    for (const auto& [name, function] : parser.GetFunDef()) names.push_back(name);
    for (const auto& [name, value] : parser.GetConst()) names.push_back(name);
    return names;
  }();
  return words;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// muParser would take "t = 3" for an order to change t.
std::size_t find_assignment(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
      continue;
    }
    if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos) return i;
  }
  return std::string::npos;
}

std::string describe_fault(const mu::Parser::exception_type& error, const Inputs& inputs, bool has_time) {
  const std::string token = show_word(error.GetToken());
  switch (error.GetCode()) {
    case mu::ecUNASSIGNABLE_TOKEN: {
      Names known = list_words();
      if (!has_time) std::erase(known, kWords[0]);
      for (const Input& input : inputs)
        if (!input.name.empty()) known.push_back(input.name);
      if (std::ranges::find(list_words(), token) != list_words().end())
        return fmt::format("'{}' is a function; expected '(' behind it", token);
      const bool is_word = !token.empty() && is_letter(token[0]);
      const std::string nearest = is_word ? suggest_name(token, known) : "";
      if (!nearest.empty()) return fmt::format("unknown word '{}'; did you mean '{}'?", token, nearest);
      if (is_word)
        return fmt::format("unknown word '{}'; expected {}, pi, a function such as sin, or an input", token,
                           has_time ? "t" : "runtime");
      return fmt::format("'{}' means nothing here", token);
    }
    case mu::ecMISSING_PARENS:
      return "a '(' is not closed";
    case mu::ecUNEXPECTED_PARENS:
      return fmt::format("'{}' is not expected here", token.empty() ? ")" : token);
    case mu::ecUNEXPECTED_EOF:
    case mu::ecEMPTY_EXPRESSION:
      return "it ends too early";
    case mu::ecTOO_MANY_PARAMS:
      return fmt::format("'{}' is given too many numbers", token);
    case mu::ecTOO_FEW_PARAMS:
      return fmt::format("'{}' is given too few numbers", token);
    default:
      return token.empty() ? std::string("it cannot be read here")
                           : fmt::format("'{}' is not expected here", token);
  }
}

// Where the fault is; of what is missing muParser says no place, or the beginning.
int find_fault(const std::string& text, const mu::Parser::exception_type& error) {
  const int end = static_cast<int>(text.size());
  if (error.GetCode() == mu::ecUNEXPECTED_EOF || error.GetCode() == mu::ecEMPTY_EXPRESSION) return end;
  if (error.GetCode() != mu::ecMISSING_PARENS) return error.GetPos();
  std::vector<int> open;
  for (int i = 0; i < end; ++i) {
    if (text[static_cast<std::size_t>(i)] == '(') open.push_back(i);
    if (text[static_cast<std::size_t>(i)] == ')' && !open.empty()) open.pop_back();
  }
  return open.empty() ? end : open.back();
}

}  // namespace

// Readers that no thread uses now. A thread looks into one place only, so that it waits for nobody; with more
// threads than places some make a reader anew.
struct IdleReaders {
  std::array<std::atomic<Reader*>, 8> places{};

  IdleReaders() = default;
  IdleReaders(const IdleReaders&) = delete;
  IdleReaders& operator=(const IdleReaders&) = delete;
  ~IdleReaders() {
    for (std::atomic<Reader*>& place : places) delete place.load();
  }

  std::atomic<Reader*>& find_place() {
    return places[std::hash<std::thread::id>()(std::this_thread::get_id()) % places.size()];
  }
  std::unique_ptr<Reader> take() { return std::unique_ptr<Reader>(find_place().exchange(nullptr)); }
  void give(std::unique_ptr<Reader> reader) { delete find_place().exchange(reader.release()); }
};

struct Formula {
  std::string text;
  Inputs inputs;
  std::vector<bool> is_used;               // input by input: by the formula, or by an input that it uses
  std::array<bool, kWords.size()> uses{};  // the same of kWords
  std::string changing;                    // the word of the text that changes with time
  std::array<double, 2> clip{};            // what `runtime` and `fps` are
  double start_s = 0;
  double more = 0;  // that its number is greater by
  mutable IdleReaders idle;
};

namespace {

std::unique_ptr<Reader> take_reader(const Formula& formula) {
  auto reader = formula.idle.take();
  return reader ? std::move(reader) : std::make_unique<Reader>(formula.text, formula.inputs, formula.clip);
}

// With the inputs' numbers in the reader; gives it back.
double evaluate_with(const Formula& formula, double time_s, std::unique_ptr<Reader> reader) {
  reader->values[0] = time_s - formula.start_s;
  double value = NAN;
  try {
    value = reader->parser.Eval();
  } catch (const mu::Parser::exception_type&) {
    // A division that muParser refuses has no value either.
  }
  formula.idle.give(std::move(reader));
  return value;
}

// The same for an input, which uses those before it.
double evaluate_input(const Formula& input, double time_s, std::span<const double> before) {
  auto reader = take_reader(input);
  std::copy_n(before.begin(), input.inputs.size(),
              reader->values.begin() + static_cast<std::ptrdiff_t>(kWords.size()));
  return evaluate_with(input, time_s, std::move(reader));
}

}  // namespace

bool is_input_name(const std::string& name) {
  return !name.empty() && name.size() <= 64 && is_letter(name[0]) &&
         std::ranges::all_of(name, [](char c) { return is_letter(c) || is_digit(c); }) &&
         std::ranges::find(list_words(), name) == list_words().end();
}

std::size_t find_word(std::string_view text, std::string_view word) {
  const auto is_part = [&](std::size_t i) {
    return i < text.size() && (is_letter(text[i]) || is_digit(text[i]));
  };
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
    if (!is_part(at - 1) && !is_part(at + word.size())) return at;
  return 0;
}

namespace {

// What it uses, by itself and through the inputs.
void find_uses(const std::set<std::string>& words, Formula& formula) {
  const Inputs& inputs = formula.inputs;
  for (std::size_t w = 0; w < kWords.size(); ++w) formula.uses[w] = words.contains(std::string(kWords[w]));
  for (std::size_t i = 0; i < inputs.size(); ++i) formula.is_used[i] = words.contains(inputs[i].name);
  if (formula.uses[0]) formula.changing = kWords[0];
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Formula* input = formula.is_used[i] ? inputs[i].formula.get() : nullptr;
    const bool is_changing = formula.is_used[i] && (inputs[i].series || (input != nullptr && input->uses[0]));
    if (is_changing && formula.changing.empty()) formula.changing = inputs[i].name;
    for (std::size_t w = 0; w < kWords.size() && input != nullptr; ++w)
      formula.uses[w] = formula.uses[w] || input->uses[w];
    formula.uses[0] = formula.uses[0] || is_changing;
  }
  for (std::size_t i = inputs.size(); i-- > 0;)
    if (formula.is_used[i] && inputs[i].formula)
      for (std::size_t j = 0; j < i && j < inputs[i].formula->is_used.size(); ++j)
        if (inputs[i].formula->is_used[j]) formula.is_used[j] = true;
}

}  // namespace

FormulaPointer build_formula(const std::string& text, const Inputs& inputs, double start_s,
                             FormulaFault& fault, const FormulaWords& words) {
  if (text.size() > kMaxFormulaLength) {
    fault = {fmt::format("it is longer than {} bytes", kMaxFormulaLength), 0};
    return {};
  }
  const auto bad =
      std::ranges::find_if(text, [](unsigned char c) { return c >= 0x7F || c < 0x20 || c == '"'; });
  if (bad != text.end()) {
    fault = {"a letter that no formula has", static_cast<std::size_t>(bad - text.begin())};
    return {};
  }
  if (const std::size_t at = find_assignment(text); at != std::string::npos) {
    fault = {"a single '='; expected '==' to compare", at};
    return {};
  }
  auto formula = std::make_shared<Formula>();
  formula->text = text;
  formula->inputs = inputs;
  formula->start_s = start_s;
  formula->is_used.assign(inputs.size(), false);
  formula->clip = {words.runtime_s.value_or(0), words.fps.value_or(0)};
  auto reader = std::make_unique<Reader>(text, inputs, formula->clip);
  std::set<std::string> used;
  try {
    int count = 0;
    reader->parser.Eval(count);
    if (count != 1) {
      fault = {fmt::format("it comes to {} numbers; expected one", count), 0};
      return {};
    }
    for (const auto& [name, variable] : reader->parser.GetUsedVar()) used.insert(name);
  } catch (const mu::Parser::exception_type& error) {
    const int at = find_fault(text, error);
    const std::size_t token = error.GetToken().size();
    // muParser points behind some of its words.
    std::size_t byte = at < 0 ? 0 : std::min<std::size_t>(static_cast<std::size_t>(at), text.size());
    if (token > 0 && text.compare(byte, token, error.GetToken()) != 0 && byte >= token &&
        text.compare(byte - token, token, error.GetToken()) == 0)
      byte -= token;
    fault = {describe_fault(error, inputs, words.has_time), byte};
    return {};
  }
  find_uses(used, *formula);
  if (formula->uses[1] && words.use != nullptr) words.use->is_asked = true;
  for (const std::size_t w : {1u, 2u})
    if (used.contains(std::string(kWords[w])) && !(w == 1 ? words.runtime_s : words.fps)) {
      fault = {fmt::format("'{}' {}", kWords[w], words.missing), find_word(text, kWords[w])};
      return {};
    }
  formula->idle.give(std::move(reader));
  return formula;
}

double evaluate(const Formula& formula, double time_s) {
  auto reader = take_reader(formula);
  const std::span<double> values = std::span(reader->values).subspan(kWords.size());
  // Each input once, in order: one may use another many times over.
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Input& input = formula.inputs[i];
    if (!formula.is_used[i])
      values[i] = 0;
    else
      values[i] = input.formula  ? evaluate_input(*input.formula, time_s, values)
                  : input.series ? sample_series(*input.series, time_s)
                                 : input.value;
  }
  return evaluate_with(formula, time_s, std::move(reader)) + formula.more;
}

FormulaPointer shift_formula(const Formula& formula, double more) {
  auto shifted = std::make_shared<Formula>();
  shifted->text = formula.text;
  shifted->inputs = formula.inputs;
  shifted->is_used = formula.is_used;
  shifted->uses = formula.uses;
  shifted->changing = formula.changing;
  shifted->clip = formula.clip;
  shifted->start_s = formula.start_s;
  shifted->more = formula.more + more;
  return shifted;
}

std::size_t count_bytes_used(const Formula& formula) {
  std::size_t bytes = formula.text.size();
  for (std::size_t i = 0; i < formula.inputs.size(); ++i)
    if (formula.is_used[i] && formula.inputs[i].formula) bytes += formula.inputs[i].formula->text.size();
  return bytes;
}

bool uses_word(const Formula& formula, std::string_view word) {
  return formula.uses[static_cast<std::size_t>(std::ranges::find(kWords, word) - kWords.begin())];
}

std::string find_changing_word(const Formula& formula) { return formula.changing; }

std::string find_unknown_input(const Formula& formula) {
  for (std::size_t i = 0; i < formula.inputs.size(); ++i) {
    const Input& input = formula.inputs[i];
    if (formula.is_used[i] && !input.formula && !input.series && std::isnan(input.value)) return input.name;
  }
  return "";
}

double compute_start_s(const Formula& formula) { return formula.start_s; }

double evaluate_held(const Formula& formula, double time_s) {
  const double value = evaluate(formula, time_s);
  return std::isfinite(value) ? value : 0;
}

const double* find_undefined(const Formula& formula, const std::vector<double>& times_s) {
  for (const double& time_s : times_s)
    if (!std::isfinite(evaluate(formula, time_s))) return &time_s;
  return nullptr;
}

}  // namespace mien
