#include "frames/figure.hpp"

#include <array>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "core/conventions.hpp"
#include "core/float4.hpp"
#include "core/pool.hpp"
#include "face/fold_ground.hpp"
#include "face/thesis_rules.hpp"
#include "frames/figure_atlas.hpp"
#include "head/beard.hpp"
#include "head/dental_arch.hpp"
#include "head/hair.hpp"
#include "head/ink_eyes.hpp"
#include "head/skin_look.hpp"
#include "head/skin_spots.hpp"
#include "head/skin_tint.hpp"
#include "head/stock_things.hpp"
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

// What a rigid part does within the head, in a pose that take_pose gave.
glm::dmat4 find_motion(const Figure& figure, Mount mount, const Pose& pose) {
  const auto gaze = [&](Side side) {
    glm::dvec3 centre = figure.head.eye.centre;
    if (side == Side::right) centre.x = -centre.x;
    const glm::dmat4 turned =
        glm::translate(glm::dmat4(1), centre) * glm::dmat4(compute_gaze(figure.face, pose, side));
    return glm::translate(turned, -centre);
  };
  if (mount == Mount::eye_left) return gaze(Side::left);
  if (mount == Mount::eye_right) return gaze(Side::right);
  if (mount == Mount::jaw) return compute_jaw(figure.face, pose);
  return glm::dmat4(1);
}

// Hairs: each keeps its shape and stands in the frame of its place on the skin.
HairRoots build_roots(const HeadPart& bound, const NeutralHead& head,
                      const std::vector<std::uint32_t>& half_of) {
  HairRoots roots;
  if (bound.bindings.empty()) return roots;
  const Mesh& rest = bound.part.rest;
  for (std::size_t b = 0; b < bound.bindings.size(); b += 2) {
    const Binding &one = bound.bindings[b],
                  &other = bound.bindings[std::min(b + 1, bound.bindings.size() - 1)];
    std::array<SkinFrame, 2> frames;
    for (const Binding* binding : {&one, &other}) {
      const Triangle& triangle = head.skin.triangles[binding->triangle];
      frames[binding == &one ? 0 : 1] =
          compute_skin_frame(head.skin.positions, head.skin.normals, triangle, binding->barycentric);
      roots.corners.push_back({half_of[triangle[0]], half_of[triangle[1]], half_of[triangle[2]]});
    }
    if (&one == &other) frames[1] = frames[0];
    roots.shares.push_back({pack(one.barycentric), pack(other.barycentric)});
    std::array<Twin, 3>& axes = roots.rest.emplace_back();
    for (int i = 0; i < 3; ++i) axes[i] = {pack(frames[0].axes[i]), pack(frames[1].axes[i])};
    for (std::size_t k = 0; k < 2; ++k) {
      const Binding& binding = k == 0 ? one : other;
      roots.first.push_back(static_cast<std::uint32_t>(roots.arms.size()));
      if (k == 1 && &one == &other) continue;
      for (std::uint32_t i = binding.first; i < binding.first + binding.count; ++i)
        roots.arms.push_back({pack(rest.positions[i]) - pack(frames[k].origin), pack(rest.normals[i])});
    }
  }
  roots.first.push_back(static_cast<std::uint32_t>(roots.arms.size()));
  return roots;
}

// The parts as the design has them at rest: the skull's for good, those of eyes and jaw no longer rigid.
void redraw_parts(Figure& figure) {
  figure.undistorted.resize(figure.parts.size());
  for (std::size_t i = 1; i < figure.parts.size(); ++i) {
    Part& part = figure.model.parts[i];
    const Mount mount = figure.parts[i].mount;
    if (mount == Mount::strands) continue;
    const Mesh rest = part.rest;
    PartShape shape;
    redraw_part(figure.redraw, 0, rest, glm::dmat4(1), glm::dmat4(1), shape);
    part.rest.positions = std::move(shape.positions);
    part.rest.normals = std::move(shape.normals);
    if (mount == Mount::skull) continue;
    part.is_rigid = part.may_bend = false;
    figure.undistorted[i] = rest;
  }
}

