// OpenSCAD 2021.01 exports whatever a polyhedron holds and leaves an open one out of a union with exit status
// 0; all that it does not check is checked here, before and after. Measured: 0.23 ms a triangle and union.
#include "scene/openscad.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

constexpr int kDecimals = 4;              // 0.1 micrometre; an STL's six digits carry no more from 10 mm on
constexpr std::size_t kItemsPerLine = 6;  // of points or faces
constexpr std::size_t kMaxTitleBytes = 120;  // a comment line that an editor shows whole

// Nothing that could end the comment, open another, or be taken for a placeholder.
std::string clean_title(const std::string& title) {
  std::string clean = title.substr(0, kMaxTitleBytes);
  if (clean.size() < title.size())  // no half letter at the end
    while (!clean.empty() && (title[clean.size()] & 0xC0) == 0x80) clean.pop_back();
  const auto is_unsafe = [](unsigned char c) {
    return c < ' ' || c == 127 || c == '*' || c == '/' || c == '\\' || c == '{' || c == '}';
  };
  std::replace_if(clean.begin(), clean.end(), is_unsafe, ' ');
  return clean;
}

void require_identifier(const std::string& name) {
  const auto is_letter = [](char c) { return c == '_' || (c >= 'a' && c <= 'z'); };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (name.empty() || !is_letter(name.front()) ||
      !std::all_of(name.begin(), name.end(), [&](char c) { return is_letter(c) || is_digit(c); }))
    throw RunError(fmt::format("solid name '{}' is not a lower-case identifier", name));
}

// The mesh as the written decimals make it: equal points joined, triangles without area by that left out.
Mesh weld_as_written(const Mesh& mesh) {
  const double grid = std::pow(10.0, kDecimals);
  Mesh welded;
  std::map<std::array<std::int64_t, 3>, std::uint32_t> index;
  std::vector<std::uint32_t> new_index(mesh.positions.size());
  const auto find_index = [&](std::uint32_t v) {
    const glm::dvec3 at = glm::dvec3(mesh.positions[v]) * grid;
    const std::array<std::int64_t, 3> key{std::llround(at.x), std::llround(at.y), std::llround(at.z)};
    const auto [place, is_new] = index.try_emplace(key, static_cast<std::uint32_t>(welded.positions.size()));
    if (is_new) welded.positions.push_back(mesh.positions[v]);
    return place->second;
  };
  for (const Triangle& t : mesh.triangles) {
    const Triangle joined{find_index(t[0]), find_index(t[1]), find_index(t[2])};
    if (joined[0] != joined[1] && joined[1] != joined[2] && joined[2] != joined[0])
      welded.triangles.push_back(joined);
  }
  return welded;
}

void require_solid(const Solid& solid, const Mesh& welded) {
  if (welded.triangles.empty()) throw RunError(fmt::format("solid '{}' is empty", solid.name));
  if (const std::size_t open = count_open_edges(welded.triangles))
    throw RunError(fmt::format("solid '{}' has {} open edges; OpenSCAD would drop it", solid.name, open));
  if (compute_volume_mm3(welded) <= 0) throw RunError(fmt::format("solid '{}' is inside out", solid.name));
}

void append_points(std::string& text, const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    text += i % kItemsPerLine == 0 ? "\n    [" : " [";
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) text += ',';
      append_number(text, mesh.positions[i][axis], kDecimals);
    }
    text += "],";
  }
}

// Clockwise seen from outside, as OpenSCAD wants them: the second and third corner change places.
void append_faces(std::string& text, const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    text += fmt::format("{}[{},{},{}],", i % (2 * kItemsPerLine) == 0 ? "\n    " : " ", a, c, b);
  }
}

std::string build_module(const Solid& solid) {
  require_identifier(solid.name);
  const Mesh welded = weld_as_written(solid.mesh);
  require_solid(solid, welded);
  std::string text = fmt::format("module {}() polyhedron(convexity = 12,\n  points = [", solid.name);
  append_points(text, welded);
  text += "\n  ],\n  faces = [";
  append_faces(text, welded);
  text += "\n  ]);\n";
  return text;
}

double find_figure_height_mm(const BustPrint& bust) {
  return bust.height_mm - bust.base_height_mm + kFootSink_mm;
}

}  // namespace

std::string build_openscad_bust(const BustPrint& bust, const std::filesystem::path& templates_folder) {
  const std::filesystem::path origin = templates_folder / "openscad/bust.scad";
  std::string modules, calls;
  for (const Solid& solid : bust.solids) {
    if (!modules.empty()) modules += '\n';
    modules += build_module(solid);
    calls += fmt::format("  place() {}();\n", solid.name);
  }
  const auto number = [](double value) { return format_number(value, kDecimals); };
  return fill_template(read_file(origin),
                       {{"title", clean_title(bust.title)},
                        {"height_mm", number(bust.height_mm)},
                        {"base_height_mm", number(bust.base_height_mm)},
                        {"base_radius_mm", number(bust.base_radius_mm)},
                        {"figure_height_mm", number(find_figure_height_mm(bust))},
                        {"foot_mm", number(bust.foot_mm)},
                        {"foot_radius_mm", number(bust.foot_radius_mm)},
                        {"foot_sink_mm", number(kFootSink_mm)},
                        {"calls", calls},
                        {"modules", modules}},
                       origin.string());
}

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

void verify_print(const BustPrint& bust, const StlFacts& facts, const std::string& name) {
  constexpr double kRound_mm = 0.01;  // far above the file's rounding, far below a layer
  if (facts.triangles == 0 || facts.open_edges != 0 || facts.parts != 1)
    throw RunError(fmt::format("{} is not one closed part: {} triangles, {} parts, {} open edges", name,
                               facts.triangles, facts.parts, facts.open_edges));
  const double low = facts.box.low.z, high = facts.box.high.z;
  if (std::abs(low) > kRound_mm || std::abs(high - bust.height_mm) > kRound_mm)
    throw RunError(fmt::format("{} reaches from {} to {} mm; 0 to {} mm were asked for", name,
                               format_number(low, 3), format_number(high, 3),
                               format_number(bust.height_mm, 3)));
  double skin = bust.solids.empty() ? 0 : compute_volume_mm3(bust.solids.front().mesh);
  double all = std::numbers::pi * bust.base_radius_mm * bust.base_radius_mm * bust.base_height_mm;
  for (const Solid& solid : bust.solids) all += compute_volume_mm3(solid.mesh);
  constexpr double kSlack = 0.001;  // of the volume: rounding
  if (facts.volume_mm3 < skin * (1 - kSlack) || facts.volume_mm3 > all * (1 + kSlack))
    throw RunError(fmt::format("{} holds {} mm3; between {} and {} were expected: a solid was lost or turned",
                               name, format_number(facts.volume_mm3, 1), format_number(skin, 1),
                               format_number(all, 1)));
}

}  // namespace mien
