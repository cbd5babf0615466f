// OpenSCAD 2021.01 exports whatever a polyhedron holds, without a check: all that it does not check is
// checked here, before and after.
#include "scene/openscad.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "core/error.hpp"
#include "core/text.hpp"
#include "scene/openscad_lists.hpp"
#include "scene/openscad_numbers.hpp"
#include "scene/title.hpp"

namespace mien {

namespace {

// What could end the comment, open another, or be taken for a placeholder.
constexpr std::string_view kUnsafe = "*/\\{}";
constexpr std::size_t kMaxTitleBytes = 120;  // a comment line that an editor shows whole

// What the expressions are called in the file: plain words, each of them once.
std::vector<std::string> list_menu_names(const PosableBust& bust) {
  constexpr std::size_t kMostLetters = 40;  // the Customizer's menu is no wider
  const auto is_odd = [](char c) {
    return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
             c == '-' || c == '/');
  };
  std::vector<std::string> names;
  for (const BustExpression& e : bust.expressions) {
    std::string plain = e.name.substr(0, kMostLetters);
    std::replace_if(plain.begin(), plain.end(), is_odd, '_');
    if (plain.empty()) plain = "own";
    std::string name = plain;
    for (int number = 2; std::find(names.begin(), names.end(), name) != names.end(); ++number)
      name = fmt::format("{}_{}", plain, number);
    names.push_back(name);
  }
  return names;
}

std::string find_menu_name(const PosableBust& bust) {
  const std::vector<std::string> names = list_menu_names(bust);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (bust.expressions[i].name == bust.expression) return names[i];
  throw RunError(fmt::format("internal: the bust has no expression '{}'", bust.expression));
}

std::string number(double value, int decimals = kScadDecimals) { return format_number(value, decimals); }

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

// --- moves and expressions ---

std::string find_variable(const BustMove& move) {
  std::string name = move.area + "_" + move.move;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

std::string list_sliders(const PosableBust& bust) {
  std::string text;
  for (const BustMove& move : bust.moves) {
    if (!move.has_slider) continue;
    std::string area = move.area;
    std::replace(area.begin(), area.end(), '.', ' ');
    text += fmt::format("// {}: {}\n{} = 0; // [{}:0.05:{}]\n", area, move.meaning, find_variable(move),
                        number(move.low - (move.low == 0 ? 1 : 0)), number(move.high));
  }
  return text;
}

std::string list_slider_names(const PosableBust& bust) {
  return list_rows(bust.moves.size(), 6, [&](std::string& text, std::size_t i) {
    text += bust.moves[i].has_slider ? find_variable(bust.moves[i]) : "0";
  });
}

std::string list_moves(const PosableBust& bust) {
  return list_rows(bust.moves.size(), 1, [&](std::string& text, std::size_t i) {
    const BustMove& move = bust.moves[i];
    text += fmt::format("[{}, {}, {}, {}, {}]", number(move.low), number(move.high),
                        number(move.reach_low, kScadFine), number(move.reach_high, kScadFine),
                        list_numbers(move.values, kScadFine));
  });
}

std::string list_expressions(const PosableBust& bust) {
  const std::vector<std::string> names = list_menu_names(bust);
  return list_rows(bust.expressions.size(), 1, [&](std::string& text, std::size_t i) {
    const BustExpression& e = bust.expressions[i];
    const auto gaze = [](const glm::vec2& g) {
      return fmt::format("[{}, {}]", number(g.x, kScadFine), number(g.y, kScadFine));
    };
    text += fmt::format("[\"{}\", {}, {}, {}, [{}, {}]]", names[i], list_numbers(e.values, kScadFine),
                        e.state, number(e.open, kScadFine), gaze(e.gaze_rad[0]), gaze(e.gaze_rad[1]));
  });
}

std::string list_expression_names(const PosableBust& bust) {
  std::string text;
  for (const std::string& name : list_menu_names(bust)) text += (text.empty() ? "" : ", ") + name;
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
    append_scad_vector(text, eye.centre);
    for (const double value : {eye.radius_mm, eye.iris_mm, eye.iris_depth_mm, eye.pupil_depth_mm, eye.slit_mm,
                               eye.line_mm, eye.light})
      text += ", " + number(value, kScadFine);
    text += ']';
  });
}

std::string list_teeth_row(const std::vector<glm::vec2>& edge, const std::vector<glm::vec2>& front) {
  return list_rows(edge.size(), 6, [&](std::string& text, std::size_t i) {
    text += edge[i].y == kNoTooth_mm ? "[]" : fmt::format("[{}, {}]", pair(edge[i]), pair(front[i]));
  });
}

std::string describe_tongue(const BustMouth& mouth) {
  const glm::vec3& r = mouth.tongue_radius;
  return fmt::format("[[{}, {}], [{}, {}, {}]]", number(mouth.tongue.z), number(-mouth.tongue.y), number(r.x),
                     number(r.z), number(r.y));
}