// The pose as this head and its design take it.
Pose take_pose(const Figure& figure, const Pose& asked) {
  return redraw_pose(figure.redraw, limit_pose(figure, asked));
}

// The smooth skin over the posed cage in buffers.points, by its slots: into buffers.place_pairs and
// buffers.normal_pairs.
void deform_slots(const Figure& figure, const Surface& surface, const Pose& pose, const TurnKey& turn,
                  DeformBuffers& buffers) {
  const bool is_redrawn = figure.redraw.is_on();
  if (is_turned(turn) && !is_redrawn)
    turn_points(figure.face, turn, compute_turn(figure.face.turn_pivot, turn, 1), buffers.points);
  pair_points(buffers.points, surface.mirror, buffers.point_pairs);
  deform_pairs(surface, buffers.point_pairs, buffers.place_pairs);
  if (is_redrawn)
    redraw_slots(figure.redraw, compute_stretch(figure.redraw, pose), surface, figure.face, turn,
                 buffers.place_pairs);
  update_pair_normals(surface, buffers.place_pairs, buffers.normal_pairs);
}

// Hair of the scalp: it goes with the skull, a fringe that lies over a brow, too.
bool is_hair(const Part& part) {
  return part.name == "hair" || part.name == "hair_back" || part.name == "hair_mass";
}

void move_with_skull(const Mesh& rest, const glm::dmat4& world, PartShape& shape) {
  shape.positions.clear();
  shape.normals.clear();
  const glm::dmat3 turn = glm::transpose(glm::inverse(glm::dmat3(world)));
  for (const glm::vec3& p : rest.positions) shape.positions.emplace_back(world * glm::dvec4(p, 1));
  for (const glm::vec3& n : rest.normals) shape.normals.emplace_back(glm::normalize(turn * glm::dvec3(n)));
}

// A part that may bend: its vertices where it does, and none where it does not.
void place_bent(const Mesh& bent, const glm::dmat4& motion, bool is_bent, PartShape& shape) {
  shape.positions.clear();
  shape.normals.clear();
  if (!is_bent) return;
  const glm::dmat3 turn(motion);
  for (const glm::vec3& p : bent.positions)
    shape.positions.emplace_back(motion * glm::dvec4(glm::dvec3(p), 1));
  for (const glm::vec3& n : bent.normals) shape.normals.emplace_back(turn * glm::dvec3(n));
}

void unpack_skin(const std::vector<MirrorPair>& pairs, std::size_t count, const DeformBuffers& buffers,
                 PartShape& skin) {
  skin.positions.resize(count);
  skin.normals.resize(count);
  unpack_pairs(pairs, buffers.place_pairs, skin.positions);
  unpack_pairs(pairs, buffers.normal_pairs, skin.normals);
}

}  // namespace

Pose limit_pose(const Figure& figure, const Pose& asked) {
  return apply_limits(figure.limits, resolve_channels(figure.head.data->doctrines, asked));
}

glm::dmat4 compute_motion(const Figure& figure, Mount mount, const Pose& asked) {
  return find_motion(figure, mount, take_pose(figure, asked));
}

void deform_skin(const Figure& figure, const Surface& surface, const Pose& asked, const TurnKey& turn,
                 DeformBuffers& buffers, PartShape& skin) {
  const Pose pose = take_pose(figure, asked);
  pose_cage(figure.head, figure.face, pose, buffers.points);
  deform_slots(figure, surface, pose, turn, buffers);
  unpack_skin(surface.pairs, surface.vertex_count(), buffers, skin);
}

