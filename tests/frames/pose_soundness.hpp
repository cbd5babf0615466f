// What is measured on a posed head to say that its face is sound: on the skin and the parts as they are
// drawn, never on what the model meant to do. Tests and ./run bench share it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "config/part_numbers.hpp"
#include "frames/figure.hpp"
#include "head/contact.hpp"

namespace mien {

// Each check with the most that is allowed within the limits, and what it is measured in.
struct PoseCheck {
  const char* name;
  const char* unit;
  double bound;
};

inline constexpr std::array kPoseChecks{
    PoseCheck{"not finite", "numbers", 0},
    PoseCheck{"turned over", "triangles", 0},       // of the visible skin, the local turn apart
    PoseCheck{"lid in the ball", "mm", 0.1},        // the skin of the lids, from the margin outward
    PoseCheck{"lid in the cornea", "mm", 0.1},      // wherever it looks
    PoseCheck{"gap of a shut eye", "mm", 0.3},      // from the upper margin to the lower one, in space
    PoseCheck{"upper lid below lower", "mm", 0.1},  // across the opening
    PoseCheck{"lips crossed", "mm", 0.2},           // height of one in the other
    PoseCheck{"upper teeth through", "mm", 0},      // the skin outside the mouth, along its normal
    PoseCheck{"lower teeth through", "mm", 0},      //
    PoseCheck{"tongue through", "mm", 0},           //
    PoseCheck{"brow off the skin", "mm", 1},        // any point of any hair
};
inline constexpr std::size_t kPoseCheckCount = kPoseChecks.size();

struct Finding {
  double value = 0;
  std::uint32_t vertex = 0;  // of the skin, near the place
};
using PoseFindings = std::array<Finding, kPoseCheckCount>;

// A rim of a left lid as the skin has it: its vertices in the order of their columns.
struct LidLine {
  std::vector<std::uint32_t> upper, lower;  // both from the inner to the outer corner
};

// A hair's vertex and the place of the neutral skin below it.
struct HairProbe {
  std::size_t part = 0;
  std::uint32_t vertex = 0, triangle = 0;
  glm::vec3 barycentric{0};
};

// What of one head is looked at; built once. The figure must outlive it.
struct PoseProbe {
  const Figure* figure = nullptr;
  EyeNumbers eye;
  std::vector<std::array<std::uint32_t, 25>> patches;  // vertices of each quad of the cage
  std::vector<std::vector<Triangle>> patch_triangles;  // visible ones
  std::vector<std::uint32_t> lid_skin;                 // left; the right ones are their mirror images
  std::array<LidLine, 2> rims;                         // the margin's inner and outer edge
  std::array<std::vector<Triangle>, 2> lips;           // upper, lower: the red, both sides
  std::vector<Triangle> outside;                       // of the mouth: lips, cheeks, chin
  std::array<std::vector<std::size_t>, 3> bites;       // parts: upper teeth, lower teeth, tongue
  std::vector<HairProbe> hairs;                        // of the brows
};

PoseProbe build_pose_probe(const Figure& figure);

// The worst of each check in one pose.
PoseFindings measure_pose(const PoseProbe& probe, const Pose& pose, DeformBuffers& buffers, Drawing& drawing);

}  // namespace mien
