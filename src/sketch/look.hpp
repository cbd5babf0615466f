// The materials of a model's parts as a sketch needs them.
#pragma once

#include <vector>

#include "core/model.hpp"
#include "sketch/sdl.hpp"
#include "sketch/texture.hpp"

namespace mien {

struct SketchPart {
  std::vector<SketchTexture> textures;  // one for each colour of the part's palette
  bool is_seen = true;                  // by the camera
  bool has_shadow = true;
  bool is_clear = false;  // something of it lets light through
  bool is_veil = false;   // all of it does, everywhere alike
};

// One for each part of the model, in its order.
struct SketchLook {
  std::vector<SketchPart> parts;
};

// `names` are those of a stage: some materials depend on how wide a pixel is, and on where the lamp stands.
// Throws RunError on a material that is not known here.
SketchLook build_sketch_look(const Model& model, const SdlNames& names);

}  // namespace mien
