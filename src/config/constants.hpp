// Formulas of what does not change with time, wherever a number or a quantity stands: a text in quotes such
// as "runtime/2" or "beat*3", in the place's own unit.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "config/formula.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

// What these formulas may use where a value stands (YamlValue::constants).
struct Constants {
  Inputs inputs;  // all that are there: those that change with time are told where they are used
  FormulaWords words;
};

// The formula that stands there, or a part of the text, as build_formula has it; whether it asks for
// `runtime` is noted with its place. `may_decide`: whether the clip's length may follow from it.
FormulaPointer build_noted_formula(const YamlValue& value, const std::string& text, const Inputs& inputs,
                                   double start_s, FormulaFault& fault, const FormulaWords& words,
                                   bool may_decide);

// Whether a formula stands there: a text in quotes, of a file of the language. With a measure, one that is no
// plain quantity: "20deg" is none.
bool is_constant(const YamlValue& value);
bool is_constant(const YamlValue& value, const Measure& measure);

// Whether one of the words that may stand in place of a number does: a text that is no number and no formula,
// or that is one of the form's words.
bool is_word(const YamlValue& value);

// The formula's number. Empty, with a mistake told at its letter, if it cannot be read, changes with time or
// is not finite.
std::optional<double> load_constant(const YamlValue& value, bool may_decide);

// The numbers of "480*k x 600*k", two formulas with an x between blanks.
bool is_two_constants(const YamlValue& value);
std::optional<std::pair<double, double>> load_two_constants(const YamlValue& value);

// What the formulas of a file may use, by the entries of its `clip`: its inputs, those of `outer` before
// them, its `fps` and its `length`; without one `runtime` is `outer`'s. Mistakes in these are told by who
// loads them.
ConstantsPointer build_constants(const YamlMapping& clip, const Constants& outer);

// The same for a whole file. Its length is `runtime_s` if it says none; `use` is told if formulas ask for
// that and it is empty.
ConstantsPointer build_file_constants(const YamlValue& root, std::optional<double> runtime_s,
                                      RuntimeUse* use = nullptr);

// The same for one who has inputs of his own, in `clip`, on top of `outer`'s.
ConstantsPointer build_own_constants(const YamlMapping& clip, const Constants& outer);

// The same for the value of one of `actors`.
ConstantsPointer build_actor_constants(const YamlValue& actor);

// Whether a formula of the text may ask for `runtime`.
bool mentions_runtime(const YamlDocument& document);

// Lets the values of a mapping use these.
void set_constants(const ConstantsPointer& constants, YamlMapping& entries);

// `fps` or `length`, whose formulas cannot use what follows from them: `runtime`, and of `fps` itself.
YamlValue find_deciding(const YamlValue& value, bool is_fps);

}  // namespace mien
