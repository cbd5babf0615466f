#include "frames/ink_mouth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/smooth.hpp"
#include "frames/ink_parts.hpp"
#include "frames/ink_round.hpp"
#include "frames/ink_strokes.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

void shift(const glm::vec3& way, PartShape& shape) {
  for (glm::vec3& p : shape.positions) p += way;
  if (shape.positions.empty()) shape.world_from_rest[3] += glm::vec4(way, 0);
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
  for (const glm::vec3& p : teeth.positions) top = std::max(top, glm::dot(p, up) - ink.taper_over_mm);
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

// What is toothless would have an empty wedge in profile, and an empty hole from below and aslant: its tongue
// rises behind the lower lip of a wide mouth, in profile beside the middle, else, as far as `below`, in it.
void raise_tongue(const Ink& ink, float share, float below, float gap_mm, Drawing& drawing) {
  constexpr float kHigh = 0.45f, kEnds = 0.8f;    // of the gap; of the way to the corners
  constexpr float kNarrow_mm = 8, kWide_mm = 14;  // between an adult's lips
  const std::vector<glm::vec3>& skin = drawing.parts.front().positions;
  const glm::vec3 up = glm::normalize(glm::vec3(drawing.parts[ink.teeth].world_from_rest[1]));
  const float high_mm = share * kHigh * gap_mm * ink.eye_size * smooth_step(kNarrow_mm, kWide_mm, gap_mm);
  const std::size_t last = ink.strip_points.size() - 1;
  std::vector<glm::vec3>& strip = drawing.parts[ink.tooth_strip].positions;
  strip.clear();
  for (std::size_t i = 0; i <= last; ++i) {
    const float aside = std::abs(2 * static_cast<float>(i) / static_cast<float>(last) - 1),
                along = std::min(aside / kEnds, 1.0f);
    strip.push_back(skin[ink.strip_points[i]]);
    strip.push_back(strip.back() +
                    high_mm * glm::mix(4 * along * (1 - along), 1 - along * along, below) * up);
  }
}

// Instead of the teeth, which would be pieces of their row between lips that are drawn out in profile, a
// strip hangs from the upper lip as low as they do.
void hang_strip(const Ink& ink, float share, Drawing& drawing) {
  constexpr float kBehind_mm = 1, kSlant_mm = 2;
  const PartShape& teeth = drawing.parts[ink.teeth];
  const std::vector<glm::vec3>& skin = drawing.parts.front().positions;
  const glm::vec3 up = glm::normalize(glm::vec3(teeth.world_from_rest[1])),
                  forward = glm::normalize(glm::vec3(teeth.world_from_rest[2]));
  float end = INFINITY;
  for (const glm::vec3& p : teeth.positions) end = std::min(end, glm::dot(p, up));
  if (teeth.positions.empty()) {
    const glm::vec4 rest_end(0, ink.teeth_end_mm, 0, 1);
    end = glm::dot(glm::vec3(teeth.world_from_rest * rest_end), up);
  }
  const std::size_t last = ink.strip_points.size() - 1;
  const float high = std::max(0.0f, glm::dot(skin[ink.strip_points[last / 2]], up) - end);
  PartShape& strip = drawing.parts[ink.tooth_strip];
  strip.positions.clear();
  for (std::size_t i = 0; i <= last; ++i) {
    const float aside = std::abs(2 * static_cast<float>(i) / static_cast<float>(last) - 1);
    const glm::vec3 behind = -ink.eye_size * (1 - aside) * forward;
    const glm::vec3 top = skin[ink.strip_points[i]] + kBehind_mm * behind;
    strip.positions.push_back(top);
    strip.positions.push_back(top + share * (kSlant_mm * behind - high * (1 - aside * aside) * up));
  }
}

// The strip stands for teeth and gums, which are drawn together in the throat. A tongue without teeth is
// raised from below and aslant as well, where its own one lies behind the lip.
void show_strip(const Ink& ink, const InkSight& sight, float gap_mm, Drawing& drawing) {
  constexpr float kBegins = 0.5f, kLeast = 0.02f, kThroat_mm = 25;
  constexpr float kLevel = 0.15f, kBelow = 0.45f;  // sines of the camera's way below
  constexpr float kFront = 0.18f, kTurned = 0.3f;  // and round the head
  const float beside = smooth_step(kBegins, 1.0f, sight.beside);
  const float below = ink.is_toothless
                          ? (1 - beside) * std::max(smooth_step(kLevel, kBelow, sight.below),
                                                    smooth_step(kFront, kTurned, std::abs(sight.aside)))
                          : 0;
  const float share = std::max(beside, below);
  if (ink.is_toothless)
    raise_tongue(ink, share, below, gap_mm, drawing);
  else
    hang_strip(ink, share, drawing);
  if (share == 0) return;
  const float size = std::max(kLeast, 1 - share);
  const glm::vec3 forward = glm::normalize(glm::vec3(drawing.parts[ink.teeth].world_from_rest[2])),
                  lip = drawing.parts.front().positions[ink.strip_points[ink.strip_points.size() / 2]];
  const glm::vec3 at = lip - kThroat_mm * ink.eye_size * forward;
  for (const std::size_t part : ink.bones) {
    PartShape& bone = drawing.parts[part];
    if (bone.positions.empty()) {
      glm::mat4 about = glm::translate(glm::mat4(1), at);
      about = glm::scale(about, glm::vec3(size));
      bone.world_from_rest = glm::translate(about, -at) * bone.world_from_rest;
    }
    for (glm::vec3& p : bone.positions) p = at + size * (p - at);
  }
}

// From elsewhere than the side the sheet lies in the throat, out of the way of teeth and tongue. Between lips
// that part a little it comes to their edges: what shows of them before it is crumbs. Its front is bowed in.
void place_mouth_sheet(const Ink& ink, float beside, float slit, const std::vector<glm::vec3>& skin,
                       PartShape& sheet) {
  constexpr float kBow = 0.12f, kBefore = 0.6f;  // of its height; of the way to the lips' edge
  std::vector<glm::vec3> points;
  for (const std::uint32_t v : ink.sheet_points) points.push_back(skin[v]);
  const std::size_t count = points.size();
  const glm::vec3 throat = 0.5f * (points[count - 1] + points[count - 2]);
  for (std::size_t lip = 0; lip < 2; ++lip)
    points[lip] = glm::mix(points[lip], skin[ink.lips[lip]], std::max(kBefore, slit));
  const glm::vec3 middle = 0.5f * (points[0] + points[1]);
  const glm::vec3 bow = kBow * (1 - slit) * glm::distance(points[0], points[1]) *
                        glm::normalize(throat - middle + glm::vec3(0, 0, -1e-6f));
  sheet.positions.clear();
  for (std::size_t i = 0; i < count; i += 2)
    for (std::uint32_t row = 0; row < kSheetRows; ++row) {
      const float down = static_cast<float>(row) / static_cast<float>(kSheetRows - 1);
      glm::vec3 p = glm::mix(points[i], points[i + 1], down);
      if (i == 0) p += 4 * down * (1 - down) * bow;
      sheet.positions.push_back(glm::mix(throat, p, beside));
    }
}

// A line along the sheet's front, or its dark would end on the ground.
void draw_mouth_edge(float beside, double line_mm, const PartShape& sheet, PartShape& edge) {
  constexpr float kHalf = 0.5f, kEnd = 0.8f;  // of a line; of that, at the lips
  const glm::vec3 &first = sheet.positions.front(), &last = sheet.positions[kSheetRows - 1],
                  &back = sheet.positions.back();
  const glm::vec3 normal = glm::cross(last - first, back - first);
  const float area = glm::length(normal);
  const glm::vec3 lift = area > 1e-6f ? normal / area : glm::vec3(1, 0, 0);
  const std::vector<glm::vec3> front(sheet.positions.begin(), sheet.positions.begin() + kSheetRows);
  Tube tube;
  for (int i = 0; i < kStrokeSteps; ++i) {
    const double at = static_cast<double>(i) / (kStrokeSteps - 1);
    tube.centres.push_back(sample_curve(front, at * (kSheetRows - 1)));
    tube.lifts.push_back(lift);
    tube.halves_mm.push_back(beside * static_cast<float>(line_mm) * kHalf *
                             static_cast<float>(std::lerp(kEnd, 1.0, 4 * at * (1 - at))));
  }
  edge.positions.clear();
  append_tube(tube, 1, edge.positions);
}

// The mouth in the frame of the skull: between its corners, between its lips' middles, half its width and
// half of how far these stand apart.
struct MouthFrame {
  glm::vec3 middle, lips, aside, up, forward;
  float half_mm = 1, high_mm = 0;
};

MouthFrame measure_frame(const Ink& ink, const Drawing& drawing) {
  const std::vector<glm::vec3>& skin = drawing.parts.front().positions;
  const glm::mat4& skull = drawing.parts[ink.teeth].world_from_rest;
  const glm::vec3 &left = skin[ink.corners[0]], &right = skin[ink.corners[1]];
  const glm::vec3 &upper = skin[ink.lips[0]], &lower = skin[ink.lips[1]];
  return {0.5f * (left + right),
          0.5f * (upper + lower),
          glm::normalize(left - right),
          glm::normalize(glm::vec3(skull[1])),
          glm::normalize(glm::vec3(skull[2])),
          0.5f * glm::distance(left, right),
          0.5f * glm::distance(upper, lower)};
}

// 1 at the corners of the mouth, 0 in its middle, in the cheek and behind it.
float find_nearness(const MouthFrame& frame, const glm::vec3& p, float whole_at = 0.8f) {
  constexpr float kBeyond = 1.9f, kNear = 0.5f, kDeep = 1.5f;  // of half the mouth's width
  const float out = std::abs(glm::dot(p - frame.middle, frame.aside)) / frame.half_mm,
              deep = glm::dot(frame.middle - p, frame.forward) / frame.half_mm;
  if (out >= kBeyond || deep >= kDeep) return 0;
  const float whole = std::min(out / whole_at, 1.0f);
  return whole * whole * (1 - smooth_step(1.0f, kBeyond, out)) * (1 - smooth_step(kNear, kDeep, deep));
}

float fade_out(float off_mm, float reach_mm, float fade_mm) {
  return 1 - smooth_step(reach_mm, reach_mm + fade_mm, std::abs(off_mm));
}

}  // namespace

