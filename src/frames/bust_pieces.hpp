// Parts that are printed as they come: taken apart into closed pieces, and only those kept that show and
// hold.
#pragma once

#include <string>
#include <vector>

#include "core/mesh.hpp"
#include "core/print.hpp"

namespace mien {

// Each connected piece of `mesh` as a closed solid: "tongue", or "teeth_upper_1", "teeth_upper_2", ... of
// several. Pieces wound inwards are turned, flat ones left out.
void append_pieces(std::vector<Solid>& solids, const std::string& name, const Mesh& mesh);

// Leaves out the solids that lie wholly inside the closed `skin` (they would only cost time) and those that
// lie wholly outside (they would fall off).
void keep_showing(std::vector<Solid>& solids, const Mesh& skin);

// Whether each point lies inside the closed `mesh`: a ray along +y crosses it an odd number of times.
std::vector<bool> find_inside(const Mesh& mesh, const std::vector<glm::vec3>& points);

}  // namespace mien
