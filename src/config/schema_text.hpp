// Texts that the schema and the manual write from the table: patterns of texts with units, and ranges in
// words.
#pragma once

#include <string>
#include <string_view>

#include "config/data_words.hpp"
#include "config/language.hpp"
#include "config/quantity.hpp"

namespace mien {

// The units of a form of time, length or angle; 24 frames a second, which no text shows.
Measure find_measure(FormKind kind);

// ECMAScript expressions for whole texts.
std::string build_quantity_pattern(const std::vector<Unit>& units, bool has_sign);
std::string
build_constant_pattern();  // any formula, but for a number with a unit that the place does not know
std::string build_two_constants_pattern();  // two of them with an x between blanks
std::string build_two_lengths_pattern();
std::string build_size_pattern(int low_px, int high_px);

// "From 20mm to 400mm."; empty for a form without a range, or one whose range says itself.
std::string describe_ranges(const Forms& forms);
// "from 20mm to 400mm", "0s or more"; empty for none.
std::string describe_range(const Form& form);

// The meaning of a word of the data's list; empty if there is none.
std::string find_meaning(const DataWords& data, const std::string& list, std::string_view name);

}  // namespace mien
