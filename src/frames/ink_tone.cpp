#include "frames/ink_tone.hpp"

#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <tuple>

#include "core/error.hpp"
#include "head/cage.hpp"
#include "head/surface.hpp"

namespace mien {

struct Heat {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> step;
  Eigen::VectorXd areas;  // of each point of the cage, mm2; of those that say nothing hardly any
};

struct InkTone {
  Heat faced, turned;  // as the head is seen: the face, and one of its sides
  std::shared_ptr<const Surface> surface;
  std::vector<std::array<std::uint32_t, 2>> parents;  // of the fine skin's vertices behind the surface's
};

bool is_bridge(std::string_view point) {
  if (point.starts_with("R:")) return false;
  for (const char* ring : {"_g", "_n", "_s", "_b1"})
    if (point.ends_with(ring)) return true;
  // And what lies between it and the inner corner of the eye.
  for (const char* ring : {"E2_", "E3_", "E4_", "E5_"})
    for (const char* place : {"0", "1", "2", "3", "12", "13", "14", "15"})
      if (point.starts_with(ring) && point.substr(3) == place) return true;
  return point == "k_b2" || point == "c3_b2";
}

float measure_nose_mm(const Figure& figure) {
  const auto find_z = [&](const char* name) {
    return figure.head.skin.positions[find_point(figure.head.cage, name)].z;
  };
  const auto size = static_cast<float>(figure.head.eye.radius_mm / figure.head.adult_eye.radius_mm);
  return (find_z("p_tip") - find_z("M5_0")) / size;
}

namespace {

// Of an edge of the cage: the width that heat crosses, over its length.
using EdgeShares = std::map<std::array<std::uint32_t, 2>, double>;

void prepare_heat(const EdgeShares& shares, double time, Heat& heat) {
  const Eigen::Index count = heat.areas.size();
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i < count; ++i) entries.emplace_back(i, i, heat.areas[i]);
  for (const auto& [edge, share] : shares) {
    const auto a = static_cast<int>(edge[0]), b = static_cast<int>(edge[1]);
    for (const auto& [row, column, value] :
         {std::tuple(a, a, share), {b, b, share}, {a, b, -share}, {b, a, -share}})
      entries.emplace_back(row, column, time * value);
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  heat.step.compute(matrix);
  if (heat.step.info() != Eigen::Success) throw RunError("internal: tones cannot be spread over this head");
}

Eigen::MatrixX3d spread_heat(const Heat& heat, Eigen::MatrixX3d values) {
  constexpr int kSteps = 2;
  for (int i = 0; i < kSteps; ++i) values = heat.step.solve(heat.areas.asDiagonal() * values).eval();
  return values;
}

}  // namespace

InkTonePointer build_ink_tone(const Figure& figure) {
  constexpr double kSpread_mm = 5;  // how far, on an adult's head
  const Cage& cage = figure.head.cage;
  const std::vector<glm::vec3>& places = figure.head.skin.positions;
  const auto size = figure.head.eye.radius_mm / figure.head.adult_eye.radius_mm;
  auto tone = std::make_shared<InkTone>();
  tone->surface = figure.head.surface;
  tone->parents = figure.folds.skin.parents;

  const auto count = static_cast<Eigen::Index>(cage.points.size());
  Eigen::VectorXd areas = Eigen::VectorXd::Constant(count, 1e-6);
  EdgeShares shares;
  for (const Quad& quad : cage.quads) {
    const auto at = [&](int i) { return glm::dvec3(places[quad[i % 4]]); };
    const double area = 0.5 * glm::length(glm::cross(at(2) - at(0), at(3) - at(1)));
    for (int i = 0; i < 4; ++i) {
      areas[quad[i]] += area / 4;
      const std::uint32_t from = quad[i], to = quad[(i + 1) % 4];
      const glm::dvec3 way = at(i + 1) - at(i);
      shares[{std::min(from, to), std::max(from, to)}] += 0.5 * area / std::max(1e-6, glm::dot(way, way));
    }
  }
  // What folds at a mouth's corner and below its lower lip says nothing: its tone is that of the cheek and
  // the chin about it, or light specks stand in the shade there.
  constexpr double kCorner = 0.02;
  const auto hush = [&](const std::string& name) {
    const std::uint32_t left = find_point(cage, name);
    for (const std::uint32_t point : {left, cage.mirror[left]}) areas[point] *= kCorner;
  };
  for (const char* ring : {"M1_", "M2_", "M3_", "MA_", "M4_", "M5_"})
    for (int place = 5; place <= 12; ++place) hush(ring + std::to_string(place));
  // Nor does the cheek above the jaw, which bulges when a mouth goes aside: islands of shade.
  for (const char* column : {"q12_", "q11_", "q10_", "s1_", "s2_", "s3_"})
    for (const char* row : {"C7", "C8", "C9"}) hush(std::string(column) + row);
  // Nor does the inside of the mouth, whose walls look anywhere.
  for (const char* ring : {"M0_", "MB1_", "MB2_"})
    for (int place = 0; place <= 12; ++place) hush(ring + std::to_string(place));
  // Nor does a nostril's rim, nor do the lids' margins.
  for (const char* ring : {"nr_", "ni_", "nd_"})
    for (int place = 0; place < 8; ++place) hush(ring + std::to_string(place));
  for (const char* ring : {"E0_", "E1_"})
    for (int place = 0; place < 16; ++place) hush(ring + std::to_string(place));
  // Nor does the nose's bridge between the eyes: its shade would run from there to the tip in pieces.
  for (const std::string& name : cage.names)
    if (is_bridge(name)) hush(name);
  // Nor does a button of a nose: its shade would be a third nostril.
  constexpr double kNose_mm = 16;
  const bool is_button = measure_nose_mm(figure) < kButtonNose_mm;
  if (is_button) {
    const glm::vec3 tip = places[find_point(cage, "p_tip")];
    for (std::size_t point = 0; point < cage.names.size(); ++point)
      if (glm::distance(tip, places[point]) < kNose_mm * size)
        areas[static_cast<Eigen::Index>(point)] *= kCorner;
  }
  const double time = 0.5 * kSpread_mm * kSpread_mm * size;
  tone->faced.areas = areas;
  prepare_heat(shares, time, tone->faced);
  // Nor does the cheek below a far eye: chips of light on the shaded side.
  for (const char* point :
       {"E2_11", "E3_11", "E4_11", "E5_11", "q13_C1", "q12_C1", "q13_C2", "q13_C3", "q12_C2", "q12_C3"})
    hush(point);
  tone->turned.areas = areas;
  prepare_heat(shares, time, tone->turned);
  return tone;
}

void compute_tones(const InkTone& tone, double turned, const std::vector<glm::vec3>& normals,
                   InkToneBuffers& buffers, std::vector<glm::vec3>& tones) {
  const Eigen::Index count = tone.faced.areas.size();
  Eigen::MatrixX3d heat(count, 3);
  for (Eigen::Index i = 0; i < count; ++i)
    for (int axis = 0; axis < 3; ++axis) heat(i, axis) = normals[static_cast<std::size_t>(i)][axis];
  if (turned <= 0)
    heat = spread_heat(tone.faced, std::move(heat));
  else if (turned >= 1)
    heat = spread_heat(tone.turned, std::move(heat));
  else
    heat = (1 - turned) * spread_heat(tone.faced, heat) + turned * spread_heat(tone.turned, heat);
  buffers.points.resize(static_cast<std::size_t>(count));
  for (Eigen::Index i = 0; i < count; ++i)
    buffers.points[static_cast<std::size_t>(i)] = pack(glm::vec3(heat(i, 0), heat(i, 1), heat(i, 2)));
  deform_surface(*tone.surface, buffers.points, tones);
  for (glm::vec3& direction : tones) direction = glm::normalize(direction + glm::vec3(0, 0, 1e-9f));
  for (const auto& [a, b] : tone.parents) tones.push_back(glm::normalize(tones[a] + tones[b]));
}

}  // namespace mien