InkMouth measure_mouth(const Ink& ink, const std::vector<glm::vec3>& skin) {
  constexpr float kMet_mm = 1.2f, kParted_mm = 3, kSlit_mm = 4, kOpen_mm = 8;
  const float gap_mm = glm::distance(skin[ink.lips[0]], skin[ink.lips[1]]) / ink.eye_size;
  return {gap_mm, smooth_step(kMet_mm, kParted_mm, gap_mm), 1 - smooth_step(kSlit_mm, kOpen_mm, gap_mm)};
}

namespace {

// Lips that go straight to the corners are a beak from the side: beside their middle they bow out as an
// ellipse does, by the upper and the lower one's share of the way there.
void bow_lips(const MouthFrame& frame, float upper, float lower, float fade_mm,
              std::vector<glm::vec3>& skin) {
  constexpr float kDeep = 0.9f, kReach_mm = 3, kSoft = 0.4f;  // the first of half the mouth's width
  for (glm::vec3& p : skin) {
    const glm::vec3 off = p - frame.middle;
    const float out = std::abs(glm::dot(off, frame.aside)) / frame.half_mm,
                deep = -glm::dot(off, frame.forward) / frame.half_mm;
    if (out >= 1 || deep >= kDeep) continue;
    const float straight_mm = frame.high_mm * (1 - out);
    const float bow_mm =
        (frame.high_mm * std::sqrt(1 - out * out) - straight_mm) * smooth_step(0.1f, 0.75f, out);
    const float off_mm = glm::dot(p - frame.lips, frame.up);
    const float side = std::clamp(off_mm / (kSoft * straight_mm + 0.1f), -1.0f, 1.0f);
    p += (side > 0 ? upper : lower) * bow_mm * side * fade_out(off_mm, straight_mm + kReach_mm, fade_mm) *
         (1 - smooth_step(0.5f * kDeep, kDeep, deep)) * frame.up;
  }
}

}  // namespace

