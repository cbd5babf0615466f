// What the materials of templates/povray/materials.inc are to programs that light by roughness and metal.
#pragma once

#include <string>

#include "core/model.hpp"

namespace mien {

struct SurfaceLook {
  float roughness = 0.5f;     // 0 a mirror .. 1 matt
  float alpha = 1;            // below 1 it is see-through
  bool is_two_sided = false;  // no solid: its back is seen
  bool is_faded = false;      // its colour fades out where its grain is 1 and more: a freckle
};

// Of a material's name; one that is not known looks as plain matter does.
SurfaceLook find_surface_look(const std::string& material);

// Whether it is a lock or a tress of hair: its grain is x across in mm, y from the root, 0, to the tip, 100.
bool has_strands(const Part& part);

// The linear colour of a vertex, or of a triangle where `shade` is its own; hair is darker at the root.
glm::vec4 compute_vertex_colour(const Part& part, const SurfaceLook& look, std::size_t vertex,
                                std::uint16_t shade);

float linearize(float srgb);

}  // namespace mien
