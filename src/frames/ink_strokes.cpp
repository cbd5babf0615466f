#include "frames/ink_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/smooth.hpp"
#include "head/binding.hpp"
#include "head/cage.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

const std::vector<StrokeRule>& list_stroke_rules() {
  static const std::vector<StrokeRule> rules{
      {.name = "upper_lashes",
       .points = {"E1_0", "E1_1", "E1_2", "E1_3", "E1_4", "E1_5", "E1_6", "E1_7", "E1_8"},
       .is_of_lid = true,
       .widths = {{0, 0.3}, {0.15, 0.9}, {0.5, 1.6}, {0.8, 2.1}, {0.9, 1.6}, {1, 0.05}},
       .lift_mm = 0.5,
       .flat = 0.45,
       .wing = {3.2f, 1.8f, -1.5f}},
      {.name = "lower_lashes",
       .points = {"E1_15", "E1_14", "E1_13", "E1_12", "E1_11", "E1_10", "E1_9", "E1_8"},
       .is_ridge = true,
       .in_profile = 2,
       .faced = 0.08f,
       .is_of_lid = true,
       .widths = {{0, 0.05}, {0.3, 0.3}, {0.6, 0.45}, {0.85, 0.7}, {1, 0.5}},
       .lift_mm = 0.3,
       .flat = 0.4,
       .from = 0.2},
      {.name = "crease",
       .points = {"E3_1", "E3_2", "E3_3", "E3_4", "E3_5", "E3_6", "E3_7"},
       .is_ridge = true,
       .is_of_front = true,
       .widths = {{0, 0.02}, {0.3, 0.55}, {0.7, 0.6}, {1, 0.02}},
       .lift_mm = 1.3,
       .flat = 0.7},
      {.name = "brow",
       .points = {"E5_2", "E5_3", "E5_4", "E5_5", "E5_6", "E5_7"},
       .is_brow = true,
       .widths = {{0, 1.2}, {0.06, 2.5}, {0.2, 3.3}, {0.45, 3.0}, {0.7, 2.2}, {0.9, 1.0}, {1, 0.1}},
       .lift_mm = 0.9,
       .flat = 0.42},
      {.name = "upper_lip",
       .points = {"R:M1_6", "R:M1_5", "R:M1_4", "R:M1_3", "R:M1_2", "R:M1_1", "M1_0", "M1_1", "M1_2", "M1_3",
                  "M1_4", "M1_5", "M1_6"},
       .is_sided = false,
       .is_smooth = true,
       .widths = {{0, 0.4}, {0.06, 0.9}, {0.3, 0.75}, {0.5, 0.95}, {0.7, 0.75}, {0.94, 0.9}, {1, 0.4}},
       .lift_mm = 1.2,
       .before = {{"R:M2_6", "R:M2_6"},
                  {"R:M2_5", "R:M2_7"},
                  {"R:M2_4", "R:M2_8"},
                  {"R:M2_3", "R:M2_9"},
                  {"R:M2_2", "R:M2_10"},
                  {"R:M2_1", "R:M2_11"},
                  {"M2_0", "M2_12"},
                  {"M2_1", "M2_11"},
                  {"M2_2", "M2_10"},
                  {"M2_3", "M2_9"},
                  {"M2_4", "M2_8"},
                  {"M2_5", "M2_7"},
                  {"M2_6", "M2_6"}}},
      {.name = "lower_lip",
       .points = {"R:M1_6", "R:M1_7", "R:M1_8", "R:M1_9", "R:M1_10", "R:M1_11", "M1_12", "M1_11", "M1_10",
                  "M1_9", "M1_8", "M1_7", "M1_6"},
       .is_sided = false,
       .is_seam = true,
       .lies_in_profile = true,
       .widths = {{0, 0.4}, {0.06, 0.7}, {0.5, 0.5}, {0.94, 0.7}, {1, 0.4}},
       .lift_mm = 1,
       .facing = {"M4_0", "M4_12"}},
      {.name = "under_lip",
       .points = {"R:M4_10", "R:M4_11", "M4_12", "M4_11", "M4_10"},
       .is_sided = false,
       .widths = {{0, 0.02}, {0.5, 0.65}, {1, 0.02}},
       .lift_mm = 0.2,
       .flat = 0.4,
       .from = 0.25,
       .to = 0.75},
      {.name = "ear_rim",
       .points = {"er7_1", "er7_2", "er7_3", "er7_4", "er7_5", "er7_6", "er7_7"},
       .widths = {{0, 0.02}, {0.3, 0.55}, {0.7, 0.55}, {1, 0.02}},
       .lift_mm = 0.6,
       .flat = 0.6},
      {.name = "ear_bowl",
       .points = {"er9_2", "er9_3", "er9_4", "er9_5", "er9_6", "er9_7", "er9_8"},
       .widths = {{0, 0.02}, {0.4, 0.6}, {0.8, 0.5}, {1, 0.02}},
       .lift_mm = 0.6,
       .flat = 0.6},
      {.name = "jaw",
       .points = {"s3_C9",   "s2_D1",    "s1_D1",    "q10_D1",   "q11_D1",   "q12_D1",   "m8_D1",
                  "m9_D1",   "m10_D1",   "m11_D1",   "m12_D1",   "R:m11_D1", "R:m10_D1", "R:m9_D1",
                  "R:m8_D1", "R:q12_D1", "R:q11_D1", "R:q10_D1", "R:s1_D1",  "R:s2_D1",  "R:s3_C9"},
       .is_sided = false,
       .is_ridge = true,
       .in_profile = 0,  // it would hang between chin and ear, tied to neither
       .widths = {{0, 0.02}, {0.12, 0.6}, {0.5, 0.75}, {0.88, 0.6}, {1, 0.02}},
       .lift_mm = 0.35,
       .flat = 0.4,
       .from = 0.03,
       .to = 0.97,
       .less_below = 0.27}};
  return rules;
}

