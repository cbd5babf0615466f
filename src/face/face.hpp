// What one head's face can do: the nine areas' moves solved as fields on its cage, lids and jaw as rotations.
//
// A pose is rest + sum of value x field, a few correctives driven by products of values, then the lids turned
// about the eyes' centres, then the jaw about its axis, then lips kept from crossing. No value can tear the
// skin.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "config/areas.hpp"
#include "head/fields.hpp"
#include "head/head.hpp"

namespace mien {

// Face units make one performance read the same on every head (the idea of MPEG-4's FAPU). Millimetres.
struct FaceUnits {
  double eye_separation = 63.0;  // between the eyes' centres
  double eye_nose = 47.8;        // eye centre to the base of the nose
  double mouth_nose = 21.5;      // base of the nose to the lips' contact
  double mouth_width = 48.6;     // between the mouth corners
  double iris = 12.4;            // diameter
};

// One way of one move, solved. `value` of the pose times `sign`, where positive, times `field`.
struct MoveField {
  std::size_t move = 0;  // in kMoves
  int sign = 1;
  Field field;
};

// A field driven by the product of several signed values, each only where positive.
struct CorrectiveField {
  std::vector<std::pair<std::size_t, int>> drivers;  // (move, sign)
  Field field;
};

// One ring of an eye's lids: the control points of its 16 columns (0 inner corner, 1..7 upper, 8 outer, 9..15
// lower).
struct LidRing {
  std::array<std::uint32_t, 16> points{};
  double upper_share = 0, lower_share = 0;  // of the lid's angle
  double least_radius_mm = 0;               // from the eye's centre; 0: free
  glm::dvec3 bulge{0};                      // mm, of a lower lid fully raised
};

// Both eyes; the right one is worked in the left one's mirror.
struct LidRig {
  std::array<std::vector<LidRing>, 2> rings;                 // left, right
  glm::dvec3 centre{0};                                      // left eye, mm
  glm::dvec3 axis{1, 0, 0};                                  // left eye, from the inner to the outer corner
  std::array<double, 9> upper_rest_rad{}, lower_rest_rad{};  // margin's height above the axis by column 0..8
  std::array<double, 9> upper_along_mm{}, lower_along_mm{};  // and how far out along the axis, ascending
  std::array<double, 9> taper{};
  double meeting = 0, least_gap_rad = 0, wide_rad = 0, raised_rad = 0;
  double follow_up = 0, follow_down = 0, follow_lower = 0;
};

struct JawRig {
  glm::dvec3 axis{0};           // a point of the axis, which is parallel to x
  double open_rad = 0;          // at chin.down 1
  glm::dvec3 forward{0};        // mm at chin.down 1
  std::vector<double> weights;  // of each control point
};

struct LipColumn {
  std::vector<std::pair<std::uint32_t, double>> upper, lower;  // control points of the rings and their shares
  std::uint32_t upper_contact = 0, lower_contact = 0;
  double rest_gap_mm = 0;
};

struct Face {
  FaceUnits units;
  std::vector<MoveField> moves;
  std::vector<CorrectiveField> correctives;
  LidRig lids;
  double eye_up_rad = 0, eye_down_rad = 0, eye_side_rad = 0;
  JawRig jaw;
  std::vector<LipColumn> lips;
  double seal_until_mm = 4;
  glm::dvec3 turn_pivot{0};
  std::vector<double> turn_weights;  // of each control point
};

FaceUnits measure_face(const Cage& cage, const std::vector<glm::dvec3>& points, const Eye& eye);

// Solves `file` (templates/head/areas.yaml) for this head. About 0.1 s. Throws RunError for broken data.
Face build_face(const NeutralHead& head, const std::filesystem::path& file);

// The cage of `head` in `pose`, into `points` (resized): mm, before the head is turned. The neutral pose
// gives the neutral cage bit for bit. Values outside their range are taken as they are: clamp first.
void pose_cage(const NeutralHead& head, const Face& face, const Pose& pose, std::vector<glm::dvec3>& points);

// Where an eyeball looks: a rotation about its centre.
glm::dmat3 find_gaze(const Face& face, const Pose& pose, Side side);

// The jaw bone's motion for the parts that sit in it: world from rest.
glm::dmat4 find_jaw(const Face& face, const Pose& pose);

}  // namespace mien
