#include "core/thin.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <queue>
#include <utility>

#include "core/collapse.hpp"
#include "core/pool.hpp"

namespace mien {

namespace {

// `drop` moves onto `keep`; worth its cost while `drop` has this version and `keep` is there.
struct Removal {
  double cost = 0;
  std::uint32_t keep = 0, drop = 0, drop_version = 0;

  // For a queue with the cheapest on top; ties by index, so that the order never depends on the library.
  bool operator<(const Removal& other) const {
    if (cost != other.cost) return cost > other.cost;
    return std::pair{keep, drop} > std::pair{other.keep, other.drop};
  }
};

// Gives the cheapest removal first. Most are never asked for: those that are dearer than a limit wait without
// an order, so that the queue stays short.
class RemovalQueue {
 public:
  explicit RemovalQueue(std::vector<Removal> removals = {}) : dear_(std::move(removals)) {}

  void push(const Removal& removal) {
    if (removal.cost <= limit_)
      cheap_.push(removal);
    else
      dear_.push_back(removal);
  }
  // Nothing if all are asked for. Those that `is_stale` says so of may be left out.
  template <typename IsStale>
  std::optional<Removal> pop(const IsStale& is_stale) {
    if (cheap_.empty()) raise_limit(is_stale);
    if (cheap_.empty()) return std::nullopt;
    const Removal removal = cheap_.top();
    cheap_.pop();
    return removal;
  }

 private:
  template <typename IsStale>
  void raise_limit(const IsStale& is_stale) {
    constexpr std::size_t kParts = 8;
    std::erase_if(dear_, is_stale);
    if (dear_.empty()) return;
    const auto part = dear_.begin() + static_cast<std::ptrdiff_t>(dear_.size() / kParts);
    std::nth_element(dear_.begin(), part, dear_.end(),
                     [](const Removal& a, const Removal& b) { return a.cost < b.cost; });
    limit_ = part->cost;
    const auto dear = std::partition(dear_.begin(), dear_.end(),
                                     [&](const Removal& removal) { return removal.cost <= limit_; });
    cheap_ = std::priority_queue(std::less<Removal>(), std::vector(dear_.begin(), dear));
    dear_.erase(dear_.begin(), dear);
  }

  std::priority_queue<Removal> cheap_;
  std::vector<Removal> dear_;
  double limit_ = -1;
};

struct Thinner {
  std::size_t pose_count = 0;
  std::vector<glm::vec3> places;  // of a vertex in all poses, one vertex after the other
  std::vector<Quadric> quadrics;  // the same
  CollapseNet net;
  std::vector<bool> is_locked;
  std::vector<std::uint32_t> version;
  std::vector<bool> is_refused;  // a removal of the vertex was: it may be possible later
  RemovalQueue queue;
  std::array<std::vector<std::uint32_t>, 2> rings;  // of one call

