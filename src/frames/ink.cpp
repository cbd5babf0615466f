#include "frames/ink.hpp"

#include <algorithm>
#include <cmath>

#include "core/smooth.hpp"
#include "frames/ink_cornea.hpp"
#include "frames/ink_hair.hpp"
#include "frames/ink_mouth.hpp"
#include "frames/ink_profile.hpp"
#include "frames/ink_strokes.hpp"

namespace mien {

namespace {

// Rounds of going half the way to the neighbours' mean.
void soften(const Ink& ink, int rounds, std::vector<glm::vec3>& normals, std::vector<glm::vec3>& buffer) {
  buffer.resize(normals.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t v = 0; v < normals.size(); ++v) {
      const std::uint32_t first = ink.first[v], last = ink.first[v + 1];
      glm::vec3 sum(0);
      for (std::uint32_t k = first; k < last; ++k) sum += normals[ink.around[k]];
      buffer[v] = 0.5f * normals[v] + sum * (0.5f / static_cast<float>(std::max(1u, last - first)));
    }
    normals.swap(buffer);
  }
}

void make_unit(std::vector<glm::vec3>& normals) {
  for (glm::vec3& n : normals) n = glm::normalize(n + glm::vec3(0, 0, 1e-9f));
}

// The triangles of a hull that face away from the camera, with the vertices they use. A thread of a line
// would be a row of dots.
void append_away(const InkView& view, const std::vector<Triangle>& triangles, InkBuffers& buffers,
                 const std::vector<glm::vec3>& hull, PartShape& shape) {
  constexpr auto kUnused = static_cast<std::uint32_t>(-1);
  constexpr float kThread = 0.3f;
  const glm::vec3 camera(view.camera_mm);
  buffers.used.assign(hull.size(), kUnused);
  for (const Triangle& t : triangles) {
    if (std::max({buffers.thick[t[0]], buffers.thick[t[1]], buffers.thick[t[2]]}) < kThread) continue;
    const glm::vec3 &a = hull[t[0]], &b = hull[t[1]], &c = hull[t[2]];
    if (glm::dot(a - camera, glm::cross(b - a, c - a)) <= 0) continue;
    Triangle own;
    for (int i = 0; i < 3; ++i) {
      std::uint32_t& used = buffers.used[t[i]];
      if (used == kUnused) {
        used = static_cast<std::uint32_t>(shape.positions.size());
        shape.positions.push_back(hull[t[i]]);
      }
      own[i] = used;
    }
    shape.triangles.push_back(own);
  }
}

// How thick an outline is where the surface looks along `normal`: more on the side of the shade.
float find_thickness(const InkView& view, const glm::vec3& normal) {
  constexpr float kLit = 0.7f, kShaded = 1.0f;
  const float away = -glm::dot(normal, glm::vec3(view.to_light));
  return static_cast<float>(view.line_mm) * (kLit + kShaded * smooth_step(-0.2f, 0.9f, away));
}

void clear_shape(PartShape& shape) {
  shape.positions.clear();
  shape.normals.clear();
  shape.triangles.clear();
}

}  // namespace