std::uint32_t find_sided(const Cage& cage, std::string_view name, float side) {
  const bool is_image = name.starts_with("R:");
  const std::uint32_t point = find_point(cage, is_image ? name.substr(2) : name);
  return is_image != (side < 0) ? cage.mirror[point] : point;
}

// Depths at even steps along a line of a fold, as the widths of its stroke.
StrokeRule make_crease(const FoldSet& set, const FoldLine& line, double strength) {
  constexpr double kEnd = 0.02;
  StrokeRule rule{.name = set.name.c_str(),
                  .points = {},
                  // In profile the others would be scratches, and beside an outline a second one.
                  .is_of_front = set.name != "forehead",
                  .is_of_near = set.name == "forehead",
                  .is_of_level = set.name == "cheek",
                  .widths = {},
                  .lift_mm = 0.35,
                  .flat = 0.4};
  const std::vector<double>& depths = line.ink.empty() ? line.depths : line.ink;
  for (std::size_t i = 0; i < depths.size(); ++i)
    rule.widths.push_back(
        {static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(2, depths.size()) - 1),
         std::max(kEnd, set.ink * strength * depths[i])});
  return rule;
}

// The places of a fold's line on the fine skin at rest: a chord between points of the cage would dive into
// the skin and come out again, as dashes.
std::vector<StrokePoint> trace_line(const Mesh& skin, const Cage& cage, const FoldLine& line, float side) {
  constexpr int kPlaces = 24;
  constexpr float kRoom_mm = 6;
  std::vector<glm::vec3> way;
  for (const FoldPoint& point : line.through)
    way.push_back(glm::mix(skin.positions[find_sided(cage, point.from, side)],
                           skin.positions[find_sided(cage, point.to, side)],
                           static_cast<float>(point.share)));
  Box box = compute_bounds(way);
  box.low -= kRoom_mm;
  box.high += kRoom_mm;
  const SkinPatch patch = build_skin_patch(skin, box);
  std::vector<StrokePoint> places;
  for (int i = 0; i < kPlaces; ++i) {
    const double at = static_cast<double>(i) / (kPlaces - 1) * static_cast<double>(way.size() - 1);
    const SkinPlace place = find_nearest_place(patch, sample_curve(way, at));
    places.push_back({skin.triangles[place.triangle], place.barycentric});
  }
  return places;
}

constexpr double kBrowEye_mm = 16;  // the eye that brows and wings are told on: a drawn adult's, nearly

}  // namespace

double find_stroke_width(const std::vector<StrokeWidth>& widths, double at) {
  if (widths.size() == 1) return widths.front().width;  // as wide all along
  std::size_t i = 1;
  while (i + 1 < widths.size() && widths[i].at < at) ++i;
  const StrokeWidth &a = widths[i - 1], &b = widths[i];
  return std::lerp(a.width, b.width, std::clamp((at - a.at) / (b.at - a.at), 0.0, 1.0));
}

