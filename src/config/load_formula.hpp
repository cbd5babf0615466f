// Formulas in a file: a text in quotes where a number could stand.
#pragma once

#include <deque>
#include <utility>

#include "config/formula.hpp"
#include "config/quantity.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

inline constexpr std::size_t kMaxInputs = 64;  // each is worked out for each number that uses it

// Where the formulas of a clip or of a script are read.
struct FormulaReader {
  Inputs inputs;
  double start_s = 0;  // when `t` is 0
  int fps = 0;         // of the frames that mistakes name; 0: a script's, whose times are no frames
  FormulaWords words = {};
  std::deque<std::pair<FormulaPointer, YamlValue>>* found =
      nullptr;                   // all that were read, and where they stand
  std::size_t* count = nullptr;  // of the whole file; none: nobody counts
};

// A text in quotes: "0.3*sin(t)". With a measure, one that is no plain quantity: "20deg" is no formula.
bool is_formula(const YamlValue& value);
bool is_formula(const YamlValue& value, const Measure& measure);

// Empty, with a mistake told at its letter, if it cannot be read.
FormulaPointer load_formula(const YamlValue& value, const FormulaReader& reader);

// Tells what is wrong at a byte of the formula that stands there.
void add_formula_fault(const YamlValue& value, const std::string& message, std::size_t byte);

// What formulas that do not change with time may use where these formulas stand (constants.hpp).
ConstantsPointer build_constants(const FormulaReader& reader);

// Tells a mistake at the formula's place if it has no value at one of the times.
void check_formula(const FormulaPointer& formula, const FormulaReader& reader,
                   const std::vector<double>& times_s);

struct ClipClock;

// `inputs:` and `parameters:`, after those that are known. `given` replaces the values of those named in it.
void load_inputs(const YamlValue& value, const Inputs& given, const ClipClock& clock, FormulaReader& reader);

}  // namespace mien
