// Limit masks: Halstead, Kass, DeRose, "Efficient, fair interpolation using Catmull-Clark surfaces", 1993;
// boundary edges are cubic B-splines (1/6, 2/3, 1/6).
#include "head/surface.hpp"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <map>
#include <memory>

#include "core/error.hpp"

namespace mien {

namespace {

namespace Far = OpenSubdiv::Far;
constexpr int kLevels =
    2;  // 16 quads for each of the cage's: smooth at 1000 pixels, quick enough for a frame

std::unique_ptr<Far::TopologyRefiner> refine_topology(const Cage& cage) {
  std::vector<int> counts(cage.quads.size(), 4), indices;
  for (const Quad& quad : cage.quads) indices.insert(indices.end(), quad.begin(), quad.end());
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(cage.points.size());
  descriptor.numFaces = static_cast<int>(counts.size());
  descriptor.numVertsPerFace = counts.data();
  descriptor.vertIndicesPerFace = indices.data();
  OpenSubdiv::Sdc::Options options;
  options.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  std::unique_ptr<Far::TopologyRefiner> refiner(
      Factory::Create(descriptor, Factory::Options(OpenSubdiv::Sdc::SCHEME_CATMARK, options)));
  if (!refiner) throw RunError("the cage cannot be subdivided");
  Far::TopologyRefiner::UniformOptions refine(kLevels);
  refine.fullTopologyInLastLevel = true;  // the limit masks need its edges
  refiner->RefineUniform(refine);
  return refiner;
}

// Mirror images of the next level's vertices, from those of this level's: children of mirrored parents.
std::vector<std::uint32_t> mirror_children(const Far::TopologyRefiner& refiner, int level,
                                           const std::vector<std::uint32_t>& mirror) {
  const Far::TopologyLevel& parent = refiner.GetLevel(level);
  std::vector<std::uint32_t> child(refiner.GetLevel(level + 1).GetNumVertices());
  const auto set = [&](int a, int b) { child[a] = static_cast<std::uint32_t>(b); };
  for (int v = 0; v < parent.GetNumVertices(); ++v)
    set(parent.GetVertexChildVertex(v), parent.GetVertexChildVertex(static_cast<int>(mirror[v])));
  for (int e = 0; e < parent.GetNumEdges(); ++e) {
    const auto ends = parent.GetEdgeVertices(e);
    const int image = parent.FindEdge(static_cast<int>(mirror[ends[0]]), static_cast<int>(mirror[ends[1]]));
    set(parent.GetEdgeChildVertex(e), parent.GetEdgeChildVertex(image));
  }
  std::map<std::array<int, 4>, int> face_of;
  const auto key_of = [](std::array<int, 4> key) {
    std::sort(key.begin(), key.end());
    return key;
  };
  for (int f = 0; f < parent.GetNumFaces(); ++f) {
    const auto v = parent.GetFaceVertices(f);
    face_of[key_of({v[0], v[1], v[2], v[3]})] = f;
  }
  for (int f = 0; f < parent.GetNumFaces(); ++f) {
    const auto v = parent.GetFaceVertices(f);
    std::array<int, 4> image{};
    for (int i = 0; i < 4; ++i) image[i] = static_cast<int>(mirror[v[i]]);
    set(parent.GetFaceChildVertex(f), parent.GetFaceChildVertex(face_of.at(key_of(image))));
  }
  return child;
}

using Row = std::vector<std::pair<std::uint32_t, double>>;

// How a vertex of the finest level reaches the limit: a mask over vertices of that level.
Row limit_mask(const Far::TopologyLevel& level, int v) {
  const auto edges = level.GetVertexEdges(v);
  Row mask;
  const auto other_end = [&](int e) {
    const auto ends = level.GetEdgeVertices(e);
    return static_cast<std::uint32_t>(ends[0] == v ? ends[1] : ends[0]);
  };
  if (level.IsVertexBoundary(v)) {
    mask.emplace_back(v, 2.0 / 3);
    for (const int e : edges)
      if (level.IsEdgeBoundary(e)) mask.emplace_back(other_end(e), 1.0 / 6);
    return mask;
  }
  const auto n = static_cast<double>(edges.size());
  mask.emplace_back(v, n / (n + 5));
  for (const int e : edges) mask.emplace_back(other_end(e), 4 / (n * (n + 5)));
  for (const int f : level.GetVertexFaces(v)) {
    const auto corners = level.GetFaceVertices(f);
    for (int i = 0; i < 4; ++i)
      if (corners[i] == v) mask.emplace_back(corners[(i + 2) % 4], 1 / (n * (n + 5)));
  }
  return mask;
}

// Sums masks over stencils densely: a row of a few dozen entries among the cage's points.
struct RowSum {
  std::vector<double> value;
  std::vector<std::uint32_t> touched;

