#include "frames/tongue_lane.hpp"

#include <algorithm>
#include <cmath>

#include "core/smooth.hpp"

namespace mien {

namespace {

constexpr double kThinnest_mm = 1.5;  // of the tip between two teeth
constexpr double kOpening_mm = 1.2;   // beyond that, until what passes is free

// The highest and the lowest places in each cell of the grid and of one more all round.
struct Heights {
  static constexpr int kWide = TongueLane::kWide + 2, kLong = TongueLane::kLong + 2;
  std::array<float, static_cast<std::size_t>(kWide*kLong)> highest{}, lowest{};

  static std::size_t at(int x, int z) { return static_cast<std::size_t>((x + 1) * kLong + z + 1); }
};

void add_place(const TongueLane& lane, const glm::dvec3& p, bool is_below, Heights& heights) {
  const int x = lane.find_x(p.x), z = lane.find_z(p.z);
  if (x < -1 || x > TongueLane::kWide || z < -1 || z > TongueLane::kLong) return;
  const std::size_t cell = Heights::at(x, z);
  const auto y = static_cast<float>(p.y);
  if (is_below)
    heights.highest[cell] = std::max(heights.highest[cell], y);
  else
    heights.lowest[cell] = std::min(heights.lowest[cell], y);
}

// Each place counts for its neighbours too: teeth have points.
void take_heights(const Heights& heights, TongueLane& lane) {
  for (int x = 0; x < TongueLane::kWide; ++x)
    for (int z = 0; z < TongueLane::kLong; ++z) {
      float& floor = lane.floor[TongueLane::at(x, z)];
      float& ceiling = lane.ceiling[TongueLane::at(x, z)];
      for (int i = x - 1; i <= x + 1; ++i)
        for (int k = z - 1; k <= z + 1; ++k) {
          floor = std::max(floor, heights.highest[Heights::at(i, k)]);
          ceiling = std::min(ceiling, heights.lowest[Heights::at(i, k)]);
        }
    }
}

// Straight between what is known of a column; behind its first place the floor falls and the ceiling rises,
// before its last one both open slowly.
void fill_column(float* row, float none, float behind, float before) {
  int last = -1;
  for (int k = 0; k < TongueLane::kLong; ++k) {
    if (row[k] == none) continue;
    if (last < 0)
      for (int i = 0; i < k; ++i) row[i] = row[k] + behind * static_cast<float>(k - i);
    else
      for (int i = last + 1; i < k; ++i)
        row[i] = std::lerp(row[last], row[k], static_cast<float>(i - last) / static_cast<float>(k - last));
    last = k;
  }
  if (last >= 0)
    for (int i = last + 1; i < TongueLane::kLong; ++i)
      row[i] = row[last] + before * static_cast<float>(i - last);
}

void smooth_columns(TongueLane::Grid& values) {
  const auto before = values;
  for (int x = 0; x < TongueLane::kWide; ++x)
    for (int z = 1; z + 1 < TongueLane::kLong; ++z)
      values[TongueLane::at(x, z)] = (before[TongueLane::at(x, z - 1)] + 2 * before[TongueLane::at(x, z)] +
                                      before[TongueLane::at(x, z + 1)]) /
                                     4;
}

// The skin of a lip, into the floor or the ceiling, on both sides of the mouth.
template <typename Add>
void add_lip(const LipSheet& sheet, const std::vector<glm::dvec3>& points, const glm::dmat4& into_jaw,
             const Add& add) {
  static thread_local std::vector<glm::dvec3> at;
  constexpr int kSteps = 3;  // a quad of the skin is some two millimetres wide
  for (const Side side : {Side::left, Side::right}) {
    place_lip(sheet, points, side, at);
    for (glm::dvec3& p : at) {
      if (side == Side::right) p.x = -p.x;
      p = glm::dvec3(into_jaw * glm::dvec4(p, 1));
    }
    for (const auto& [a, b, c, d] : sheet.quads)
      for (int i = 0; i < kSteps; ++i)
        for (int k = 0; k < kSteps; ++k) {
          const double u = double(i) / kSteps, v = double(k) / kSteps;
          add(glm::mix(glm::mix(at[a], at[b], u), glm::mix(at[d], at[c], u), v));
        }
  }
}

// Without teeth and lips.
TongueLane make_lane(const TongueRig& rig) {
  TongueLane lane;
  lane.step *= rig.scale;
  lane.along *= rig.scale;
  lane.begin_z = rig.tip.z - 8 * rig.scale;
  lane.floor.fill(-TongueLane::kNone);
  lane.ceiling.fill(TongueLane::kNone);
  return lane;
}

double compute_pass(const TongueRig& rig, double room_mm) {
  const double free_mm = room_mm - rig.scale * (2 * kTongueFree_mm + kThinnest_mm);
  return smooth_step(0, kOpening_mm * rig.scale, free_mm);
}

}  // namespace

std::vector<float> measure_lower_heights(const TongueRig& rig) {
  const TongueLane lane = make_lane(rig);
  Heights heights;
  heights.highest.fill(-TongueLane::kNone);
  for (const glm::vec3& p : rig.lower) add_place(lane, glm::dvec3(p), true, heights);
  return {heights.highest.begin(), heights.highest.end()};
}

TongueLane build_tongue_lane(const TongueRig& rig, const Face& face, const glm::dmat4& into_jaw,
                             const std::vector<glm::dvec3>& points) {
  constexpr float kBehind = 2, kFloorBefore = -0.45f, kCeilingBefore = 0.5f;  // mm a mm
  TongueLane lane = make_lane(rig);
  Heights heights;
  std::ranges::copy(rig.lower_heights, heights.highest.begin());
  heights.lowest.fill(TongueLane::kNone);
  for (const glm::vec3& p : rig.upper)
    add_place(lane, glm::dvec3(into_jaw * glm::dvec4(glm::dvec3(p), 1)), false, heights);
  std::array<bool, TongueLane::kWide> has_upper{}, has_lower{};
  const auto mark = [&](std::array<bool, TongueLane::kWide>& has, const glm::dvec3& p) {
    if (const int x = lane.find_x(p.x); x >= 0 && x < TongueLane::kWide)
      has[static_cast<std::size_t>(x)] = true;
  };
  add_lip(face.upper_lip, points, into_jaw, [&](const glm::dvec3& p) {
    add_place(lane, p, false, heights);
    mark(has_upper, p);
  });
  add_lip(face.lower_lip, points, into_jaw, [&](const glm::dvec3& p) {
    add_place(lane, p, true, heights);
    mark(has_lower, p);
  });
  take_heights(heights, lane);
  for (int x = 0; x < TongueLane::kWide; ++x) {
    lane.is_open[static_cast<std::size_t>(x)] =
        has_upper[static_cast<std::size_t>(x)] && has_lower[static_cast<std::size_t>(x)];
    const auto mm = static_cast<float>(lane.along);
    fill_column(&lane.floor[TongueLane::at(x, 0)], -TongueLane::kNone, -kBehind * mm, kFloorBefore * mm);
    fill_column(&lane.ceiling[TongueLane::at(x, 0)], TongueLane::kNone, kBehind * mm, kCeilingBefore * mm);
  }
  smooth_columns(lane.floor);
  smooth_columns(lane.ceiling);
  return lane;
}

double sample_tongue_lane(const TongueLane& lane, const TongueLane::Grid& of, double x, double z) {
  const double at_x = std::clamp(x / lane.step + TongueLane::kMiddle, 0.0, TongueLane::kWide - 1.001);
  const double at_z = std::clamp((z - lane.begin_z) / lane.along, 0.0, TongueLane::kLong - 1.001);
  const int i = static_cast<int>(at_x), k = static_cast<int>(at_z);
  const double u = at_x - i, v = at_z - k;
  const auto value = [&](int a, int b) { return double(of[TongueLane::at(a, b)]); };
  return std::lerp(std::lerp(value(i, k), value(i, k + 1), v),
                   std::lerp(value(i + 1, k), value(i + 1, k + 1), v), u);
}

double sample_tongue_lane(const TongueLane& lane, const TonguePassage::Line& of, double z) {
  const double at = std::clamp((z - lane.begin_z) / lane.along, 0.0, TongueLane::kLong - 1.001);
  const auto i = static_cast<std::size_t>(at);
  return std::lerp(of[i], of[i + 1], at - static_cast<double>(i));
}

TonguePassage build_tongue_passage(const TongueRig& rig, const TongueLane& lane) {
  constexpr int kAbreast = 3;  // columns on either side of the middle that the tip needs
  TonguePassage passage;
  double pass = 1;
  std::array<double, 2> wide{};
  wide.fill(TongueLane::kMiddle * lane.step);
  for (int z = 0; z < TongueLane::kLong; ++z) {
    double floor = -1e9, ceiling = 1e9;
    for (int x = TongueLane::kMiddle - kAbreast; x <= TongueLane::kMiddle + kAbreast; ++x) {
      floor = std::max<double>(floor, lane.floor[TongueLane::at(x, z)]);
      ceiling = std::min<double>(ceiling, lane.ceiling[TongueLane::at(x, z)]);
    }
    passage.floor[static_cast<std::size_t>(z)] = floor;
    passage.ceiling[static_cast<std::size_t>(z)] = ceiling;
    const double at_z = lane.begin_z + z * lane.along;
    if (at_z > rig.tip.z) {
      pass = std::min(pass, compute_pass(rig, ceiling - floor));
      passage.way_mm += pass * lane.along;
    }
    for (const int side : {0, 1}) {
      double width = 0, through = 1;
      for (int i = 0; i <= TongueLane::kMiddle; ++i) {
        const int x = TongueLane::kMiddle + (side == 0 ? i : -i);
        const bool is_shut = at_z > rig.edge_z && !lane.is_open[static_cast<std::size_t>(x)];
        through = std::min(through, is_shut ? 0
                                            : compute_pass(rig, double(lane.ceiling[TongueLane::at(x, z)]) -
                                                                    lane.floor[TongueLane::at(x, z)]));
        width += through * lane.step;
      }
      if (at_z > rig.edge_z - kTongueCome_mm * rig.scale)
        wide[static_cast<std::size_t>(side)] = std::min(wide[static_cast<std::size_t>(side)], width);
    }
    passage.left[static_cast<std::size_t>(z)] = wide[0];
    passage.right[static_cast<std::size_t>(z)] = wide[1];
  }
  // A ring is as narrow as what the next one passes.
  constexpr std::size_t kAhead = 6;
  for (std::size_t z = 0; z < TongueLane::kLong; ++z) {
    const std::size_t ahead = std::min<std::size_t>(z + kAhead, TongueLane::kLong - 1);
    passage.left[z] = passage.left[ahead];
    passage.right[z] = passage.right[ahead];
  }
  return passage;
}

}  // namespace mien
