// What one head's face can do: the nine areas' moves solved as fields on its cage, lids and jaw as rotations.
//
// A pose is rest + sum of value x field, a few correctives driven by products of values, then the lids turned
// about the eyes' centres, then the jaw about its axis, then lips kept from crossing. No value can tear the
// skin.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "config/areas.hpp"
#include "face/lid_rig.hpp"
#include "face/paling.hpp"
#include "head/fields.hpp"
#include "head/head.hpp"
#include "head/least_squares.hpp"
#include "head/lip_sheet.hpp"

namespace mien {

// Face units make one performance read the same on every head (the idea of MPEG-4's FAPU). Millimetres.
struct FaceUnits {
  double eye_separation = 63.0;  // between the eyes' centres
  double eye_nose = 47.8;        // eye centre to the base of the nose
  double mouth_nose = 21.5;      // base of the nose to the lips' contact
  double mouth_width = 48.6;     // between the mouth corners
  double iris = 12.4;            // diameter
};

// A value of a pose, positive or negative part.
struct SignedMove {
  std::size_t move = 0;  // in kMoves
  int sign = 1;
};

// What else moves the skin of a field, on one side or on both alike, and the share that the field then lacks.
struct Yield {
  std::vector<SignedMove> to;  // one or two
  double share = 0;
};

// A field and what drives it: the product of some signed values, each only where positive. A sided one has a
// mirror image with drivers of its own side; the two are added to each other before anything else, so that
// mirrored poses give mirrored sums to the last bit.
struct DrivenField {
  std::vector<SignedMove> drivers;
  Field field;
  std::vector<SignedMove> mirror_drivers;  // empty: no mirror image
  Field mirror_field;
  bool is_late = false;  // the jaw's slides: after it has turned
  std::vector<Yield> yields, mirror_yields;
};

struct JawRig {
  glm::dvec3 axis{0};      // a point of the axis, which is parallel to x
  double open_rad = 0;     // at chin.down 1
  glm::dvec3 forward{0};   // mm at chin.down 1
  double straight_mm = 0;  // straight down at chin.straight 1
  // At jaw.side, jaw.forward and lips.roll_lower 1: of teeth and tongue, the skin has its fields.
  glm::dvec3 aside{0}, protruded{0}, rolled{0};
  std::vector<double> weights;  // of each control point
  std::vector<double> shut;     // and what it lacks of that at lips.shut 1
};

struct LipColumn {
  std::vector<std::pair<std::uint32_t, double>> upper, lower;  // control points of the rings and their shares
  std::uint32_t upper_contact = 0, lower_contact = 0;
  double rest_gap_mm = 0;
  std::array<std::uint32_t, 3> upper_edge{},
      lower_edge{};                       // the contact with the points before and behind it
  std::uint32_t inward = 0, outward = 0;  // the upper lip's contact in the next columns
  double rest_skin_gap_mm = 0, rest_leaning_gap_mm = 0;
};

// The upper lip's skin above the lower's, where both come out of the mouth.
double compute_skin_gap_mm(const LipColumn& column, const std::vector<glm::dvec3>& points);

// What is added to it above one place, because the lower lip's point lies aside of the upper's on a line that
// is not level.
double compute_lean_mm(const LipColumn& column, const std::vector<glm::dvec3>& points);

// A column of the upper lip under the base of the nose.
struct PhiltrumColumn {
  std::uint32_t nose = 0;
  std::vector<std::pair<std::uint32_t, double>> rows;  // control points and their shares of a push; the first
                                                       // is the one that may not pass the nose
  double rest_gap_mm = 0;
};

// Points of the skin in a row, away from the one that holds still. What is pushed toward the one before it
// stops there ever more and bulges.
struct GiveWayLine {
  std::vector<std::uint32_t> points;
  std::vector<glm::dvec3> ways;  // from each to the next at rest, of length 1
  std::vector<double> rest_mm;
};

struct GiveWay {
  double from = 0.5, least = 0.25, forward = 0;  // shares of the room at rest; mm forward for each that lacks
  std::vector<GiveWayLine> lines;
};

// The rectangle of one brow, and how high its points are on the skin. Heights are y in mm.
struct BrowBox {
  static constexpr std::size_t kPoints = 5;  // from the inner end to the outer one
  using Heights = std::array<double, kPoints>;
  Heights rest_mm{};
  std::vector<Heights> rises_mm, mirror_rises_mm;  // by each of Face::fields and its mirror image at 1
  double top_mm = 0, bottom_mm = 0;
  double highest = 1, lowest = -1;  // brow.up there
};
class DoctrineFields;  // face/doctrine.hpp

// A corner of an eye on the skin, and the control points of the lids' rings there, which have this share of
// it.
struct EyeCorner {
  LinearRow row;
  std::vector<std::uint32_t> points;
  double share = 1;
};

struct Face {
  FaceUnits units;
  std::vector<DrivenField> fields;  // of the moves, one driver each, then correctives
  LidRig lids;
  std::array<double, kMoveCount> plus_reach{}, minus_reach{};  // how far a value of 2 or -2 goes: at most 2
  double eye_up_rad = 0, eye_down_rad = 0, eye_side_rad = 0;
  JawRig jaw;
  std::vector<LipColumn> lips;
  std::vector<PhiltrumColumn> philtrum;
  GiveWay give_way;
  LipSheet upper_lip, lower_lip;
  RedBorder red_border;
  double seal_until_mm = 4;
  double tongue_out_mm = 34, tongue_up_mm = 20;  // of its tip at its limits
  bool follows_thesis = false;
  std::vector<EyeCorner> eye_corners;    // of both eyes, by `rules: thesis`; else none
  std::vector<BrowBox> brow_boxes;       // left and right, by `rules: thesis`; else none
  std::optional<double> match_level_mm;  // LIPS_MATCH_LEVEL above where the lips meet at rest
  glm::dvec3 turn_pivot{0};
  std::vector<double> turn_weights;           // of each control point
  std::shared_ptr<DoctrineFields> doctrines;  // of muscles and units; made when a pose moves one
};

// How much further than a real head's a move of an area goes, by the head's design.
double get_gain(const DesignNumbers& design, std::string_view area, std::string_view move, int sign);

FaceUnits measure_face(const Cage& cage, const std::vector<glm::dvec3>& points, const Eye& eye);

// Solves templates/head/areas.yaml for this head. About 0.1 s. Throws RunError for data that cannot be
// solved.
Face build_face(const NeutralHead& head);

// What a move of the left side drags of the middle ends on the right before the far corner of the mouth and
// the far eye: smoothly, and then it is nothing to the last bit.
void fade_far_side(const Cage& cage, Field& field);

// The fields of muscles and of units, where the pose has any of them.
std::vector<const std::vector<DrivenField>*> list_doctrine_fields(const NeutralHead& head, const Face& face,
                                                                  const Pose& pose);

// What a field is multiplied by in a pose: the product of its drivers, less what yields take of it.
double compute_drive(const std::vector<SignedMove>& drivers, const std::vector<Yield>& yields,
                     const Pose& pose);

// Where the jaw takes a point of the head at these shares of its turn and of its way straight down.
glm::dvec3 move_jaw_point(const JawRig& jaw, const glm::dvec3& point, double turned, double straight);

// How much of lips.shut is left beside what else pushes the lips together.
double compute_shut(const Pose& pose);

// How much of the jaw's way a control point goes: its weight, less what lips hold back that stay shut (see
// compute_shut).
double compute_jaw_share(const JawRig& jaw, std::size_t point, double shut);

// How much of chin.straight a pose has: what chin.down leaves of the chin's one limit.
double compute_straight(const Pose& pose);

// What a pose's values come to where `exaggerate` or `head.limits` lift them past their limits: skin that is
// stretched or pressed together gets stiff. Within the limits it is the pose itself.
Pose stiffen_pose(const Face& face, const Pose& pose);

// The cage of `head` in `pose`, into `points` (resized): mm, before the head is turned. What muscles and
// units do by moves of the areas stands in the pose already (resolve_channels, config/doctrine_data.hpp). The
// neutral pose gives the neutral cage bit for bit. Values past their limits are stiffened.
void pose_cage(const NeutralHead& head, const Face& face, const Pose& pose, std::vector<glm::dvec3>& points);

// The same before lips are kept from crossing: what fields, lids and jaw alone come to. A doctrine that knows
// of no contact is measured by it.
void pose_cage_bare(const NeutralHead& head, const Face& face, const Pose& pose,
                    std::vector<glm::dvec3>& points);

// Where an eyeball looks: a rotation about its centre.
glm::dmat3 compute_gaze(const Face& face, const Pose& pose, Side side);

// The jaw bone's motion for the parts that sit in it: world from rest.
glm::dmat4 compute_jaw(const Face& face, const Pose& pose);

}  // namespace mien
