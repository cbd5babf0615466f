// The numbers of a print's formulas as OpenSCAD's templates take them. They stand in core/print_numbers.hpp:
// a template has none of its own that C++ knows too.
#pragma once

#include <map>
#include <string>

#include "core/print.hpp"

namespace mien {

using ScadValues = std::map<std::string, std::string>;  // placeholder to text

ScadValues list_scad_base();                      // of templates/openscad/base.scad
ScadValues list_scad_hollow();                    // of hollow.scad
ScadValues list_scad_carving();                   // of bust.scad
ScadValues list_scad_lens(const BustLens& lens);  // of lens.scad

}  // namespace mien
