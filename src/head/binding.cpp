#include "head/binding.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <map>
#include <tuple>

#include "core/error.hpp"
#include "core/float4.hpp"
#include "core/nearest_point.hpp"

namespace mien {

namespace {

glm::vec3 blend(const std::vector<glm::vec3>& values, const Triangle& triangle,
                const glm::vec3& barycentric) {
  return values[triangle[0]] * barycentric[0] + values[triangle[1]] * barycentric[1] +
         values[triangle[2]] * barycentric[2];
}

// Which vertex is the mirror image of which, and which triangle has these three vertices.
struct MirrorIndex {
  std::map<std::tuple<float, float, float>, std::uint32_t> vertex_at;
  std::map<Triangle, std::uint32_t> triangle_of;  // key: vertices in ascending order
};

Triangle sort_vertices(Triangle triangle) {
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

MirrorIndex build_mirror_index(const Mesh& skin, const Box& mirrored_box) {
  const auto is_inside = [&](std::uint32_t v) {
    const glm::vec3& p = skin.positions[v];
    return glm::all(glm::greaterThanEqual(p, mirrored_box.low)) &&
           glm::all(glm::lessThanEqual(p, mirrored_box.high));
  };
  MirrorIndex index;
  for (std::uint32_t v = 0; v < skin.positions.size(); ++v)
    if (is_inside(v)) index.vertex_at[{skin.positions[v].x, skin.positions[v].y, skin.positions[v].z}] = v;
  for (std::uint32_t t = 0; t < skin.triangles.size(); ++t) {
    const Triangle& triangle = skin.triangles[t];
    if (is_inside(triangle[0]) && is_inside(triangle[1]) && is_inside(triangle[2]))
      index.triangle_of[sort_vertices(triangle)] = t;
  }
  return index;
}

Binding mirror_binding(const Binding& left, const Mesh& skin, const MirrorIndex& index) {
  const Triangle& from = skin.triangles[left.triangle];
  Triangle image{};
  for (int i = 0; i < 3; ++i) {
    const glm::vec3& p = skin.positions[from[i]];
    const auto found = index.vertex_at.find({-p.x, p.y, p.z});
    if (found == index.vertex_at.end()) throw RunError("the skin is not the mirror image of itself");
    image[i] = found->second;
  }
  const auto found = index.triangle_of.find(sort_vertices(image));
  if (found == index.triangle_of.end()) throw RunError("the skin is not the mirror image of itself");
  Binding right{found->second, glm::vec3(0), left.first, left.count};
  const Triangle& to = skin.triangles[right.triangle];
  for (int i = 0; i < 3; ++i)
    right.barycentric[i] =
        left.barycentric[static_cast<int>(std::find(image.begin(), image.end(), to[i]) - image.begin())];
  return right;
}

Box compute_mirrored_box(const std::vector<HeadPart>& left, const Mesh& skin) {
  std::vector<glm::vec3> corners;
  for (const HeadPart& part : left)
    for (const Binding& binding : part.bindings)
      for (const std::uint32_t v : skin.triangles[binding.triangle])
        corners.push_back({-skin.positions[v].x, skin.positions[v].y, skin.positions[v].z});
  return compute_bounds(corners);
}

Mount mirror_mount(Mount mount) {
  if (mount == Mount::eye_left) return Mount::eye_right;
  if (mount == Mount::eye_right) return Mount::eye_left;
  return mount;
}

}  // namespace

SkinFrame compute_skin_frame(const std::vector<glm::vec3>& positions, const std::vector<glm::vec3>& normals,
                             const Triangle& triangle, const glm::vec3& barycentric) {
  // As blend does it; four floats at once, since every hair of every frame asks for it.
  const auto [i, j, k] = triangle;
  const Float4 a = pack(positions[i]), b = pack(positions[j]), c = pack(positions[k]);
  const Float4 origin = a * barycentric[0] + b * barycentric[1] + c * barycentric[2];
  const Float4 blended = pack(normals[i]) * barycentric[0] + pack(normals[j]) * barycentric[1] +
                         pack(normals[k]) * barycentric[2];
  const Float4 normal = normalize(blended, 1e-12f, Float4{0, 0, 1, 0}), edge = b - a;
  Float4 tangent = edge - normal * dot(edge, normal);
  if (!(dot(tangent, tangent) > 1e-12f)) {  // a collapsed edge: any direction along the skin
    const Float4 any = std::abs(normal[0]) < 0.9f ? Float4{1, 0, 0, 0} : Float4{0, 1, 0, 0};
    tangent = any - normal * dot(any, normal);
  }
  tangent = normalize(tangent, 0, tangent);
  return {unpack(origin), glm::mat3(unpack(tangent), unpack(cross(normal, tangent)), unpack(normal))};
}

SkinPatch build_skin_patch(const Mesh& skin, const Box& box) {
  SkinPatch patch{&skin, {}, {}, {}};
  for (std::uint32_t t = 0; t < skin.triangles.size(); ++t) {
    const auto& [i, j, k] = skin.triangles[t];
    const glm::vec3 &a = skin.positions[i], &b = skin.positions[j], &c = skin.positions[k];
    const glm::vec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    if (glm::any(glm::lessThan(high, box.low)) || glm::any(glm::greaterThan(low, box.high))) continue;
    const glm::vec3 centre = (a + b + c) / 3.0f;
    patch.triangles.push_back(t);
    patch.centres.push_back(centre);
    patch.radii_mm.push_back(
        std::max({glm::distance(a, centre), glm::distance(b, centre), glm::distance(c, centre)}));
  }
  return patch;
}

SkinPlace find_nearest_place(const SkinPatch& patch, const glm::vec3& point) {
  assert(!patch.triangles.empty());
  const Mesh& skin = *patch.skin;
  SkinPlace best;
  float nearest = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    if (glm::distance(patch.centres[i], point) - patch.radii_mm[i] >= nearest) continue;
    const auto& [a, b, c] = skin.triangles[patch.triangles[i]];
    const glm::vec3 barycentric =
        compute_nearest_barycentric(point, skin.positions[a], skin.positions[b], skin.positions[c]);
    const glm::vec3 on_skin = blend(skin.positions, skin.triangles[patch.triangles[i]], barycentric);
    const float distance = glm::distance(on_skin, point);
    if (distance < nearest) {
      nearest = distance;
      best = {patch.triangles[i], barycentric, on_skin, best.normal};
    }
  }
  const glm::vec3 normal = blend(skin.normals, skin.triangles[best.triangle], best.barycentric);
  best.normal = glm::dot(normal, normal) > 1e-12f ? glm::normalize(normal) : glm::vec3(0, 0, 1);
  return best;
}

std::vector<HeadPart> mirror_parts(const std::vector<HeadPart>& left, const Mesh& skin) {
  const MirrorIndex index = build_mirror_index(skin, compute_mirrored_box(left, skin));
  std::vector<HeadPart> right = left;
  for (HeadPart& part : right) {
    const std::string ending = "_left";
    if (part.part.name.ends_with(ending))
      part.part.name.replace(part.part.name.size() - ending.size(), ending.size(), "_right");
    part.mount = mirror_mount(part.mount);
    for (glm::vec3& p : part.part.rest.positions) p.x = -p.x;
    for (glm::vec3& n : part.part.rest.normals) n.x = -n.x;
    for (Triangle& t : part.part.rest.triangles) std::swap(t[1], t[2]);
    for (Binding& binding : part.bindings) binding = mirror_binding(binding, skin, index);
  }
  return right;
}

void add_mirror_image(HeadPart& part, const Mesh& skin) {
  if (part.bindings.empty()) return;
  const HeadPart right = mirror_parts({part}, skin).front();
  const auto shift = static_cast<std::uint32_t>(part.part.rest.positions.size());
  append_mesh(part.part.rest, right.part.rest);
  part.part.shade.insert(part.part.shade.end(), right.part.shade.begin(), right.part.shade.end());
  part.part.grain.insert(part.part.grain.end(), right.part.grain.begin(), right.part.grain.end());
  for (Binding binding : right.bindings) {
    binding.first += shift;
    part.bindings.push_back(binding);
  }
}

}  // namespace mien
