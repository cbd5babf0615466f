// A head as one closed print: skin, carved eyes, mouth and brows stitched together, with the same triangles
// in every pose.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/holes.hpp"
#include "frames/bust_brows.hpp"
#include "frames/bust_eyes.hpp"
#include "frames/bust_foot.hpp"
#include "frames/bust_hair.hpp"
#include "frames/bust_mouth.hpp"
#include "frames/bust_patch.hpp"
#include "frames/bust_relax.hpp"
#include "frames/bust_slit.hpp"
#include "frames/figure.hpp"
#include "head/lens.hpp"
#include "head/surface.hpp"

namespace mien {

struct BustSize {
  Stand stand = Stand::foot;
  double figure_mm = 72;  // height of the print's figure, on its foot
  double whole_mm = 80;   // of the print: relief is as deep as it asks for
  std::size_t triangles = 15000;

  bool operator==(const BustSize&) const = default;
};

// Everything about a bust that no pose changes. Lengths of the head's space unless said otherwise.
struct BustBody {
  Stand stand = Stand::foot;
  // The vertices that were kept, by their index among all of them; triangles name kept ones.
  std::vector<std::uint32_t> kept;
  std::vector<Triangle> triangles;  // counter-clockwise from outside; open at the foot alone
  std::uint32_t first_hair = 0;     // of the kept vertices; those of the hair's mass are the last ones
  Loop foot;                        // the open edge, counter-clockwise seen from above
  std::array<Patch, 2> eyes;        // left, right; vertices among the kept ones
  Patch mouth;
  // From the head's space to the print's: z up, front toward -y, the foot's centre on the origin.
  glm::vec3 origin{0};
  float print_per_head = 1;

  BustRelax relax;
  Lens lens;  // that all of it goes through at last
  std::vector<glm::vec3>
      thicker;  // of each kept vertex, mm of the print: what every pose adds before the lens; or empty

  std::shared_ptr<const Surface> surface;  // of the skin, as far as kept vertices need it

  // All vertices before any was left out.
  std::size_t all_count = 0;
  std::array<Patch, 2> all_eyes;
  Patch all_mouth;
  std::array<Slit, 2> eye_slits;
  Slit mouth_slit;
  float eye_slit_mm = 0, mouth_slit_mm = 0;
  RaisedBrows brows;
  Loop chest;                    // the skin's lower edge
  std::uint32_t first_foot = 0;  // rings of as many vertices as the chest's edge
  BustHair hair;                 // of a drawn head whose cut is a mass
  std::array<CarvedEye, 2> carved;
  CarvedMouth carved_mouth;  // its jaw at rest
};

// Whether a bust of the figure is to have its hair: that of a drawn head, if its cut is a mass and not paint
// alone. Its body has none all the same where the hair's edge cannot be sewn.
bool wears_hair(const Figure& figure);

// The body of a figure. Its pose decides nothing but where the least missed triangles are. About 0.3 s.
BustBody build_bust_body(const Figure& figure, const BustSize& size);

// The kept vertices in a pose, mm of the print: within the limits that the figure's head has. The head is not
// turned: a bust looks ahead.
std::vector<glm::vec3> place_bust(const BustBody& body, const Figure& figure, const Pose& pose);
// The same on another stand than the body's, at the body's scale and from its origin.
std::vector<glm::vec3> place_bust(const BustBody& body, const Figure& figure, const Pose& pose, Stand stand);

// The same before the lens: what formulas and sums of moves make.
std::vector<glm::vec3> place_straight(const BustBody& body, const Figure& figure, const Pose& pose,
                                      Stand stand);
std::vector<glm::vec3> place_straight(const BustBody& body, const Figure& figure, const Pose& pose);

// Through the lens: vertices of the print.
void bend_print(const BustBody& body, std::vector<glm::vec3>& print);

// What is printed of a real head in one expression: where it passes through itself it is relaxed. A drawn one
// is so in every pose, by place_straight; a real one's sums of moves must be its own poses.
void relax_print(const BustBody& body, std::vector<glm::vec3>& print);

// Which kept vertices stay where formulas look for them: patches, their rims and the foot.
std::vector<bool> list_fixed(const BustBody& body);

// The eyes and the mouth as they are carved in a pose, mm of the head.
std::array<CarvedEye, 2> compute_carved_eyes(const BustBody& body, const Figure& figure, const Pose& pose);
CarvedMouth compute_carved_mouth(const BustBody& body, const Figure& figure, const Pose& pose);

}  // namespace mien
