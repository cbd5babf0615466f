// Shading a height over a surface by its gradient: Blinn, "Simulation of wrinkled surfaces", 1978. Folds lie
// across the pull of the muscle under them (Langer's and Kraissl's lines).
#include "face/folds.hpp"

#include <algorithm>
#include <cmath>

#include "face/fold_tracks.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

// Of a height, in the skin's shape; its shading has all of it. More, and the facets of a groove throw shadows
// with teeth.
constexpr float kRelief = 0.5f;
constexpr float kNothing_mm = 0.002f;  // a height below it is none

// What part of a fold at x belongs to the left side; the rest is the right side's.
double find_left_share(const FoldSet& set, double x_mm) {
  if (set.across_mm == 0) return x_mm >= 0 ? 1 : 0;
  return smooth_step(-set.across_mm, set.across_mm, x_mm);
}

FoldField build_field(const FineSkin& skin, const std::vector<glm::vec3>& adult,
                      const std::vector<Track>& tracks, const FoldSet& set, double scale) {
  FoldField field{set.drives, set.from, set.to, {}};
  for (std::uint32_t v = 0; v < skin.vertex_count(); ++v) {
    if (adult[v].x < 0) continue;
    const double height_mm = scale * find_height_mm(tracks, set, adult[v]);
    if (std::abs(height_mm) < kNothing_mm) continue;
    const bool is_middle = skin.mirror[v] == v;
    const double own = is_middle ? 0.5 : find_left_share(set, adult[v].x);
    field.vertices.push_back(
        {v, static_cast<float>(height_mm * own), static_cast<float>(height_mm * (1 - own))});
  }
  return field;
}

double find_strength(const FoldData& data, const HeadSpec& spec) {
  double ages = 0;
  for (const auto& [age, weight] : spec.age) {
    const auto found = data.ages.find(age);
    ages += weight * (found == data.ages.end() ? 1 : found->second);
  }
  double mixed = spec.mix.empty() ? 1 : 0;
  for (const HeadShare& share : spec.mix) mixed += share.weight * find_strength(data, share.head);
  const double other = spec.character < 0 ? data.female : data.male;
  return ages * mixed * (1 + std::abs(spec.character) * (other - 1));
}

double read_driver(const Driver& driver, const Pose& pose, Side side) {
  auto move = find_move(driver.area, side, driver.move);
  if (!move) move = find_move(driver.area, Side::none, driver.move);
  return std::max(0.0, driver.sign * pose.values[*move]);
}

// Adds `area` times the slope of the heights over a triangle to its corners. Returns false where it is flat.
bool find_slope(const std::array<float, 3>& heights, const std::array<glm::vec3, 3>& p, glm::vec4& slope) {
  if (heights[0] == 0 && heights[1] == 0 && heights[2] == 0) return false;
  const glm::vec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  const float area = glm::length(normal);
  if (area < 1e-9f) return false;
  const glm::vec3 sum = heights[0] * (p[2] - p[1]) + heights[1] * (p[0] - p[2]) + heights[2] * (p[1] - p[0]);
  slope = glm::vec4(glm::cross(normal, sum) / area, area);
  return true;
}

// The slopes of a left triangle and of its mirror image at their vertices. One of the mid-plane takes both at
// once, so that the order of the sum is the same in the mirror.
void add_slopes(const Folds& folds, std::uint32_t pair, const std::vector<glm::vec3>& positions,
                FoldBuffers& buffers) {
  std::array<glm::vec4, 2> slopes{glm::vec4(0), glm::vec4(0)};
  const Triangle& left = folds.skin.triangles[pair];
  for (int side = 0; side < 2; ++side) {
    std::array<float, 3> heights{};
    std::array<glm::vec3, 3> corners{};
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = side == 0 ? left[i] : folds.skin.mirror[left[i]];
      heights[i] = buffers.heights[v];
      corners[i] = positions[v];
    }
    find_slope(heights, corners, slopes[side]);
    if (slopes[side].w == 0)
      slopes[side].w = glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  }
  for (const std::uint32_t v : left) {
    const std::uint32_t image = folds.skin.mirror[v];
    if (image == v) {
      buffers.slopes[v] += slopes[0] + slopes[1];
    } else {
      buffers.slopes[v] += slopes[0];
      buffers.slopes[image] += slopes[1];
    }
  }
}

}  // namespace

