// OpenSCAD 2021.01 exports whatever a polyhedron holds, without a check: all that it does not check is
// checked here, before and after.
#include "scene/openscad.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

constexpr int kDecimals = 3;                 // a micrometre; offsets too
constexpr int kFine = 5;                     // of angles and shares
constexpr std::size_t kMaxTitleBytes = 120;  // a comment line that an editor shows whole
constexpr std::size_t kRowsPerLine = 8;

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

bool is_plain_word(const std::string& name) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '/';
  };
  return !name.empty() && name.size() <= 40 && std::all_of(name.begin(), name.end(), is_plain);
}

// What an expression is called in the file: its own name if that is a plain word.
std::string find_menu_name(const std::string& name) { return is_plain_word(name) ? name : "own"; }

std::string number(double value, int decimals = kDecimals) { return format_number(value, decimals); }

// A list of `count` things in lines of some, "a, b,\n  c".
template <typename Append>
std::string list_rows(std::size_t count, std::size_t per_line, const Append& append) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += ',';
    text += i % per_line == 0 ? "\n  " : " ";
    append(text, i);
  }
  return text;
}

void append_vector(std::string& text, const glm::vec3& p) {
  text += '[';
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) text += ',';
    append_number(text, p[axis], kDecimals);
  }
  text += ']';
}

std::string pair(const glm::vec2& p) { return fmt::format("[{}, {}]", number(p.x), number(p.y)); }

std::string list_numbers(const std::vector<double>& values, int decimals) {
  std::string text = "[";
  for (const double value : values) text += (text.size() > 1 ? "," : "") + number(value, decimals);
  return text + "]";
}

std::string list_indices(const std::vector<std::uint32_t>& indices) {
  return list_rows(indices.size(), 20,
                   [&](std::string& text, std::size_t i) { text += fmt::format("{}", indices[i]); });
}

// --- vertices ---

// For each vertex the states that move it, rising, and what they add.
struct Moved {
  std::vector<std::size_t> states;
  std::vector<glm::vec3> offsets;
};

std::vector<Moved> list_moved(const PosableBust& bust) {
  std::vector<Moved> moved(bust.rest.size());
  const float least = 0.5f * std::pow(10.0f, -float(kDecimals));
  for (std::size_t s = 0; s < bust.states.size(); ++s) {
    const BustState& state = bust.states[s];
    for (std::size_t i = 0; i < state.vertices.size(); ++i) {
      const glm::vec3 offset = glm::abs(state.offsets[i]);
      if (std::max({offset.x, offset.y, offset.z}) < least) continue;
      moved[state.vertices[i]].states.push_back(s);
      moved[state.vertices[i]].offsets.push_back(state.offsets[i]);
    }
  }
  return moved;
}

std::string list_vertices(const PosableBust& bust, const std::vector<Moved>& moved, std::size_t first,
                          std::size_t end) {
  return list_rows(end - first, kRowsPerLine, [&](std::string& text, std::size_t row) {
    const std::size_t v = first + row;
    text += '[';
    append_vector(text, bust.rest[v]);
    if (!moved[v].states.empty()) {
      text += ",[";
      for (std::size_t i = 0; i < moved[v].states.size(); ++i)
        text += fmt::format("{}{}", i > 0 ? "," : "", moved[v].states[i]);
      text += "],[";
      for (std::size_t i = 0; i < moved[v].states.size(); ++i) {
        if (i > 0) text += ',';
        append_vector(text, moved[v].offsets[i]);
      }
      text += ']';
    }
    text += ']';
  });
}

// Clockwise seen from outside, as OpenSCAD wants them: the second and third corner change places.
std::string list_triangles(const std::vector<Triangle>& triangles) {
  return list_rows(triangles.size(), 12, [&](std::string& text, std::size_t i) {
    const auto& [a, b, c] = triangles[i];
    text += fmt::format("[{},{},{}]", a, c, b);
  });
}

// --- moves and expressions ---

