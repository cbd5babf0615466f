#include "head/cage.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace mien {

namespace {

// Points that have no place of their own begin at the average of their neighbours, spread until it settles.
void place_free_points(Cage& cage, const std::vector<bool>& is_free) {
  std::vector<std::vector<std::uint32_t>> neighbours(cage.points.size());
  for (const Quad& quad : cage.quads)
    for (int i = 0; i < 4; ++i) {
      neighbours[quad[i]].push_back(quad[(i + 1) % 4]);
      neighbours[quad[i]].push_back(quad[(i + 3) % 4]);
    }
  constexpr int kRounds = 60;  // free runs are at most a few points long; more rounds change nothing visible
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < cage.points.size(); ++i) {
      if (!is_free[i]) continue;
      glm::dvec3 sum{0};
      for (const std::uint32_t k : neighbours[i]) sum += cage.points[k];
      cage.points[i] = sum / static_cast<double>(neighbours[i].size());
    }
}

}  // namespace

std::uint32_t find_point(const Cage& cage, std::string_view name) {
  const auto found = cage.index.find(name);
  if (found == cage.index.end()) throw RunError(fmt::format("the head has no point called '{}'", name));
  return found->second;
}

bool has_prefix(std::string_view name, std::string_view prefix) {
  return strip_side(name).starts_with(prefix);
}

std::string_view strip_side(std::string_view name) {
  if (name.starts_with("R:")) name.remove_prefix(2);
  return name;
}

Cage build_cage(const HalfHead& half) {
  Cage cage;
  std::vector<bool> is_free;
  const auto add = [&](const std::string& name, const glm::dvec3& point, bool free) {
    cage.index.emplace(name, static_cast<std::uint32_t>(cage.points.size()));
    cage.names.push_back(name);
    cage.points.push_back(point);
    is_free.push_back(free);
  };
  for (const SkinPoint& p : half.points) add(p.name, p.skin.value_or(glm::dvec3(0)), !p.skin);
  const auto left_count = static_cast<std::uint32_t>(cage.points.size());

  cage.mirror.resize(left_count);
  for (std::uint32_t i = 0; i < left_count; ++i) {
    const bool is_middle = half.points[i].skin && half.points[i].skin->x == 0;
    cage.mirror[i] = is_middle ? i : static_cast<std::uint32_t>(cage.points.size());
    if (is_middle) continue;
    add("R:" + half.points[i].name, cage.points[i] * glm::dvec3(-1, 1, 1), is_free[i]);
    cage.mirror.push_back(i);
  }
  for (const auto& names : half.quads) {
    Quad quad{};
    for (int i = 0; i < 4; ++i) quad[i] = cage.index.find(names[i])->second;
    cage.quads.push_back(quad);
  }
  for (std::size_t q = 0; q < half.quads.size(); ++q) {
    const auto [a, b, c, d] = cage.quads[q];
    cage.quads.push_back({cage.mirror[a], cage.mirror[d], cage.mirror[c], cage.mirror[b]});
  }
  place_free_points(cage, is_free);
  return cage;
}

}  // namespace mien