  void add(std::uint32_t point, double weight) {
    if (value[point] == 0) touched.push_back(point);
    value[point] += weight;
  }
  Row take() {
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    Row row;
    for (const std::uint32_t p : touched) {
      if (value[p] != 0) row.emplace_back(p, value[p]);
      value[p] = 0;
    }
    touched.clear();
    return row;
  }
};

// The row of a vertex of the mid-plane in pairs of mirror images of one weight: summed in this order, they
// cancel to an x of exactly 0.
Row pair_row(const Row& row, const std::vector<std::uint32_t>& mirror) {
  const std::map<std::uint32_t, double> weight_of(row.begin(), row.end());
  Row paired;
  for (const auto& [point, weight] : row) {
    const std::uint32_t image = mirror[point];
    if (image < point) continue;
    const double mean = 0.5 * (weight + weight_of.at(image));
    paired.emplace_back(point, mean);
    if (image != point) paired.emplace_back(image, mean);
  }
  return paired;
}

// Slots for all vertices, in the order of their rows: those of the left half are read one after the other.
void pair_up(Surface& surface) {
  std::vector<bool> is_known(surface.mirror.size(), false);
  const auto take = [&](std::uint32_t v) {
    if (is_known[v]) return;
    is_known[v] = is_known[surface.mirror[v]] = true;
    surface.pairs.push_back({v, surface.mirror[v]});
  };
  for (std::size_t q = 0; q < surface.quads.size(); q += 2)
    for (const std::uint32_t v : surface.quads[q]) take(v);
  std::ranges::sort(surface.pairs, {}, &MirrorPair::left);
}

// The quads by their slots.
void pair_quads(Surface& surface) {
  std::vector<std::uint32_t> slot(surface.mirror.size(), 0);
  for (std::uint32_t i = 0; i < surface.pairs.size(); ++i) slot[surface.pairs[i].left] = i;
  for (std::size_t q = 0; q < surface.quads.size(); q += 2) {
    PairedQuad& paired = surface.pair_quads.emplace_back();
    for (std::uint32_t i = 0; i < 4; ++i) {
      paired.slots[i] = slot[surface.quads[q][i]];
      if (surface.pairs[paired.slots[i]].is_middle()) paired.middle |= 1U << i;
    }
  }
}

}  // namespace

Surface build_surface(const Cage& cage) {
  const auto refiner = refine_topology(cage);
  Far::StencilTableFactory::Options options;
  options.generateIntermediateLevels = false;
  options.factorizeIntermediateLevels = true;
  options.generateOffsets = true;
  const std::unique_ptr<const Far::StencilTable> stencils(
      Far::StencilTableFactory::Create(*refiner, options));

  Surface surface;
  surface.mirror = cage.mirror;
  for (int level = 0; level < kLevels; ++level)
    surface.mirror = mirror_children(*refiner, level, surface.mirror);

  const Far::TopologyLevel& fine = refiner->GetLevel(kLevels);
  const auto count = static_cast<std::uint32_t>(fine.GetNumVertices());
  RowSum sum{std::vector<double>(cage.points.size(), 0), {}};
  std::vector<Row> rows(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    if (surface.mirror[v] < v) {  // the mirror image was made before: mirror it, in the same order
      rows[v] = rows[surface.mirror[v]];
      for (auto& entry : rows[v]) entry.first = cage.mirror[entry.first];
      continue;
    }
    for (const auto& [vertex, mask_weight] : limit_mask(fine, static_cast<int>(v))) {
      const Far::Stencil stencil = stencils->GetStencil(static_cast<int>(vertex));
      for (int i = 0; i < stencil.GetSize(); ++i)
        sum.add(static_cast<std::uint32_t>(stencil.GetVertexIndices()[i]),
                mask_weight * stencil.GetWeights()[i]);
    }
    rows[v] = sum.take();
  }
  for (std::uint32_t v = 0; v < count; ++v)
    if (surface.mirror[v] == v) rows[v] = pair_row(rows[v], cage.mirror);
  surface.first.push_back(0);
  for (const Row& row : rows) {
    for (const auto& [point, weight] : row) {
      surface.point.push_back(point);
      surface.weight.push_back(static_cast<float>(weight));
    }
    surface.first.push_back(static_cast<std::uint32_t>(surface.point.size()));
  }
  for (int f = 0; f < fine.GetNumFaces() / 2; ++f) {  // the cage's left quads come first, and so do theirs
    const auto v = fine.GetFaceVertices(f);
    const auto image = [&](int i) { return surface.mirror[v[i]]; };
    surface.quads.push_back({static_cast<std::uint32_t>(v[0]), static_cast<std::uint32_t>(v[1]),
                             static_cast<std::uint32_t>(v[2]), static_cast<std::uint32_t>(v[3])});
    surface.quads.push_back({image(0), image(3), image(2), image(1)});
  }
  pair_up(surface);
  pair_quads(surface);
  return surface;
}

std::vector<float> spread_over_surface(const Surface& surface, const std::vector<double>& values) {
  std::vector<float> spread(surface.vertex_count());
  for (std::size_t v = 0; v < spread.size(); ++v) {
    double sum = 0;
    for (std::uint32_t k = surface.first[v]; k < surface.first[v + 1]; ++k)
      sum += static_cast<double>(surface.weight[k]) * values[surface.point[k]];
    spread[v] = static_cast<float>(sum);
  }
  return spread;
}

std::vector<Triangle> split_quads(const Surface& surface, const std::vector<glm::vec3>& positions) {
  std::vector<Triangle> triangles;
  triangles.reserve(surface.quads.size() * 2);
  constexpr float kTie =
      1e-4f;  // mm: equal diagonals must not be told apart by rounding, or mirror images differ
  for (const auto& [a, b, c, d] : surface.quads) {
    const float ac = glm::distance(positions[a], positions[c]),
                bd = glm::distance(positions[b], positions[d]);
    // On a tie the diagonal that leaves the vertex nearer to the mid-plane at the bottom: the same in the
    // mirror.
    const bool by_ac = std::abs(ac - bd) > kTie ? ac < bd
                                                : std::abs(positions[a].x) + std::abs(positions[c].x) <
                                                      std::abs(positions[b].x) + std::abs(positions[d].x);
    if (by_ac) {
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    } else {
      triangles.push_back({b, c, d});
      triangles.push_back({b, d, a});
    }
  }
  return triangles;
}

Surface select_vertices(const Surface& surface, std::vector<bool> is_wanted,
                        const std::vector<bool>& is_normal_wanted) {
  Surface selected;
  selected.mirror = surface.mirror;
  selected.pairs = surface.pairs;
  for (std::size_t q = 0; q < surface.quads.size(); q += 2) {
    const Quad &left = surface.quads[q], &right = surface.quads[q + 1];
    const auto is_asked = [&](std::uint32_t v) {
      return is_normal_wanted[v] || is_normal_wanted[surface.mirror[v]];
    };
    if (std::none_of(left.begin(), left.end(), is_asked)) continue;
    for (const Quad& quad : {left, right}) {
      selected.quads.push_back(quad);
      for (const std::uint32_t v : quad) is_wanted[v] = true;
    }
  }
  for (std::uint32_t v = 0; v < surface.vertex_count(); ++v) {
    selected.first.push_back(static_cast<std::uint32_t>(selected.point.size()));
    if (!is_wanted[v] && !is_wanted[surface.mirror[v]]) continue;
    const auto from = static_cast<std::ptrdiff_t>(surface.first[v]),
               to = static_cast<std::ptrdiff_t>(surface.first[v + 1]);
    selected.point.insert(selected.point.end(), surface.point.begin() + from, surface.point.begin() + to);
    selected.weight.insert(selected.weight.end(), surface.weight.begin() + from, surface.weight.begin() + to);
  }
  selected.first.push_back(static_cast<std::uint32_t>(selected.point.size()));
  pair_quads(selected);
  return selected;
}

}  // namespace mien
