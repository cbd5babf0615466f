// How a node's place, turn or weights go in time, as animations of glTF 2.0 tell it (Khronos, 3.11).
#pragma once

#include <array>
#include <glm/gtc/quaternion.hpp>
#include <span>

#include "import/gltf_file.hpp"

namespace mien {

enum class GltfBetween { linear, step, cubic };

struct GltfWay {
  std::size_t width = 0;      // numbers a time: of weights as many as there are targets
  std::vector<float> at_s;    // rising, from 0 on; one at least
  std::vector<float> values;  // time by time; of a cubic one each between its two tangents
  GltfBetween between = GltfBetween::linear;
  bool is_turn = false;  // values are quaternions, x y z w
};

// The first way of the node's "translation", "rotation" or "weights" in any animation of the file. Throws
// InputError if it is broken.
std::optional<GltfWay> read_gltf_way(GltfFile& gltf, std::size_t node, std::string_view path);

// The `width` numbers at a time; before its first time and after its last one it stays.
void sample_gltf_way(const GltfWay& way, double at_s, std::span<double> into);
glm::dquat sample_gltf_turn(const GltfWay& way, double at_s);

// Turn to the character's left, nod (chin down) and tilt (crown to the left) of a head that x to its left, y
// up and z forward turn by this.
std::array<float, 3> find_turn_deg(const glm::dquat& turn);

}  // namespace mien