std::vector<InkStroke> list_strokes(const Figure& figure, const HeadSpec& spec,
                                    std::vector<FoldField>& folds) {
  // What is drawn says more than skin would show: a child's frown is a thin line, not none, and an old face
  // has its lines at rest.
  constexpr double kMostStrength = 1.3, kTold = 0.7, kRest = 1.7;
  const Cage& cage = figure.head.cage;
  std::vector<InkStroke> strokes;
  for (const StrokeRule& rule : list_stroke_rules())
    for (const float side : {1.0f, -1.0f}) {
      if (side < 0 && !rule.is_sided) continue;
      InkStroke stroke{rule, {}, {}, {}, side, {}};
      if (rule.is_brow)
        for (StrokeWidth& width : stroke.rule.widths) width.width *= figure.head.brow_thickness;
      for (const char* name : rule.points) {
        const std::uint32_t point = find_sided(cage, name, side);
        stroke.points.push_back({{point, point, point}, {1, 0, 0}});
      }
      for (const char* name : rule.facing) stroke.facing.push_back(find_sided(cage, name, side));
      for (const auto& [one, other] : rule.before)
        stroke.before.push_back({find_sided(cage, one, side), find_sided(cage, other, side)});
      strokes.push_back(std::move(stroke));
    }
  const FoldData& data = figure.head.data->folds;
  const double strength = std::min(kMostStrength, std::pow(compute_fold_strength(data, spec), kTold));
  for (std::size_t f = 0; f < data.sets.size(); ++f) {
    if (data.sets[f].ink == 0) continue;
    FoldField field = figure.folds.fields[f];
    field.vertices.clear();
    field.rest = std::min(1.0, kRest * field.rest);
    for (const FoldLine& line : data.sets[f].lines)
      for (const float side : {1.0f, -1.0f}) {
        InkStroke stroke{make_crease(data.sets[f], line, strength), {}, {}, {}, side, folds.size()};
        stroke.points = trace_line(figure.model.parts.front().rest, cage, line, side);
        strokes.push_back(std::move(stroke));
      }
    folds.push_back(std::move(field));
  }
  return strokes;
}

std::vector<Triangle> list_stroke_triangles(std::uint32_t first) {
  std::vector<Triangle> triangles;
  const auto at = [&](int step, int spoke) {
    return first + static_cast<std::uint32_t>(step * kStrokeSpokes + spoke % kStrokeSpokes);
  };
  for (int i = 0; i + 1 < kStrokeSteps; ++i)
    for (int k = 0; k < kStrokeSpokes; ++k) {
      triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
      triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
    }
  return triangles;
}

void append_tube(const Tube& tube, double flat, std::vector<glm::vec3>& vertices) {
  const auto& [centres, lifts, halves] = tube;
  const std::size_t last = centres.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const glm::vec3 along = centres[std::min(i + 1, last)] - centres[std::max<std::size_t>(i, 1) - 1];
    const glm::vec3 across = glm::cross(along, lifts[i]);
    const float length = glm::length(across);
    const glm::vec3 aside = length > 1e-6f ? across / length : glm::vec3(0, 1, 0);
    const glm::vec3 up = glm::length(along) > 1e-6f ? glm::normalize(glm::cross(aside, along)) : lifts[i];
    for (int k = 0; k < kStrokeSpokes; ++k) {
      const double turn = 2 * std::numbers::pi * k / kStrokeSpokes;
      vertices.push_back(centres[i] + halves[i] * (static_cast<float>(std::cos(turn)) * aside +
                                                   static_cast<float>(flat * std::sin(turn)) * up));
    }
  }
}

