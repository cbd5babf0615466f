#include "frames/bust_body.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/error.hpp"
#include "core/thin.hpp"
#include "frames/bust_foot.hpp"
#include "head/cage.hpp"
#include "head/lids.hpp"

namespace mien {

namespace {

// The relief's measures in mm of the print; in the comments' words.
constexpr float kBrowPerHeight = 0.5f / 80;   // standing out less, it is lost between two layers
constexpr float kLockPerHeight = 0.6f / 80;   // from lock to lock of the brow; finer would not print
constexpr float kIrisPerHeight = 0.45f / 80;  // a dish that throws a shadow
constexpr float kPupilPerHeight = 1.0f / 80;  // dark in every light
// Of shut lids and lips: narrower fills with plastic. Lips meet aslant, which takes a tenth.
constexpr float kLidLine_mm = 0.37f, kLipLine_mm = 0.34f;
constexpr float kLineDepth_mm = 0.7f;
constexpr float kWidestLine_mm = 2.2f;  // of the head: a low print's line must not gape
constexpr float kLight_mm = 1.1f;       // the width of the light in the pupil
constexpr float kLeastLight = 0.17f,
                kMostLight = 0.32f;     // half of it in radii of the iris: more fills the pupil
constexpr float kIrisRadius_mm = 5.7f;  // at a ball of 13 mm

std::size_t side_index(Side side) { return side == Side::left ? 0 : 1; }

std::vector<Mesh> list_brows(const Model& model) {
  std::vector<Mesh> brows;
  for (const Part& part : model.parts)
    if (part.name == "brow_left" || part.name == "brow_right") brows.push_back(part.rest);
  return brows;
}

// The loop that reaches lowest is the chest's edge.
std::size_t compute_chest(const Mesh& mesh, const std::vector<Loop>& loops) {
  const auto lowest = [&](const Loop& loop) {
    float y = mesh.positions[loop.front()].y;
    for (const std::uint32_t v : loop) y = std::min(y, mesh.positions[v].y);
    return y;
  };
  const auto found = std::min_element(loops.begin(), loops.end(),
                                      [&](const Loop& a, const Loop& b) { return lowest(a) < lowest(b); });
  return static_cast<std::size_t>(found - loops.begin());
}

// All vertices in a pose, mm of the head.
std::vector<glm::vec3> place_all(const BustBody& body, const Figure& figure, const Pose& pose, Stand stand) {
  DeformBuffers buffers;
  PartShape skin;  // without folds: layers are as thick as they are deep, and they would come out as specks
  deform_skin(figure, body.surface ? *body.surface : *figure.head.surface, pose, {}, buffers, skin);
  std::vector<glm::vec3> positions = std::move(skin.positions);
  for (std::size_t i = 0; i < 2; ++i) part_slit(body.eye_slits[i], body.eye_slit_mm, positions);
  part_slit(body.mouth_slit, body.mouth_slit_mm, positions);
  raise_brows(body.brows, positions, skin.normals);
  positions.resize(body.all_count);
  const std::array<CarvedEye, 2> eyes = compute_carved_eyes(body, figure, pose);
  for (std::size_t i = 0; i < 2; ++i)
    place_patch(
        body.all_eyes[i], [&](const PatchPlace& at) { return place_on_eye(eyes[i], at); }, positions);
  const CarvedMouth mouth = compute_carved_mouth(body, figure, pose);
  place_patch(
      body.all_mouth, [&](const PatchPlace& at) { return place_in_mouth(mouth, at); }, positions);
  place_foot(body.chest, body.first_foot, stand, positions);
  place_hair(body.hair, positions);
  return positions;
}

std::vector<glm::vec3> compute_print(const BustBody& body, const std::vector<glm::vec3>& all) {
  std::vector<glm::vec3> print;
  print.reserve(body.kept.size());
  for (const std::uint32_t v : body.kept) {
    const glm::vec3 at = (all[v] - body.origin) * body.print_per_head;
    print.emplace_back(at.x, -at.z, at.y);
  }
  if (!body.thicker.empty())
    for (std::size_t v = 0; v < print.size(); ++v) print[v] += body.thicker[v];
  return print;
}

// The skin without what lies inside mouth and eyes, finer under the brows, with all patches, the foot and
// the hair, if there is any.
Mesh build_all(const Figure& figure, float mm_of_print, const std::optional<HairRelief>& hair,
               BustBody& body) {
  const NeutralHead& head = figure.head;
  body.eye_slits = {compute_eye_slit(head, 1), compute_eye_slit(head, -1)};
  body.mouth_slit = compute_mouth_slit(head);
  Mesh mesh = head.skin;
  const std::uint32_t socket = find_point(head.cage, "EB_0");
  cut_slit(mesh, body.eye_slits[0], socket);
  cut_slit(mesh, body.eye_slits[1], head.cage.mirror[socket]);
  cut_slit(mesh, body.mouth_slit, find_point(head.cage, "MB2_0"));
  for (Slit& slit : body.eye_slits) spread_slit(mesh, 2.5f, 7, slit);
  spread_slit(mesh, 5, 11, body.mouth_slit);
  body.brows = refine_brows(mesh, list_brows(figure.model),
                            {kBrowPerHeight * mm_of_print, kLockPerHeight * mm_of_print});
  mesh.normals.clear();
  const std::size_t skin_count = mesh.positions.size();
  for (std::size_t i = 0; i < 2; ++i) body.all_eyes[i] = append_patch(mesh, body.eye_slits[i]);
  body.all_mouth = append_patch(mesh, body.mouth_slit);

  const std::vector<Loop> loops = find_boundary_loops(mesh.triangles);
  if (loops.empty()) throw RunError("internal: the skin has no edge to stand on");
  const std::size_t chest = compute_chest(mesh, loops);
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (i != chest) append_ear_cap(mesh, loops[i]);
  body.chest = loops[chest];
  body.first_foot = static_cast<std::uint32_t>(mesh.positions.size());
  Loop above = body.chest;
  for (int ring = 0; ring < kFootRings; ++ring) {
    Loop below;
    for (std::size_t i = 0; i < above.size(); ++i) {
      below.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.emplace_back(0);
    }
    append_band(mesh, above, below);
    above = below;
  }
  body.foot = above;
  if (hair) body.hair = append_hair(head, *hair, skin_count, 1 / body.print_per_head, mesh);
  body.all_count = mesh.positions.size();
  return mesh;
}

void measure_carving(const Figure& figure, double whole_mm, float mm_of_print, BustBody& body) {
  const float per_mm = mm_of_print / float(whole_mm);  // mm of the head for one of the print
  body.eye_slit_mm = std::min(kLidLine_mm * per_mm, kWidestLine_mm);
  body.mouth_slit_mm = std::min(kLipLine_mm * per_mm, kWidestLine_mm);
  for (std::size_t i = 0; i < 2; ++i) {
    CarvedEye& eye = body.carved[i];
    eye.centre = glm::vec3(figure.head.eye.centre) * glm::vec3(i == 0 ? 1 : -1, 1, 1);
    eye.radius_mm = static_cast<float>(figure.head.eye.radius_mm);
    eye.iris_mm = kIrisRadius_mm * eye.radius_mm / 13;
    for (const Part& part : figure.model.parts)
      if (part.name == (i == 0 ? "iris_left" : "iris_right")) {
        const Box box = compute_bounds(part.rest.positions);
        eye.iris_mm = (box.high.y - box.low.y) / 2;
      }
    const float deepest = eye.radius_mm * 0.6f;  // a low print must not be bored through
    eye.iris_depth_mm = std::min(kIrisPerHeight * mm_of_print, deepest / 2);
    eye.pupil_depth_mm = std::min(kPupilPerHeight * mm_of_print, deepest);
    eye.light = std::clamp(kLight_mm / 2 * per_mm / eye.iris_mm, kLeastLight, kMostLight);
    eye.slit_mm = body.eye_slit_mm;
    eye.line_mm = std::min(kLineDepth_mm * per_mm, deepest / 2);
  }
  body.carved_mouth = build_carved_mouth(figure.model);
  body.carved_mouth.line_mm = std::min(kLineDepth_mm * per_mm, 4.0f);
}

// Poses that together show where triangles are needed: each area at its ends, no two of one area at once.
std::vector<Pose> list_extreme_poses() {
  std::vector<Pose> poses(1);
  const auto set = [](Pose& pose, std::string_view area, std::string_view move, double value) {
    for (std::size_t i = 0; i < kMoveCount; ++i)
      if (kMoves[i].area == area && kMoves[i].move == move) pose.values[i] = value;
  };
  const auto add = [&](std::initializer_list<std::tuple<std::string_view, std::string_view, double>> moves) {
    Pose pose;
    for (const auto& [area, move, value] : moves) set(pose, area, move, value);
    poses.push_back(pose);
  };
  add({{"brow", "up", 1}, {"lid", "upper", -1}, {"corner", "up", 1}, {"corner", "out", 1}});
  add({{"brow", "up", -1}, {"brow", "turn", -1}, {"lid", "upper", 1}, {"chin", "down", 1}});
  add({{"brow", "turn", 1}, {"lid", "lower", 1}, {"corner", "out", -1}, {"lips", "press", 1}});
  add({{"corner", "up", -1}, {"lips", "upper", 1}, {"lips", "lower", -1}, {"lid", "upper", -0.5}});
  return poses;
}

Patch find_kept(const Patch& patch, const std::vector<std::uint32_t>& new_index) {
  Patch kept = patch;
  for (std::uint32_t& v : kept.upper) v = new_index[v];
  for (std::uint32_t& v : kept.lower) v = new_index[v];
  kept.first = new_index[patch.first];
  return kept;
}

// Patches, rims and the chest's edge stay whole: formulas go along them.
std::vector<bool> list_locked(const BustBody& body) {
  std::vector<bool> is_locked(body.all_count, false);
  for (const Patch* patch : {&body.all_eyes[0], &body.all_eyes[1], &body.all_mouth}) {
    for (const std::uint32_t v : patch->upper) is_locked[v] = true;
    for (const std::uint32_t v : patch->lower) is_locked[v] = true;
    for (std::uint32_t i = 0; i < patch->vertex_count(); ++i) is_locked[patch->first + i] = true;
  }
  return is_locked;
}

// What the skin's other vertices do is of no account once the body is thinned.
void leave_out_skin(const Figure& figure, std::vector<bool> is_kept, BustBody& body) {
  leave_out_hair(body.hair, std::vector<bool>(is_kept), is_kept);
  leave_out_brows(body.brows, is_kept);
  std::vector<bool> is_wanted(is_kept.begin(),
                              is_kept.begin() + static_cast<std::ptrdiff_t>(body.brows.skin_count));
  std::vector<bool> has_normal(is_wanted.size(), false);
  for (std::size_t i = 0; i < body.brows.ends.size(); ++i)
    if (!body.brows.is_left_out[i])
      for (const std::uint32_t v : body.brows.ends[i])
        if (v < has_normal.size()) has_normal[v] = true;
  for (const auto& [v, height] : body.brows.heights)
    if (v < has_normal.size()) has_normal[v] = true;
  for (const Slit* slit : {&body.eye_slits[0], &body.eye_slits[1], &body.mouth_slit}) {
    for (const SlitVertex& v : slit->vertices) is_wanted[v.vertex] = true;
    for (const SlitColumn& column : slit->columns)
      for (const auto* rows : {&column.upper, &column.lower})
        for (const std::uint32_t v : *rows) is_wanted[v] = true;
  }
  for (const std::uint32_t v : body.chest) is_wanted[v] = true;
  body.surface = std::make_shared<const Surface>(
      select_vertices(*figure.head.surface, std::move(is_wanted), has_normal));
}

void thin_body(const Figure& figure, std::size_t most, std::vector<Triangle> triangles, BustBody& body) {
  std::vector<std::vector<glm::vec3>> poses;
  for (const Pose& pose : list_extreme_poses()) poses.push_back(place_all(body, figure, pose, body.stand));
  triangles = thin_posed(poses, std::move(triangles), list_locked(body), most);
  std::vector<bool> is_kept(body.all_count, false);
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t) is_kept[v] = true;
  leave_out_skin(figure, is_kept, body);
  std::vector<std::uint32_t> new_index(body.all_count, 0);
  for (std::uint32_t v = 0; v < body.all_count; ++v) {
    new_index[v] = static_cast<std::uint32_t>(body.kept.size());
    if (is_kept[v]) body.kept.push_back(v);
  }
  for (Triangle& t : triangles)
    for (std::uint32_t& v : t) v = new_index[v];
  body.triangles = std::move(triangles);
  for (std::uint32_t& v : body.foot) v = new_index[v];
  body.first_hair = static_cast<std::uint32_t>(
      std::ranges::lower_bound(body.kept, body.hair.is_on() ? body.hair.first_of_mass() : body.all_count) -
      body.kept.begin());
  for (std::size_t i = 0; i < 2; ++i) body.eyes[i] = find_kept(body.all_eyes[i], new_index);
  body.mouth = find_kept(body.all_mouth, new_index);
}

}  // namespace

