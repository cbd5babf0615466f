// Sums over many points, quick on any processor: none of them asks for more than a number at a time, so every
// processor gives the same bits.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace mien {

// points[i] += by * field[i]. Both are as long.
void add_products(double by, const std::vector<glm::dvec3>& field, std::vector<glm::dvec3>& points);

// points[i] += by * field[i] + other_by * other[i]: the products are added to each other first.
void add_products(double by, const std::vector<glm::dvec3>& field, double other_by,
                  const std::vector<glm::dvec3>& other, std::vector<glm::dvec3>& points);

}  // namespace mien
