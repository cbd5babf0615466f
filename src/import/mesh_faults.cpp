#include "import/mesh_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace mien {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

// The faces on each side of an edge: in its own direction, and against it.
struct EdgeUse {
  std::vector<std::uint32_t> along, against;
};

struct FaultFinder {
  const Polygons& mesh;
  std::size_t most;
  MeshReport report;

  std::size_t count(std::uint32_t face) const { return mesh.first[face + 1] - mesh.first[face]; }
  std::uint32_t corner(std::uint32_t face, std::size_t i) const {
    return mesh.corners[mesh.first[face] + i % count(face)];
  }
  const glm::dvec3& place(std::uint32_t face, std::size_t i) const { return mesh.positions[corner(face, i)]; }
};

std::string format_place(const glm::dvec3& place) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", place.x, place.y, place.z);
}

int find_line(const FaultFinder& finder, std::uint32_t vertex) {
  return finder.mesh.lines.empty() ? 0 : static_cast<int>(finder.mesh.lines[vertex]);
}

// Tells those of one kind: not more than there is patience for.
void add_faults(FaultFinder& finder, const char* kind, std::vector<MeshFault> found,
                bool is_warning = false) {
  const std::size_t total = found.size();
  for (std::size_t i = 0; i < total; ++i) {
    if (i < finder.most) {
      finder.report.faults.push_back(std::move(found[i]));
    } else {
      MeshFault& rest = i == finder.most ? finder.report.faults.emplace_back() : finder.report.faults.back();
      rest.message = fmt::format("and {} more {}", total - finder.most, kind);
      rest.faces.insert(rest.faces.end(), found[i].faces.begin(), found[i].faces.end());
    }
    finder.report.faults.back().is_warning = is_warning;
  }
}

// Newell's normal: that of the polygon whatever its corners do.
glm::dvec3 compute_normal(const FaultFinder& finder, std::uint32_t face) {
  glm::dvec3 normal(0);
  for (std::size_t i = 0; i < finder.count(face); ++i)
    normal += glm::cross(finder.place(face, i), finder.place(face, i + 1));
  return normal;
}

void check_faces(FaultFinder& finder) {
  std::vector<MeshFault> folded, bent;
  for (std::uint32_t face = 0; face < finder.mesh.face_count(); ++face) {
    const std::size_t count = finder.count(face);
    std::set<std::uint32_t> corners;
    double longest = 0;
    glm::dvec3 middle(0);
    for (std::size_t i = 0; i < count; ++i) {
      corners.insert(finder.corner(face, i));
      longest = std::max(longest, glm::distance(finder.place(face, i), finder.place(face, i + 1)));
      middle += finder.place(face, i) / double(count);
    }
    const glm::dvec3 normal = compute_normal(finder, face);
    const int line = find_line(finder, finder.corner(face, 0));
    if (corners.size() < count) {
      folded.push_back(
          {fmt::format("polygon {} at {} has a corner twice; expected each once", face, format_place(middle)),
           line,
           {face}});
      continue;
    }
    if (glm::length(normal) <= 1e-12 * longest * longest) {
      folded.push_back(
          {fmt::format("polygon {} at {} has no area; expected some", face, format_place(middle)),
           line,
           {face}});
      continue;
    }
    double off = 0;
    for (std::size_t i = 0; i < count; ++i)
      off = std::max(off, std::abs(glm::dot(finder.place(face, i) - middle, glm::normalize(normal))));
    if (count > 3 && off > kFlatness * longest)
      bent.push_back(
          {fmt::format("polygon {} at {} is not flat: a corner lies {:.0f} % of its longest edge out of its "
                       "plane; expected {:.0f} % at most",
                       face, format_place(middle), 100 * off / longest, 100 * kFlatness),
           line,
           {face}});
  }
  add_faults(finder, "polygons without area", std::move(folded));
  add_faults(finder, "polygons that are not flat", std::move(bent), true);
}

std::map<Edge, EdgeUse> list_edges(const FaultFinder& finder) {
  std::map<Edge, EdgeUse> edges;
  for (std::uint32_t face = 0; face < finder.mesh.face_count(); ++face)
    for (std::size_t i = 0; i < finder.count(face); ++i) {
      const std::uint32_t a = finder.corner(face, i), b = finder.corner(face, i + 1);
      EdgeUse& use = edges[std::minmax(a, b)];
      (a < b ? use.along : use.against).push_back(face);
    }
  return edges;
}

void check_edges(FaultFinder& finder, const std::map<Edge, EdgeUse>& edges) {
  std::vector<MeshFault> crowded, turned;
  for (const auto& [edge, use] : edges) {
    std::vector<std::uint32_t> faces = use.along;
    faces.insert(faces.end(), use.against.begin(), use.against.end());
    const auto& [a, b] = edge;
    const std::string where = fmt::format("from {} to {}", format_place(finder.mesh.positions[a]),
                                          format_place(finder.mesh.positions[b]));
    if (faces.size() > 2)
      crowded.push_back(
          {fmt::format("the edge {} is used by {} polygons; expected two at most", where, faces.size()),
           find_line(finder, a), faces});
    else if (faces.size() == 2 && use.along.size() != use.against.size())
      turned.push_back(
          {fmt::format("the polygons on both sides of the edge {} face opposite ways; expected one outside",
                       where),
           find_line(finder, a), faces});
  }
  add_faults(finder, "edges with too many polygons", std::move(crowded));
  add_faults(finder, "edges between polygons that face opposite ways", std::move(turned));
}

