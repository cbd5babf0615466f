#include "sheet/wire_head.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/refine.hpp"
#include "head/shapes.hpp"
#include "head/strands.hpp"
#include "head/surface.hpp"
#include "sheet/limit_lines.hpp"
#include "timeline/head_turn.hpp"
#include "wire/slice.hpp"

namespace mien {

namespace {

using MeshEdge = std::pair<std::uint32_t, std::uint32_t>;

MeshEdge order(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

// How many vertices the first subdivision of a cage has: one for each of its points, edges and quads. They
// are the first vertices of the second.
std::size_t count_first_vertices(const Cage& cage) {
  std::set<MeshEdge> edges;
  for (const Quad& quad : cage.quads)
    for (std::size_t i = 0; i < 4; ++i) edges.insert(order(quad[i], quad[(i + 1) % 4]));
  return cage.points.size() + edges.size() + cage.quads.size();
}

// The skin of the second subdivision with each edge halved once more, so that outlines are round, and on it
// the edges of the first.
WireSolid build_skin(const NeutralHead& head, const PartShape& drawn, std::vector<WireLine>& lines) {
  const Surface& surface = *head.surface;
  const std::size_t count = surface.vertex_count();
  Mesh mesh;
  mesh.positions.assign(drawn.positions.begin(),
                        drawn.positions.begin() + static_cast<std::ptrdiff_t>(count));
  mesh.normals.assign(drawn.normals.begin(), drawn.normals.begin() + static_cast<std::ptrdiff_t>(count));
  mesh.triangles = split_quads(surface, mesh.positions);
  std::vector<bool> marks(count, true);
  const std::vector<std::array<std::uint32_t, 2>> ends = refine_marked(mesh, marks);
  std::map<MeshEdge, std::uint32_t> middles;
  for (std::size_t i = 0; i < ends.size(); ++i)
    middles[order(ends[i][0], ends[i][1])] = static_cast<std::uint32_t>(count + i);

  // An edge of the first subdivision is two of the second: from a vertex that both have to one that only the
  // second has, and on.
  const std::size_t first = count_first_vertices(head.cage);
  std::map<std::uint32_t, std::set<std::uint32_t>> halves;
  for (const Quad& quad : surface.quads)
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t a = quad[i], b = quad[(i + 1) % 4];
      if (a < first) halves[b].insert(a);
      if (b < first) halves[a].insert(b);
    }
  const std::vector<glm::vec3>& at = mesh.positions;
  for (const auto& [middle, both] : halves) {
    if (both.size() != 2) continue;
    const std::uint32_t a = *both.begin(), b = *both.rbegin();
    lines.push_back(
        {{at[a], at[middles.at(order(a, middle))], at[middle], at[middles.at(order(middle, b))], at[b]},
         Pen::mesh});
  }
  return {mesh.positions, mesh.triangles};
}

// The cage itself, as its points stand in the pose.
WireSolid build_cage_solid(const Figure& figure, const WireFace& face, const std::vector<glm::dvec3>& posed,
                           std::vector<WireLine>& lines) {
  WireSolid solid;
  const double stretch =
      compute_stretch(figure.redraw, redraw_pose(figure.redraw, limit_pose(figure, face.pose)));
  for (std::size_t i = 0; i < posed.size(); ++i) {
    glm::dvec3 p = posed[i];
    if (figure.redraw.is_on()) {
      p = redraw_point(figure.redraw, stretch, p);
      p = glm::dvec3(compute_turn(figure.face.turn_pivot, face.turn, figure.face.turn_weights[i]) *
                     glm::dvec4(p, 1));
    }
    solid.positions.emplace_back(p);
  }
  std::set<MeshEdge> edges;
  for (const Quad& quad : figure.head.cage.quads) {
    solid.triangles.push_back({quad[0], quad[1], quad[2]});
    solid.triangles.push_back({quad[0], quad[2], quad[3]});
    for (std::size_t i = 0; i < 4; ++i) edges.insert(order(quad[i], quad[(i + 1) % 4]));
  }
  for (const auto& [a, b] : edges) lines.push_back({{solid.positions[a], solid.positions[b]}, Pen::mesh});
  return solid;
}

std::vector<glm::vec3> find_positions(const Part& part, const PartShape& shape) {
  if (!is_carried(part, shape)) return shape.positions;
  std::vector<glm::vec3> positions;
  for (const glm::vec3& p : part.rest.positions)
    positions.emplace_back(shape.world_from_rest * glm::vec4(p, 1));
  return positions;
}

// A part that hides what is behind it, by its name: what is clear or as thin as a hair does not.
bool is_solid(const std::string& name) {
  for (const char* start : {"eye_", "iris_", "caruncle_", "teeth_", "gum_", "tongue"})
    if (name.starts_with(start)) return true;
  return false;
}

// The net of what is nearly black, which is so fine that it is black on paper too: a pupil.
void append_black(const Part& part, const std::vector<glm::vec3>& positions, std::vector<WireLine>& lines) {
  constexpr float kBlack = 0.02f;
  const auto is_black = [&](std::uint32_t v) {
    const glm::vec3 srgb = part.palette[part.shade[v]].srgb;
    return std::max({srgb.x, srgb.y, srgb.z}) < kBlack;
  };
  if (part.shade.empty()) return;
  std::set<MeshEdge> edges;
  for (const Triangle& t : part.rest.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (const std::uint32_t a = t[i], b = t[(i + 1) % 3]; is_black(a) && is_black(b))
        edges.insert(order(a, b));
  for (const auto& [a, b] : edges) lines.push_back({{positions[a], positions[b]}, Pen::hair});
}

// The middle line of each hair, which is rings and a tip; a binding has all of them or one ring, and the last
// one of a hair the tip besides.
void append_hairs(const HeadPart& part, const std::vector<glm::vec3>& positions,
                  std::vector<WireLine>& lines) {
  WireLine hair{{}, Pen::hair};
  for (const Binding& binding : part.bindings) {
    for (std::uint32_t i = binding.first; i + kHairSides <= binding.first + binding.count; i += kHairSides) {
      glm::vec3 middle{0};
      for (std::uint32_t k = 0; k < kHairSides; ++k)
        middle += positions[i + k] / static_cast<float>(kHairSides);
      hair.points.push_back(middle);
    }
    if (binding.count % kHairSides == 0) continue;
    hair.points.push_back(positions[binding.first + binding.count - 1]);
    lines.push_back(std::exchange(hair, {{}, Pen::hair}));
  }
}

void append_guides(const Figure& figure, const WireSolid& skin, const glm::dmat4& world, WireModel& model) {
  const glm::dmat3 turn(world);
  const double chin_mm = measure_guide_heights(figure.head).front().second;
  const auto cut = [&](const glm::dvec3& normal, const glm::dvec3& through) {
    const glm::dvec3 turned = turn * normal;
    for (WireLine& line :
         slice_solid(skin, turned, glm::dot(turned, glm::dvec3(world * glm::dvec4(through, 1))), Pen::guide))
      model.lines.push_back(std::move(line));
  };
  for (const auto& [name, y_mm] : measure_guide_heights(figure.head))
    if (name != "chin" && name != "crown") cut({0, 1, 0}, {0, y_mm, 0});
  const std::size_t first = model.lines.size();
  cut({1, 0, 0}, {0, 0, 0});
  // Of the middle line what is above the chin.
  const glm::dmat4 figure_from_world = glm::inverse(world);
  for (std::size_t i = first; i < model.lines.size(); ++i) {
    std::vector<glm::vec3> above;
    for (const glm::vec3& p : model.lines[i].points)
      if ((figure_from_world * glm::dvec4(p, 1)).y >= chin_mm) above.push_back(p);
    model.lines[i].points = std::move(above);
  }
  std::erase_if(model.lines, [](const WireLine& line) { return line.points.size() < 2; });
}

}  // namespace

void append_wire_head(const Figure& figure, const WireFace& face, const WireOptions& wanted,
                      WireModel& model) {
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(figure, face.pose, face.turn, buffers, drawing);
  WireModel own;
  const WireSolid skin = build_skin(figure.head, drawing.parts.front(), own.lines);
  if (wanted.has_cage) {
    own.lines.clear();
    own.solids.push_back(build_cage_solid(figure, face, buffers.points, own.lines));
  } else {
    own.solids.push_back(skin);
  }
  constexpr double kSharp_deg = 50;  // edges of teeth, the rim of the iris; less and gums get nets
  for (std::size_t i = 1; i < figure.parts.size(); ++i) {
    const Part& part = figure.model.parts[i];
    const bool is_hair = part.name.starts_with("brow_") || part.name.starts_with("lash_");
    if (!is_hair && !is_solid(part.name)) continue;
    const std::vector<glm::vec3> positions = find_positions(part, drawing.parts[i]);
    if (is_hair) {
      append_hairs(figure.parts[i], positions, own.lines);
      continue;
    }
    if (part.name.starts_with("iris_")) append_black(part, positions, own.lines);
    own.solids.push_back({positions, part.rest.triangles, true, kSharp_deg});
  }
  const glm::dmat4 turn =
      is_turned(face.turn) ? compute_turn(figure.face.turn_pivot, face.turn, 1) : glm::dmat4(1);
  if (wanted.has_guides) append_guides(figure, own.solids.front(), turn, own);
  if (wanted.has_limits) append_limit_lines(figure, turn, own);

  const glm::mat4 world(face.world_from_figure);
  const auto place = [&](std::vector<glm::vec3>& points) {
    for (glm::vec3& p : points) p = glm::vec3(world * glm::vec4(p, 1));
  };
  for (WireSolid& solid : own.solids) {
    place(solid.positions);
    model.solids.push_back(std::move(solid));
  }
  for (WireLine& line : own.lines) {
    place(line.points);
    model.lines.push_back(std::move(line));
  }
}

}  // namespace mien