Folds build_folds(const NeutralHead& head, const HeadSpec& spec, const std::filesystem::path& file) {
  const FoldData data = load_fold_data(file);
  Mesh adult{{}, {}, head.skin.triangles};
  std::vector<glm::vec4> packed;
  pack_points(head.adult_points, packed);
  deform_surface(*head.surface, packed, adult.positions);
  update_surface_normals(*head.surface, adult.positions, adult.normals);
  const std::vector<Track> tracks = build_tracks(head, adult, data, file);

  Folds folds;
  folds.skin = refine_skin(*head.surface, adult.triangles, adult.positions, limit_edges(tracks, data.edge));
  append_fine_points(folds.skin, adult.positions, adult.normals);
  const double scale = find_strength(data, spec) * head.eye.centre.x / head.adult_eye.centre.x;
  std::vector<bool> is_folded(folds.skin.vertex_count(), false);
  for (const FoldSet& set : data.sets) {
    folds.fields.push_back(build_field(folds.skin, adult.positions, tracks, set, scale));
    for (const FoldedVertex& folded : folds.fields.back().vertices) is_folded[folded.vertex] = true;
  }
  std::vector<bool> is_touched(folds.skin.vertex_count(), false);
  for (std::uint32_t t = 0; t < folds.skin.triangles.size(); t += 2) {
    const Triangle& left = folds.skin.triangles[t];
    if (!is_folded[left[0]] && !is_folded[left[1]] && !is_folded[left[2]]) continue;
    folds.pairs.push_back(t);
    for (const std::uint32_t v : left) is_touched[v] = is_touched[folds.skin.mirror[v]] = true;
  }
  for (std::uint32_t v = 0; v < is_touched.size(); ++v)
    if (is_touched[v]) folds.vertices.push_back(v);
  return folds;
}

double find_fold_amount(const FoldField& field, const Pose& pose, Side side) {
  double sum = 0;
  for (const FoldDrive& drive : field.drives) {
    double product = drive.share;
    for (const Driver& driver : drive.drivers) product *= read_driver(driver, pose, side);
    sum += product;
  }
  const double t = std::clamp((sum - field.from) / (field.to - field.from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

void press_folds(const Folds& folds, const Pose& pose, FoldBuffers& buffers,
                 std::vector<glm::vec3>& positions, std::vector<glm::vec3>& normals) {
  buffers.heights.resize(folds.skin.vertex_count(), 0);
  buffers.slopes.resize(folds.skin.vertex_count(), glm::vec4(0));
  bool is_smooth = true;
  for (const FoldField& field : folds.fields) {
    const auto left = static_cast<float>(find_fold_amount(field, pose, Side::left));
    const auto right = static_cast<float>(find_fold_amount(field, pose, Side::right));
    if (left == 0 && right == 0) continue;
    is_smooth = false;
    for (const FoldedVertex& folded : field.vertices) {
      const std::uint32_t image = folds.skin.mirror[folded.vertex];
      buffers.heights[folded.vertex] += folded.near_mm * left + folded.far_mm * right;
      if (image != folded.vertex) buffers.heights[image] += folded.near_mm * right + folded.far_mm * left;
    }
  }
  if (is_smooth) return;
  for (const std::uint32_t pair : folds.pairs) add_slopes(folds, pair, positions, buffers);
  for (const std::uint32_t v : folds.vertices) {
    glm::vec3& n = normals[v];
    positions[v] += kRelief * buffers.heights[v] * n;
    const glm::vec4& slope = buffers.slopes[v];
    if (glm::vec3(slope) != glm::vec3(0)) {
      const glm::vec3 up = n - glm::vec3(slope) / slope.w;
      n = up / std::sqrt(glm::dot(up, up));
    }
    buffers.heights[v] = 0;
    buffers.slopes[v] = glm::vec4(0);
  }
}

}  // namespace mien