std::string find_variable(const BustMove& move) {
  std::string name = move.area + "_" + move.move;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

std::string list_sliders(const PosableBust& bust) {
  std::string text;
  for (const BustMove& move : bust.moves) {
    std::string area = move.area;
    std::replace(area.begin(), area.end(), '.', ' ');
    text += fmt::format("// {}: {}\n{} = 0; // [{}:0.05:{}]\n", area, move.meaning, find_variable(move),
                        number(move.low - (move.low == 0 ? 1 : 0)), number(move.high));
  }
  return text;
}

std::string list_slider_names(const PosableBust& bust) {
  return list_rows(bust.moves.size(), 6,
                   [&](std::string& text, std::size_t i) { text += find_variable(bust.moves[i]); });
}

std::string list_moves(const PosableBust& bust) {
  return list_rows(bust.moves.size(), 1, [&](std::string& text, std::size_t i) {
    const BustMove& move = bust.moves[i];
    text += fmt::format("[{}, {}, {}, {}, {}]", number(move.low), number(move.high),
                        number(move.reach_low, kFine), number(move.reach_high, kFine),
                        list_numbers(move.values, kFine));
  });
}

std::string list_expressions(const PosableBust& bust) {
  return list_rows(bust.expressions.size(), 1, [&](std::string& text, std::size_t i) {
    const BustExpression& e = bust.expressions[i];
    const auto gaze = [](const glm::vec2& g) {
      return fmt::format("[{}, {}]", number(g.x, kFine), number(g.y, kFine));
    };
    text +=
        fmt::format("[\"{}\", {}, {}, {}, [{}, {}]]", find_menu_name(e.name), list_numbers(e.values, kFine),
                    e.state, number(e.open, kFine), gaze(e.gaze_rad[0]), gaze(e.gaze_rad[1]));
  });
}

std::string list_expression_names(const PosableBust& bust) {
  std::string text;
  for (const BustExpression& e : bust.expressions)
    text += (text.empty() ? "" : ", ") + find_menu_name(e.name);
  return text;
}

std::size_t find_move_index(const PosableBust& bust, std::string_view area, std::string_view move) {
  for (std::size_t i = 0; i < bust.moves.size(); ++i)
    if (bust.moves[i].area == area && bust.moves[i].move == move) return i;
  throw RunError(fmt::format("internal: the bust has no move '{} {}'", area, move));
}

// --- eyes and mouth ---

std::string list_eyes(const PosableBust& bust) {
  return list_rows(2, 1, [&](std::string& text, std::size_t i) {
    const BustEye& eye = bust.eyes[i];
    text += fmt::format("[[{}],\n   [{}],\n   ", list_indices(eye.grid.upper), list_indices(eye.grid.lower));
    append_vector(text, eye.centre);
    for (const double value :
         {eye.radius_mm, eye.iris_mm, eye.iris_depth_mm, eye.pupil_depth_mm, eye.slit_mm, eye.line_mm})
      text += ", " + number(value, kFine);
    text += ']';
  });
}

std::string list_teeth_row(const std::vector<glm::vec2>& edge, const std::vector<glm::vec2>& front) {
  constexpr float kTooth = -100;  // nearer to the front than this there is one
  return list_rows(edge.size(), 6, [&](std::string& text, std::size_t i) {
    text += edge[i].y < kTooth ? "[]" : fmt::format("[{}, {}]", pair(edge[i]), pair(front[i]));
  });
}

std::string describe_tongue(const BustMouth& mouth) {
  const glm::vec3& r = mouth.tongue_radius;
  return fmt::format("[[{}, {}], [{}, {}, {}]]", number(mouth.tongue.z), number(-mouth.tongue.y), number(r.x),
                     number(r.z), number(r.y));
}

std::string read_functions(const std::filesystem::path& path) {
  std::string text = read_file(path);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

// --- hollow and holes ---

std::string build_hollow_settings(const PosableBust& bust) {
  if (bust.cavity.triangles.empty()) return "";
  return fmt::format(
      "// Hollow, with an inner wall and holes to drain it\nhollow = {};\n"
      "// Thickness of the wall in mm\nwall_mm = {}; // [0.8:0.1:10]\n"
      "// Diameter of the holes in mm; 0: none\ndrain_mm = {}; // [0:0.5:12]\n",
      bust.is_hollow ? "true" : "false", number(bust.wall_mm), number(bust.drain_mm));
}

std::string build_cavity(const PosableBust& bust) {
  if (bust.cavity.triangles.empty()) return "";
  Mesh cavity = bust.cavity;
  update_normals(cavity);
  const auto points = list_rows(cavity.positions.size(), kRowsPerLine, [&](std::string& text, std::size_t i) {
    text += '[';
    append_vector(text, cavity.positions[i]);
    text += ',';
    append_vector(text, cavity.normals[i]);
    text += ']';
  });
  const auto drains = list_rows(bust.drains.size(), 4, [&](std::string& text, std::size_t i) {
    text += fmt::format("[{}, {}, {}]", number(bust.drains[i].x), number(bust.drains[i].y),
                        number(bust.drain_tops_mm[i]));
  });
  return fmt::format(
      "// The cavity: places and the way outward; drains: where and how high they reach.\n"
      "cavity_rows = [{}];\ncavity_triangles = [{}];\ndrains = [{}];\nown_wall_mm = {};\n",
      points, list_triangles(cavity.triangles), drains, number(bust.wall_mm));
}

constexpr std::string_view kHollowModules =
    R"(// The cavity grows with the bust; a wall that is asked for otherwise moves it along its own normals.
cavity_growth = height_mm / own_height_mm;
module cavity() polyhedron(convexity = 12,
  points = [for (r = cavity_rows) r[0] * cavity_growth + r[1] * (own_wall_mm * cavity_growth - wall_mm)],
  faces = cavity_triangles);
module drain_holes() for (d = drains) translate([d[0] * cavity_growth, d[1] * cavity_growth, -1])
  cylinder(h = d[2] * cavity_growth + 1, d = drain_mm, $fn = hole_sides);

)";

constexpr std::string_view kMagnetModule = R"(module magnet_pocket() translate([0, 0, -1])
  cylinder(h = magnet_depth_mm + 1, d = magnet_diameter_mm, $fn = hole_sides);

)";