void round_far_corner(const Ink& ink, const Pose& pose, const InkSight& sight, const InkMouth& mouth,
                      Drawing& drawing) {
  constexpr float kFront = 0.25f, kQuarter = 0.5f;  // sines of the camera's way round the head
  constexpr float kWide = 1.3f, kWider = 2;         // the mouth against how far its lower lip hangs
  constexpr float kRound = 0.7f, kLow = 0.35f;      // of what hangs: so far below the corners the lips meet
  constexpr float kForth = 0.6f;                    // of how far the corner lies behind the lips
  constexpr float kRoundNear = 0.66f, kRoundFar = 0.77f;  // a round mouth's would stand before the lips
  constexpr float kFade_mm = 20, kForthFade_mm = 8;
  constexpr float kTall = 0.5f, kTaller = 0.75f;  // a round mouth's height against its width
  constexpr float kEllipse = 0.9f, kInset = 0.12f;
  constexpr float kNick_mm = 9, kNickForth_mm = 3;  // about the corner, which would nick the far outline
  const float turned =
      smooth_step(kFront, kQuarter, std::abs(sight.aside)) * (1 - sight.beside) * mouth.parted;
  if (turned == 0 || !ink.redraw.lens.is_on()) return;
  std::vector<glm::vec3>& skin = drawing.parts.front().positions;
  const MouthFrame frame = measure_frame(ink, drawing);
  const std::size_t far = sight.aside > 0 ? 1 : 0;
  const glm::vec3 corner = skin[ink.corners[far]];
  const glm::vec3 aside = glm::normalize(corner - frame.middle);
  const float hangs_mm = glm::dot(corner - skin[ink.lips[1]], frame.up);
  const float wide = hangs_mm > 0 ? smooth_step(kWide, kWider, 2 * frame.half_mm / hangs_mm) : 0,
              share = kRound * turned * wide;
  const float most_mm = kLow * std::max(hangs_mm, 0.0f), meeting_mm = glm::dot(corner, frame.up) - most_mm;
  const float stays = (1 - wide) * smooth_step(kRoundNear, kRoundFar, std::abs(sight.aside));
  const float forth_mm = kForth * turned * (1 - stays) * glm::dot(frame.lips - corner, frame.forward);
  const float nick_mm = kNickForth_mm * turned * (1 - find_smile(pose, far)) * ink.eye_size;
  for (glm::vec3& p : skin) {
    if (glm::dot(p - frame.middle, aside) <= 0) continue;
    const float near = find_nearness(frame, p);
    if (near == 0) continue;
    const float high_mm = glm::dot(p, frame.up) - meeting_mm, off_mm = glm::dot(p - frame.lips, frame.up);
    const float together = share * near * fade_out(high_mm, most_mm, kFade_mm * ink.eye_size),
                forth = near * fade_out(off_mm, frame.high_mm, kForthFade_mm * ink.eye_size);
    const float nick = 1 - smooth_step(0.0f, kNick_mm * ink.eye_size, glm::distance(p, corner));
    p += (forth * forth_mm + nick * nick_mm) * frame.forward -
         together * std::clamp(high_mm, -most_mm, most_mm) * frame.up;
  }
  const float round =
      smooth_step(kTall, kTaller, frame.high_mm / frame.half_mm) * (1 - find_smile(pose, far));
  round_mouth(ink, kEllipse * turned * round,
              kInset * smooth_step(kRoundNear, kRoundFar, std::abs(sight.aside)), sight.to_camera, drawing);
}

