// POV-Ray 3.7: mesh2 and texture_list as in its reference manual, section 3.4.5.2.4; measured facts are noted
// where they decided something.
#include "scene/povray.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/conventions.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/thousandths.hpp"
#include "scene/plate.hpp"
#include "scene/povray_stage.hpp"
#include "scene/surface_look.hpp"

namespace mien {

namespace {

// Digits behind the point. A thousandth of a millimetre is a two-hundredth of a pixel in a picture 1000 mm^-1
// wide; a thousandth in a normal is 0.06 degrees, below what a highlight shows.
constexpr int kPositionDecimals = 3;
constexpr int kNormalDecimals = 3;
constexpr int kRigidNormalDecimals = 5;  // of parts written once a clip: wet eyes mirror the lights sharply
constexpr int kMatrixDecimals = 7;
constexpr int kColourDecimals = 4;
constexpr int kGrainDecimals = 2;
constexpr int kPictureDecimals = 6;  // of places on a picture: a hundredth of a pixel of one 8192 wide

// How far the camera stands at distance 1. With the box of CameraView this is a 100 mm lens on 24 x 36 film:
// nearer makes the nose big, farther flattens the face.
constexpr double kLensDistance_mm = 900;

// POV-Ray refuses a cylinder that has no length.
constexpr float kShortest_mm = 0.002f;

// A camera that looks straight up or down has no upright of its own; POV-Ray would turn it at will.
constexpr double kSteepest_deg = 89.5;

// POV-Ray's z points into the picture, ours out of it. The only place where z changes sign.
glm::vec3 to_povray(const glm::vec3& v) { return {v.x, v.y, -v.z}; }

// write_number, told in place where it is one of the many.
inline char* write_quickly(char* text, float value, int decimals) {
  if (decimals == 3)
    if (char* const end = write_thousandths(text, value)) return end;
  return write_number(text, value, decimals);
}

// Into a buffer that has room for four numbers.
inline char* write_numbers(char* text, const glm::vec3& v, int decimals) {
  text = write_quickly(text, v.x, decimals);
  *text++ = ',';
  text = write_quickly(text, v.y, decimals);
  *text++ = ',';
  return write_quickly(text, v.z, decimals);
}

void append_numbers(std::string& text, const glm::vec3& v, int decimals) {
  std::array<char, std::size_t{4} * kLongestNumber> numbers;
  const char* end = write_numbers(numbers.data(), v, decimals);
  text.append(numbers.data(), static_cast<std::size_t>(end - numbers.data()));
}

void append_vector(std::string& text, const glm::vec3& v, int decimals) {
  text += '<';
  append_numbers(text, to_povray(v), decimals);
  text += '>';
}

// Told into a buffer that stays in the nearest cache, and from there to the text.
void append_vectors(std::string& text, const char* block, const std::vector<glm::vec3>& vectors,
                    int decimals) {
  constexpr std::size_t kChunk = 256, kLongest = std::size_t{4} * kLongestNumber;
  std::array<char, kChunk * kLongest> chunk;
  text += fmt::format("{} {{ {}", block, vectors.size());
  for (std::size_t first = 0; first < vectors.size(); first += kChunk) {
    char* end = chunk.data();
    const std::size_t last = std::min(first + kChunk, vectors.size());
    for (std::size_t i = first; i < last; ++i) {
      for (const char c : {',', '\n', '<'}) *end++ = c;
      end = write_numbers(end, to_povray(vectors[i]), decimals);
      *end++ = '>';
    }
    text.append(chunk.data(), static_cast<std::size_t>(end - chunk.data()));
  }
  text += " }\n";
}

// matrix<> takes the images of x, y and z, then the shift. Both the vertices it moves and where they land are
// in POV-Ray's space, so each axis is turned over before and after.
void append_matrix(std::string& text, const glm::mat4& world_from_rest) {
  text += "matrix <";
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 unit(0);
    unit[axis] = 1;
    append_numbers(text, to_povray(glm::mat3(world_from_rest) * to_povray(unit)), kMatrixDecimals);
    text += ", ";
  }
  append_numbers(text, to_povray(glm::vec3(world_from_rest[3])), kPositionDecimals + 1);
  text += '>';
}

[[noreturn]] void fail_part(const Part& part, const std::string& what) {
  throw RunError(fmt::format("internal: part '{}' {}", part.name, what));
}

void check_part(const Part& part) {
  const std::size_t count = part.rest.positions.size();
  if (part.rest.triangles.empty() && !part.is_outline) fail_part(part, "has no triangles");
  if (part.palette.empty()) fail_part(part, "has no palette");
  if (!part.shade.empty() && part.shade.size() != count) fail_part(part, "has not one shade a vertex");
  if (!part.grain.empty() && part.grain.size() != count)
    fail_part(part, "has not one place on its grain a vertex");
  for (const std::uint16_t s : part.shade)
    if (s >= part.palette.size()) fail_part(part, "has a shade outside its palette");
  if (!part.triangle_shade.empty() && part.triangle_shade.size() != part.rest.triangles.size())
    fail_part(part, "has not one shade a triangle");
  for (const std::uint16_t shade : part.triangle_shade)
    if (shade >= part.palette.size()) fail_part(part, "has a shade outside its palette");
  for (const Triangle& triangle : part.rest.triangles)
    for (const std::uint32_t v : triangle)
      if (v >= count) fail_part(part, "has a triangle outside its vertices");
  if (part.is_rigid && part.rest.normals.size() != count) fail_part(part, "has not one normal a vertex");
  if (part.picture && part.picture->atlas->triangles.size() != part.rest.triangles.size())
    fail_part(part, "has not one triangle of its picture a triangle");
  if (part.may_bend && (!part.is_rigid || part.is_outline)) fail_part(part, "bends, and is not rigid");
}

// The grain, or places on a picture, as uv_vectors: POV-Ray's uv_mapping then bends a pattern with the skin.
// z is not in it.
void append_places(std::string& text, const std::vector<glm::vec2>& places, int decimals) {
  text += fmt::format("uv_vectors {{ {}", places.size());
  for (const glm::vec2& uv : places) {
    text += ",\n<";
    append_number(text, uv.x, decimals);
    text += ',';
    append_number(text, uv.y, decimals);
    text += '>';
  }
  text += " }\n";
}

// A part under a picture: its palette has only its gloss left, in few steps.
struct GlossSteps {
  std::vector<float> gloss;
  std::vector<std::uint16_t> step;  // of each vertex
};

GlossSteps list_gloss_steps(const Part& part) {
  constexpr float kSteps = 12;
  GlossSteps steps;
  for (std::size_t v = 0; v < part.rest.positions.size(); ++v) {
    const float gloss =
        std::round(part.palette[part.shade.empty() ? 0 : part.shade[v]].gloss * kSteps) / kSteps;
    const auto found = std::ranges::find(steps.gloss, gloss);
    steps.step.push_back(static_cast<std::uint16_t>(found - steps.gloss.begin()));
    if (found == steps.gloss.end()) steps.gloss.push_back(gloss);
  }
  return steps;
}

void append_face(std::string& text, const Triangle& triangle) {
  fmt::format_to(std::back_inserter(text), ",\n<{},{},{}>", triangle[0], triangle[1], triangle[2]);
}

// The textures of a face's corners. POV-Ray blends three over a face; one is named once and costs a third.
void append_face_textures(std::string& text, std::uint16_t a, std::uint16_t b, std::uint16_t c) {
  if (a == b && b == c)
    fmt::format_to(std::back_inserter(text), ",{}", a);
  else
    fmt::format_to(std::back_inserter(text), ",{},{},{}", a, b, c);
}

// The picture through POV-Ray's own image_map, by places of its own: where it is cut a vertex has two.
void append_painted_faces(std::string& text, const Part& part) {
  const PartPicture& picture = *part.picture;
  const GlossSteps steps = list_gloss_steps(part);
  text += fmt::format("texture_list {{ {}", steps.gloss.size());
  for (const float gloss : steps.gloss)
    text += fmt::format(",\npainted_skin_texture(painted_{}, {}, {})", part.name, format_number(gloss, 3),
                        format_number(picture.side_mm, 2));
  text += fmt::format(" }}\nface_indices {{ {}", part.rest.triangles.size());
  for (const Triangle& triangle : part.rest.triangles) {
    append_face(text, triangle);
    append_face_textures(text, steps.step[triangle[0]], steps.step[triangle[1]], steps.step[triangle[2]]);
  }
  text += fmt::format(" }}\nuv_indices {{ {}", picture.atlas->triangles.size());
  for (const Triangle& triangle : picture.atlas->triangles) append_face(text, triangle);
  text += " }\n";
}

void append_shaded_faces(std::string& text, const Part& part) {
  const bool is_faced = !part.triangle_shade.empty();
  const bool is_shaded = is_faced || (!part.shade.empty() && part.palette.size() > 1);
  if (is_shaded) {
    text += fmt::format("texture_list {{ {}", part.palette.size());
    for (const Shade& shade : part.palette) text += fmt::format(",\n{}", format_povray_texture(part, shade));
    text += " }\n";
  }
  if (!part.is_outline) text += fmt::format("face_indices {{ {}", part.rest.triangles.size());
  for (std::size_t i = 0; i < part.rest.triangles.size(); ++i) {
    const auto& [a, b, c] = part.rest.triangles[i];
    append_face(text, part.rest.triangles[i]);
    if (is_faced)
      fmt::format_to(std::back_inserter(text), ",{}", part.triangle_shade[i]);
    else if (is_shaded)
      append_face_textures(text, part.shade[a], part.shade[b], part.shade[c]);
  }
  if (!part.is_outline) text += " }\n";
  if (!is_shaded)
    text += fmt::format("{}\n",
                        format_povray_texture(part, part.palette[part.shade.empty() ? 0 : part.shade[0]]));
}

// Wear, texture_list and face_indices, the object's words: all that follows the vertices in a mesh2.
void append_surface(std::string& text, const Part& part, bool has_object_macro) {
  if (part.picture)
    append_places(text, part.picture->atlas->places, kPictureDecimals);
  else if (!part.grain.empty())
    append_places(text, part.grain, kGrainDecimals);
  if (part.wear > 0) text += fmt::format("#declare Wear = {};\n", format_number(part.wear, 3));
  if (part.picture)
    append_painted_faces(text, part);
  else
    append_shaded_faces(text, part);
  if (part.wear > 0) text += "#declare Wear = 0;\n";
  if (has_object_macro) text += fmt::format("{}_object()\n", part.material);
}

// Rigid parts whole, the others as a macro that a frame calls behind its vertices.
void append_part(std::string& text, const Part& part, const std::string& materials) {
  check_part(part);
  const auto has_macro = [&](const char* what) {
    return materials.find(fmt::format("#macro {}_{}(", part.material, what)) != std::string::npos;
  };
  if (!has_macro("texture"))
    throw RunError(fmt::format("part '{}': unknown material '{}'", part.name, part.material));
  if (part.picture)
    text += fmt::format(
        "\n#declare painted_{} = pigment {{ uv_mapping image_map {{ png \"{}\" gamma srgb interpolate 2 }} "
        "}}\n",
        part.name, part.picture->name);
  if (part.is_rigid) {
    text += fmt::format("\n#declare part_{} = mesh2 {{\n", part.name);
    append_vectors(text, "vertex_vectors", part.rest.positions, kPositionDecimals + 1);
    append_vectors(text, "normal_vectors", part.rest.normals, kRigidNormalDecimals);
  } else {
    text += fmt::format("\n#macro surface_of_{}()\n", part.name);
  }
  append_surface(text, part, has_macro("object"));
  text += part.is_rigid ? "}\n" : "#end\n";
}

// Triangles without shades, told as append_vectors tells vertices.
void append_triangles(std::string& text, const std::vector<Triangle>& triangles) {
  constexpr std::size_t kChunk = 256, kLongest = 3 * 11 + 4;  // bytes of a triangle
  std::array<char, kChunk * kLongest> chunk;
  text += fmt::format("face_indices {{ {}", triangles.size());
  for (std::size_t first = 0; first < triangles.size(); first += kChunk) {
    char* end = chunk.data();
    const std::size_t last = std::min(first + kChunk, triangles.size());
    for (std::size_t i = first; i < last; ++i) {
      for (const char c : {',', '\n', '<'}) *end++ = c;
      for (const std::uint32_t v : triangles[i]) {
        end = std::to_chars(end, chunk.data() + chunk.size(), v).ptr;
        *end++ = ',';
      }
      end[-1] = '>';
    }
    text.append(chunk.data(), static_cast<std::size_t>(end - chunk.data()));
  }
  text += " }\n";
}

// Triangles of the drawing's own; none of them are no object.
void append_outline(std::string& text, const Part& part, const PartShape& shape) {
  if (shape.triangles.empty()) return;
  text += "mesh2 {\n";
  append_vectors(text, "vertex_vectors", shape.positions, kPositionDecimals);
  append_triangles(text, shape.triangles);
  text += fmt::format("surface_of_{}() }}\n", part.name);
}

// Only rays to lamps meet it.
void append_caster(std::string& text, const Mesh& caster) {
  text += "mesh2 {\n";
  append_vectors(text, "vertex_vectors", caster.positions, kPositionDecimals);
  append_triangles(text, caster.triangles);
  text += "pigment { rgb 1 } no_image no_reflection }\n";
}

// Before all that is made of it: eyes have their colours in head.inc.
void append_ink_lamp(std::string& text, const InkLamp& lamp) {
  text += "#declare Lamp_way = ";
  append_vector(text, glm::vec3(lamp.to_light), kRigidNormalDecimals);
  for (const auto& [name, colour] : {std::pair("lit", lamp.lit), {"dark", lamp.dark}, {"flat", lamp.flat}}) {
    text += fmt::format(";\n#declare Lamp_{} = rgb <", name);
    append_numbers(text, colour, kColourDecimals);
    text += '>';
  }
  text += ";\n";
}

void append_camera(std::string& text, const CameraView& view) {
  const double angle = view.angle_deg * kRadiansPerDegree;
  const double height = std::clamp(view.height_deg, -kSteepest_deg, kSteepest_deg) * kRadiansPerDegree;
  const glm::vec3 toward_camera(std::sin(angle) * std::cos(height), std::sin(height),
                                std::cos(angle) * std::cos(height));
  const double distance_mm = compute_camera_distance_mm(view);
  text += view.is_orthographic ? "stage_flat_camera(" : "stage_camera(";
  append_vector(text, view.look_at + static_cast<float>(distance_mm * view.distance) * toward_camera, 4);
  text += ", ";
  append_vector(text, view.look_at, 4);
  for (const double length_mm : {distance_mm, view.frame_width_mm, view.frame_height_mm})
    text += fmt::format(", {}", format_number(length_mm, 4));
  text += ")\n";
}

}  // namespace

