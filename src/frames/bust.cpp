#include "frames/bust.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/error.hpp"
#include "core/simplify.hpp"
#include "frames/bust_brows.hpp"
#include "frames/bust_eyes.hpp"
#include "frames/bust_pieces.hpp"
#include "frames/bust_skin.hpp"

namespace mien {

namespace {

// The print's own measures as shares of its height; in the comments' words, mm at a height of 80.
constexpr double kBaseHeight = 8.0 / 80;
constexpr double kBaseRadius = 15.0 / 80;
constexpr float kBrow = 0.5f / 80;        // standing out less, it is lost between two layers
constexpr float kLock = 0.6f / 80;        // from lock to lock of the brow; finer would not print
constexpr float kIrisDepth = 0.45f / 80;  // a dish that throws a shadow
constexpr float kPupilDepth = 1.0f / 80;  // dark in every light
// Of the printed surface. Measured: 0.013 mm at most are lost, an eighth of a fine layer, and half of the
// triangles.
constexpr double kTolerance_mm = 0.03;
constexpr double kSpeck_mm3 = 0.3;      // a bead that no printer makes
constexpr float kIrisRadius_mm = 5.7f;  // of the head, if the model has no iris

// One drawing of a model, with its parts findable by name.
struct PosedModel {
  const Model& model;
  const Drawing& drawing;

  const Part* find_part(std::string_view name) const {
    const auto found = std::find_if(model.parts.begin(), model.parts.end(),
                                    [&](const Part& part) { return part.name == name; });
    return found == model.parts.end() ? nullptr : &*found;
  }
  const PartShape& find_shape(const Part& part) const {
    return drawing.parts[static_cast<std::size_t>(&part - model.parts.data())];
  }
  // The part as it stands in the drawing.
  Mesh build_mesh(const Part& part) const {
    const PartShape& shape = find_shape(part);
    Mesh mesh;
    mesh.triangles = part.rest.triangles;
    mesh.positions = shape.positions;
    if (part.is_rigid)
      for (const glm::vec3& p : part.rest.positions)
        mesh.positions.emplace_back(shape.world_from_rest * glm::vec4(p, 1));
    return mesh;
  }
};

// From the drawing's space (y up, z forward) to the print's (z up, front toward -y, the foot on the origin).
struct Placing {
  glm::vec3 foot{0};
  float scale = 1;

  void apply(Mesh& mesh) const {
    for (glm::vec3& p : mesh.positions) {
      const glm::vec3 at = (p - foot) * scale;
      p = {at.x, -at.z, at.y};
    }
    mesh.normals.clear();
  }
};

Placing find_placing(const BustSkin& skin, double figure_height_mm) {
  const Box box = find_bounds(skin.mesh.positions);
  return {skin.foot, static_cast<float>(figure_height_mm / (box.high.y - skin.foot.y))};
}

// The eye of one side as its parts stand in the drawing; `print_mm` of the drawing are the whole print's
// height.
CarvedEye find_carved_eye(const NeutralHead& head, const PosedModel& figure, const std::string& side,
                          float print_mm) {
  const Part& ball = *figure.find_part("eye_" + side);
  const glm::vec3 mirror(side == "left" ? 1 : -1, 1, 1);
  const glm::vec3 centre = glm::vec3(head.eye.centre) * mirror;
  const glm::mat4 turn = ball.is_rigid ? figure.find_shape(ball).world_from_rest : glm::mat4(1);
  CarvedEye eye;
  eye.centre = turn * glm::vec4(centre, 1);
  eye.radius_mm = static_cast<float>(head.eye.radius_mm);
  eye.iris_mm = kIrisRadius_mm * eye.radius_mm / 13;
  eye.gaze = turn * glm::vec4(0, 0, 1, 0);
  eye.up = turn * glm::vec4(0, 1, 0, 0);
  if (const Part* iris = figure.find_part("iris_" + side)) {
    const Mesh disc = figure.build_mesh(*iris);
    const Box box = find_bounds(iris->rest.positions);
    eye.gaze = glm::normalize((find_bounds(disc.positions).low + find_bounds(disc.positions).high) * 0.5f -
                              eye.centre);
    eye.iris_mm = (box.high.y - box.low.y) / 2;
  }
  const float deepest = eye.radius_mm * 0.6f;  // a low print must not be bored through
  eye.iris_depth_mm = std::min(kIrisDepth * print_mm, deepest / 2);
  eye.pupil_depth_mm = std::min(kPupilDepth * print_mm, deepest);
  return eye;
}

bool is_named(const Part& part, std::string_view stem) {
  return part.name == std::string(stem) + "_left" || part.name == std::string(stem) + "_right";
}

std::vector<Mesh> list_hairs(const PosedModel& figure) {
  std::vector<Mesh> hairs;
  for (const Part& part : figure.model.parts)
    if (is_named(part, "brow")) hairs.push_back(figure.build_mesh(part));
  return hairs;
}

// The printed parts but the skin, as solids where the drawing has them.
std::vector<Solid> list_inner_solids(const NeutralHead& head, const PosedModel& figure, float print_mm) {
  std::vector<Solid> solids;
  for (const Part& part : figure.model.parts) {
    const bool is_carved = is_named(part, "brow") || is_named(part, "iris");  // into skin and ball
    if (!part.is_printed || is_carved || part.name == "skin") continue;
    if (is_named(part, "eye"))
      solids.push_back(
          {part.name, build_carved_eye(find_carved_eye(head, figure, part.name.substr(4), print_mm))});
    else
      append_pieces(solids, part.name, figure.build_mesh(part));
  }
  return solids;
}

void require_fit(const PosedModel& figure) {
  const auto& [model, drawing] = figure;
  if (drawing.parts.size() != model.parts.size())
    throw RunError(fmt::format("internal: a drawing of {} parts for a model of {}", drawing.parts.size(),
                               model.parts.size()));
  if (!figure.find_part("skin")) throw RunError("internal: the model has no part 'skin'");
}

}  // namespace

BustPrint build_bust(const NeutralHead& head, const Model& model, const Drawing& drawing, double height_mm,
                     std::string title) {
  const PosedModel figure{model, drawing};
  require_fit(figure);
  BustPrint print;
  print.title = std::move(title);
  print.height_mm = height_mm;
  print.base_height_mm = kBaseHeight * height_mm;
  print.base_radius_mm = kBaseRadius * height_mm;

  BustSkin skin = build_bust_skin(head, figure.find_shape(*figure.find_part("skin")).positions);
  const Placing placing = find_placing(skin, height_mm - print.base_height_mm + kFootSink_mm);
  const float print_mm = float(height_mm) / placing.scale;  // of the drawing, for the whole print's height
  print.foot_radius_mm = skin.foot_radius_mm * placing.scale;
  print.foot_mm = (skin.chest_y_mm - skin.foot.y) * placing.scale;

  raise_brows(skin.mesh, list_hairs(figure), {kBrow * print_mm, kLock * print_mm});
  std::vector<Solid> inner = list_inner_solids(head, figure, print_mm);
  keep_showing(inner, skin.mesh);
  print.solids.push_back({"skin", std::move(skin.mesh)});
  std::move(inner.begin(), inner.end(), std::back_inserter(print.solids));
  for (Solid& solid : print.solids) {
    placing.apply(solid.mesh);
    simplify_mesh(solid.mesh, kTolerance_mm);
  }
  std::erase_if(print.solids, [](const Solid& solid) { return compute_volume_mm3(solid.mesh) < kSpeck_mm3; });
  return print;
}

}  // namespace mien