void append_stroke(const InkStroke& stroke, double amount, const StrokeGround& ground,
                   std::vector<glm::vec3>& vertices) {
  // A stroke dives into the skin where it gets thinner than that, in lines: a fold's grows from its middle,
  // and none is a row of dots.
  constexpr double kThin = 0.12, kDrawn = 0.22, kDived_mm = -1.5;
  constexpr float kAside = 0.2f;  // of a rule's `faced`: there nothing is drawn
  constexpr float kShown = 0.3f;
  constexpr int kRounds = 3;                                    // of smoothing
  constexpr float kProfile = 0.1f, kEdge = 0.1f, kFace = 0.5f;  // of its lift; cosines as well
  const StrokeRule& rule = stroke.rule;
  if (stroke.fold) {  // one that is nowhere thicker would be a speck
    constexpr double kLeast = 0.2, kWhole = 0.27;
    const double most = std::ranges::max_element(rule.widths, {}, &StrokeWidth::width)->width;
    amount *= smooth_step(kLeast, kWhole, amount * most);
  }
  const auto find_lift_mm = [&](double at) {
    if (rule.is_brow) return rule.lift_mm;
    return std::lerp(kDived_mm, rule.lift_mm,
                     smooth_step(kThin, kDrawn, amount * find_stroke_width(rule.widths, at)));
  };
  const auto eye = static_cast<float>(ground.eye_size * 13 / kBrowEye_mm);
  std::vector<glm::vec3> line, ups;
  for (const StrokePoint& point : stroke.points) {
    const auto mix = [&](const std::vector<glm::vec3>& values) {
      glm::vec3 sum(0);
      for (int i = 0; i < 3; ++i) sum += point.shares[i] * values[point.vertices[i]];
      return sum;
    };
    line.push_back(mix(ground.positions));
    ups.push_back(glm::normalize(mix(ground.normals)));
  }
  if (!stroke.facing.empty()) {
    glm::vec3 facing(0);
    for (const std::uint32_t point : stroke.facing) facing += ground.normals[point];
    for (glm::vec3& up : ups) up = glm::normalize(0.3f * up + 0.8f * glm::normalize(facing));
  }
  if (rule.is_smooth)
    for (int round = 0; round < kRounds; ++round) {
      const std::vector<glm::vec3> before = line;
      for (std::size_t i = 1; i + 1 < line.size(); ++i)
        line[i] = glm::mix(0.25f * before[i - 1] + 0.5f * before[i] + 0.25f * before[i + 1], before[i],
                           std::max(ground.beside, 1 - ground.met));
    }
  // Toward the camera, or it would leave the slit that it is drawn along.
  for (std::size_t i = 0; i < stroke.before.size(); ++i) {
    const float met = ground.met * (1 - ground.beside);
    ups[i] = glm::normalize(ground.camera_mm - line[i]);
    for (const std::uint32_t point : stroke.before[i]) {
      const float ahead = glm::dot(ground.positions[point] - line[i], ups[i]);
      line[i] += std::max(0.0f, ahead) * met * ups[i];
    }
  }
  if (rule.wing != glm::vec3(0)) {
    // Beyond the outer corner, told in the frame of the skin there.
    const glm::vec3 along = glm::normalize(line.back() - line[line.size() - 3]);
    const glm::vec3 up = ups.back(), over = glm::normalize(glm::cross(up, along)) * stroke.side;
    line.push_back(line.back() + eye * (rule.wing.x * along + rule.wing.y * over + rule.wing.z * up * 0.3f));
    ups.push_back(up);
  }
  std::vector<glm::vec3> centres(kStrokeSteps), lifts(kStrokeSteps);
  const auto last = static_cast<double>(line.size() - 1);
  for (int i = 0; i < kStrokeSteps; ++i) {
    const double less = rule.less_below * static_cast<double>(ground.below);
    const double at =
        std::lerp(rule.from + less, rule.to - less, static_cast<double>(i) / (kStrokeSteps - 1));
    lifts[i] = glm::normalize(sample_curve(ups, at * last));
    centres[i] = sample_curve(line, at * last);
    // Seen along the skin, what stands off it is a second line beside its edge.
    const float faced = std::abs(glm::dot(lifts[i], glm::normalize(ground.camera_mm - centres[i])));
    const float lift = rule.lies_in_profile ? std::lerp(kProfile, 1.0f, smooth_step(kEdge, kFace, faced)) : 1;
    centres[i] += lift * static_cast<float>(find_lift_mm(at)) * eye * lifts[i];
  }
  std::vector<float> halves;
  for (int i = 0; i < kStrokeSteps; ++i) {
    const double at = static_cast<double>(i) / (kStrokeSteps - 1);
    const double unit = std::lerp(1.0f, rule.in_profile, ground.beside) *
                        (rule.is_brow ? ground.eye_size * 13 / kBrowEye_mm : ground.line_mm);
    // Of ridges and of folds no more is drawn where they are seen along.
    const float faced = smooth_step(kAside * rule.faced, rule.faced,
                                    glm::dot(lifts[i], glm::normalize(ground.camera_mm - centres[i])));
    float shown = rule.is_ridge ? static_cast<float>(amount) * faced : stroke.fold ? faced : 1.0f;
    shown *= std::lerp(1.0f, std::min(rule.in_profile, 1.0f), static_cast<float>(ground.beside));
    // A thread that is as thin as it may be would be a row of dots.
    if (shown < kShown) centres[i] += static_cast<float>(kDived_mm) * (1 - shown / kShown) * eye * lifts[i];
    const auto half =
        static_cast<float>(std::max(0.02, unit * amount * shown * find_stroke_width(rule.widths, at)));
    halves.push_back(half);
  }
  append_tube({centres, lifts, halves}, rule.flat, vertices);
}

}  // namespace mien
