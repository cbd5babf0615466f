// Shading a height over a surface by its gradient: Blinn, "Simulation of wrinkled surfaces", 1978. Folds lie
// across the pull of the muscle under them (Langer's and Kraissl's lines).
#include "face/folds.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/pool.hpp"
#include "core/smooth.hpp"
#include "face/fold_ground.hpp"
#include "face/fold_tracks.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

// Of a height, in the skin's shape; its shading has all of it. More, and the facets of a groove throw shadows
// with teeth.
constexpr float kRelief = 0.5f;
constexpr float kNothing_mm = 0.002f;  // a height below it is none

// What part of a fold at x belongs to the left side; the rest is the right side's.
double compute_left_share(const FoldSet& set, double x_mm) {
  if (set.across_mm == 0) return x_mm >= 0 ? 1 : 0;
  return smooth_step(-set.across_mm, set.across_mm, x_mm);
}

FoldField build_field(const FineSkin& skin, const std::vector<FoldHeight>& heights, const FoldSet& set,
                      double scale, double rest) {
  FoldField field{set.drives, set.from, set.to, rest, set.stretched, {}};
  for (const auto& [v, mm, left_own] : heights) {
    const auto [left, right] = mm;
    if (scale * std::max(std::abs(left), std::abs(right)) < kNothing_mm) continue;
    const bool is_middle = skin.mirror[v] == v;
    const double own = is_middle ? 0.5 : left_own;
    const auto of = [&](double height, double share) { return static_cast<float>(scale * height * share); };
    field.vertices.push_back({v, of(left, own), of(left, 1 - own), of(right, own), of(right, 1 - own)});
  }
  return field;
}

std::vector<FoldHeight> list_heights(const std::vector<Track>& tracks, const FoldSet& set,
                                     const std::vector<glm::vec3>& adult) {
  std::vector<FoldHeight> heights;
  for (std::uint32_t v = 0; v < adult.size(); ++v) {
    if (adult[v].x < 0) continue;
    const std::array<double, 2> mm = compute_heights_mm(tracks, set, adult[v]);
    if (mm[0] != 0 || mm[1] != 0) heights.push_back({v, mm, compute_left_share(set, adult[v].x)});
  }
  return heights;
}

// The mean of what a table says of the ages; `other` for those that it does not name.
double mix_ages(const std::map<std::string, double>& table, double other, const HeadSpec& spec) {
  double sum = 0;
  for (const auto& [age, weight] : spec.age) {
    const auto found = table.find(age);
    sum += weight * (found == table.end() ? other : found->second);
  }
  return sum;
}

// How much of the lines at rest the head has: its own age's, or those of the heads that it is mixed of.
double compute_rest(const FoldData& data, const HeadSpec& spec) {
  double rest = mix_ages(data.ages_at_rest, 0, spec);
  for (const HeadShare& share : spec.mix) rest += share.weight * compute_rest(data, share.head);
  return std::min(rest, 1.0);
}

double read_driver(const Driver& driver, const Pose& pose, Side side) {
  auto move = find_move(driver.area, side, driver.move);
  if (!move) move = find_move(driver.area, Side::none, driver.move);
  return std::max(0.0, driver.sign * pose.values[*move]);
}

double sum_drives(const std::vector<FoldDrive>& drives, const Pose& pose, Side side) {
  double sum = 0;
  for (const FoldDrive& drive : drives) {
    double product = drive.share;
    for (const Driver& driver : drive.drivers) product *= read_driver(driver, pose, side);
    sum += product;
  }
  return sum;
}

// Which triangles and vertices of folds.skin the folds need; from here on the fields name vertices by their
// place among those.
void find_touched(const std::vector<bool>& is_folded, Folds& folds) {
  constexpr auto kNone = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> slot_of(folds.skin.vertex_count(), kNone);  // of left vertices
  const auto take = [&](std::uint32_t left) {
    if (slot_of[left] == kNone) {
      slot_of[left] = static_cast<std::uint32_t>(folds.vertices.size());
      folds.vertices.push_back({left, folds.skin.mirror[left]});
    }
    return slot_of[left];
  };
  for (std::uint32_t t = 0; t < folds.skin.triangles.size(); t += 2) {
    const Triangle& left = folds.skin.triangles[t];
    if (!is_folded[left[0]] && !is_folded[left[1]] && !is_folded[left[2]]) continue;
    folds.triangles.push_back({take(left[0]), take(left[1]), take(left[2])});
  }
  for (FoldField& field : folds.fields)
    for (FoldedVertex& folded : field.vertices) {
      folded.slot = take(folded.slot);
    }
  std::vector<std::uint32_t> slots(folds.skin.vertex_count(), 0);
  for (std::uint32_t i = 0; i < folds.skin.pairs.size(); ++i) slots[folds.skin.pairs[i].left] = i;
  for (std::uint32_t i = 0; i < folds.vertices.size(); ++i) {
    folds.slots.push_back(slots[folds.vertices[i].left]);
    if (folds.vertices[i].is_middle()) folds.middles.push_back(i);
  }
}

}  // namespace

