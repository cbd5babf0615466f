// Expressions written as action units of FACS: "AU6C+AU12D", "L12C", "1+2+5B+26".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "config/areas.hpp"
#include "config/scan.hpp"

namespace mien {

struct ExpressionBook;
struct MappingData;

// Units with '+' between them. A unit is AU and its number, of which a side L or R and 'AU' may be left out,
// and its intensity from A (a trace) to E (the most), a fifth each; without it E. One of them at least has an
// AU, a side, an intensity or another unit beside it: a number alone is none.
bool is_facs_notation(std::string_view word);
// The same as an ECMAScript expression, for the schema.
std::string build_facs_pattern();

// The pose of a notation; empty, with `fault` said, if it names a unit that is not known or one twice. What
// is known of an emotion (`known` of configs/mappings/facs.yaml) poses that one's expression, as strongly as
// the weakest of its units is there; the rest of the units adds to it. A unit of one side moves that side,
// and what has no sides by half. The pose lies within the limits.
std::optional<Pose> find_notation_pose(const MappingData& data, std::string_view word, std::string& fault);

// Adds what the words of the document note to the book, each as an expression of library "facs".
void append_notations(const YamlDocument& document, ExpressionBook& book);

}  // namespace mien