void round_profile(const Ink& ink, const InkSight& sight, const InkMouth& mouth, Drawing& drawing) {
  constexpr float kUpper = 0.2f, kLower = 0.4f, kFade_mm = 8;
  const float share = sight.beside * mouth.parted * (1 - mouth.slit);
  if (share == 0 || !ink.redraw.lens.is_on()) return;
  bow_lips(measure_frame(ink, drawing), kUpper * share, kLower * share, kFade_mm * ink.eye_size,
           drawing.parts.front().positions);
}

void lift_corners(const Ink& ink, const Pose& pose, const InkSight& sight, Drawing& drawing) {
  constexpr float kRow = 0.15f;  // of the corners' way: so far the teeth come along
  constexpr float kLift = 1.4f, kAbove_mm = 16, kBelow_mm = 7, kWhole = 1.05f;
  constexpr float kLevel = 0.08f, kMost = 0.6f;  // sines of the camera's way below
  const float below = (std::clamp(sight.below, kLevel, kMost) - kLevel) * (1 - sight.beside);
  if (below == 0 || !ink.redraw.lens.is_on()) return;
  const MouthFrame frame = measure_frame(ink, drawing);
  std::array<float, 2> lifts_mm{};
  for (const std::size_t side : {0, 1}) {
    const float smile = find_smile(pose, side);
    const float behind_mm =
        glm::dot(frame.lips - drawing.parts.front().positions[ink.corners[side]], frame.forward);
    lifts_mm[side] = kLift * smile * std::max(behind_mm, 0.0f) * below / std::sqrt(1 - below * below);
  }
  for (const std::size_t part : {ink.teeth, ink.gum})
    shift(kRow * 0.5f * (lifts_mm[0] + lifts_mm[1]) * frame.up, drawing.parts[part]);
  for (glm::vec3& p : drawing.parts.front().positions) {
    const float near = find_nearness(frame, p, kWhole);
    if (near == 0) continue;
    const float lift_mm = lifts_mm[glm::dot(p - frame.middle, frame.aside) > 0 ? 0 : 1];
    const float off_mm = glm::dot(p - frame.lips, frame.up);
    p += near * fade_out(off_mm, frame.high_mm, ink.eye_size * (off_mm > 0 ? kAbove_mm : kBelow_mm)) *
         lift_mm * frame.up;
  }
}

void draw_mouth(const Ink& ink, const Pose& pose, const InkSight& sight, const InkMouth& mouth,
                double line_mm, Drawing& drawing) {
  for (const std::size_t part : {ink.teeth, ink.gum}) {
    PartShape& row = drawing.parts[part];
    if (!row.positions.empty())
      taper_row({glm::normalize(glm::vec3(row.world_from_rest[0])),
                 glm::normalize(glm::vec3(row.world_from_rest[1])),
                 glm::normalize(glm::vec3(row.world_from_rest[2]))},
                ink.taper_over_mm, row.positions);
  }
  hide_teeth(ink, mouth.gap_mm, drawing);
  show_strip(ink, sight, mouth.gap_mm, drawing);
  lift_veil(mouth.parted, drawing.parts[ink.veil].positions);
  sink_lower_teeth(ink, pose, mouth.gap_mm, drawing);
  place_mouth_sheet(ink, sight.beside * mouth.parted, mouth.slit, drawing.parts.front().positions,
                    drawing.parts[ink.sheet]);
  draw_mouth_edge(sight.beside * mouth.parted * (1 - mouth.slit), line_mm, drawing.parts[ink.sheet],
                  drawing.parts[ink.mouth_edge]);
}

}  // namespace mien
