// Surfaces with control points in an OBJ: cstype, deg, surf, parm and end (Wavefront, "Object Files", B1).
#pragma once

#include <array>
#include <string_view>

#include "import/patches.hpp"

namespace mien {

// One statement, whatever lines it goes on over.
struct ObjStatement {
  std::string file;
  int line = 0;  // where it begins
  std::vector<std::string_view> words;
  std::size_t point_count = 0;  // v lines before it
};

struct ObjSurface {
  int line = 0;
  bool is_rational = false, is_bezier = false;
  std::array<int, 2> degrees{};  // along u and v, as all pairs here
  std::array<double, 2> low{}, high{};
  std::array<std::vector<double>, 2> knots;
  std::vector<std::uint32_t> points;
};

struct ObjSurfaces {
  std::string kind;  // what cstype names last; and what `deg` says
  bool is_rational = false;
  std::array<int, 2> degrees{};
  enum class Open { nothing, curve, surface } open = Open::nothing;
  std::vector<ObjSurface> found;  // while one is open it is the last
  std::size_t point_count = 0;    // of all of them
  std::size_t trimmed = 0;        // surfaces with trimming curves
  std::size_t last_trimmed = 0;   // the number of the last one, from 1
  int trimmed_line = 0;           // of the first, where it says so
  int curve_line = 0;             // of the first curve; 0: none
};

// Takes the statement if it is one of surfaces and curves; false if it is another one. Curves are passed.
// Throws InputError for what cannot be made a surface.
bool read_surface_statement(const ObjStatement& statement, ObjSurfaces& surfaces);

// What was found, once all points are known: each with the weight that its v line has (NAN: it has no
// number there).
std::vector<SplinePatch> build_patches(const std::string& file, const ObjSurfaces& surfaces,
                                       const std::vector<glm::dvec3>& positions,
                                       const std::vector<double>& weights);

}  // namespace mien
