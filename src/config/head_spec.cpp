#include "config/head_spec.hpp"

namespace mien {

Look compute_aged_look(const Look& look, const Mix& age) {
  const auto found = age.find("old");
  const auto old = static_cast<float>(found == age.end() ? 0 : found->second);
  Look aged = look;
  if (look.brow_old) aged.brow = glm::mix(look.brow, *look.brow_old, old);
  if (look.hair_old) aged.hair = glm::mix(look.hair, *look.hair_old, old);
  if (look.age_spots_old) aged.age_spots = glm::mix(look.age_spots, *look.age_spots_old, double{old});
  aged.brow_old = aged.hair_old = {};
  aged.age_spots_old = {};
  return aged;
}

}  // namespace mien
