// OpenSCAD sources: self-contained busts made of closed polyhedra. Faces are turned clockwise-from-outside
// here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/model.hpp"

namespace mien {

// A closed solid of the bust, by name; the source unions them all.
struct Solid {
  std::string name;  // a lower-case identifier
  Mesh mesh;         // closed, wound outwards, mm
};

struct BustPrint {
  std::string title;          // written as a comment only, after it was cleaned of line ends
  double height_mm = 80;      // whole print with its base
  std::vector<Solid> solids;  // skin first
};

// A customizable source: height, base and wall as Customizer variables, then the solids as literal polyhedra
// (templates/openscad/bust.scad). Throws RunError if a solid is open, since OpenSCAD would not tell.
std::string build_openscad_bust(const BustPrint& bust, const std::filesystem::path& templates_folder);

}  // namespace mien