  const glm::vec3& place(std::uint32_t v, std::size_t pose) const { return places[v * pose_count + pose]; }
};

Removal find_removal(const Thinner& s, std::uint32_t drop, std::uint32_t keep) {
  constexpr double kShort = 1e-9;  // of the squared length: among equals the shortest edge goes first
  const Quadric* quadric = &s.quadrics[drop * s.pose_count];
  const glm::vec3* place = &s.places[keep * s.pose_count];
  double cost = 0;
  for (std::size_t p = 0; p < s.pose_count; ++p) cost += quadric[p].measure(place[p]);
  const glm::vec3 along = s.place(keep, 0) - s.place(drop, 0);
  return {cost + kShort * glm::dot(along, along), keep, drop, s.version[drop]};
}

// Whether the triangles of `drop` keep their side and a sound shape in every pose once it lies on `keep`.
bool keeps_shape(const Thinner& s, std::uint32_t drop, std::uint32_t keep) {
  constexpr float kSlender = 0.06f;
  for (const std::uint32_t t : s.net.around[drop]) {
    const Triangle& corners = s.net.triangles[t];
    if (std::find(corners.begin(), corners.end(), keep) != corners.end()) continue;
    for (std::size_t p = 0; p < s.pose_count; ++p) {
      std::array<glm::vec3, 3> now, then;
      for (int i = 0; i < 3; ++i) {
        now[i] = s.place(corners[i], p);
        then[i] = corners[i] == drop ? s.place(keep, p) : now[i];
      }
      if (!keeps_triangle(now, then, p == 0 ? kSlender : 0))
        return false;  // a stretched pose may stretch triangles
    }
  }
  return true;
}

// `s.rings` are those of `drop` and of `keep` before.
void remove(Thinner& s, std::uint32_t drop, std::uint32_t keep) {
  for (std::size_t p = 0; p < s.pose_count; ++p)
    s.quadrics[keep * s.pose_count + p].add(s.quadrics[drop * s.pose_count + p]);
  join_vertices(s.net, drop, keep);
  ++s.version[keep];
  ++s.version[drop];
  const auto push_with = [&](std::uint32_t v, bool is_new) {
    if (!s.is_locked[keep]) s.queue.push(find_removal(s, keep, v));
    if (!s.is_locked[v] && (is_new || s.is_refused[v]))  // else it is there already
      s.queue.push(find_removal(s, v, keep));
  };
  const auto& [dropped, kept] = s.rings;
  for (const std::uint32_t v : kept)
    if (v != drop) push_with(v, false);
  for (const std::uint32_t v : dropped)
    if (v != keep && !std::binary_search(kept.begin(), kept.end(), v)) push_with(v, true);
}

// The planes of all triangles around a vertex.
void add_planes(Thinner& s, std::uint32_t v) {
  for (const std::uint32_t index : s.net.around[v])
    for (std::size_t p = 0; p < s.pose_count; ++p) {
      const Triangle& t = s.net.triangles[index];
      const glm::dvec3 a(s.place(t[0], p)), b(s.place(t[1], p)), c(s.place(t[2], p));
      const glm::dvec3 area = find_area_vector(a, b, c);
      const double length = glm::length(area);
      if (length == 0) continue;
      s.quadrics[v * s.pose_count + p].add_plane(area / length, glm::dot(area / length, a), length);
    }
}

Thinner build_thinner(const std::vector<std::vector<glm::vec3>>& poses, std::vector<Triangle> triangles,
                      const std::vector<bool>& is_locked) {
  const std::size_t count = poses.front().size();
  Thinner s;
  s.pose_count = poses.size();
  s.is_locked = compute_open_vertices(triangles, count);
  for (std::size_t v = 0; v < count; ++v)
    if (is_locked[v]) s.is_locked[v] = true;
  s.net = build_collapse_net(std::move(triangles), count);
  s.version.resize(count);
  s.is_refused.resize(count);
  s.places.reserve(count * s.pose_count);
  for (std::size_t v = 0; v < count; ++v)
    for (const std::vector<glm::vec3>& pose : poses) s.places.push_back(pose[v]);
  constexpr std::size_t kChunk = 2048;  // of vertices; a thread's share of the work
  s.quadrics.resize(count * s.pose_count);
  std::vector<std::vector<Removal>> chunks((count + kChunk - 1) / kChunk);
  const auto for_each_chunk = [&](const auto& work) {
    for_each_index(chunks.size(), count_workers(), [&](std::size_t chunk, int) {
      const auto first = static_cast<std::uint32_t>(chunk * kChunk);
      work(chunk, first, static_cast<std::uint32_t>(std::min(first + kChunk, count)));
    });
  };
  for_each_chunk([&](std::size_t, std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t v = first; v < end; ++v) add_planes(s, v);
  });
  for_each_chunk([&](std::size_t chunk, std::uint32_t first, std::uint32_t end) {
    std::vector<std::uint32_t> ring;
    for (std::uint32_t v = first; v < end; ++v) {
      if (s.is_locked[v]) continue;
      list_neighbours(s.net, v, ring);
      for (const std::uint32_t w : ring) chunks[chunk].push_back(find_removal(s, v, w));
    }
  });
  std::vector<Removal> removals;
  for (const std::vector<Removal>& chunk : chunks)
    removals.insert(removals.end(), chunk.begin(), chunk.end());
  s.queue = RemovalQueue(std::move(removals));
  return s;
}

}  // namespace

std::vector<Triangle> thin_posed(const std::vector<std::vector<glm::vec3>>& poses,
                                 std::vector<Triangle> triangles, const std::vector<bool>& is_locked,
                                 std::size_t most) {
  if (poses.empty() || triangles.size() <= most) return triangles;
  Thinner s = build_thinner(poses, std::move(triangles), is_locked);
  const auto is_stale = [&](const Removal& r) {
    return s.version[r.drop] != r.drop_version || s.net.around[r.keep].empty();
  };
  while (s.net.alive > most) {
    const std::optional<Removal> next = s.queue.pop(is_stale);
    if (!next) break;
    if (is_stale(*next)) continue;
    if (keeps_surface(s.net, next->drop, next->keep, s.rings) && keeps_shape(s, next->drop, next->keep))
      remove(s, next->drop, next->keep);
    else
      s.is_refused[next->drop] = true;
  }
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < s.net.triangles.size(); ++t)
    if (s.net.is_alive[t]) kept.push_back(s.net.triangles[t]);
  return kept;
}

}  // namespace mien
