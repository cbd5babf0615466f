#include "frames/figure.hpp"

#include <array>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "core/conventions.hpp"
#include "core/float4.hpp"
#include "core/pool.hpp"
#include "head/beard.hpp"
#include "head/hair.hpp"
#include "head/skin_look.hpp"
#include "head/skin_spots.hpp"
#include "head/skin_tint.hpp"
#include "head/surface.hpp"
#include "timeline/head_turn.hpp"

namespace mien {

namespace {

void turn_points(const Face& face, const TurnKey& turn, const glm::dmat4& whole,
                 std::vector<glm::dvec3>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double share = face.turn_weights[i];
    if (share == 0 && turn.breath_mm == 0) continue;
    const glm::dmat4 world = share == 1 ? whole : compute_turn(face.turn_pivot, turn, share);
    points[i] = glm::dvec3(world * glm::dvec4(points[i], 1));
  }
}

glm::mat4 compute_transform(const Figure& figure, Mount mount, const Pose& pose,
                            const glm::dmat4& head_turn) {
  const auto gaze = [&](Side side) {
    glm::dvec3 centre = figure.head.eye.centre;
    if (side == Side::right) centre.x = -centre.x;
    const glm::dmat4 turned =
        glm::translate(glm::dmat4(1), centre) * glm::dmat4(compute_gaze(figure.face, pose, side));
    return glm::mat4(head_turn * glm::translate(turned, -centre));
  };
  if (mount == Mount::eye_left) return gaze(Side::left);
  if (mount == Mount::eye_right) return gaze(Side::right);
  if (mount == Mount::jaw) return glm::mat4(head_turn * compute_jaw(figure.face, pose));
  return glm::mat4(head_turn);
}

std::vector<SkinFrame> compute_frames(const HeadPart& bound, const NeutralHead& head,
                                      const std::vector<glm::vec3>& positions,
                                      const std::vector<glm::vec3>& normals) {
  std::vector<SkinFrame> frames;
  frames.reserve(bound.bindings.size());
  for (const Binding& binding : bound.bindings)
    frames.push_back(
        compute_skin_frame(positions, normals, head.skin.triangles[binding.triangle], binding.barycentric));
  return frames;
}

// Hairs: each keeps its shape and stands in the frame of its place on the skin.
void deform_strands(const HeadPart& bound, const NeutralHead& head, const Part& part,
                    const std::vector<SkinFrame>& rest, const PartShape& skin, PartShape& shape) {
  shape.positions.resize(part.rest.positions.size());
  shape.normals.resize(part.rest.normals.size());
  for (std::size_t b = 0; b < bound.bindings.size(); ++b) {
    const Binding& binding = bound.bindings[b];
    const SkinFrame now = compute_skin_frame(skin.positions, skin.normals,
                                             head.skin.triangles[binding.triangle], binding.barycentric);
    const glm::mat3 turn = now.axes * glm::transpose(rest[b].axes);
    const Float4 x = pack(turn[0]), y = pack(turn[1]), z = pack(turn[2]), origin = pack(now.origin);
    const Float4 root = pack(rest[b].origin);
    for (std::uint32_t i = binding.first; i < binding.first + binding.count; ++i) {
      const Float4 arm = pack(part.rest.positions[i]) - root, normal = pack(part.rest.normals[i]);
      shape.positions[i] = unpack(origin + (x * arm[0] + y * arm[1] + z * arm[2]));
      shape.normals[i] = unpack(x * normal[0] + y * normal[1] + z * normal[2]);
    }
  }
}

}  // namespace

