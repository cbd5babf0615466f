// Rings of the tongue go forward and up by what is asked, come into the lane between teeth and lips where
// they pass them (frames/tongue_lane.hpp), and each vertex keeps to it. All in the jaw's rest space.
#include "frames/tongue.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/smooth.hpp"
#include "frames/tongue_lane.hpp"
#include "head/cage.hpp"
#include "head/dental_arch.hpp"

namespace mien {

namespace {

// Millimetres of an adult's mouth.
constexpr double kUpReach_mm = 26;   // of the tongue behind its tip that rises with it
constexpr double kTipLength_mm = 9;  // of its front, which keeps its shape: what is behind grows longer
constexpr double kNear_mm = 1.8;     // half of the way between two rings of a tongue that is out
constexpr double kMoved_mm = 1.5;    // after which a ring keeps to the lane wholly
constexpr double kLick_mm = 12;      // a raised tongue that is out lies so far above the floor
constexpr double kBroad = 0.5;       // how much wider the front of a tongue that is out
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

MovedRing move_ring(const TongueRig& rig, const TongueRing& ring, const TongueWay& way,
                    const TongueLane& lane, const TonguePassage& passage) {
  const double scale = rig.scale, length = rig.rings.front().from_tip;
  const double forward = 1 - smooth_step(kTipLength_mm * scale, 0.95 * length, ring.from_tip);
  const double rise = way.up * (1 - smooth_step(0, kUpReach_mm * scale, ring.from_tip));
  const double settle = 3 * scale / (3 * scale + way.out_mm);  // a tip that is out has left the ridge
  MovedRing moved;
  moved.z = ring.z + forward * way.out_mm + rise * way.rise_mm.y * settle;
  moved.y = ring.y + rise * way.rise_mm.x;
  moved.high = std::max(0.5, 1 - kOutThin * way.out_share * forward - kUpThin * rise);
  const double half = moved.high * ring.half_high, free = kTongueFree_mm * scale;
  const double in_lane = smooth_step(rig.edge_z - kTongueCome_mm * scale, rig.edge_z, moved.z) *
                         smooth_step(0, 4 * scale, way.out_mm);
  if (in_lane > 0) {
    const double floor = sample_tongue_lane(lane, passage.floor, moved.z),
                 ceiling = sample_tongue_lane(lane, passage.ceiling, moved.z);
    const double low = floor + free + half, high = std::min(ceiling - free - half, low + kLick_mm * scale);
    const double lane_y = high < low ? 0.5 * (floor + ceiling) : glm::mix(low, high, way.up);
    moved.y = glm::mix(moved.y, lane_y, in_lane);
  }
  const double is_past = smooth_step(rig.edge_z - kTongueCome_mm * scale, rig.edge_z - 2 * scale, moved.z);
  moved.moved = smooth_step(0, kMoved_mm * scale, std::hypot(moved.y - ring.y, moved.z - ring.z));
  // A tip that is out is blunt.
  const double broad = 1 + kBroad * way.out_share * (1 - smooth_step(4 * scale, 16 * scale, ring.from_tip));
  const auto narrow = [&](const TonguePassage::Line& wide) {
    const double share =
        std::min(broad, sample_tongue_lane(lane, wide, moved.z) / std::max(ring.half_wide, 0.1));
    return glm::mix(1.0, share, is_past * moved.moved);
  };
  moved.left = narrow(passage.left);
  moved.right = narrow(passage.right);
  return moved;
}

glm::vec3 place_vertex(const TongueRing& ring, const MovedRing& moved, const TongueRig& rig,
                       const TongueLane& lane, const glm::vec3& rest) {
  const double x = rest.x * (rest.x > 0 ? moved.left : moved.right);
  const double z = moved.z + (rest.z - ring.z), y = moved.y + moved.high * (rest.y - ring.y);
  const double free = kTongueFree_mm * rig.scale;
  const double near = kNear_mm * rig.scale;
  double low = -1e9, high = 1e9;
  for (const double at_z : {z - near, z, z + near}) {  // the way to the next ring, too
    low = std::max(low, sample_tongue_lane(lane, lane.floor, x, at_z) + free);
    high = std::min(high, sample_tongue_lane(lane, lane.ceiling, x, at_z) - free);
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
  rig.lower_heights = measure_lower_heights(rig);
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
  const TongueLane lane = build_tongue_lane(rig, face, into_jaw, points);
  const TonguePassage passage = build_tongue_passage(rig, lane);
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
