#include "frames/bust_mouth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "core/print_numbers.hpp"
#include "core/smooth.hpp"

namespace mien {

namespace {

// Where the part's triangles cross the plane of that x: pieces of lines, as (y, z).
void append_crossings(const Mesh& mesh, float x, std::vector<std::array<glm::vec2, 2>>& lines) {
  for (const Triangle& t : mesh.triangles) {
    std::vector<glm::vec2> ends;
    for (int i = 0; i < 3; ++i) {
      const glm::vec3 &a = mesh.positions[t[i]], &b = mesh.positions[t[(i + 1) % 3]];
      if ((a.x < x) == (b.x < x)) continue;
      const glm::vec3 p = glm::mix(a, b, (x - a.x) / (b.x - a.x));
      ends.emplace_back(p.y, p.z);
    }
    if (ends.size() == 2) lines.push_back({ends[0], ends[1]});
  }
}

// The furthest z of the lines at that y.
float compute_front(const std::vector<std::array<glm::vec2, 2>>& lines, float y) {
  float front = kNoTooth_mm;
  for (const auto& [a, b] : lines) {
    if ((a.x < y) == (b.x < y)) continue;
    front = std::max(front, glm::mix(a.y, b.y, (y - a.x) / (b.x - a.x)));
  }
  return front;
}

// A gap between two teeth is narrower than what a print can show: the row goes on across it.
void bridge_gaps(ToothRow& row) {
  constexpr float kGap_mm = 2;  // a sample this far behind both its neighbours is a gap
  for (int i = 1; i + 1 < kToothSamples; ++i) {
    const glm::vec2 before = row.edge[i - 1], after = row.edge[i + 1];
    if (row.edge[i].y > std::min(before.y, after.y) - kGap_mm) continue;
    row.edge[i] = 0.5f * (before + after);
    row.front[i] = 0.5f * (row.front[i - 1] + row.front[i + 1]);
  }
}

// `sign` 1: teeth that hang down, their biting edge lowest; -1: those that stand up.
ToothRow build_tooth_row(const Model& model, std::string_view stem, float sign) {
  constexpr float kSameTooth_mm = 5;  // further back at the same x stands another tooth
  ToothRow row;
  for (int i = 0; i < kToothSamples; ++i) {
    // Not quite on a sample's own x, where the mid-plane's vertices lie.
    const float x = kToothReach_mm * (2 * float(i) / (kToothSamples - 1) - 1) + 0.013f;
    std::vector<std::array<glm::vec2, 2>> lines;
    for (const Part& part : model.parts)
      if (part.name.starts_with(stem)) append_crossings(part.rest, x, lines);
    row.edge[i] = row.front[i] = {0, kNoTooth_mm};
    float foremost = kNoTooth_mm;
    for (const auto& line : lines)
      for (const glm::vec2& p : line) foremost = std::max(foremost, p.y);
    std::erase_if(lines, [&](const auto& line) { return line[0].y < foremost - kSameTooth_mm; });
    if (lines.empty()) continue;
    glm::vec2 edge{sign * 1e6f, 0};
    for (const auto& line : lines)
      for (const glm::vec2& p : line)
        if (sign * p.x < sign * edge.x) edge = p;
    const float crown = edge.x + sign * kCrown_mm, near = edge.x + sign * 0.4f;
    const float front = compute_front(lines, crown), rim = compute_front(lines, near);
    if (front == kNoTooth_mm || rim == kNoTooth_mm) continue;
    row.edge[i] = {edge.x, rim};
    row.front[i] = {crown, front};
  }
  bridge_gaps(row);
  return row;
}

// A row's edge and front at x between the samples; z is kNoTooth_mm outside.
struct ToothPlace {
  glm::vec2 edge{0, kNoTooth_mm}, front{0, kNoTooth_mm};
};

ToothPlace compute_tooth(const ToothRow& row, float x) {
  const float at = (x / kToothReach_mm + 1) / 2 * (kToothSamples - 1);
  const int i = static_cast<int>(std::floor(at));
  if (i < 0 || i + 1 >= kToothSamples) return {};
  if (row.edge[i].y == kNoTooth_mm || row.edge[i + 1].y == kNoTooth_mm) return {};
  const float share = at - float(i);
  return {glm::mix(row.edge[i], row.edge[i + 1], share), glm::mix(row.front[i], row.front[i + 1], share)};
}

// The relief of a row in the hollow: z of the back, or of the tooth that stands before it at (x, y).
float stand_teeth(const ToothRow& row, float sign, float x, float y, float back) {
  const ToothPlace tooth = compute_tooth(row, x);
  if (tooth.edge.y == kNoTooth_mm) return back;
  const float height = sign * (y - tooth.edge.x);  // above the biting edge, toward the gums
  const float shown = smooth_step(-kToothEdge_mm, kToothEdge_mm, height);
  const float crown =
      std::max(kLeastCrown_mm, sign * (tooth.front.x - tooth.edge.x));  // shorter when the jaw is open
  const float slope = (tooth.front.y - tooth.edge.y) / crown;
  const float z = tooth.edge.y + slope * std::clamp(height, 0.0f, kCrownReach_mm);
  return glm::mix(back, std::max(back, z), shown);
}

float stand_tongue(const TongueMound& tongue, float x, float y, float back) {
  if (tongue.radius.x <= 0) return back;
  const glm::vec2 at = (glm::vec2(x, y) - glm::vec2(tongue.centre)) / glm::vec2(tongue.radius);
  const float inside = 1 - glm::dot(at, at);
  if (inside <= 0) return back;
  return std::max(back, tongue.centre.z + tongue.radius.z * std::sqrt(inside));
}

glm::vec2 move_point(const glm::mat4& jaw, const glm::vec2& p) {
  const glm::vec4 at = jaw * glm::vec4(0, p.x, p.y, 1);
  return {at.y, at.z};
}

// How far down a row of the grid lies.
float compute_down(const CarvedMouth& mouth, const PatchPlace& at, float gap_mm) {
  constexpr int kBetween = kPatchRows - 2 * kTeethRows - 2;  // steps
  const float x = 0.5f * (at.upper.x + at.lower.x),
              height = std::max(at.upper.y - at.lower.y, kLeastMouthGap_mm);
  const ToothPlace above = compute_tooth(mouth.upper, x), below = compute_tooth(mouth.lower, x);
  const float high = above.edge.y == kNoTooth_mm ? kNoUpperTooth : (at.upper.y - above.edge.x) / height;
  const float low = below.edge.y == kNoTooth_mm ? kNoLowerTooth : (at.upper.y - below.edge.x) / height;
  const float first = std::clamp(high, kLeastUpperRows, kMostUpperRows),
              second = std::clamp(low, first + kLeastBetweenRows, kMostLowerRows);
  const float step = std::min(kToothEdge_mm / std::max(gap_mm, kLeastMouthGap_mm), kMostEdgeStep);
  if (at.row <= kTeethRows) return (first - step) * float(at.row) / kTeethRows;
  if (at.row < kPatchRows - kTeethRows)
    return glm::mix(first + step, second - step, float(at.row - kTeethRows - 1) / kBetween);
  return glm::mix(second + step, 1.0f, float(at.row - (kPatchRows - kTeethRows)) / kTeethRows);
}

}  // namespace

CarvedMouth build_carved_mouth(const Model& model) {
  CarvedMouth mouth;
  mouth.upper = build_tooth_row(model, "teeth_upper", 1);
  mouth.lower = build_tooth_row(model, "teeth_lower", -1);
  for (const Part& part : model.parts) {
    if (part.name != "tongue") continue;
    const Box box = compute_bounds(part.rest.positions);
    mouth.tongue.centre = 0.5f * (box.low + box.high);
    mouth.tongue.radius = 0.5f * (box.high - box.low);
  }
  return mouth;
}

CarvedMouth move_jaw(const CarvedMouth& mouth, const glm::mat4& jaw) {
  CarvedMouth moved = mouth;
  for (int i = 0; i < kToothSamples; ++i) {
    if (mouth.lower.edge[i].y == kNoTooth_mm) continue;
    moved.lower.edge[i] = move_point(jaw, mouth.lower.edge[i]);
    moved.lower.front[i] = move_point(jaw, mouth.lower.front[i]);
  }
  moved.tongue.centre = glm::vec3(jaw * glm::vec4(mouth.tongue.centre, 1));
  return moved;
}

glm::vec3 place_in_mouth(const CarvedMouth& mouth, const PatchPlace& at) {
  const float gap_mm = glm::distance(at.upper, at.lower);
  const float down = compute_down(mouth, at, gap_mm);
  const glm::vec3 p = glm::mix(at.upper, at.lower, down);
  const float depth_mm = std::min(
      mouth.line_mm * smooth_step(0, kLipLineFade_mm, gap_mm) + kDepthPerGap * gap_mm, kDeepestMouth_mm);
  const float back = p.z - depth_mm * std::sqrt(std::sin(std::numbers::pi_v<float> * down));
  float z = stand_tongue(mouth.tongue, p.x, p.y, back);
  z = std::max(z, stand_teeth(mouth.lower, -1, p.x, p.y, back));
  z = std::max(z, stand_teeth(mouth.upper, 1, p.x, p.y, back));
  return {p.x, p.y, std::min(z, std::max(back, p.z - kBehindLips_mm))};
}

}  // namespace mien