std::array<CarvedEye, 2> compute_carved_eyes(const BustBody& body, const Figure& figure, const Pose& asked) {
  const Pose pose = limit_pose(figure, asked);
  std::array<CarvedEye, 2> eyes = body.carved;
  for (const Side side : {Side::left, Side::right})
    eyes[side_index(side)].gaze = glm::vec3(compute_gaze(figure.face, pose, side) * glm::dvec3(0, 0, 1));
  return eyes;
}

CarvedMouth compute_carved_mouth(const BustBody& body, const Figure& figure, const Pose& posed) {
  // The relief behind the lips opens and shuts, and does not slide.
  Pose pose = limit_pose(figure, posed);
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (kMoves[i].of == Area::jaw) pose.values[i] = 0;
  return move_jaw(body.carved_mouth, glm::mat4(compute_jaw(figure.face, pose)));
}

bool wears_hair(const Figure& figure) {
  return build_lens(figure.head).is_on() && has_hair_mass(figure.head, figure.hair);
}

namespace {

BustBody build_body(const Figure& figure, const BustSize& size, bool has_hair) {
  BustBody body;
  // The skin's own height and its hair's decide the scale; the foot's is a part of it.
  const Box box = compute_bounds(figure.head.skin.positions);
  const std::vector<Loop> edges = find_boundary_loops(figure.head.skin.triangles);
  const Loop& chest = edges[compute_chest(figure.head.skin, edges)];
  const ChestBox foot = measure_chest(chest, figure.head.skin.positions);
  body.stand = size.stand;
  body.lens = build_lens(figure.head);
  body.origin = foot.middle;
  if (size.stand == Stand::flat) body.origin.y = compute_flat_y(foot);
  float top = box.high.y;
  std::optional<HairRelief> hair;
  if (has_hair) {
    constexpr double kHigher = 1.04;  // with hair
    HairSurroundings around;
    for (const std::uint32_t v : chest) around.chest.push_back(figure.head.skin.positions[v]);
    for (const glm::vec3& lid : find_named_ring(figure.head, "E2_", 0, 15))
      for (const float side : {1.0f, -1.0f}) around.face.emplace_back(side * lid.x, lid.y, lid.z);
    for (const Mesh& brow : list_brows(figure.model))
      around.face.insert(around.face.end(), brow.positions.begin(), brow.positions.end());
    hair =
        build_hair_relief(figure.head, figure.hair, around, kHigher * (top - body.origin.y) / size.figure_mm);
    top = std::max(top, float(hair->top_mm));
  }
  body.print_per_head = float(size.figure_mm) / (top - body.origin.y);
  const float mm_of_print = float(size.whole_mm) / body.print_per_head;
  measure_carving(figure, size.whole_mm, mm_of_print, body);
  const Mesh all = build_all(figure, mm_of_print, hair, body);
  if (has_hair && !body.hair.is_on()) return body;
  thin_body(figure, size.triangles, all.triangles, body);
  body.relax = build_bust_relax(body.triangles, list_fixed(body));
  return body;
}

}  // namespace

