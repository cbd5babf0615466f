// Numbers that are a law of time: "0.3 * sin(2*pi*t/1.5)". The arithmetic is muParser's
// (https://beltoforion.de/ en/muparser): it has no loops, no files and no memory of its own, so that a
// formula always ends.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace mien {

struct Formula;
struct Series;  // series.hpp
using FormulaPointer = std::shared_ptr<const Formula>;

// A name that formulas may use.
struct Input {
  std::string name;  // empty: only those that were read before may use it
  double value = 0;
  FormulaPointer formula = {};                // instead of the value
  std::shared_ptr<const Series> series = {};  // the same
};
using Inputs = std::vector<Input>;  // each may use those before it

// Whether a formula asked for `runtime` while the clip's length was not known yet, and which one did that may
// decide it.
struct RuntimeUse {
  bool is_asked = false;
  Place place = {};  // of the first that is no law of time; nothing: none
  std::string subject = {}, line = {};
  bool may_decide = false;  // it is a time or a count
};

// What the words of formulas stand for besides the inputs.
struct FormulaWords {
  std::optional<double> runtime_s = {}, fps = {};  // the clip's length and frames a second; empty: not known
  std::string_view missing = "is not known here";  // said of one that is not
  bool has_time = true;                            // whether `t` may be meant
  RuntimeUse* use = nullptr;                       // told of whoever asks for `runtime`
};

// What is wrong with a formula, and at which byte of its text (from 0).
struct FormulaFault {
  std::string message;
  std::size_t byte = 0;
};

// Empty, and `fault` filled, if the text is no formula of `t` (seconds since `start_s`), `runtime` (s),
// `fps`, `pi` and the inputs, or uses one of these that is not known.
FormulaPointer build_formula(const std::string& text, const Inputs& inputs, double start_s,
                             FormulaFault& fault, const FormulaWords& words = {});

// The formula's number at a time; not finite where it has none, as 1/t at 0. Any number of threads may ask.
double evaluate(const Formula& formula, double time_s);

// The same, with 0, at rest, where it has none.
double evaluate_held(const Formula& formula, double time_s);

// The same formula whose number is greater by `more`.
FormulaPointer shift_formula(const Formula& formula, double more);

// How many bytes of formulas are worked out for its number: its own, and those of the inputs that it uses.
std::size_t count_bytes_used(const Formula& formula);

// Whether its number depends on a word, "t", "runtime" or "fps", by itself or through the inputs that it
// uses.
bool uses_word(const Formula& formula, std::string_view word);

// The word of its text that changes with time, `t` or an input; empty if none does.
std::string find_changing_word(const Formula& formula);

// An input that it uses and that has no number; empty if all have one.
std::string find_unknown_input(const Formula& formula);

// Where a word stands in a text, as a whole; 0 if it does not.
std::size_t find_word(std::string_view text, std::string_view word);

// When its `t` is 0.
double compute_start_s(const Formula& formula);

// The first time of `times_s` at which it has none; empty if it has one at all of them.
const double* find_undefined(const Formula& formula, const std::vector<double>& times_s);

// What a name of an input has to be: a letter or '_', then letters, digits or '_', and no word of formulas.
bool is_input_name(const std::string& name);

}  // namespace mien