double compute_fold_strength(const FoldData& data, const HeadSpec& spec) {
  const double ages = mix_ages(data.ages, 1, spec);
  double mixed = spec.mix.empty() ? 1 : 0;
  for (const HeadShare& share : spec.mix) mixed += share.weight * compute_fold_strength(data, share.head);
  const double other = spec.character < 0 ? data.female : data.male;
  return ages * mixed * (1 + std::abs(spec.character) * (other - 1));
}

FoldGround build_fold_ground(const NeutralHead& head) {
  const FoldData& data = head.data->folds;
  Mesh adult{{}, {}, head.skin.triangles};
  std::vector<Float4> packed;
  pack_points(head.adult_points, packed);
  deform_surface(*head.surface, packed, adult.positions);
  update_surface_normals(*head.surface, adult.positions, adult.normals);
  const std::vector<Track> tracks = build_tracks(head, adult, data);
  FoldGround ground;
  ground.skin = refine_skin(*head.surface, adult.triangles, adult.positions, limit_edges(tracks, data.edge));
  append_fine_points(ground.skin, adult.positions, adult.normals);
  ground.sets.resize(data.sets.size());
  for_each_index(data.sets.size(), count_workers(), [&](std::size_t i, int) {
    ground.sets[i] = list_heights(tracks, data.sets[i], adult.positions);
  });
  return ground;
}

Folds build_folds(const FoldGround& ground, const NeutralHead& head, const HeadSpec& spec) {
  const FoldData& data = head.data->folds;
  Folds folds;
  folds.skin = ground.skin;
  const double scale =
      head.design.folds * compute_fold_strength(data, spec) * head.eye.centre.x / head.adult_eye.centre.x;
  const double rest = compute_rest(data, spec);
  std::vector<bool> is_folded(folds.skin.vertex_count(), false);
  for (std::size_t i = 0; i < data.sets.size(); ++i) {
    const FoldSet& set = data.sets[i];
    folds.fields.push_back(
        build_field(folds.skin, ground.sets[i], set, scale, std::max(set.always, rest * set.rest)));
    for (const FoldedVertex& folded : folds.fields.back().vertices) is_folded[folded.slot] = true;
  }
  find_touched(is_folded, folds);
  return folds;
}

Folds build_folds(const NeutralHead& head, const HeadSpec& spec) {
  return build_folds(build_fold_ground(head), head, spec);
}

double compute_fold_amount(const FoldField& field, const Pose& pose, Side side) {
  const double grown =
      std::lerp(field.rest, 1.0, smooth_step(field.from, field.to, sum_drives(field.drives, pose, side)));
  return grown * (1 - smooth_step(0, 1, sum_drives(field.stretched, pose, side)));
}

void press_folds(const Folds& folds, const Pose& pose, FoldBuffers& buffers, std::vector<Twin>& places,
                 std::vector<Twin>& normals) {
  std::vector<std::array<float, 2>> amounts(folds.fields.size());
  bool is_smooth = true;
  for (std::size_t f = 0; f < amounts.size(); ++f) {
    for (const Side side : {Side::left, Side::right})
      amounts[f][side == Side::right ? 1 : 0] =
          static_cast<float>(compute_fold_amount(folds.fields[f], pose, side));
    is_smooth = is_smooth && amounts[f][0] == 0 && amounts[f][1] == 0;
  }
  if (is_smooth) return;
  buffers.places.resize(folds.slots.size());
  buffers.normals.resize(folds.slots.size());
  for (std::size_t i = 0; i < folds.slots.size(); ++i) {
    Twin& place = buffers.places[i] = places[folds.slots[i]];
    place.left[3] = place.right[3] = 0;
    buffers.normals[i] = normals[folds.slots[i]];
  }
  for (std::size_t f = 0; f < amounts.size(); ++f) {
    const auto [left, right] = amounts[f];
    if (left == 0 && right == 0) continue;
    for (const FoldedVertex& folded : folds.fields[f].vertices) {
      Twin& place = buffers.places[folded.slot];
      place.left[3] += folded.near_mm * left + folded.far_mm * right;
      place.right[3] += folded.image_near_mm * right + folded.image_far_mm * left;
    }
  }
  for (const std::uint32_t i : folds.middles) buffers.places[i].right[3] = buffers.places[i].left[3];
  press_pairs(folds.vertices, folds.triangles, kRelief, buffers);
  for (std::size_t i = 0; i < folds.slots.size(); ++i) {
    places[folds.slots[i]] = buffers.places[i];
    normals[folds.slots[i]] = buffers.normals[i];
  }
}

}  // namespace mien