BustBody build_bust_body(const Figure& figure, const BustSize& size) {
  if (wears_hair(figure))
    if (BustBody body = build_body(figure, size, true); body.hair.is_on()) return body;
  return build_body(figure, size, false);
}

std::vector<bool> list_fixed(const BustBody& body) {
  std::vector<bool> is_fixed(body.kept.size(), false);
  for (const Patch* patch : {&body.eyes[0], &body.eyes[1], &body.mouth}) {
    for (const std::uint32_t v : patch->upper) is_fixed[v] = true;
    for (const std::uint32_t v : patch->lower) is_fixed[v] = true;
    std::fill_n(is_fixed.begin() + patch->first, patch->vertex_count(), true);
  }
  for (const std::uint32_t v : body.foot) is_fixed[v] = true;
  return is_fixed;
}

std::vector<glm::vec3> place_straight(const BustBody& body, const Figure& figure, const Pose& pose,
                                      Stand stand) {
  std::vector<glm::vec3> print = compute_print(body, place_all(body, figure, pose, stand));
  if (body.lens.is_on())
    relax_crossings(
        body.relax, body.triangles, [&](std::vector<glm::vec3>& bent) { bend_print(body, bent); }, print);
  return print;
}

std::vector<glm::vec3> place_straight(const BustBody& body, const Figure& figure, const Pose& pose) {
  return place_straight(body, figure, pose, body.stand);
}

void bend_print(const BustBody& body, std::vector<glm::vec3>& print) {
  if (!body.lens.is_on()) return;
  const double scale = body.print_per_head;
  for (glm::vec3& p : print) {
    const glm::dvec3 at = glm::dvec3(p.x, p.z, -p.y) / scale + glm::dvec3(body.origin),
                     bent = (bend(body.lens, at) - glm::dvec3(body.origin)) * scale;
    p = {bent.x, -bent.z, bent.y};
  }
}

void relax_print(const BustBody& body, std::vector<glm::vec3>& print) {
  if (!body.lens.is_on())
    relax_crossings(
        body.relax, body.triangles, [](std::vector<glm::vec3>&) {}, print);
}

std::vector<glm::vec3> place_bust(const BustBody& body, const Figure& figure, const Pose& pose, Stand stand) {
  std::vector<glm::vec3> print = place_straight(body, figure, pose, stand);
  bend_print(body, print);
  return print;
}

std::vector<glm::vec3> place_bust(const BustBody& body, const Figure& figure, const Pose& pose) {
  return place_bust(body, figure, pose, body.stand);
}

}  // namespace mien
