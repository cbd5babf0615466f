// How open the sky is above each vertex: what makes sockets, nostrils and the underside of the chin read as
// hollows.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

// For each vertex the share (0 shut .. 1 open) of the directions above its normal that leave `mesh`
// unhindered, each weighted by its cosine: ambient occlusion, by one depth map a direction (Williams 1978,
// "Casting curved shadows on curved surfaces"). `mirror` names each vertex' mirror image; mirror images get
// the same value, bit for bit. Hollows narrower than about 3 mm are missed. 27,000 vertices take about 50 ms.
std::vector<float> measure_openness(const Mesh& mesh, const std::vector<std::uint32_t>& mirror);

}  // namespace mien
