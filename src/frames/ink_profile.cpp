#include "frames/ink_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/smooth.hpp"

namespace mien {

namespace {

// Space that is drawn out backward, on both sides of the middle of the face and not in it, about what is in
// `middle`.
struct DrawnOut {
  glm::vec3 middle{0}, aside{1, 0, 0}, up{0, 1, 0}, forward{0, 0, 1};
  float front_mm = 0, deep_mm = 1;  // over the middle along `forward`: where it begins, and how deep
                                    // what is drawn out is
  float aside_mm = 1, high_mm = 1;  // half of how wide and how high that is
  float deeper = 0;                 // by this share of its depth
  float lower = 0;  // what is whole aside: by this share of its height, for it ends in a wedge
  float none_aside = 0.2f, whole_aside = 0.7f;  // of aside_mm
  float whole_high = 1.5f, none_high = 2.6f;    // of high_mm
  float none_lower = 1, most_lower_mm = 0;      // of high_mm; what is farther off goes no farther
  float none_deep = 3.5f;                       // of deep_mm: the head's back stays
  float late = 1;                               // as a power: the front less, and more what lies behind
};

void draw_out(const DrawnOut& out, glm::vec3& p) {
  const glm::vec3 way = p - out.middle;
  const float behind = (out.front_mm - glm::dot(way, out.forward)) / out.deep_mm;
  const float high = std::abs(glm::dot(way, out.up)) / out.high_mm;
  if (behind <= 0 || behind >= out.none_deep || high >= out.none_high) return;
  const float share =
      std::pow(std::min(behind, 1.0f), out.late) *
      smooth_step(out.none_aside, out.whole_aside, std::abs(glm::dot(way, out.aside)) / out.aside_mm) *
      (1 - smooth_step(1.0f, out.none_deep, behind));
  const float deeper = out.deeper * share * (1 - smooth_step(out.whole_high, out.none_high, high));
  const float above_mm = glm::dot(way, out.up);
  const float lower = out.lower * share * (1 - smooth_step(0.0f, out.none_lower, high));
  p -= deeper * out.deep_mm * out.forward +
       lower * std::clamp(above_mm, -out.most_lower_mm, out.most_lower_mm) * out.up;
}

DrawnOut measure_eyes(const Ink& ink, const Drawing& drawing) {
  constexpr float kLids = 0.9f;  // behind the balls' front, in their radii: so deep are the lids
  constexpr float kDeeper = 0.7f;
  const auto find_middle = [&](std::size_t part) {
    const Box box = compute_bounds(drawing.parts[part].positions);
    return 0.5f * (box.low + box.high);
  };
  const std::array middles{find_middle(ink.whites[0]), find_middle(ink.whites[1])};
  const glm::mat4& skull = drawing.parts[ink.teeth].world_from_rest;
  DrawnOut eyes{.middle = 0.5f * (middles[0] + middles[1]),
                .aside = glm::normalize(middles[0] - middles[1]),
                .up = glm::normalize(glm::vec3(skull[1])),
                .forward = glm::normalize(glm::vec3(skull[2])),
                .front_mm = -INFINITY,
                .deep_mm = kLids * static_cast<float>(ink.redraw.lens.radius_mm),
                .aside_mm = 0.5f * glm::distance(middles[0], middles[1]),
                .high_mm = 0,
                .deeper = kDeeper};
  for (const std::size_t part : ink.balls)
    for (const glm::vec3& p : drawing.parts[part].positions) {
      eyes.front_mm = std::max(eyes.front_mm, glm::dot(p - eyes.middle, eyes.forward));
      eyes.high_mm = std::max(eyes.high_mm, std::abs(glm::dot(p - eyes.middle, eyes.up)));
    }
  return eyes;
}

// Of the lips, from their front to their corners, which go farthest: they end in a wedge.
DrawnOut measure_mouth(const Ink& ink, const DrawnOut& eyes, const std::vector<glm::vec3>& skin) {
  constexpr float kDeeper = 0.7f, kLower = 1, kHeld = 0.6f, kLips_mm = 6, kBeyond_mm = 15,
                  kBeyondWedge_mm = 12;
  const glm::vec3 &upper = skin[ink.lips[0]], &lower = skin[ink.lips[1]];
  const glm::vec3 &left = skin[ink.corners[0]], &right = skin[ink.corners[1]];
  DrawnOut mouth{
      .middle = 0.5f * (left + right), .aside = eyes.aside, .up = eyes.up, .forward = eyes.forward};
  mouth.front_mm = glm::dot(upper - mouth.middle, mouth.forward);
  mouth.deep_mm = std::max(1.0f, mouth.front_mm);
  mouth.aside_mm = 0.5f * glm::distance(left, right);
  mouth.high_mm = 0.5f * glm::distance(upper, lower) + kLips_mm * ink.eye_size;
  mouth.deeper = kDeeper;
  mouth.lower = kLower;
  mouth.most_lower_mm = kHeld * glm::distance(upper, lower);
  mouth.whole_aside = 0.8f;
  mouth.whole_high = 0;
  mouth.none_lower = 1 + kBeyondWedge_mm * ink.eye_size / mouth.high_mm;
  mouth.none_high = 1 + kBeyond_mm * ink.eye_size / mouth.high_mm;
  return mouth;
}

// Wherever a cheek goes its blush is as round in profile as at rest. What is between it and the eye comes
// nearer, or the ball would stand before it.
void hold_flush(const Ink& ink, float beside, const DrawnOut& eyes, std::vector<glm::vec3>& skin) {
  constexpr float kSeen = 1.1f, kHigh = 1;  // of how far it reaches outward, along a cheek, and up
  constexpr float kWhole = 0.999f, kNearer = 0.5f, kNearer_mm = 4;
  const std::vector<glm::vec3>& rest = ink.model.parts.front().rest.positions;
  const auto find_offset = [&](std::size_t v) {
    const glm::vec3& place = ink.flush_places[v];
    return kHigh * place.y * eyes.up - kSeen * place.x * eyes.forward;
  };
  std::array<glm::vec3, 2> middles{};
  std::array<float, 2> counts{};
  for (std::size_t v = 0; v < skin.size(); ++v) {
    if (ink.flush_places[v].z < kWhole) continue;
    const std::size_t side = rest[v].x > 0 ? 0 : 1;
    middles[side] += skin[v] - find_offset(v);
    counts[side] += 1;
  }
  for (std::size_t v = 0; v < skin.size(); ++v) {
    const float held = ink.flush_places[v].z;
    if (held == 0) continue;
    const std::size_t side = rest[v].x > 0 ? 0 : 1;
    const glm::vec3 way = middles[side] / std::max(1.0f, counts[side]) + find_offset(v) - skin[v],
                    out = side == 0 ? eyes.aside : -eyes.aside;
    skin[v] +=
        beside * (held * (glm::dot(way, eyes.forward) * eyes.forward + glm::dot(way, eyes.up) * eyes.up) +
                  kNearer_mm * ink.eye_size * smooth_step(0.0f, kNearer, held) * out);
  }
}

// How far cheeks are seen from below, as a share, and not from the side.
float measure_below(const InkSight& sight) {
  constexpr float kLevel = 0.08f, kBelow = 0.5f;  // sines of the camera's way below
  return smooth_step(kLevel, kBelow, sight.below) * (1 - sight.beside);
}

}  // namespace

InkSight measure_sight(const Ink& ink, const InkView& view, const Drawing& drawing) {
  constexpr float kQuarter = 0.88f, kProfile = 0.98f;  // sines of the camera's way round the head
  constexpr float kFront = 0.25f, kTurned = 0.5f;
  const std::vector<glm::vec3>& skin = drawing.parts.front().positions;
  const glm::vec3 &left = skin[ink.sides[0]], &right = skin[ink.sides[1]];
  const glm::vec3 up = glm::normalize(glm::vec3(drawing.parts[ink.teeth].world_from_rest[1]));
  const glm::vec3 to_camera = glm::normalize(glm::vec3(view.camera_mm) - 0.5f * (left + right));
  const float aside = glm::dot(to_camera, glm::normalize(left - right)), sine = std::abs(aside);
  return {smooth_step(kQuarter, kProfile, sine), 1 - smooth_step(kFront, kTurned, sine), aside,
          -glm::dot(to_camera, up), to_camera};
}

float find_smile(const Pose& pose, std::size_t side) {
  const auto up =
      static_cast<float>(pose.values[*find_move(Area::corner, side == 0 ? Side::left : Side::right, "up")]);
  return std::clamp(up, 0.0f, 1.0f);
}

float measure_slit(const Ink& ink, const std::vector<glm::vec3>& skin, std::size_t side) {
  constexpr float kShut_mm = 1, kSlit_mm = 4,
                  kOpen_mm = 12;  // between the lids of an eye as large as an adult's
  const auto [upper, lower] = ink.lids[side];
  const float gap_mm = glm::distance(skin[upper], skin[lower]) / ink.eye_size;
  return smooth_step(kShut_mm, kSlit_mm, gap_mm) * (1 - smooth_step(kSlit_mm, kOpen_mm, gap_mm));
}

void part_lids(const Ink& ink, float beside, const std::array<float, 2>& slits, Drawing& drawing) {
  if (beside == 0 || !ink.redraw.lens.is_on()) return;
  constexpr float kUp_mm = 2.4f, kDown = 0.3f, kNear_mm = 9, kFar_mm = 24;  // the second of what goes up
  std::vector<glm::vec3>& skin = drawing.parts.front().positions;
  const glm::vec3 up = glm::normalize(glm::vec3(drawing.parts[ink.teeth].world_from_rest[1]));
  for (const std::size_t side : {0, 1}) {
    const float up_mm = kUp_mm * beside * slits[side] * ink.eye_size;
    if (up_mm == 0) continue;
    const glm::vec3 upper = skin[ink.lids[side][0]], lower = skin[ink.lids[side][1]];
    const glm::vec3 middle = 0.5f * (upper + lower);
    const float half_mm = 0.5f * glm::distance(upper, lower);
    for (glm::vec3& p : skin) {
      const float far_mm = glm::distance(p, middle) / ink.eye_size;
      if (far_mm >= kFar_mm) continue;
      const float way = std::clamp(glm::dot(p - middle, up) / half_mm, -kDown, 1.0f);
      p += up_mm * way * (1 - smooth_step(kNear_mm, kFar_mm, far_mm)) * up;
    }
  }
}

void widen_features(const Ink& ink, float beside, float parted, Drawing& drawing) {
  if (beside == 0 || !ink.redraw.lens.is_on()) return;
  std::vector<glm::vec3>& skin = drawing.parts.front().positions;
  DrawnOut eyes = measure_eyes(ink, drawing), mouth = measure_mouth(ink, eyes, skin);
  constexpr float kCheek_mm = 9;
  eyes.deeper *= beside;
  mouth.deeper *= beside * parted;
  mouth.lower *= beside * parted;
  for (std::size_t v = 0; v < skin.size(); ++v) {
    draw_out(eyes, skin[v]);
    draw_out(mouth, skin[v]);
    skin[v] -= beside * kCheek_mm * ink.eye_size * ink.cheek[v] * eyes.forward;
  }
  hold_flush(ink, beside, eyes, skin);
  constexpr float kLate = 1.8f;  // or an iris is as broad as it is from before
  DrawnOut balls = eyes;
  balls.late = kLate;
  for (const std::size_t part : ink.balls)
    for (glm::vec3& p : drawing.parts[part].positions) draw_out(balls, p);
  // Or cheeks that are drawn out would have teeth through them.
  constexpr float kNarrower = 0.35f;
  for (const std::size_t part : ink.bones) {
    PartShape& bone = drawing.parts[part];
    if (bone.positions.empty())
      bone.world_from_rest = glm::scale(bone.world_from_rest, glm::vec3(1 - kNarrower * beside, 1, 1));
    for (glm::vec3& p : bone.positions)
      p -= kNarrower * beside * glm::dot(p - eyes.middle, eyes.aside) * eyes.aside;
  }
}

void flatten_cheeks(const Ink& ink, const Pose& pose, const InkSight& sight, Drawing& drawing) {
  constexpr float kBack_mm = 9;
  constexpr float kQuarter = 0.4f, kHidden = 0.7f;  // sines of the camera's way round the head
  constexpr float kRaised = 0.5f;                   // of the way stays undone where a smile raises the cheek
  const float below = measure_below(sight);
  const float behind = smooth_step(kQuarter, kHidden, std::abs(sight.aside)) * (1 - sight.beside) *
                       (1 - kRaised * find_smile(pose, sight.aside > 0 ? 1 : 0));
  if (std::max(below, behind) == 0 || !ink.redraw.lens.is_on()) return;
  const std::vector<glm::vec3>& rest = ink.model.parts.front().rest.positions;
  std::vector<glm::vec3>& skin = drawing.parts.front().positions;
  const glm::vec3 forward = glm::normalize(glm::vec3(drawing.parts[ink.teeth].world_from_rest[2]));
  for (std::size_t v = 0; v < skin.size(); ++v) {
    const float share = rest[v].x * sight.aside < 0 ? std::max(below, behind) : below;
    skin[v] -= share * kBack_mm * ink.eye_size * ink.lower_cheek[v] * forward;
  }
}

namespace {

// A direction in the shade, less than a right angle from that of the skin: POV-Ray turns round what is more.
glm::vec3 turn_into_shade(const glm::vec3& direction, const glm::vec3& to_light) {
  constexpr float kAway = 0.4f, kWithin = 0.8f;
  const float along = glm::dot(direction, to_light), across = std::sqrt(std::max(0.0f, 1 - along * along));
  const float away = std::min(kAway, kWithin * across / std::max(along, 1e-3f));
  return glm::normalize(direction - (along + away * across) * to_light + glm::vec3(0, 0, 1e-6f));
}

}  // namespace

void lift_tones(const Ink& ink, const InkSight& sight, const glm::vec3& to_light,
                std::vector<glm::vec3>& tones) {
  constexpr float kLit = 0.7f, kLitBelow = 0.4f, kLitFaced = 0.08f, kLitFlushed = 0.2f;
  // Heights of unit normals: from before and below, and in profile.
  constexpr float kUnder = -0.7f, kLevel = -0.25f;
  constexpr float kClear = 0.5f;  // cosine: what is lit as it is
  constexpr float kDown = -0.85f, kMiddle = -0.65f, kLifted = -0.2f;
  const float beside = sight.beside, below = measure_below(sight);
  const float lit = std::max(kLitBelow * below, sight.faced * glm::mix(kLitFaced, kLitFlushed, ink.flush));
  if (lit > 0 && ink.redraw.lens.is_on())
    for (glm::vec3& tone : tones)
      if (glm::dot(tone, to_light) < kClear)
        tone = glm::normalize(glm::mix(tone, to_light, lit * smooth_step(kUnder, kLevel, tone.y)));
  constexpr float kChin = 0.6f;
  if (ink.redraw.lens.is_on())
    for (std::size_t v = 0; v < tones.size(); ++v)
      tones[v] =
          glm::normalize(glm::mix(tones[v], to_light, kChin * (1 - below) * (1 - beside) * ink.chin[v]));
  if (below > 0 && ink.redraw.lens.is_on())
    for (std::size_t v = 0; v < tones.size(); ++v)
      tones[v] =
          glm::normalize(glm::mix(tones[v], turn_into_shade(tones[v], to_light), below * ink.throat[v]));
  if (beside == 0) return;
  for (std::size_t v = 0; v < tones.size(); ++v)
    tones[v] = glm::normalize(glm::mix(tones[v], to_light, kLit * beside * (1 - ink.off_strokes[v])));
  for (glm::vec3& tone : tones) {
    if (tone.y >= 0 || tone.y <= kDown) continue;
    const float lifted = tone.y > kMiddle ? tone.y * kLifted / kMiddle
                                          : glm::mix(kLifted, kDown, (tone.y - kMiddle) / (kDown - kMiddle));
    tone.y = glm::mix(tone.y, lifted, beside);
    tone = glm::normalize(tone);
  }
}

}  // namespace mien
