// The neutral head: a cage of control points, the smooth skin it stands for, and the parts that sit in it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "config/areas.hpp"
#include "config/head_data.hpp"
#include "config/head_spec.hpp"
#include "core/model.hpp"

namespace mien {

// Names to indices, findable by string_view.
using NameIndex = std::map<std::string, std::uint32_t, std::less<>>;

// A closed-but-for-neck-and-eyes quad mesh of control points over the whole head. The left half (x >= 0) has
// the names of templates/head/half_points.csv ("E1_4"); its mirror image has "R:" before them. Points of the
// mid-plane (x = 0) stand once.
struct Cage {
  std::vector<std::string> names;
  std::vector<glm::dvec3> points;  // mm
  std::vector<Quad> quads;
  std::vector<std::uint32_t> mirror;  // index of the mirror image; of itself on the mid-plane
  NameIndex index;                    // name -> index
};

struct Surface;

// The eye of the left half; the right one is its mirror image.
struct Eye {
  glm::dvec3 centre{31.5, 0, 69.5};  // mm
  double radius_mm = 13.0;           // of the ball; the cornea stands 1.05 mm further out at 13
};

// The skin as a smooth mesh, and where the cage's points came to lie on it: vertex i of the mesh is point i
// of the cage, moved to the limit surface, for i below the number of cage points.
struct NeutralHead {
  HeadDataPointer data;  // what it is made from, and its parts will be
  std::vector<glm::dvec3>
      adult_points;  // the average adult's control points, in the same order: the yardstick
  Eye adult_eye;
  Cage cage;
  std::shared_ptr<const Surface> surface;  // how the skin follows the cage; see head/surface.hpp
  Eye eye;
  double hairline = 4;        // where it crosses the mid-line; see compute_hairline in head/guides.hpp
  double brow_thickness = 1;  // width of the brows against the adult's
  double shortened_mm = 0;    // by its design: how much nearer to the eyes the chin has come
  DesignNumbers design;       // how it is posed and drawn
  Mix ages;                   // how old it is, by the names of ages; empty: a scan that does not say
  Mesh skin;  // two Catmull-Clark levels at limit positions, about 27,000 vertices, triangulated
};

// What carries a part from the neutral head into a drawing.
enum class Mount { skin, strands, skull, jaw, eye_left, eye_right };

// Vertices [first, first + count) of a part ride on one place of the skin as a rigid little thing (a hair).
struct Binding {
  std::uint32_t triangle = 0;  // of the skin
  glm::vec3 barycentric{1, 0, 0};
  std::uint32_t first = 0, count = 0;
};

struct HeadPart {
  Part part;
  Mount mount = Mount::skull;
  std::vector<Binding> bindings;  // Mount::strands only; they cover all vertices once, in order
};

// A place on the skin as a frame: origin, and the columns tangent, bitangent, normal.
struct SkinFrame {
  glm::vec3 origin{0};
  glm::mat3 axes{1};
};

// The frame of a binding on the skin as it is now (positions and normals of one drawing). The tangent follows
// the triangle's first edge, so the frame turns with the skin.
SkinFrame compute_skin_frame(const std::vector<glm::vec3>& positions, const std::vector<glm::vec3>& normals,
                             const Triangle& triangle, const glm::vec3& barycentric);

struct HeadStock;

// The neutral head of `spec`, its skin included. Throws InputError for broken files that it names.
NeutralHead build_neutral_head(const HeadStock& stock, const HeadSpec& spec);

// The parts, each fitted to the neutral head it is given. Left ones first, then their exact mirror images.
// eyes: eye_left/right (sclera), iris_left/right (disc with pupil), cornea_left/right, tear_left/right (wet
// line of the lower lid), caruncle_left/right. Eyeball parts are rigid (Mount::eye_*) about the ball's
// centre.
std::vector<HeadPart> build_eyes(const NeutralHead& head, const Look& look);
// mouth: teeth_upper and gum_upper (Mount::skull), teeth_lower, gum_lower and tongue (Mount::jaw), lip_veil
// on the upper lip (Mount::strands), which keeps teeth from shining through shut lips.
std::vector<HeadPart> build_mouth(const NeutralHead& head, const Look& look);
// brows and lashes: brow_left/right, lash_left/right as tapered hair tubes (Mount::strands).
std::vector<HeadPart> build_hairs(const NeutralHead& head, const Look& look);

}  // namespace mien