std::string format_povray_texture(const Part& part, const Shade& shade) {
  std::string colour;
  append_numbers(colour, shade.srgb, kColourDecimals);
  const std::string pale = shade.blood > 0 ? fmt::format(" * pale({})", format_number(shade.blood, 3)) : "";
  return fmt::format("{}_texture(srgb <{}>{}, {})", part.material, colour, pale,
                     format_number(shade.gloss, 3));
}

double compute_camera_distance_mm(const CameraView& view) {
  return kLensDistance_mm * (view.lens_mm / kPortraitLens_mm) * view.frame_height_mm /
         CameraView{}.frame_height_mm;
}

std::string build_povray_parts(const Model& model, const Templates& templates) {
  const std::string materials = find_template(templates, "povray/materials.inc").text +
                                find_template(templates, "povray/materials_drawn.inc").text;
  std::string parts;
  if (std::ranges::any_of(model.parts, [](const Part& part) { return part.picture != nullptr; }))
    parts = find_template(templates, "povray/materials_painted.inc").text;
  for (const Part& part : model.parts) append_part(parts, part, materials);
  return parts;
}

std::string build_povray_include(const Model& model, const RenderSpec& render, const Templates& templates) {
  return build_povray_stage(build_povray_parts(model, templates), render, templates);
}

