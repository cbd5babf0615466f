#include "config/spec.hpp"

namespace mien {

std::vector<ActorSpec> list_actors(const Spec& spec) {
  if (!spec.actors.empty()) return spec.actors;
  return {ActorSpec{"", spec.head, {}, spec.clip}};
}

}  // namespace mien
