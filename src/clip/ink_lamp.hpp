// The one lamp of ink where a clip says lights: it stands where the light sets' keys do.
#pragma once

#include <optional>
#include <vector>

#include "core/staging.hpp"
#include "scene/povray.hpp"

namespace mien {

// None of no lights: then the lamp is where compute_ink_view says, and colours are as they are.
std::optional<InkLamp> find_ink_lamp(const std::vector<LightShare>& lights, const CameraView& view);

}  // namespace mien
