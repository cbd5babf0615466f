// A place of the skin that is the same on every head: where it lies on the adult.
#pragma once

#include <vector>

#include "head/head.hpp"

namespace mien {

// Where each vertex of the skin lies on the average adult, mm. Pores, patches and spots belong to a place of
// the skin and not of the room: on a head that grows they must not crawl.
std::vector<glm::vec3> compute_places_on_adult(const NeutralHead& head);

}  // namespace mien
