// What a wrap is worth: how far the wrapped face lies from the scan, how much of it the scan shows, and
// whether the two look the same way.
#pragma once

#include "head/placed_scan.hpp"
#include "head/scan.hpp"

namespace mien {

// A wrap just before its eyes and lips are finished, on the adult's size.
struct WrapView {
  const HeadStock& stock;
  const Scan& scan;
  const PlacedScan& placed;
  const std::vector<std::uint32_t>& vertices;        // of the left half's and the middle's plain skin
  const std::vector<glm::vec3>&positions, &normals;  // of the wrapped skin
  const std::vector<glm::dvec3>& points;             // of the wrapped cage
  const std::vector<glm::dvec3>& marks;              // where the placed scan has its landmarks
};

// Of the face's places, each seen from both sides.
struct WrapWorth {
  double covered = 0;   // share that has the scan near it, on either side
  double rms_mm = 0;    // how far it lies from the scan, of those
  double off = 0;       // share of those that lie further than kOff_mm
  double agreeing = 0;  // share of those that look the way the scan looks there
  double stray_points =
      0;               // share of the scan's points about the face that lie further than kStray_mm off it
  int folded = 0;      // triangles of the face that are turned over
  double mark_mm = 0;  // how far the worst landmark lies from its place
  std::size_t worst_mark = 0;
};
inline constexpr double kOff_mm = 3, kStray_mm = 5;

WrapWorth measure_wrap(const WrapView& wrap);

// What is to be said of it, for the scan as a whole or at a landmark: nothing, warnings, or one mistake if
// the scan is no face.
std::vector<Diagnostic> judge_wrap(const Scan& scan, const WrapWorth& worth);

}  // namespace mien
