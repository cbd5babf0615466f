#include "frames/ink.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/smooth.hpp"
#include "frames/ink_hair.hpp"
#include "frames/ink_profile.hpp"
#include "frames/ink_strokes.hpp"

namespace mien {

namespace {

void shift(const glm::vec3& way, PartShape& shape) {
  for (glm::vec3& p : shape.positions) p += way;
  if (shape.positions.empty()) shape.world_from_rest[3] += glm::vec4(way, 0);
}

// Between the lips' middles, on an adult's head.
float measure_gap_mm(const Ink& ink, const std::vector<glm::vec3>& skin) {
  return glm::distance(skin[ink.lips[0]], skin[ink.lips[1]]) / ink.eye_size;
}

// The lower teeth and their gum, which are as dark as the mouth, would leave their scallops on the tongue:
// all three lie lower, or it would fill the mouth. One that comes out lies where it did.
void sink_lower_teeth(const Ink& ink, const Pose& pose, float gap_mm, Drawing& drawing) {
  constexpr float kDown = 0.6f, kBack = 0.2f, kTongue = 0.4f;  // of the upper ones' height
  // Between lips that are parted and no more it is not seen: it would be a wedge of red at their corner.
  constexpr float kLower = 0.35f, kShut_mm = 1, kParted_mm = 7, kWide_mm = 15;
  const float parted = smooth_step(kShut_mm, kParted_mm, gap_mm) - smooth_step(kParted_mm, kWide_mm, gap_mm);
  const auto out = static_cast<float>(pose.values[*find_move(Area::tongue, Side::none, "out")]);
  const float sunk = (1 - std::clamp(out, 0.0f, 1.0f)) * (kTongue + kLower * parted);
  PartShape& tongue = drawing.parts[ink.tongue];
  shift(-sunk * ink.teeth_high_mm * glm::vec3(tongue.world_from_rest[1]), tongue);
  for (const std::size_t part : ink.lower) {
    PartShape& shape = drawing.parts[part];
    const glm::vec3 up(shape.world_from_rest[1]), forward(shape.world_from_rest[2]);
    shift(-ink.teeth_high_mm * (kDown * up + kBack * forward), shape);
  }
}

// Brings the ends of teeth nearer to their gum, along their own way up. What is drawn as a whole stays a
// body: POV-Ray undoes its transform.
void draw_in(const Ink& ink, float share, PartShape& teeth) {
  constexpr float kLeast = 0.02f;
  if (teeth.positions.empty()) {
    glm::mat4& world = teeth.world_from_rest;
    world = glm::translate(world, glm::vec3(0, ink.teeth_top_mm, 0));
    world = glm::scale(world, glm::vec3(1, std::max(kLeast, 1 - share), 1));
    world = glm::translate(world, glm::vec3(0, -ink.teeth_top_mm, 0));
    return;
  }
  const glm::vec3 up = glm::normalize(glm::vec3(teeth.world_from_rest[1]));
  float top = -INFINITY;
  for (const glm::vec3& p : teeth.positions) top = std::max(top, glm::dot(p, up));
  for (glm::vec3& p : teeth.positions) p += share * (top - glm::dot(p, up)) * up;
}

// Between lips that part a little a drawing has a dark line, and no slivers of teeth and tongue.
void hide_teeth(const Ink& ink, float gap_mm, Drawing& drawing) {
  constexpr float kHidden_mm = 4.0f, kShown_mm = 6.0f;  // between an adult's lips
  constexpr float kUp = 0.35f, kBack = 0.35f;  // of the teeth's height: more, and the tongue comes out below
  const float hidden = 1 - smooth_step(kHidden_mm, kShown_mm, gap_mm);
  if (hidden == 0) return;
  const glm::mat4& skull = drawing.parts[ink.teeth].world_from_rest;
  const glm::vec3 up(skull[1]), forward(skull[2]);
  for (const std::size_t part : {ink.teeth, ink.gum}) draw_in(ink, hidden, drawing.parts[part]);
  shift(hidden * ink.teeth_high_mm * (-kUp * up - kBack * forward), drawing.parts[ink.tongue]);
}

// What closes the slit of shut lips would be a dark strip below those that part, and before them in profile.
void lift_veil(float parted, std::vector<glm::vec3>& veil) {
  const Box box = compute_bounds(veil);
  const glm::vec3 middle = 0.5f * (box.low + box.high);
  for (glm::vec3& p : veil) p = glm::mix(p, middle, parted);
}

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
  constexpr float kMet_mm = 1.2f, kParted_mm = 3, kSlit_mm = 4, kOpen_mm = 8;  // between an adult's lips
  drawing.parts.resize(ink.model.parts.size());
  PartShape& skin = drawing.parts.front();
  const InkSight sight = measure_sight(ink, view, skin.positions);
  const float beside = sight.beside;
  const float gap_mm = measure_gap_mm(ink, skin.positions), parted = smooth_step(kMet_mm, kParted_mm, gap_mm);
  widen_features(ink, beside, parted, drawing);
  buffers.soft = skin.normals;
  soften(ink, kHullRounds, buffers.soft, buffers.turn);
  make_unit(buffers.soft);
  compute_tones(*ink.tone, buffers.soft, buffers.tone, buffers.tones);