void append_povray_start(std::string& text, const FrameStart& start) {
  text += "#version 3.7;\n";
  if (start.lamp) append_ink_lamp(text, *start.lamp);
  text += "#include \"head.inc\"\n";
  for (const std::string& include : start.includes) text += fmt::format("#include \"{}\"\n", include);
  append_povray_lights(text, start.lights);
  append_povray_background(text, start.backgrounds);
  append_camera(text, start.view);
}

void append_povray_figure(std::string& text, const Model& model, const Drawing& drawing,
                          const std::vector<Mesh>* casters) {
  if (drawing.parts.size() != model.parts.size())
    throw RunError("internal: a drawing has not the model's parts");
  constexpr std::size_t kPerVertex =
      56;  // bytes of a place and a normal; fewer and the text is moved as it grows
  std::size_t vertices = 0;
  for (const PartShape& shape : drawing.parts) vertices += shape.positions.size();
  text.reserve(text.size() + vertices * kPerVertex);
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const Part& part = model.parts[i];
    const PartShape& shape = drawing.parts[i];
    if (is_carried(part, shape)) {
      text += fmt::format("object {{ part_{} ", part.name);
      append_matrix(text, shape.world_from_rest);
      text += " }\n";
      continue;
    }
    if (part.is_outline) {
      append_outline(text, part, shape);
      continue;
    }
    const std::size_t count = part.rest.positions.size();
    if (shape.positions.size() != count || (!shape.normals.empty() && shape.normals.size() != count))
      fail_part(part, "is drawn with another number of vertices");
    const std::string paling = format_number(shape.paling, 2);
    if (paling != "0") text += fmt::format("#declare Paling = {};\n", paling);
    const bool has_own_lamps = has_strands(part) && !part.is_rigid;
    if (has_own_lamps) text += "light_group { strand_lamps()\n";
    text += "mesh2 {\n";
    append_vectors(text, "vertex_vectors", shape.positions, kPositionDecimals);
    if (!shape.normals.empty()) append_vectors(text, "normal_vectors", shape.normals, kNormalDecimals);
    if (part.is_rigid) {  // bent: its surface has no macro
      append_surface(text, part, false);
      text += "}\n";
      continue;
    }
    const bool has_caster = casters && !(*casters)[i].triangles.empty();
    text += fmt::format("surface_of_{}(){} }}\n", part.name, has_caster ? " no_shadow" : "");
    if (has_own_lamps) text += "global_lights off }\n";
    if (paling != "0") text += "#declare Paling = 0;\n";
    if (has_caster) append_caster(text, (*casters)[i]);
  }
}