Figure build_figure(const HeadStock& stock, const HeadSpec& asked, FigureUse use) {
  HeadSpec spec = asked;
  spec.look = compute_aged_look(asked.look, asked.age);
  const bool is_print = use == FigureUse::print;
  Figure figure;
  figure.head = build_neutral_head(stock, spec);
  figure.limits = compute_limit_shares(spec.limits);
  // Independent of each other, the slow ones first.
  std::array<std::vector<HeadPart>, 7> made;
  std::vector<SkinTint> tints;
  const std::array<std::function<void()>, 10> works{
      [&] { figure.face = build_face(figure.head); },
      [&] {
        if (!is_print) figure.folds = build_folds(figure.head, spec);
      },
      [&] {
        made[0].push_back({is_print ? build_plain_skin_part(figure.head, spec.look)
                                    : build_skin_part(figure.head, spec.look),
                           Mount::skin,
                           {}});
      },
      [&] {
        if (!is_print) made[5] = build_skin_spots(figure.head, spec.look);
      },
      [&] { made[4] = build_hair(figure.head, spec.hair, spec.look); },
      [&] {
        if (!is_print) tints = list_hair_tints(figure.head, spec);
      },
      [&] { made[6] = build_beard(figure.head, spec.look); },
      [&] { made[3] = build_hairs(figure.head, spec.look); },
      [&] { made[2] = build_mouth(figure.head, spec.look); },
      [&] { made[1] = build_eyes(figure.head, spec.look); }};
  for_each_index(works.size(), count_workers(), [&](std::size_t i, int) { works[i](); });
  for (const SkinTint& tint : tints) tint_skin(made[0].front().part, tint.covers, tint.srgb);
  for (std::vector<HeadPart>& parts : made)
    for (HeadPart& part : parts) figure.parts.push_back(std::move(part));
  for (const HeadPart& part : figure.parts)
    figure.roots.push_back(
        compute_frames(part, figure.head, figure.head.skin.positions, figure.head.skin.normals));
  for (HeadPart& part : figure.parts) figure.model.parts.push_back(std::move(part.part));
  if (!is_print) refine_part(figure.folds.skin, figure.model.parts.front());
  return figure;
}

void deform_skin(const Figure& figure, const Surface& surface, const Pose& asked, const TurnKey& turn,
                 DeformBuffers& buffers, PartShape& skin) {
  pose_cage(figure.head, figure.face, apply_limits(figure.limits, asked), buffers.points);
  if (is_turned(turn))
    turn_points(figure.face, turn, compute_turn(figure.face.turn_pivot, turn, 1), buffers.points);
  pair_points(buffers.points, surface.mirror, buffers.point_pairs);
  deform_pairs(surface, buffers.point_pairs, buffers.place_pairs);
  update_pair_normals(surface, buffers.place_pairs, buffers.normal_pairs);
  skin.positions.resize(surface.vertex_count());
  skin.normals.resize(surface.vertex_count());
  unpack_pairs(surface.pairs, buffers.place_pairs, 0, skin.positions);
  unpack_pairs(surface.pairs, buffers.normal_pairs, 0, skin.normals);
}

void deform_figure(const Figure& figure, const Pose& asked, const TurnKey& turn, DeformBuffers& buffers,
                   Drawing& drawing) {
  const Pose pose = apply_limits(figure.limits, asked);
  drawing.parts.resize(figure.parts.size());
  const bool is_neutral = pose == Pose{} && !is_turned(turn);
  const glm::dmat4 head_turn =
      is_turned(turn) ? compute_turn(figure.face.turn_pivot, turn, 1) : glm::dmat4(1);

  PartShape& skin = drawing.parts.front();
  deform_skin(figure, *figure.head.surface, asked, turn, buffers, skin);
  for (std::size_t i = 1; i < figure.parts.size(); ++i) {
    const HeadPart& bound = figure.parts[i];
    const Part& part = figure.model.parts[i];
    PartShape& shape = drawing.parts[i];
    if (bound.mount != Mount::strands) {
      shape.world_from_rest = compute_transform(figure, bound.mount, pose, head_turn);
    } else if (is_neutral) {
      shape.positions = part.rest.positions;
      shape.normals = part.rest.normals;
    } else {
      deform_strands(bound, figure.head, part, figure.roots[i], skin, shape);
    }
  }
  // Last: hairs stand on the smooth skin, whose normals do not shake.
  const FineSkin& fine = figure.folds.skin;
  append_fine_pairs(fine, buffers.place_pairs, buffers.normal_pairs);
  skin.positions.resize(fine.vertex_count());
  skin.normals.resize(fine.vertex_count());
  unpack_pairs(fine.pairs, buffers.place_pairs, fine.base_pairs, skin.positions);
  unpack_pairs(fine.pairs, buffers.normal_pairs, fine.base_pairs, skin.normals);
  if (buffers.has_folds) press_folds(figure.folds, pose, buffers.folds, skin.positions, skin.normals);
}

}  // namespace mien
