// Teeth and lips are a floor and a ceiling over a grid seen from above, both in the jaw's rest space, where
// the lower teeth stand still. The tongue's rings go forward and up by what is asked, come into the lane
// between floor and ceiling where they pass the teeth, and each vertex keeps to it.
#include "frames/tongue.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/smooth.hpp"
#include "head/cage.hpp"
#include "head/dental_arch.hpp"

namespace mien {

namespace {

// Millimetres of an adult's mouth.
constexpr double kFree_mm = 0.6;  // between the tongue and what it passes: less and the grid's steps touch
constexpr double kThinnest_mm = 1.5;  // of the tip between two teeth
constexpr double kOpening_mm = 1.2;   // beyond that, until what passes is free
constexpr double kUpReach_mm = 26;    // of the tongue behind its tip that rises with it
constexpr double kTipLength_mm = 9;   // of its front, which keeps its shape: what is behind grows longer
constexpr double kCome_mm = 9;        // before the teeth's edge, over which it comes into the lane
constexpr double kNear_mm = 1.8;      // half of the way between two rings of a tongue that is out
constexpr double kMoved_mm = 1.5;     // after which a ring keeps to the lane wholly
constexpr double kLick_mm = 12;       // a raised tongue that is out lies so far above the floor
constexpr double kBroad = 0.5;        // how much wider the front of a tongue that is out
constexpr double kOutThin = 0.4, kUpThin = 0.25;  // how much of its height the tongue loses

double find_value(const Face& face, const Pose& pose, std::string_view move) {
  return std::clamp(stiffen_pose(face, pose).values[*find_move(Area::tongue, Side::none, move)], 0.0, 1.0);
}

// Places on a mesh's triangles, so near to each other that none is more than `step` from the next.
void append_places(const Mesh& mesh, double step, double from_z, std::vector<glm::vec3>& places) {
  for (const auto& [ia, ib, ic] : mesh.triangles) {
    const glm::vec3 &a = mesh.positions[ia], &b = mesh.positions[ib], &c = mesh.positions[ic];
    if (std::max({a.z, b.z, c.z}) < from_z) continue;
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    const int count = std::max(1, static_cast<int>(std::ceil(longest / step)));
    for (int i = 0; i <= count; ++i)
      for (int k = 0; i + k <= count; ++k) {
        const float u = static_cast<float>(i) / static_cast<float>(count),
                    v = static_cast<float>(k) / static_cast<float>(count);
        places.push_back(a + u * (b - a) + v * (c - a));
      }
  }
}

// Neighbouring triangles share places.
void drop_repeated(std::vector<glm::vec3>& places) {
  std::ranges::sort(places, {}, [](const glm::vec3& p) { return std::array{p.x, p.y, p.z}; });
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

const Mesh* find_rest(const Model& model, std::string_view name) {
  for (const Part& part : model.parts)
    if (part.name == name) return &part.rest;
  return nullptr;
}

std::vector<TongueRing> list_rings(const Mesh& rest) {
  std::vector<TongueRing> rings(kTongueRings);
  const double tip_z = rest.positions.back().z;
  for (std::size_t r = 0; r < kTongueRings; ++r) {
    double low = 1e9, high = -1e9;
    for (std::size_t k = 0; k < kTonguePoints; ++k) {
      const glm::vec3& p = rest.positions[1 + r * kTonguePoints + k];
      low = std::min<double>(low, p.y);
      high = std::max<double>(high, p.y);
      rings[r].half_wide = std::max<double>(rings[r].half_wide, p.x);
      rings[r].z = p.z;
    }
    rings[r].y = 0.5 * (low + high);
    rings[r].half_high = 0.5 * (high - low);
    rings[r].from_tip = tip_z - rings[r].z;
  }
  return rings;
}

// What the tongue passes, over a grid of x and z.
struct Lane {
  static constexpr int kWide = 45, kLong = 72, kMiddle = kWide / 2;
  static constexpr float kNone = 1e6f;
  double step = 1, begin_z = 0, along = 0.7;  // mm
  std::array<float, static_cast<std::size_t>(kWide*kLong)> floor{}, ceiling{};
  std::array<bool, kWide> is_open{};  // columns with a lip above and a lip below
  int first_known = kLong;            // row of the first place, of teeth or lips, in the middle

  static std::size_t at(int x, int z) { return static_cast<std::size_t>(x * kLong + z); }
  // A cast is quicker than rounding, of what is above 0.
  static int find_nearest(double at) { return static_cast<int>(at + 1000.5) - 1000; }
  int find_x(double x) const { return find_nearest(x / step) + kMiddle; }
  int find_z(double z) const { return find_nearest((z - begin_z) / along); }
};

// The highest and the lowest places in each cell of the grid and of one more all round.
struct Heights {
  static constexpr int kWide = Lane::kWide + 2, kLong = Lane::kLong + 2;
  std::array<float, static_cast<std::size_t>(kWide*kLong)> highest{}, lowest{};

  static std::size_t at(int x, int z) { return static_cast<std::size_t>((x + 1) * kLong + z + 1); }
};

void add_place(const Lane& lane, const glm::dvec3& p, bool is_below, Heights& heights) {
  const int x = lane.find_x(p.x), z = lane.find_z(p.z);
  if (x < -1 || x > Lane::kWide || z < -1 || z > Lane::kLong) return;
  const std::size_t cell = Heights::at(x, z);
  const auto y = static_cast<float>(p.y);
  if (is_below)
    heights.highest[cell] = std::max(heights.highest[cell], y);
  else
    heights.lowest[cell] = std::min(heights.lowest[cell], y);
}

// Each place counts for its neighbours too: teeth have points.
void take_heights(const Heights& heights, Lane& lane) {
  for (int x = 0; x < Lane::kWide; ++x)
    for (int z = 0; z < Lane::kLong; ++z) {
      float& floor = lane.floor[Lane::at(x, z)];
      float& ceiling = lane.ceiling[Lane::at(x, z)];
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
  for (int k = 0; k < Lane::kLong; ++k) {
    if (row[k] == none) continue;
    if (last < 0)
      for (int i = 0; i < k; ++i) row[i] = row[k] + behind * static_cast<float>(k - i);
    else
      for (int i = last + 1; i < k; ++i)
        row[i] = std::lerp(row[last], row[k], static_cast<float>(i - last) / static_cast<float>(k - last));
    last = k;
  }
  if (last >= 0)
    for (int i = last + 1; i < Lane::kLong; ++i) row[i] = row[last] + before * static_cast<float>(i - last);
}

void smooth_columns(std::array<float, static_cast<std::size_t>(Lane::kWide* Lane::kLong)>& values) {
  const auto before = values;
  for (int x = 0; x < Lane::kWide; ++x)
    for (int z = 1; z + 1 < Lane::kLong; ++z)
      values[Lane::at(x, z)] =
          (before[Lane::at(x, z - 1)] + 2 * before[Lane::at(x, z)] + before[Lane::at(x, z + 1)]) / 4;
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
Lane make_lane(const TongueRig& rig) {
  Lane lane;
  lane.step *= rig.scale;
  lane.along *= rig.scale;
  lane.begin_z = rig.tip.z - 8 * rig.scale;
  lane.floor.fill(-Lane::kNone);
  lane.ceiling.fill(Lane::kNone);
  return lane;
}

Lane build_lane(const TongueRig& rig, const Face& face, const glm::dmat4& into_jaw,
                const std::vector<glm::dvec3>& points) {
  constexpr float kBehind = 2, kFloorBefore = -0.45f, kCeilingBefore = 0.5f;  // mm a mm
  Lane lane = make_lane(rig);
  Heights heights;
  std::ranges::copy(rig.lower_heights, heights.highest.begin());
  heights.lowest.fill(Lane::kNone);
  for (const glm::vec3& p : rig.upper)
    add_place(lane, glm::dvec3(into_jaw * glm::dvec4(glm::dvec3(p), 1)), false, heights);
  std::array<bool, Lane::kWide> has_upper{}, has_lower{};
  const auto mark = [&](std::array<bool, Lane::kWide>& has, const glm::dvec3& p) {
    if (const int x = lane.find_x(p.x); x >= 0 && x < Lane::kWide) has[static_cast<std::size_t>(x)] = true;
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
  for (int x = 0; x < Lane::kWide; ++x) {
    lane.is_open[static_cast<std::size_t>(x)] =
        has_upper[static_cast<std::size_t>(x)] && has_lower[static_cast<std::size_t>(x)];
    const auto mm = static_cast<float>(lane.along);
    fill_column(&lane.floor[Lane::at(x, 0)], -Lane::kNone, -kBehind * mm, kFloorBefore * mm);
    fill_column(&lane.ceiling[Lane::at(x, 0)], Lane::kNone, kBehind * mm, kCeilingBefore * mm);
  }
  smooth_columns(lane.floor);
  smooth_columns(lane.ceiling);
  return lane;
}

// Between the grid's places, at the nearest of its ends beyond.
double sample(const Lane& lane,
              const std::array<float, static_cast<std::size_t>(Lane::kWide* Lane::kLong)>& of, double x,
              double z) {
  const double at_x = std::clamp(x / lane.step + Lane::kMiddle, 0.0, Lane::kWide - 1.001);
  const double at_z = std::clamp((z - lane.begin_z) / lane.along, 0.0, Lane::kLong - 1.001);
  const int i = static_cast<int>(at_x), k = static_cast<int>(at_z);
  const double u = at_x - i, v = at_z - k;
  const auto value = [&](int a, int b) { return double(of[Lane::at(a, b)]); };
  return std::lerp(std::lerp(value(i, k), value(i, k + 1), v),
                   std::lerp(value(i + 1, k), value(i + 1, k + 1), v), u);
}

// The lane along the middle of the mouth, and what it lets through.
struct Passage {
  std::array<double, Lane::kLong> floor{}, ceiling{};
  std::array<double, Lane::kLong> left{}, right{};  // how wide a tongue gets so far, mm, on either side
  double way_mm = 0;                                // how far the tip gets
};

double compute_pass(const TongueRig& rig, double room_mm) {
  const double free_mm = room_mm - rig.scale * (2 * kFree_mm + kThinnest_mm);
  return smooth_step(0, kOpening_mm * rig.scale, free_mm);
}

Passage build_passage(const TongueRig& rig, const Lane& lane) {
  constexpr int kAbreast = 3;  // columns on either side of the middle that the tip needs
  Passage passage;
  double pass = 1;
  std::array<double, 2> wide{};
  wide.fill(Lane::kMiddle * lane.step);
  for (int z = 0; z < Lane::kLong; ++z) {
    double floor = -1e9, ceiling = 1e9;
    for (int x = Lane::kMiddle - kAbreast; x <= Lane::kMiddle + kAbreast; ++x) {
      floor = std::max<double>(floor, lane.floor[Lane::at(x, z)]);
      ceiling = std::min<double>(ceiling, lane.ceiling[Lane::at(x, z)]);
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
      for (int i = 0; i <= Lane::kMiddle; ++i) {
        const int x = Lane::kMiddle + (side == 0 ? i : -i);
        const bool is_shut = at_z > rig.edge_z && !lane.is_open[static_cast<std::size_t>(x)];
        through = std::min(through, is_shut ? 0
                                            : compute_pass(rig, double(lane.ceiling[Lane::at(x, z)]) -
                                                                    lane.floor[Lane::at(x, z)]));
        width += through * lane.step;
      }
      if (at_z > rig.edge_z - kCome_mm * rig.scale)
        wide[static_cast<std::size_t>(side)] = std::min(wide[static_cast<std::size_t>(side)], width);
    }
    passage.left[static_cast<std::size_t>(z)] = wide[0];
    passage.right[static_cast<std::size_t>(z)] = wide[1];
  }
  // A ring is as narrow as what the next one passes.
  constexpr std::size_t kAhead = 6;
  for (std::size_t z = 0; z < Lane::kLong; ++z) {
    const std::size_t ahead = std::min<std::size_t>(z + kAhead, Lane::kLong - 1);
    passage.left[z] = passage.left[ahead];
    passage.right[z] = passage.right[ahead];
  }
  return passage;
}

double sample(const Lane& lane, const std::array<double, Lane::kLong>& of, double z) {
  const double at = std::clamp((z - lane.begin_z) / lane.along, 0.0, Lane::kLong - 1.001);
  const auto i = static_cast<std::size_t>(at);
  return std::lerp(of[i], of[i + 1], at - static_cast<double>(i));
}

// Where a ring comes to.
struct MovedRing {
  double y = 0, z = 0, high = 1, left = 1, right = 1;  // high, left and right times what they were
  double moved = 0;                                    // 0 not at all .. 1: it keeps to the lane
};

// What is asked of the tongue in one pose.
struct TongueWay {
  double out_mm = 0, out_share = 0, up = 0;
  glm::dvec2 rise_mm{0};  // of the tip, y and z, at up 1
};

MovedRing move_ring(const TongueRig& rig, const TongueRing& ring, const TongueWay& way, const Lane& lane,
                    const Passage& passage) {
  const double scale = rig.scale, length = rig.rings.front().from_tip;
  const double forward = 1 - smooth_step(kTipLength_mm * scale, 0.95 * length, ring.from_tip);
  const double rise = way.up * (1 - smooth_step(0, kUpReach_mm * scale, ring.from_tip));
  const double settle = 3 * scale / (3 * scale + way.out_mm);  // a tip that is out has left the ridge
  MovedRing moved;
  moved.z = ring.z + forward * way.out_mm + rise * way.rise_mm.y * settle;
  moved.y = ring.y + rise * way.rise_mm.x;
  moved.high = std::max(0.5, 1 - kOutThin * way.out_share * forward - kUpThin * rise);
  const double half = moved.high * ring.half_high, free = kFree_mm * scale;
  const double in_lane =
      smooth_step(rig.edge_z - kCome_mm * scale, rig.edge_z, moved.z) * smooth_step(0, 4 * scale, way.out_mm);
  if (in_lane > 0) {
    const double floor = sample(lane, passage.floor, moved.z),
                 ceiling = sample(lane, passage.ceiling, moved.z);
    const double low = floor + free + half, high = std::min(ceiling - free - half, low + kLick_mm * scale);
    const double lane_y = high < low ? 0.5 * (floor + ceiling) : glm::mix(low, high, way.up);
    moved.y = glm::mix(moved.y, lane_y, in_lane);
  }
  const double is_past = smooth_step(rig.edge_z - kCome_mm * scale, rig.edge_z - 2 * scale, moved.z);
  moved.moved = smooth_step(0, kMoved_mm * scale, std::hypot(moved.y - ring.y, moved.z - ring.z));
  // A tip that is out is blunt.
  const double broad = 1 + kBroad * way.out_share * (1 - smooth_step(4 * scale, 16 * scale, ring.from_tip));
  const auto narrow = [&](const std::array<double, Lane::kLong>& wide) {
    const double share = std::min(broad, sample(lane, wide, moved.z) / std::max(ring.half_wide, 0.1));
    return glm::mix(1.0, share, is_past * moved.moved);
  };
  moved.left = narrow(passage.left);
  moved.right = narrow(passage.right);
  return moved;
}

glm::vec3 place_vertex(const TongueRing& ring, const MovedRing& moved, const TongueRig& rig, const Lane& lane,
                       const glm::vec3& rest) {
  const double x = rest.x * (rest.x > 0 ? moved.left : moved.right);
  const double z = moved.z + (rest.z - ring.z), y = moved.y + moved.high * (rest.y - ring.y);
  const double free = kFree_mm * rig.scale;
  const double near = kNear_mm * rig.scale;
  double low = -1e9, high = 1e9;
  for (const double at_z : {z - near, z, z + near}) {  // the way to the next ring, too
    low = std::max(low, sample(lane, lane.floor, x, at_z) + free);
    high = std::min(high, sample(lane, lane.ceiling, x, at_z) - free);
  }
  const double kept = high < low ? 0.5 * (low + high) : std::clamp(y, low, high);
  return {x, glm::mix(y, kept, moved.moved), z};
}

}  // namespace

TongueRig build_tongue_rig(const NeutralHead& head, const Model& model) {
  TongueRig rig;
  for (std::size_t i = 0; i < model.parts.size(); ++i)
    if (model.parts[i].name == "tongue") rig.part = i;
  if (rig.part == TongueRig::kNone) return rig;
  rig.rest = {model.parts[rig.part].rest.positions, {}, model.parts[rig.part].rest.triangles};
  rig.rings = list_rings(rig.rest);
  rig.scale = head.cage.points[find_point(head.cage, "M1_6")].x / head.data->parts.mouth.corner_mm;
  rig.tip = glm::dvec3(rig.rest.positions.back());
  const double from_z = rig.tip.z - 9 * rig.scale;
  for (const auto& [name, places] : {std::pair{"teeth_upper", &rig.upper},
                                     {"gum_upper", &rig.upper},
                                     {"teeth_lower", &rig.lower},
                                     {"gum_lower", &rig.lower}})
    if (const Mesh* mesh = find_rest(model, name)) append_places(*mesh, 0.8 * rig.scale, from_z, *places);
  const Lane lane = make_lane(rig);
  Heights heights;
  heights.highest.fill(-Lane::kNone);
  for (const glm::vec3& p : rig.lower) add_place(lane, glm::dvec3(p), true, heights);
  rig.lower_heights.assign(heights.highest.begin(), heights.highest.end());
  double upper_edge = 1e9, lower_edge = -1e9;
  const double middle = 3 * rig.scale;
  for (const glm::vec3& p : rig.upper)
    if (std::abs(p.x) < middle) upper_edge = std::min<double>(upper_edge, p.y);
  for (const glm::vec3& p : rig.lower)
    if (std::abs(p.x) < middle && p.y > lower_edge) {
      lower_edge = p.y;
      rig.edge_z = p.z;
    }
  // Behind the teeth at the height of their gum.
  const double ridge_y = upper_edge + 6 * rig.scale, around = 1.5 * rig.scale;
  double back = 1e9;
  for (const glm::vec3& p : rig.upper)
    if (std::abs(p.x) < middle && std::abs(p.y - ridge_y) < around) back = std::min<double>(back, p.z);
  rig.ridge = {0, ridge_y, std::min(back, rig.edge_z) - 1.2 * rig.scale};
  drop_repeated(rig.upper);
  return rig;
}

bool bend_tongue(const TongueRig& rig, const Face& face, const Pose& pose,
                 const std::vector<glm::dvec3>& points, Mesh& bent) {
  constexpr double kHeld = 0.8;  // of its way out, by lips that are pressed or rolled in
  const auto lips = [&](std::string_view move) {
    return std::clamp(pose.values[*find_move(Area::lips, Side::none, move)], 0.0, 1.0);
  };
  const double up = find_value(face, pose, "up"),
               out = find_value(face, pose, "out") * (1 - kHeld * lips("press")) * (1 - kHeld * lips("roll"));
  if (rig.part == TongueRig::kNone || (out == 0 && up == 0)) return false;
  const glm::dmat4 into_jaw = glm::inverse(compute_jaw(face, pose));
  const Lane lane = build_lane(rig, face, into_jaw, points);
  const Passage passage = build_passage(rig, lane);
  TongueWay way;
  way.up = up;
  way.out_mm = std::min(out * face.tongue_out_mm, passage.way_mm);
  way.out_share = way.out_mm / face.tongue_out_mm;
  const glm::dvec3 ridge = glm::dvec3(into_jaw * glm::dvec4(rig.ridge, 1)) - rig.tip;
  way.rise_mm = {std::min(std::max(ridge.y, 0.0), face.tongue_up_mm), std::min(ridge.z, 4 * rig.scale)};

  bent.positions.resize(rig.rest.positions.size());
  bent.triangles = rig.rest.triangles;
  for (std::size_t r = 0; r < rig.rings.size(); ++r) {
    const MovedRing moved = move_ring(rig, rig.rings[r], way, lane, passage);
    const auto place = [&](std::size_t v) {
      bent.positions[v] = place_vertex(rig.rings[r], moved, rig, lane, rig.rest.positions[v]);
    };
    if (r == 0) place(0);
    for (std::size_t k = 0; k < kTonguePoints; ++k) place(1 + r * kTonguePoints + k);
    if (r + 1 == rig.rings.size()) place(bent.positions.size() - 1);
  }
  update_normals(bent);
  return true;
}

}  // namespace mien
