// Numbers that are a law of time: "0.3 * sin(2*pi*t/1.5)". The arithmetic is muParser's
// (https://beltoforion.de/ en/muparser): it has no loops, no files and no memory of its own, so that a
// formula always ends.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace mien {

struct Formula;
struct Series;  // series.hpp
using FormulaPointer = std::shared_ptr<const Formula>;

// A name that formulas may use.
struct Input {
  std::string name;
  double value = 0;
  FormulaPointer formula = {};                // instead of the value
  std::shared_ptr<const Series> series = {};  // the same
};
using Inputs = std::vector<Input>;  // each may use those before it

// What is wrong with a formula, and at which byte of its text (from 0).
struct FormulaFault {
  std::string message;
  std::size_t byte = 0;
};

// Empty, and `fault` filled, if the text is no formula of `t` (seconds since `start_s`), `pi` and the inputs.
FormulaPointer build_formula(const std::string& text, const Inputs& inputs, double start_s,
                             FormulaFault& fault);

// The formula's number at a time; not finite where it has none, as 1/t at 0. Any number of threads may ask.
double evaluate(const Formula& formula, double time_s);

// The same, with 0, at rest, where it has none.
double evaluate_held(const Formula& formula, double time_s);

// The same formula whose number is greater by `more`.
FormulaPointer shift_formula(const Formula& formula, double more);

// How many bytes of formulas are worked out for its number: its own, and those of the inputs that it uses.
std::size_t count_bytes_used(const Formula& formula);

// When its `t` is 0.
double compute_start_s(const Formula& formula);

// The first time of `times_s` at which it has none; empty if it has one at all of them.
const double* find_undefined(const Formula& formula, const std::vector<double>& times_s);

// What a name of an input has to be: a letter or '_', then letters, digits or '_', and no word of formulas.
bool is_input_name(const std::string& name);

}  // namespace mien