void append_povray_frame(std::string& text, const Model& model, const Drawing& drawing,
                         const CameraView& view) {
  append_povray_start(text, {{}, {}, {}, view});
  append_povray_figure(text, model, drawing);
}

void append_povray_overlay(std::string& text, const Overlay& overlay, const CameraView& view) {
  const auto append_colour = [&](const glm::vec3& srgb) {
    text += "srgb <";
    append_numbers(text, srgb, kColourDecimals);
    text += ">)";
  };
  for (const OverlayLine& line : overlay.lines) {
    if (line.segments.empty() && line.tips.empty()) continue;
    const auto append_piece = [&](const char* piece, const std::array<glm::vec3, 2>& ends, double radius_mm) {
      if (glm::distance(ends[0], ends[1]) < kShortest_mm) return;
      text += fmt::format("{}(", piece);
      append_vector(text, ends[0], kPositionDecimals);
      text += ", ";
      append_vector(text, ends[1], kPositionDecimals);
      text += fmt::format(", {})\n", format_number(radius_mm, kPositionDecimals));
    };
    text += "union {\n";
    for (const auto& segment : line.segments) append_piece("stage_line", segment, line.radius_mm);
    for (const auto& tip : line.tips) append_piece("stage_tip", tip, line.radius_mm * kTipWidth);
    text += "stage_ink(";
    append_colour(line.srgb);
    text += " }\n";
  }
  for (const OverlayWords& words : overlay.words) {
    text += fmt::format("stage_words({}, ", quote_povray(words.words));
    append_vector(text, words.at, kPositionDecimals);
    text += fmt::format(", {}, {}, {}, ", format_number(words.size_mm, kPositionDecimals),
                        format_number(words.align, 2), format_number(-view.angle_deg, 4));
    append_colour(words.srgb);
    text += "\n";
  }
}

}  // namespace mien
