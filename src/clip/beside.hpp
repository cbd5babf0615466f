// One performance on several designs of a head, side by side in one clip.
#pragma once

#include <string>
#include <vector>

#include "clip/clip.hpp"
#include "config/design_data.hpp"

namespace mien {

// The clip with everybody's head of that design, in the style that goes with it unless the file says one; its
// files are in a folder of the design's name within the clip's. Throws InputError for a design that is not
// there.
Clip redesign_clip(const Clip& clip, const std::string& name, const std::vector<Design>& designs);

// The clip of all of them: as wide as they are together.
Clip widen_clip(const Clip& clip, std::size_t count);

// The keys of the whole's pictures, from those of each of its parts'.
std::vector<std::string> join_keys(const std::vector<std::vector<std::string>>& parts);

// Pastes the pictures of `parts`, which have been rendered, into those of `whole`, from left to right, but
// for those that are there already with their key.
void join_pictures(const std::vector<Clip>& parts, const Clip& whole, const std::vector<std::string>& keys);

}  // namespace mien
