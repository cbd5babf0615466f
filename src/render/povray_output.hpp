// What POV-Ray says: its messages made readable, and the truths that its exit status hides.
#pragma once

#include <string>

#include "render/process.hpp"

namespace mien {

// POV-Ray's messages with the line breaks taken out that it puts in after 80 columns.
std::string unwrap_povray_output(const std::string& output);

// The lines where the reason of a failure stands, unwrapped: the errors and what came since the last heading
// ("==== [Parsing...]"), or if it thinks that all went well, its warnings.
std::string find_povray_reason(const ProcessResult& result);

// By its own statistics: nothing bounded, such as a mesh, and nothing without bounds, such as a plane. Lights
// and sky are no objects. POV-Ray renders such a scene and exits with 0; its warning "No objects in scene"
// counts lights.
bool is_empty_scene(const std::string& output);

// The machine was too busy: POV-Ray gives up where its own threads do not come up in some seconds. Nothing of
// that is the scene's fault.
bool is_late_start(const std::string& output);

}  // namespace mien
