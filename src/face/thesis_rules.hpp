// The rules of the areas to the letter, for heads that say `rules: thesis`; and LIPS_MATCH_LEVEL as a height,
// which any head may say.
// Source: Yen, "Animation of Human Faces", Tamkang University, 1990, section 5.3.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "face/face.hpp"
#include "face/limits.hpp"

namespace mien {

// A brow that its rectangle held, and which of its points reached which limit.
struct BrowHold {
  Side side = Side::left;
  bool is_top = true;                // EYEBROW_?_U_VERT_LIMIT; else EYEBROW_?_D_VERT_LIMIT
  std::size_t point = 0;             // in kBrowPointWords
  double asked_up = 0, held_up = 0;  // brow.up
};

// The control points under the left brow, and what they are called.
inline constexpr std::array<const char*, BrowBox::kPoints> kBrowPoints{"E5_2", "E5_3", "E5_4", "E5_5",
                                                                       "E5_6"};
inline constexpr std::array<std::string_view, BrowBox::kPoints> kBrowPointWords{
    "inner end", "inner half", "peak", "outer half", "outer end"};

// Makes a face follow the thesis, whose fields have been solved. A brow turns about its end: up about the
// outer one, down about the inner one, by the angle between its ends that the data's own turn has. A shut lid
// ends where the lower one rests. The eyeballs' limits are where the pupil's edge meets the lids' outline at
// rest, no further than eyes turn. The lips and the chin stop at one level.
void follow_thesis(const NeutralHead& head, Face& face);

// The skin at the corners of both eyes, in the order of Face::eye_corners.
std::vector<glm::dvec3> find_eye_corners(const Face& face, const std::vector<glm::dvec3>& points);

// Takes the skin there back to where it was before the lids turned.
void keep_eye_corners(const Face& face, const std::vector<glm::dvec3>& before,
                      std::vector<glm::dvec3>& points);

// The rectangles of this head's brows, with its limits: the top is that of the highest point where a brow
// goes up as far as it may, the bottom that of the lowest where it goes down. Left and right.
std::vector<BrowBox> build_brow_boxes(const NeutralHead& head, const Face& face, const LimitShares& limits);

// The pose with each brow in its rectangle, whatever turns it: as far as its highest point stands above the
// top the brow goes less up, as far as its lowest stands below the bottom less down. What was held is
// appended to `holds`, if one is given. Without rectangles it is the pose.
Pose hold_brows(const Face& face, const Pose& pose, std::vector<BrowHold>* holds = nullptr);

// What the rectangles hold of a pose as an author writes it, with this head's limits.
std::vector<BrowHold> find_brow_holds(const Face& face, const LimitShares& limits, const Pose& pose);

// "brow.left.up is 1; its inner end reaches EYEBROW_R_U_VERT_LIMIT, and it goes to 0.42".
std::string describe_hold(const BrowHold& hold);

// The pose with the chin no further up than brings the lower lip's middle to the match level. Without a level
// it is the pose.
Pose hold_chin(const NeutralHead& head, const Face& face, const Pose& pose);

// Where the lips of a column stop: y in mm of the upper one's lowest and the lower one's highest place, and
// of the level, where they meet if both go past it.
struct LipStop {
  double upper_mm = 0, lower_mm = 0, level_mm = 0;
};

// Of each of Face::lips, carried by whatever moves the mouth as a whole: corners, cheeks and nose. Empty
// without a level.
std::vector<LipStop> compute_lip_stops(const NeutralHead& head, const Face& face, const Pose& pose);

}  // namespace mien
