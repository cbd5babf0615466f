// OpenSCAD 2021.01 exports whatever a polyhedron holds, without a check, and leaves out of a union what it
// cannot use: neither its exit status nor its silence says that a print is right.
#include "scene/openscad_check.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

std::string number(double value, int decimals = 3) { return format_number(value, decimals); }

}  // namespace

std::vector<std::string> list_openscad_command(const std::filesystem::path& source,
                                               const std::filesystem::path& stl) {
  return {"openscad", "--hardwarnings", "--export-format", "binstl", "-o", stl.string(), source.string()};
}

std::string find_openscad_complaint(const std::string& output) {
  constexpr std::array<std::string_view, 6> kComplaints{"ERROR",  "WARNING",    "DEPRECATED",
                                                        "TRACE:", "Can't open", "Current top level"};
  std::size_t begin = 0;
  while (begin < output.size()) {
    const std::size_t end = std::min(output.find('\n', begin), output.size());
    const std::string line = output.substr(begin, end - begin);
    for (const std::string_view complaint : kComplaints)
      if (line.find(complaint) != std::string::npos) return line;
    begin = end + 1;
  }
  return {};
}

void verify_print(const StlFacts& meant, const StlFacts& facts, const std::string& name) {
  constexpr float kRound_mm = 0.02f;  // above the file's rounding, far below a layer
  constexpr double kSlack = 0.01;     // of the volume
  if (facts.triangles == 0 || facts.open_edges != 0 || facts.parts != 1)
    throw RunError(fmt::format("{} is not one closed part: {} triangles, {} parts, {} open edges", name,
                               facts.triangles, facts.parts, facts.open_edges));
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(facts.box.low[axis] - meant.box.low[axis]) > kRound_mm ||
        std::abs(facts.box.high[axis] - meant.box.high[axis]) > kRound_mm)
      throw RunError(fmt::format("{} reaches from {} to {} mm along {}; {} to {} mm were meant", name,
                                 number(facts.box.low[axis]), number(facts.box.high[axis]), "xyz"[axis],
                                 number(meant.box.low[axis]), number(meant.box.high[axis])));
  if (std::abs(facts.volume_mm3 - meant.volume_mm3) > kSlack * std::abs(meant.volume_mm3))
    throw RunError(fmt::format("{} holds {} mm3; {} were meant", name, number(facts.volume_mm3, 1),
                               number(meant.volume_mm3, 1)));
}

}  // namespace mien