void deform_figure(const Figure& figure, const Pose& asked, const TurnKey& turn, DeformBuffers& buffers,
                   Drawing& drawing) {
  const Pose pose = take_pose(figure, asked);
  drawing.parts.resize(figure.parts.size());
  const bool is_neutral = pose == Pose{} && !is_turned(turn);
  const glm::dmat4 head_turn =
      is_turned(turn) ? compute_turn(figure.face.turn_pivot, turn, 1) : glm::dmat4(1);

  const double stretch = compute_stretch(figure.redraw, pose);
  const glm::dmat4 world = stretch == 0 ? head_turn : head_turn * compute_stretching(figure.redraw, stretch);
  pose_cage(figure.head, figure.face, pose, buffers.points);
  const bool has_bent = bend_tongue(figure.tongue, figure.face, pose, buffers.points, buffers.tongue);
  drawing.parts.front().paling = compute_paling(figure.face.red_border, buffers.points);
  deform_slots(figure, *figure.head.surface, pose, turn, buffers);
  for (std::size_t i = 1; i < figure.parts.size(); ++i) {
    const HeadPart& bound = figure.parts[i];
    const Part& part = figure.model.parts[i];
    PartShape& shape = drawing.parts[i];
    if (!part.is_rigid && bound.mount != Mount::strands) {
      redraw_part(figure.redraw, stretch,
                  has_bent && i == figure.tongue.part ? buffers.tongue : figure.undistorted[i],
                  find_motion(figure, bound.mount, pose), head_turn, shape);
    } else if (bound.mount != Mount::strands) {
      const glm::dmat4 motion = world * find_motion(figure, bound.mount, pose);
      shape.world_from_rest = glm::mat4(motion);
      if (part.may_bend) place_bent(buffers.tongue, motion, has_bent && i == figure.tongue.part, shape);
    } else if (figure.has_still_hair && is_hair(part)) {
      move_with_skull(part.rest, world, shape);
    } else if (is_neutral) {
      shape.positions = part.rest.positions;
      shape.normals = part.rest.normals;
    } else {
      shape.positions.resize(part.rest.positions.size());
      shape.normals.resize(part.rest.normals.size());
      place_hairs(figure.roots[i], buffers.place_pairs, buffers.normal_pairs, shape.positions.data(),
                  shape.normals.data());
    }
  }
  // Last: hairs stand on the smooth skin, whose normals do not shake.
  const FineSkin& fine = figure.folds.skin;
  append_fine_pairs(fine, buffers.place_pairs, buffers.normal_pairs);
  if (buffers.has_folds)
    press_folds(figure.folds, resolve_folds(figure.head.data->doctrines, pose), buffers.folds,
                buffers.place_pairs, buffers.normal_pairs);
  unpack_skin(fine.pairs, fine.vertex_count(), buffers, drawing.parts.front());
}

namespace {

// The whole figure at rest, as it is drawn.
void redraw_rest(Figure& figure) {
  redraw_parts(figure);
  DeformBuffers buffers;
  Drawing drawing;
  // The strands stand where they are bound; asked for the neutral pose they would be taken from the rest.
  pose_cage(figure.head, figure.face, take_pose(figure, Pose{}), buffers.points);
  deform_slots(figure, *figure.head.surface, take_pose(figure, Pose{}), TurnKey{}, buffers);
  unpack_pairs(figure.head.surface->pairs, buffers.place_pairs, figure.head.skin.positions);
  unpack_pairs(figure.head.surface->pairs, buffers.normal_pairs, figure.head.skin.normals);
  for (std::size_t i = 1; i < figure.parts.size(); ++i)
    if (figure.parts[i].mount == Mount::strands) {
      Mesh& rest = figure.model.parts[i].rest;
      place_hairs(figure.roots[i], buffers.place_pairs, buffers.normal_pairs, rest.positions.data(),
                  rest.normals.data());
    }
  deform_figure(figure, Pose{}, TurnKey{}, buffers, drawing);
  figure.model.parts.front().rest.positions = drawing.parts.front().positions;
  figure.model.parts.front().rest.normals = drawing.parts.front().normals;
}

}  // namespace