void draw_ink(const Ink& ink, const Pose& asked, const InkView& view, InkBuffers& buffers, Drawing& drawing) {
  constexpr int kHullRounds = 4;
  drawing.parts.resize(ink.model.parts.size());
  PartShape& skin = drawing.parts.front();
  const DoctrineData& doctrines = ink.data->doctrines;
  const Pose pose = resolve_folds(
      doctrines, redraw_pose(ink.redraw, apply_limits(ink.limits, resolve_channels(doctrines, asked))));
  const InkSight sight = measure_sight(ink, view, drawing);
  const float beside = sight.beside;
  const InkMouth mouth = measure_mouth(ink, skin.positions);
  const float parted = mouth.parted;
  const std::array<float, 2> slits{measure_slit(ink, skin.positions, 0),
                                   measure_slit(ink, skin.positions, 1)};
  part_lids(ink, beside, slits, drawing);
  widen_features(ink, beside, parted, drawing);
  round_far_corner(ink, pose, sight, mouth, drawing);
  round_profile(ink, sight, mouth, drawing);
  lift_corners(ink, pose, sight, drawing);
  flatten_cheeks(ink, pose, sight, drawing);
  buffers.soft = skin.normals;
  soften(ink, kHullRounds, buffers.soft, buffers.turn);
  make_unit(buffers.soft);
  constexpr float kLevel = 0.15f, kBelow = 0.4f;    // sines of the camera's way below
  constexpr float kFront = 0.13f, kTurned = 0.25f;  // and round the head
  const float below = smooth_step(kLevel, kBelow, sight.below);
  const float turned = ink.redraw.lens.is_on()
                           ? smooth_step(kFront, kTurned, std::abs(sight.aside)) * (1 - below) * (1 - beside)
                           : 0;
  compute_tones(*ink.tone, turned, buffers.soft, buffers.tone, buffers.tones);
  draw_mouth(ink, asked, sight, mouth, view.line_mm, drawing);

  // Seen from below a nose would cast a chip beside its nostril.
  const float deeper = ink.redraw.lens.is_on() ? std::max(beside, below) : beside;
  PartShape& caster = drawing.parts[ink.caster];
  caster.positions.resize(ink.model.parts[ink.caster].rest.positions.size());
  for (std::size_t v = 0; v < caster.positions.size(); ++v)
    caster.positions[v] =
        skin.positions[v] - std::lerp(ink.below_mm[v], ink.below_beside_mm[v], deeper) * buffers.tones[v];

  lift_tones(ink, sight, glm::vec3(view.to_light), buffers.tones);
  std::size_t next = ink.first_outline;
  constexpr float kWithin = 0.6f, kOutline = 0.75f;  // sines: there lips and nose are the head's edge
  const float turned_out = smooth_step(kWithin, kOutline, std::abs(sight.aside));
  constexpr float kFarCheek = 0.38f, kFarEdge = 0.52f;  // there the far corner of a mouth is
  const float far_out = smooth_step(kFarCheek, kFarEdge, std::abs(sight.aside)) * (1 - beside);
  {  // before the skin gets the vertices of its borders
    PartShape& outline = drawing.parts[next++];
    clear_shape(outline);
    buffers.turn.resize(skin.positions.size());
    buffers.thick.clear();
    for (std::size_t v = 0; v < skin.positions.size(); ++v) {
      const float faced_or_turned = std::lerp(ink.hull_faced[v], ink.hull_turned[v], turned_out);
      const float far =
          ink.model.parts.front().rest.positions[v].x * sight.aside < 0 ? far_out * ink.beside_mouth[v] : 0;
      const float share = std::max(far, std::lerp(faced_or_turned, ink.hull_beside[v], beside)) *
                          (1 - sight.faced * ink.folded[v]) * (1 - below * ink.button[v]);
      buffers.thick.push_back(share);
      buffers.turn[v] = skin.positions[v] + share * find_thickness(view, buffers.tones[v]) * buffers.soft[v];
    }
    append_away(view, ink.hull_triangles, buffers, buffers.turn, outline);
  }
  const Box hair_ball =
      ink.outlined.empty() ? Box{} : compute_bounds(drawing.parts[ink.outlined.front()].positions);
  const glm::vec3 hair_middle = 0.5f * (hair_ball.low + hair_ball.high);
  std::size_t index = 0;
  for (const std::size_t part : ink.outlined) {
    // What is drawn behind hair is all of it, larger by a line: thin locks have no far side that a hull would
    // need. A fringe comes nearer on the way that it is seen on, before the forehead and what is drawn there:
    // whatever a brow does, it looks the same.
    constexpr float kHair = 1.0f;     // of a line
    constexpr float kBehind_mm = 16;  // nearer, and it shows inside the outline of what is round
    constexpr float kBefore_mm = 21;
    constexpr float kAside = 0.15f, kFaced = 0.8f;  // where the ball looks toward the camera: cosines
    PartShape& shape = drawing.parts[part];
    PartShape& outline = drawing.parts[next++];
    clear_shape(outline);
    buffers.turn.resize(shape.positions.size());
    const std::vector<float>& before = ink.before[index++];
    if (ink.model.parts[part].name == "hair_mass") tuck_far_lock(ink, sight, drawing, shape.positions);
    for (std::size_t v = 0; v < shape.positions.size(); ++v) {
      const glm::vec3 way = glm::normalize(shape.positions[v] - glm::vec3(view.camera_mm));
      const glm::vec3 aside = shape.normals[v] - glm::dot(shape.normals[v], way) * way;
      const glm::vec3 out = shape.positions[v] - hair_middle;
      const float faced = -(out.x * way.x + out.z * way.z) / std::max(1e-3f, std::hypot(out.x, out.z));
      shape.positions[v] -= kBefore_mm * before[v] * smooth_step(kAside, kFaced, faced) * way;
      buffers.turn[v] =
          shape.positions[v] + kBehind_mm * way +
          kHair * static_cast<float>(view.line_mm) * aside / std::max(glm::length(aside), 1e-4f);
    }
    outline.positions = buffers.turn;
    outline.triangles = ink.model.parts[part].rest.triangles;
    if (ink.model.parts[part].name == "hair_mass") {
      const StrokeGround ground{shape.positions, shape.normals, glm::vec3(view.camera_mm), view.line_mm, 1};
      clear_shape(drawing.parts.back());
      for (const InkStroke& stroke : ink.strokes)
        if (stroke.rule.is_on_hair)
          append_hair_line(stroke, ground, hair_middle, drawing.parts.back().positions);
    }
    round_hair(hair_ball, glm::vec3(view.camera_mm), shape.positions, shape.normals);
  }
  PartShape &lines = drawing.parts[next++], &brows = drawing.parts[next++];
  clear_shape(lines);
  clear_shape(brows);
  constexpr float kNear = 0.3f, kFar = 0.5f;  // sines: so far round the head a nose hides the fold behind it
  constexpr float kSlant = 0.5f, kRound = 0.72f;  // and so far a forehead goes round its far side
  constexpr double kThinner = 0.5;
  const auto measure_amount = [&](const InkStroke& stroke) {
    const Side side = stroke.side < 0 ? Side::right : Side::left;
    const double shown = stroke.rule.is_of_front ? 1.0 - beside : 1.0;
    const bool is_lifted = stroke.rule.is_of_level && ink.redraw.lens.is_on();
    const double level = is_lifted ? 1.0 - below : 1.0;
    const float behind = -stroke.side * sight.aside;
    const double near = is_lifted                ? 1.0 - smooth_step(kNear, kFar, behind)
                        : stroke.rule.is_of_near ? 1.0 - smooth_step(kSlant, kRound, behind)
                                                 : 1.0;
    if (stroke.rule.is_of_lid) return 1.0 - kThinner * beside * slits[stroke.side < 0 ? 1 : 0];
    if (stroke.fold) return level * near * shown * compute_fold_amount(ink.folds[*stroke.fold], pose, side);
    return stroke.rule.is_seam ? static_cast<double>(parted) : shown;
  };
  const StrokeGround ground{skin.positions, buffers.soft, glm::vec3(view.camera_mm),
                            view.line_mm,   ink.eye_size, beside,
                            1 - parted,     below};
  for (const InkStroke& stroke : ink.strokes)
    if (!stroke.rule.is_on_hair)
      append_stroke(stroke, measure_amount(stroke), ground, (stroke.rule.is_brow ? brows : lines).positions);
  append_cornea(ink, sight, view.line_mm, drawing, lines.positions);

  skin.normals = buffers.tones;
  for (const auto& [from, to, share] : ink.cuts) {
    skin.positions.push_back(glm::mix(skin.positions[from], skin.positions[to], share));
    skin.normals.push_back(glm::normalize(glm::mix(skin.normals[from], skin.normals[to], share)));
  }
}

}  // namespace mien