std::string build_assembly(const PosableBust& bust) {
  const bool can_hollow = !bust.cavity.triangles.empty();
  std::string text = "module whole() {\n  body();\n";
  if (!bust.label.empty()) text += "  if (base != \"none\" && label != \"\") base_label();\n";
  text += "}\n\n";
  const std::string condition = can_hollow ? "hollow || magnet_diameter_mm > 0" : "magnet_diameter_mm > 0";
  text += fmt::format("if ({}) difference() {{\n  whole();\n", condition);
  if (can_hollow) text += "  if (hollow) cavity();\n  if (hollow && drain_mm > 0) drain_holes();\n";
  text += "  if (magnet_diameter_mm > 0) magnet_pocket();\n} else whole();\n\n";
  return text;
}

void require_closed(const PosableBust& bust) {
  std::vector<Triangle> closed = bust.triangles;
  const auto apex = static_cast<std::uint32_t>(bust.rest.size());
  for (std::size_t i = 0; i < bust.foot.size(); ++i)
    closed.push_back({bust.foot[i], bust.foot[(i + 1) % bust.foot.size()], apex});
  if (const std::size_t open = count_open_edges(closed))
    throw RunError(fmt::format("the bust is not closed: {} open edges", open));
}

}  // namespace

std::string build_openscad_bust(const PosableBust& bust, const std::filesystem::path& templates_folder) {
  require_closed(bust);
  const std::filesystem::path folder = templates_folder / "openscad", origin = folder / "bust.scad";
  const std::vector<Moved> moved = list_moved(bust);
  const BustGrid& mouth = bust.mouth.grid;
  const std::size_t chest =
      mouth.first + (2 * mouth.upper.size() - 3) * static_cast<std::size_t>(mouth.rows - 1);
  return fill_template(
      read_file(origin),
      {{"title", clean_title(bust.title)},
       {"height_mm", number(bust.height_mm)},
       {"figure_mm", number(bust.figure_mm)},
       {"base_shape", bust.base_shape},
       {"base_height_mm", number(bust.base_height_mm)},
       {"base_radius_mm", number(bust.base_radius_mm)},
       {"label_settings", ""},
       {"magnet_diameter_mm", number(bust.magnet_diameter_mm)},
       {"magnet_depth_mm", number(bust.magnet_depth_mm)},
       {"hollow_settings", build_hollow_settings(bust)},
       {"expression", find_menu_name(bust.expression)},
       {"expression_names", list_expression_names(bust)},
       {"sliders", list_sliders(bust)},
       {"slider_names", list_slider_names(bust)},
       {"own_is_flat", bust.base_shape == "none" ? "true" : "false"},
       {"other_foot_mm", number(bust.other_foot_mm)},
       {"mm_per_head_mm", number(bust.mm_per_head_mm, 6)},
       {"base_functions", read_functions(folder / "base.scad")},
       {"modules",
        std::string(kMagnetModule) + (bust.cavity.triangles.empty() ? "" : std::string(kHollowModules))},
       {"assembly", build_assembly(bust)},
       {"moves", list_moves(bust)},
       {"expressions", list_expressions(bust)},
       {"chin_down", fmt::format("{}", find_move_index(bust, "chin", "down"))},
       {"left_eye_up", fmt::format("{}", find_move_index(bust, "eye.left", "up"))},
       {"right_eye_up", fmt::format("{}", find_move_index(bust, "eye.right", "up"))},
       {"gaze_side_rad", number(bust.gaze_side_rad, kFine)},
       {"gaze_up_rad", number(bust.gaze_up_rad, kFine)},
       {"gaze_down_rad", number(bust.gaze_down_rad, kFine)},
       {"grid_rows", fmt::format("{}", mouth.rows)},
       {"eyes", list_eyes(bust)},
       {"mouth", fmt::format("[{}],\n  [{}]", list_indices(mouth.upper), list_indices(mouth.lower))},
       {"mouth_line", number(bust.mouth.line_mm, kFine)},
       {"jaw_axis", pair(bust.mouth.jaw_axis)},
       {"jaw_open_rad", number(bust.mouth.jaw_open_rad, 6)},
       {"jaw_forward", pair(bust.mouth.jaw_forward)},
       {"teeth_reach", number(bust.mouth.reach_mm)},
       {"teeth", fmt::format("[{}],\n  [{}]", list_teeth_row(bust.mouth.upper_edge, bust.mouth.upper_front),
                             list_teeth_row(bust.mouth.lower_edge, bust.mouth.lower_front))},
       {"tongue", describe_tongue(bust.mouth)},
       {"foot", list_indices(bust.foot)},
       {"skin_rows", list_vertices(bust, moved, 0, bust.eyes[0].grid.first)},
       {"chest_rows", list_vertices(bust, moved, chest, bust.rest.size())},
       {"triangles", list_triangles(bust.triangles)},
       {"cavity", build_cavity(bust)}},
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