  hide_teeth(ink, gap_mm, drawing);
  hang_teeth(ink, beside, drawing);
  lift_veil(parted, drawing.parts[ink.veil].positions);
  sink_lower_teeth(ink, asked, gap_mm, drawing);

  PartShape& caster = drawing.parts[ink.caster];
  caster.positions.resize(ink.model.parts[ink.caster].rest.positions.size());
  for (std::size_t v = 0; v < caster.positions.size(); ++v)
    caster.positions[v] =
        skin.positions[v] - std::lerp(ink.below_mm[v], ink.below_beside_mm[v], beside) * buffers.tones[v];

  lift_tones(ink, beside, glm::vec3(view.to_light), buffers.tones);
  place_mouth_sheet(ink, beside * parted, 1 - smooth_step(kSlit_mm, kOpen_mm, gap_mm), skin.positions,
                    drawing.parts[ink.sheet]);
  std::size_t next = ink.first_outline;
  {  // before the skin gets the vertices of its borders
    PartShape& outline = drawing.parts[next++];
    clear_shape(outline);
    buffers.turn.resize(skin.positions.size());
    buffers.thick.clear();
    for (std::size_t v = 0; v < skin.positions.size(); ++v) {
      const float share =
          std::lerp(ink.hull[v], ink.hull_beside[v], beside) * (1 - sight.faced * ink.folded[v]);
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
  const DoctrineData& doctrines = ink.data->doctrines;
  const Pose pose = resolve_folds(
      doctrines, redraw_pose(ink.redraw, apply_limits(ink.limits, resolve_channels(doctrines, asked))));
  const auto measure_amount = [&](const InkStroke& stroke) {
    const Side side = stroke.side < 0 ? Side::right : Side::left;
    const double shown = stroke.rule.is_of_front ? 1.0 - beside : 1.0;
    if (stroke.fold) return shown * compute_fold_amount(ink.folds[*stroke.fold], pose, side);
    return stroke.rule.is_seam ? static_cast<double>(parted) : shown;
  };
  const StrokeGround ground{skin.positions, buffers.soft, glm::vec3(view.camera_mm),
                            view.line_mm,   ink.eye_size, beside,
                            1 - parted};
  for (const InkStroke& stroke : ink.strokes)
    if (!stroke.rule.is_on_hair)
      append_stroke(stroke, measure_amount(stroke), ground, (stroke.rule.is_brow ? brows : lines).positions);

  skin.normals = buffers.tones;
  for (const auto& [from, to, share] : ink.cuts) {
    skin.positions.push_back(glm::mix(skin.positions[from], skin.positions[to], share));
    skin.normals.push_back(glm::normalize(glm::mix(skin.normals[from], skin.normals[to], share)));
  }
}

}  // namespace mien