// Any text as a string of OpenSCAD's: nothing in it can end it.
std::string quote_scad(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += static_cast<unsigned char>(c) < ' ' || c == 127 ? ' ' : c;
  }
  return quoted + "\"";
}

std::string build_label_settings(const PosableBust& bust) {
  return fmt::format(
      "// Text on the base's front\nlabel = {};\n"
      "// Height of its letters in mm; 0: as large as the front allows\nlabel_size_mm = 0; // [0:0.5:30]\n",
      quote_scad(bust.label));
}

// A template that becomes a part of another one.
std::string fill_part(const Templates& templates, std::string_view name, const ScadValues& values) {
  std::string text = fill_template(templates, name, values);
  while (!text.empty() && text.back() == '\n') text.pop_back();
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

std::string build_openscad_bust(const PosableBust& bust, const Templates& templates) {
  require_closed(bust);
  const BustGrid& mouth = bust.mouth.grid;
  const std::size_t chest = mouth.first + mouth.vertex_count();
  ScadValues base = list_scad_base();
  base["letters"] = bust.letters;
  ScadValues values = list_scad_carving();
  const bool is_bent = bust.lens.is_on;
  values.merge(ScadValues{
      {"title", clean_title(bust.title, kUnsafe, kMaxTitleBytes)},
      {"height_mm", number(bust.height_mm)},
      {"figure_mm", number(bust.figure_mm)},
      {"base_shape", bust.base_shape},
      {"base_height_mm", number(bust.base_height_mm)},
      {"base_radius_mm", number(bust.base_radius_mm)},
      {"label_settings", build_label_settings(bust)},
      {"magnet_diameter_mm", number(bust.magnet_diameter_mm)},
      {"magnet_depth_mm", number(bust.magnet_depth_mm)},
      {"is_hollow", bust.is_hollow ? "true" : "false"},
      {"wall_mm", number(bust.wall_mm)},
      {"drain_mm", number(bust.drain_mm)},
      {"expression", find_menu_name(bust)},
      {"expression_names", list_expression_names(bust)},
      {"sliders", list_sliders(bust)},
      {"slider_names", list_slider_names(bust)},
      {"own_is_flat", bust.base_shape == "none" ? "true" : "false"},
      {"other_foot_mm", number(bust.other_foot_mm)},
      {"mm_per_head_mm", number(bust.mm_per_head_mm, 6)},
      {"base_functions", fill_part(templates, "openscad/base.scad", base)},
      {"hollow_functions", fill_part(templates, "openscad/hollow.scad", list_scad_hollow())},
      {"moves", list_moves(bust)},
      {"expressions", list_expressions(bust)},
      {"chin_down", fmt::format("{}", find_move_index(bust, "chin", "down"))},
      {"left_eye_up", fmt::format("{}", find_move_index(bust, "eye.left", "up"))},
      {"right_eye_up", fmt::format("{}", find_move_index(bust, "eye.right", "up"))},
      {"gaze_side_rad", number(bust.gaze_side_rad, kScadFine)},
      {"gaze_up_rad", number(bust.gaze_up_rad, kScadFine)},
      {"gaze_down_rad", number(bust.gaze_down_rad, kScadFine)},
      {"grid_rows", fmt::format("{}", mouth.rows)},
      {"eyes", list_eyes(bust)},
      {"mouth", fmt::format("[{}],\n  [{}]", list_indices(mouth.upper), list_indices(mouth.lower))},
      {"mouth_line", number(bust.mouth.line_mm, kScadFine)},
      {"jaw_axis", pair(bust.mouth.jaw_axis)},
      {"jaw_open_rad", number(bust.mouth.jaw_open_rad, 6)},
      {"jaw_open_shift", pair(bust.mouth.jaw_forward)},
      {"teeth_reach", number(bust.mouth.reach_mm)},
      {"teeth", fmt::format("[{}],\n  [{}]", list_teeth_row(bust.mouth.upper_edge, bust.mouth.upper_front),
                            list_teeth_row(bust.mouth.lower_edge, bust.mouth.lower_front))},
      {"tongue", describe_tongue(bust.mouth)},
      {"foot", list_indices(bust.foot)},
      {"skin_rows", list_scad_vertices(bust, 0, bust.eyes[0].grid.first)},
      {"chest_rows", list_scad_vertices(bust, chest, bust.rest.size())},
      {"triangles", list_scad_triangles(bust.triangles)},
      {"straight", is_bent ? "q" : "p"},
      {"bent", is_bent ? "let (p = bend(q)) " : ""},
      {"lens", is_bent ? fill_template(templates, "openscad/lens.scad", list_scad_lens(bust.lens)) : ""},
      {"cavity", list_scad_cavity(bust.cavity)}});
  return fill_template(templates, "openscad/bust.scad", values);
}

}  // namespace mien
