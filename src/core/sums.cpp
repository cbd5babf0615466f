#include "core/sums.hpp"

#include <cassert>

// The choice of a processor is made when the program starts, where the compiler can build for several.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#define MIEN_CLONES [[gnu::target_clones("avx2", "default")]]
#else
#define MIEN_CLONES
#endif

namespace mien {

namespace {

MIEN_CLONES void add(std::size_t count, double by, const double* __restrict field, double* __restrict sums) {
  for (std::size_t i = 0; i < count; ++i) sums[i] += by * field[i];
}

MIEN_CLONES void add_two(std::size_t count, double by, const double* __restrict field, double other_by,
                         const double* __restrict other, double* __restrict sums) {
  for (std::size_t i = 0; i < count; ++i) sums[i] += by * field[i] + other_by * other[i];
}

static_assert(sizeof(glm::dvec3) == 3 * sizeof(double));

}  // namespace

void add_products(double by, const std::vector<glm::dvec3>& field, std::vector<glm::dvec3>& points) {
  assert(field.size() == points.size());
  if (!points.empty()) add(3 * points.size(), by, &field.front().x, &points.front().x);
}

void add_products(double by, const std::vector<glm::dvec3>& field, double other_by,
                  const std::vector<glm::dvec3>& other, std::vector<glm::dvec3>& points) {
  assert(field.size() == points.size() && other.size() == points.size());
  if (!points.empty())
    add_two(3 * points.size(), by, &field.front().x, other_by, &other.front().x, &points.front().x);
}

}  // namespace mien