void check_points(FaultFinder& finder, const std::map<Edge, EdgeUse>& edges) {
  std::vector<int> uses(finder.mesh.positions.size(), 0);
  for (const auto& [edge, use] : edges) {
    ++uses[edge.first];
    ++uses[edge.second];
  }
  std::vector<MeshFault> loose, twice;
  std::map<std::array<double, 3>, std::uint32_t> known;
  for (std::uint32_t v = 0; v < uses.size(); ++v) {
    const glm::dvec3& place = finder.mesh.positions[v];
    if (uses[v] < 2)
      loose.push_back({fmt::format("point {} at {} is on {}; expected two edges at least", v,
                                   format_place(place), uses[v] == 0 ? "no edge" : "one edge"),
                       find_line(finder, v),
                       {}});
    const auto [found, is_new] = known.emplace(std::array{place.x, place.y, place.z}, v);
    if (!is_new)
      twice.push_back({fmt::format("point {} at {} is point {} again; expected each place once", v,
                                   format_place(place), found->second),
                       find_line(finder, v),
                       {}});
  }
  add_faults(finder, "points on fewer than two edges", std::move(loose));
  add_faults(finder, "points that are there again", std::move(twice), true);
}

void check_twins(FaultFinder& finder) {
  std::vector<MeshFault> twice;
  std::map<std::vector<std::uint32_t>, std::uint32_t> known;
  for (std::uint32_t face = 0; face < finder.mesh.face_count(); ++face) {
    std::vector<std::uint32_t> corners(finder.mesh.corners.begin() + finder.mesh.first[face],
                                       finder.mesh.corners.begin() + finder.mesh.first[face + 1]);
    std::ranges::sort(corners);
    const auto [found, is_new] = known.emplace(std::move(corners), face);
    if (!is_new)
      twice.push_back({fmt::format("polygon {} at {} is polygon {} again; expected each once", face,
                                   format_place(finder.place(face, 0)), found->second),
                       find_line(finder, finder.corner(face, 0)),
                       {face}});
  }
  add_faults(finder, "polygons that are there again", std::move(twice));
}

std::uint32_t find_root(std::vector<std::uint32_t>& parents, std::uint32_t v) {
  while (parents[v] != v) v = parents[v] = parents[parents[v]];
  return v;
}

// What hangs together by edges; all but the largest piece are told.
void check_pieces(FaultFinder& finder, const std::map<Edge, EdgeUse>& edges) {
  std::vector<std::uint32_t> parents(finder.mesh.positions.size());
  std::iota(parents.begin(), parents.end(), 0u);
  for (const auto& [edge, use] : edges)
    parents[find_root(parents, edge.first)] = find_root(parents, edge.second);
  std::map<std::uint32_t, std::vector<std::uint32_t>> pieces;
  for (std::uint32_t face = 0; face < finder.mesh.face_count(); ++face)
    pieces[find_root(parents, finder.corner(face, 0))].push_back(face);
  finder.report.pieces = pieces.size();
  const auto largest =
      std::ranges::max_element(pieces, {}, [](const auto& piece) { return piece.second.size(); });
  std::vector<MeshFault> loose;
  for (auto piece = pieces.begin(); piece != pieces.end(); ++piece) {
    if (piece == largest) continue;
    const std::uint32_t first = piece->second.front();
    loose.push_back({fmt::format("{} polygons at {} hang on nothing else; expected one piece",
                                 piece->second.size(), format_place(finder.place(first, 0))),
                     find_line(finder, finder.corner(first, 0)), piece->second});
  }
  add_faults(finder, "loose pieces", std::move(loose), true);
}

// Open edges hang together in rims.
void count_rims(FaultFinder& finder, const std::map<Edge, EdgeUse>& edges) {
  std::map<std::uint32_t, std::uint32_t> ids;
  std::vector<std::uint32_t> parents;
  const auto take = [&](std::uint32_t v) {
    const auto [found, is_new] = ids.emplace(v, static_cast<std::uint32_t>(parents.size()));
    if (is_new) parents.push_back(found->second);
    return found->second;
  };
  for (const auto& [edge, use] : edges) {
    if (use.along.size() + use.against.size() != 1) continue;
    ++finder.report.open_edges;
    parents[find_root(parents, take(edge.first))] = find_root(parents, take(edge.second));
  }
  for (std::uint32_t i = 0; i < parents.size(); ++i) finder.report.rims += find_root(parents, i) == i;
}

}  // namespace

MeshReport find_mesh_faults(const Polygons& mesh, std::size_t most) {
  FaultFinder finder{mesh, most, {}};
  const std::map<Edge, EdgeUse> edges = list_edges(finder);
  check_faces(finder);
  check_edges(finder, edges);
  check_points(finder, edges);
  check_twins(finder);
  check_pieces(finder, edges);
  count_rims(finder, edges);
  return std::move(finder.report);
}

std::string draw_mesh_faults(const Polygons& mesh, const MeshReport& report) {
  std::set<std::uint32_t> wrong;
  for (const MeshFault& fault : report.faults) wrong.insert(fault.faces.begin(), fault.faces.end());
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\ncomment faces with a fault are red\nelement vertex {}\nproperty float "
      "x\nproperty float "
      "y\nproperty float z\nelement face {}\nproperty list uchar uint vertex_indices\nproperty uchar "
      "red\nproperty uchar "
      "green\nproperty uchar blue\nend_header\n",
      mesh.positions.size(), mesh.face_count());
  for (const glm::dvec3& p : mesh.positions) text += fmt::format("{:.6g} {:.6g} {:.6g}\n", p.x, p.y, p.z);
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
    text += fmt::to_string(mesh.first[face + 1] - mesh.first[face]);
    for (std::uint32_t i = mesh.first[face]; i < mesh.first[face + 1]; ++i)
      text += fmt::format(" {}", mesh.corners[i]);
    text += wrong.contains(face) ? " 230 40 30\n" : " 190 190 190\n";
  }
  return text;
}

}  // namespace mien
