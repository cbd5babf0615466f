// The eyeball kept in its lids when somebody else has moved them.
#pragma once

#include "head/form.hpp"

namespace mien {

// A scaling, a turn and a shift: to = scale * rotation * from + shift.
struct Similarity {
  double scale = 1;
  glm::dmat3 rotation{1};
  glm::dvec3 shift{0};
};

glm::dvec3 apply_similarity(const Similarity& similarity, const glm::dvec3& point);

// The one that brings the points of `from` nearest to those of `to`, in the mean of the squares: Umeyama,
// "Least-squares estimation of transformation parameters between two point patterns", 1991. At least three
// points that are not in one line.
Similarity fit_similarity(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to);

// Moves the ball of `form` as its left lids (the rings E0, E1, E2 on the skin) have moved since `before`;
// lids that have not moved leave it as it is. Then lifts lids that would sink into the ball.
void fit_eye(const HeadStock& stock, const std::vector<glm::dvec3>& before, HeadForm& form);

}  // namespace mien
