#include "core/smooth.hpp"
#include "head/lids.hpp"
#include "head/strands.hpp"
#include "head/tubes.hpp"

namespace mien {

HeadPart make_hair_part(const std::string& name) {
  HeadPart part;
  part.part.name = name;
  part.part.material = "hair";
  part.mount = Mount::strands;
  return part;
}

std::vector<Shade> make_hair_palette(const glm::vec3& colour, float spread, float gloss) {
  std::vector<Shade> palette;
  for (int i = 0; i < kHairShades; ++i) {
    const float way = 2.0f * static_cast<float>(i) / (kHairShades - 1) - 1;
    const glm::vec3 shade = colour * (1 + spread * way) + glm::vec3(0.03f, 0.01f, -0.01f) * spread * way;
    palette.push_back({glm::clamp(shade, 0.0f, 1.0f), gloss});
  }
  return palette;
}

void finish_hair(HeadPart& part, const std::vector<SkinPlace>& places, std::uint16_t shade) {
  const auto count = static_cast<std::uint32_t>(part.part.rest.positions.size());
  std::uint32_t first = part.bindings.empty() ? 0 : part.bindings.back().first + part.bindings.back().count;
  for (const SkinPlace& place : places) {
    const std::uint32_t last = &place == &places.back() ? count : first + kHairSides;
    part.bindings.push_back({place.triangle, place.barycentric, first, last - first});
    first = last;
  }
  part.part.shade.resize(count, shade);
}

std::uint32_t append_blade(const std::array<glm::vec3, 5>& places, const glm::vec3& normal, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const glm::vec3& p : places) {
    mesh.positions.push_back(p);
    mesh.normals.push_back(normal);
  }
  mesh.triangles.push_back({first, first + 1, first + 3});
  mesh.triangles.push_back({first, first + 3, first + 2});
  mesh.triangles.push_back({first + 2, first + 3, first + 4});
  return first;
}

std::vector<HeadPart> build_hairs(const NeutralHead& head, const Look& look) {
  const PartNumbers& numbers = head.data->parts;
  const double youth =
      1 - smooth_step(numbers.brow.grown_mm[0], numbers.brow.grown_mm[1], compute_eye_to_chin_mm(head));
  std::vector<HeadPart> parts;
  parts.push_back(build_brow(head, numbers.brow, look, youth));
  parts.push_back(build_lashes(head, numbers, look, youth));
  const std::vector<HeadPart> right = mirror_parts(parts, head.skin);
  parts.insert(parts.end(), right.begin(), right.end());
  return parts;
}

}  // namespace mien