Figure build_figure(const HeadStock& stock, const HeadSpec& asked, FigureUse use) {
  HeadSpec spec = asked;
  spec.look = compute_aged_look(asked.look, asked.age);
  const bool is_print = use == FigureUse::print, is_ink = use == FigureUse::ink;
  Figure figure;
  figure.head = build_neutral_head(stock, spec);
  figure.limits = compute_limit_shares(spec.limits);
  figure.hair = spec.hair;
  // Independent of each other, the slow ones first.
  std::array<std::vector<HeadPart>, 7> made;
  std::vector<SkinTint> tints;
  std::vector<float> scalp;
  const std::array<std::function<void()>, 10> works{
      [&] { figure.face = build_face(figure.head); },
      [&] {
        if (is_print) return;
        const auto ground =
            share_stock_thing(stock, "fold ground", [&] { return build_fold_ground(figure.head); });
        figure.folds = build_folds(*ground, figure.head, spec);
      },
      [&] {
        made[0].push_back({is_print || is_ink ? build_plain_skin_part(figure.head, spec.look)
                                              : build_skin_part(figure.head, spec.look),
                           Mount::skin,
                           {}});
      },
      [&] {
        if (is_print) return;
        const auto places = share_stock_thing(stock, name_spot_places(spec.look, is_ink), [&] {
          return list_spot_places(figure.head, spec.look, is_ink);
        });
        made[5] = build_skin_spots(*places, figure.head, spec.look, is_ink);
      },
      [&] {
        if (is_print || is_ink) {
          made[4] = build_hair(figure.head, spec.hair, spec.look, is_ink);
        } else {
          WornHair hair = build_worn_hair(figure.head, spec.hair, spec.look);
          made[4] = std::move(hair.parts);
          scalp = std::move(hair.scalp);
        }
      },
      [&] {
        if (!is_print && !is_ink) tints = list_hair_tints(figure.head, spec);
      },
      [&] { made[6] = build_beard(figure.head, spec.look); },
      [&] {
        if (!is_ink) made[3] = build_hairs(figure.head, spec.look);
      },
      [&] { made[2] = is_ink ? build_drawn_mouth(figure.head) : build_mouth(figure.head, spec.look); },
      [&] {
        made[1] = is_ink ? build_ink_eyes(figure.head, spec.look) : build_eyes(figure.head, spec.look);
      }};
  for_each_index(works.size(), count_workers(), [&](std::size_t i, int) { works[i](); });
  if (spec.match_level) figure.face.match_level_mm = compute_length_mm(figure.face.units, *spec.match_level);
  if (spec.follows_thesis) follow_thesis(figure.head, figure.face);
  fit_limit_lengths(figure.head, figure.face, spec.limit_lengths, figure.limits);
  if (spec.follows_thesis) figure.face.brow_boxes = build_brow_boxes(figure.head, figure.face, figure.limits);
  tints.push_back({std::move(scalp), 0.8f * spec.look.hair});
  for (const SkinTint& tint : tints) tint_skin(made[0].front().part, tint.covers, tint.srgb);
  for (std::vector<HeadPart>& parts : made)
    for (HeadPart& part : parts) figure.parts.push_back(std::move(part));
  std::vector<std::uint32_t> half_of(figure.head.surface->vertex_count());
  for (std::uint32_t i = 0; i < figure.head.surface->pairs.size(); ++i) {
    half_of[figure.head.surface->pairs[i].right] = 2 * i + 1;
    half_of[figure.head.surface->pairs[i].left] = 2 * i;
  }
  for (const HeadPart& part : figure.parts) figure.roots.push_back(build_roots(part, figure.head, half_of));
  for (HeadPart& part : figure.parts) figure.model.parts.push_back(std::move(part.part));
  if (!is_print) refine_part(figure.folds.skin, figure.model.parts.front());
  if (!is_print) figure.tongue = build_tongue_rig(figure.head, figure.model);
  if (use == FigureUse::picture) paint_figure(stock, spec, figure);
  figure.redraw = build_redraw(figure.head, figure.face);
  if (is_print) {  // has one height, its lids are sliders of their own, and goes through its lens when all of
                   // it is carved
    figure.redraw.jaw_stretch = figure.redraw.brow_stretch = 0;
    figure.redraw.early = figure.redraw.lid_hood = 0;
    figure.redraw.lens = {};
  }
  if (figure.redraw.is_on()) redraw_rest(figure);
  figure.has_still_hair = is_ink;
  return figure;
}

}  // namespace mien
