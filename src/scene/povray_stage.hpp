// Of a POV-Ray scene what is not a figure: lights and what lies behind.
#pragma once

#include <string>
#include <vector>

#include "core/staging.hpp"

namespace mien {

// The macros frame_lights and frame_background of a frame that has lights or a background of its own; nothing
// otherwise: head.inc has both already.
void append_povray_lights(std::string& text, const std::vector<LightShare>& lights);
void append_povray_background(std::string& text, const std::vector<BackgroundShare>& backgrounds);

}  // namespace mien
