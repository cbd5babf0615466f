// What a writer is given: the parts of a figure, and one drawing of them. Writers know meshes, not heads.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/atlas.hpp"
#include "core/mesh.hpp"

namespace mien {

// A colour of a part's palette. Skin goes from face to lip to mouth in small steps of it, so no border is
// hard.
struct Shade {
  glm::vec3 srgb{1};  // 0..1 a channel, as in "#rrggbb"
  float gloss = 0;    // 0 matt .. 1 wet; what it means is the material's affair
  float blood = 0;    // 0..1: how much of its red goes where the drawing is pale (PartShape::paling)
};

// A picture that lies over a part.
struct PartPicture {
  std::filesystem::path file;          // a PNG
  std::string name;                    // its name beside a scene: of its bytes, "skin_0123456789abcdef.png"
  std::shared_ptr<const Atlas> atlas;  // its triangles are the part's
  float side_mm = 1;                   // how long on the part a side of the picture is
};

// One part: what of it never changes in a clip.
struct Part {
  std::string name;            // "skin", "eye_left", ...: a lower-case identifier, unique in the model
  std::string material;        // a material of templates/povray/materials.inc: "skin", "sclera", "hair", ...
  Mesh rest;                   // the neutral shape; its triangles hold for every drawing
  std::vector<Shade> palette;  // at least one
  std::vector<std::uint16_t>
      shade;  // an index into `palette` for each vertex; empty: all vertices take palette[0]
  std::vector<std::uint16_t> triangle_shade =
      {};                        // the same for each triangle instead: borders are sharp; or empty
  std::vector<glm::vec2> grain;  // mm; where a vertex lies on the skin as if unrolled flat: fine patterns
                                 // that must move with the skin live there; one a vertex, or empty
  double wear = 0;        // 0 fresh .. 1 old: how far fine lines are worn into it; the material's affair too
  bool is_rigid = false;  // true: a drawing gives a transform only; false: it gives positions and normals
  bool is_outline = false;  // a drawing gives its triangles too (PartShape::triangles), and `rest` is empty
  bool may_bend = false;    // of a rigid part: a drawing may give its positions and normals all the same
  std::shared_ptr<const PartPicture> picture =
      {};                  // in place of the palette's colours, where it can be shown; or none
  bool is_printed = true;  // false: too fine for a bust (lashes, tear line, cornea)
};

struct Model {
  std::vector<Part> parts;
};

// One part in one drawing. A rigid part has only `world_from_rest`; another has only positions and normals.
// One that may bend has no positions where it does not.
struct PartShape {
  std::vector<glm::vec3> positions;  // mm, world; as many as in the part's rest mesh
  std::vector<glm::vec3> normals;    // unit, world; as many, or none of a part that is flat
  std::vector<Triangle> triangles;   // of an outline alone
  glm::mat4 world_from_rest{1};      // a rotation and a shift
  double paling = 0;                 // 0..1: how little blood is in the shades that have some
};

// Whether a drawing carries the part as a whole, and has no vertices of it.
inline bool is_carried(const Part& part, const PartShape& shape) {
  return part.is_rigid && (!part.may_bend || shape.positions.empty());
}

struct Drawing {
  std::vector<PartShape> parts;  // in the order of Model::parts
  bool is_away = false;          // nothing of it is to be seen, whatever the parts are
};

}  // namespace mien
