// UsdSkel: "Skeletal deformation", OpenUSD's documentation; matrices hold rows for vectors on the left.
#include "scene/usd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>

#include "core/text.hpp"
#include "scene/surface_look.hpp"
#include "scene/title.hpp"

namespace mien {

namespace {

constexpr int kPlaceDecimals = 4, kUnitDecimals = 5, kWeightDecimals = 6, kTimeDecimals = 4;

std::string format_vector(const glm::dvec3& v, int decimals) {
  return fmt::format("({}, {}, {})", format_number(v.x, decimals), format_number(v.y, decimals),
                     format_number(v.z, decimals));
}

std::string format_turn(const glm::dquat& turn) {
  const glm::dquat unit = glm::normalize(turn);
  return fmt::format("({}, {}, {}, {})", format_number(unit.w, kWeightDecimals),
                     format_number(unit.x, kWeightDecimals), format_number(unit.y, kWeightDecimals),
                     format_number(unit.z, kWeightDecimals));
}

// A list of `count` things, comma-separated in brackets.
std::string format_list(std::size_t count, const std::function<std::string(std::size_t)>& format) {
  std::string text = "[";
  for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + format(i);
  return text + "]";
}

std::string format_vectors(const std::vector<glm::vec3>& vectors, int decimals) {
  return format_list(vectors.size(), [&](std::size_t i) { return format_vector(vectors[i], decimals); });
}

std::string format_shift(const glm::dvec3& shift) {
  return fmt::format("((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), ({}, {}, {}, 1))",
                     format_number(shift.x, kPlaceDecimals), format_number(shift.y, kPlaceDecimals),
                     format_number(shift.z, kPlaceDecimals));
}

// A name of a prim: letters, digits and underscores.
std::string make_prim_name(const std::string& name) {
  std::string prim = name;
  for (char& c : prim)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return prim;
}

std::vector<std::string> list_joint_paths(const Rig& rig) {
  std::vector<std::string> paths;
  for (const RigJoint& joint : rig.joints)
    paths.push_back(joint.parent < 0 ? joint.name : paths[joint.parent] + "/" + joint.name);
  return paths;
}

std::string format_names(const std::vector<std::string>& names) {
  return format_list(names.size(), [&](std::size_t i) { return fmt::format("\"{}\"", names[i]); });
}

glm::dvec3 find_own_place(const Rig& rig, const RigJoint& joint) {
  return joint.parent < 0 ? joint.at_mm : joint.at_mm - rig.joints[joint.parent].at_mm;
}

// `name` with one value, or with one at each time.
void append_samples(std::string& text, const UsdScene& scene, const std::string& name,
                    const std::function<std::string(const RigPose&)>& format) {
  const RigTake& take = scene.take;
  if (take.poses.size() < 2) {
    text += fmt::format("            {} = {}\n", name, format(take.poses.front()));
    return;
  }
  text += fmt::format("            {}.timeSamples = {{\n", name);
  for (std::size_t i = 0; i < take.poses.size(); ++i)
    text += fmt::format("                {}: {},\n",
                        format_number(take.times_s[i] * scene.fps, kTimeDecimals), format(take.poses[i]));
  text += "            }\n";
}

void append_skeleton(std::string& text, const UsdScene& scene) {
  const Rig& rig = scene.rig;
  const std::string joints = format_names(list_joint_paths(rig));
  const std::size_t count = rig.joints.size();
  text += "    def Skeleton \"Rig\" (\n        prepend apiSchemas = [\"SkelBindingAPI\"]\n    )\n    {\n";
  text += fmt::format("        uniform token[] joints = {}\n", joints);
  text += fmt::format("        uniform matrix4d[] bindTransforms = {}\n",
                      format_list(count, [&](std::size_t j) { return format_shift(rig.joints[j].at_mm); }));
  text += fmt::format(
      "        uniform matrix4d[] restTransforms = {}\n",
      format_list(count, [&](std::size_t j) { return format_shift(find_own_place(rig, rig.joints[j])); }));
  text +=
      "        rel skel:animationSource = </Face/Rig/Take>\n        def SkelAnimation \"Take\"\n        {\n";
  text += fmt::format("            uniform token[] joints = {}\n", joints);
  text += fmt::format("            uniform token[] blendShapes = {}\n", format_names(rig.targets));
  text += fmt::format("            half3[] scales = {}\n",
                      format_list(count, [](std::size_t) { return std::string("(1, 1, 1)"); }));
  append_samples(text, scene, "float3[] translations", [](const RigPose& pose) {
    return format_list(pose.joints.size(),
                       [&](std::size_t j) { return format_vector(pose.joints[j].at_mm, kPlaceDecimals); });
  });
  append_samples(text, scene, "quatf[] rotations", [](const RigPose& pose) {
    return format_list(pose.joints.size(), [&](std::size_t j) { return format_turn(pose.joints[j].turn); });
  });
  append_samples(text, scene, "float[] blendShapeWeights", [](const RigPose& pose) {
    return format_list(pose.weights.size(),
                       [&](std::size_t t) { return format_number(pose.weights[t], kWeightDecimals); });
  });
  text += "        }\n    }\n";
}

void append_target(std::string& text, const std::string& name, const RigTarget& target) {
  text += fmt::format("        def BlendShape \"{}\"\n        {{\n", make_prim_name(name));
  text += fmt::format("            uniform int[] pointIndices = {}\n",
                      format_list(target.places.vertices.size(),
                                  [&](std::size_t i) { return fmt::to_string(target.places.vertices[i]); }));
  text += fmt::format("            uniform vector3f[] offsets = {}\n",
                      format_vectors(target.places.offsets, kPlaceDecimals));
  if (!target.normals.empty())
    text += fmt::format("            uniform vector3f[] normalOffsets = {}\n",
                        format_vectors(target.normals, kUnitDecimals));
  text += "        }\n";
}

// Which joints carry the vertices: two each, or one for all of them.
void append_binding(std::string& text, const RigPart& part) {
  if (part.shares.empty()) {
    text += fmt::format(
        "        int[] primvars:skel:jointIndices = [{}] (\n            elementSize = 1\n            "
        "interpolation = \"constant\"\n        )\n"
        "        float[] primvars:skel:jointWeights = [1] (\n            elementSize = 1\n            "
        "interpolation = \"constant\"\n        )\n",
        part.joint);
    return;
  }
  const std::vector<JointShare>& shares = part.shares;
  text += fmt::format(
      "        int[] primvars:skel:jointIndices = {} (\n            elementSize = 2\n            "
      "interpolation = \"vertex\"\n        )\n",
      format_list(shares.size(),
                  [&](std::size_t v) { return fmt::format("{}, {}", shares[v].first, shares[v].second); }));
  text += fmt::format(
      "        float[] primvars:skel:jointWeights = {} (\n            elementSize = 2\n            "
      "interpolation = \"vertex\"\n        )\n",
      format_list(shares.size(), [&](std::size_t v) {
        return fmt::format("{}, {}", format_number(1 - shares[v].share, kWeightDecimals),
                           format_number(shares[v].share, kWeightDecimals));
      }));
}

// A colour a vertex, or where triangles have shades of their own one a face.
void append_colours(std::string& text, const Part& part) {
  const SurfaceLook look = find_surface_look(part.material);
  const bool is_by_face = !part.triangle_shade.empty();
  const std::size_t count = is_by_face ? part.triangle_shade.size() : part.rest.positions.size();
  const std::string colours = format_list(count, [&](std::size_t i) {
    const std::uint16_t shade = is_by_face           ? part.triangle_shade[i]
                                : part.shade.empty() ? std::uint16_t(0)
                                                     : part.shade[i];
    const std::size_t vertex = is_by_face ? part.rest.triangles[i][0] : i;
    return format_vector(glm::dvec3(compute_vertex_colour(part, look, vertex, shade)), kUnitDecimals);
  });
  text += fmt::format(
      "        color3f[] primvars:displayColor = {} (\n            interpolation = \"{}\"\n        )\n",
      colours, is_by_face ? "uniform" : "vertex");
  if (look.alpha < 1)
    text += fmt::format(
        "        float[] primvars:displayOpacity = [{}] (\n            interpolation = \"constant\"\n        "
        ")\n",
        format_number(look.alpha, kUnitDecimals));
}

void append_part(std::string& text, const UsdScene& scene, std::size_t index) {
  const Part& part = scene.model.parts[index];
  const RigPart& rigged = scene.rig.parts[index];
  if (part.rest.triangles.empty()) return;
  const std::string name = make_prim_name(part.name);
  text += fmt::format(
      "    def Mesh \"{}\" (\n        prepend apiSchemas = [\"SkelBindingAPI\"]\n    )\n    {{\n", name);
  text += "        uniform token subdivisionScheme = \"none\"\n";
  if (find_surface_look(part.material).is_two_sided) text += "        uniform bool doubleSided = 1\n";
  text += fmt::format("        int[] faceVertexCounts = {}\n",
                      format_list(part.rest.triangles.size(), [](std::size_t) { return std::string("3"); }));
  text += fmt::format("        int[] faceVertexIndices = {}\n",
                      format_list(part.rest.triangles.size(), [&](std::size_t t) {
                        const Triangle& corners = part.rest.triangles[t];
                        return fmt::format("{}, {}, {}", corners[0], corners[1], corners[2]);
                      }));
  text += fmt::format("        point3f[] points = {}\n", format_vectors(part.rest.positions, kPlaceDecimals));
  if (!part.rest.normals.empty())
    text +=
        fmt::format("        normal3f[] normals = {} (\n            interpolation = \"vertex\"\n        )\n",
                    format_vectors(part.rest.normals, kUnitDecimals));
  append_colours(text, part);
  append_binding(text, rigged);
  text += fmt::format("        matrix4d primvars:skel:geomBindTransform = {}\n", format_shift(glm::dvec3(0)));
  text += "        rel skel:skeleton = </Face/Rig>\n";
  if (!rigged.targets.empty()) {
    const std::size_t count = rigged.targets.size();
    const auto name_target = [&](std::size_t t) { return scene.rig.targets[rigged.targets[t].name]; };
    text +=
        fmt::format("        uniform token[] skel:blendShapes = {}\n",
                    format_list(count, [&](std::size_t t) { return fmt::format("\"{}\"", name_target(t)); }));
    text += fmt::format("        rel skel:blendShapeTargets = {}\n", format_list(count, [&](std::size_t t) {
                          return fmt::format("</Face/{}/{}>", name, make_prim_name(name_target(t)));
                        }));
    for (std::size_t t = 0; t < count; ++t) append_target(text, name_target(t), rigged.targets[t]);
  }
  text += "    }\n";
}

}  // namespace

std::string build_usd(const UsdScene& scene) {
  std::string text = "#usda 1.0\n(\n    defaultPrim = \"Face\"\n";
  text += fmt::format("    doc = \"{}\"\n", clean_title(scene.title, "\\\""));
  text += "    metersPerUnit = 0.001\n    upAxis = \"Y\"\n";
  if (scene.take.poses.size() > 1)
    text += fmt::format("    startTimeCode = 0\n    endTimeCode = {}\n    timeCodesPerSecond = {}\n",
                        format_number(scene.take.times_s.back() * scene.fps, kTimeDecimals),
                        format_number(scene.fps, kTimeDecimals));
  text += ")\n\ndef SkelRoot \"Face\" (\n    kind = \"component\"\n)\n{\n";
  append_skeleton(text, scene);
  for (std::size_t i = 0; i < scene.model.parts.size(); ++i) append_part(text, scene, i);
  return text + "}\n";
}

}  // namespace mien
