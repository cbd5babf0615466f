// What a drawing is made from as one short word, so that one which was computed once need not be computed
// again to know its picture.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "clip/figure_store.hpp"
#include "clip/scenes.hpp"
#include "render/picture_store.hpp"

namespace mien {

// Of each of the plan's drawings: two that share it are the same picture, computed by this very program from
// the same data. It holds everybody's head, place and pose, light, ground and camera; of a mesh or scan its
// file's size and time.
std::vector<std::string> list_origins(const SceneRun& run);

// Origins and the keys of their pictures, as the store's folder has them: an unreadable file holds none.
using KnownDrawings = std::map<std::string, std::string>;
KnownDrawings read_known_drawings(const PictureStore& store);

// Keeps those whose picture the store has and those of `in_use`. A folder that cannot be written keeps none,
// which costs time and nothing else.
void write_known_drawings(const PictureStore& store, const KnownDrawings& known,
                          const std::vector<std::string>& in_use);

}  // namespace mien
