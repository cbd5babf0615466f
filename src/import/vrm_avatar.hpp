// What an avatar of VRM can do with its face: its expressions, by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mien {

// A shape of the avatar's mesh, by the name of its target, as far as the expression has it.
struct VrmBind {
  std::string target;  // empty where the mesh names none
  double weight = 0;   // 0..1
};

struct VrmExpression {
  std::string name;                    // "happy", "aa", "jawOpen"; as VRM 1.0 writes presets
  bool is_custom = false;              // none of VRM's presets
  bool is_binary = false;              // nothing or all
  std::vector<std::string> overrides;  // what it takes from others: "blink block", "mouth blend"
  std::vector<VrmBind> binds;
};

struct VrmAvatar {
  std::string file;
  std::vector<VrmExpression>
      expressions;  // presets first, in the file's order; without those that do nothing
};

// Reads VRM 1.0 (VRMC_vrm, "expressions") and VRM 0.x (VRM, "blendShapeMaster"); textures and materials that
// an expression changes are not asked. Throws InputError "FILE: error: what was found; expected ...".
VrmAvatar load_vrm_avatar(const std::filesystem::path& file);

}  // namespace mien
