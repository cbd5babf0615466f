// The cheek's outline on the far side of a face that smiles.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "config/config_fixture.hpp"
#include "core/conventions.hpp"
#include "frames/figure.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

constexpr double kTop_mm = -2, kStep_mm = -1;  // from the eye's height on down
constexpr int kSteps = 72;

// How far out the skin of the left half reaches at each height, seen from so many degrees to the right.
std::vector<double> trace_outline(const Mesh& skin, const std::vector<glm::vec3>& positions,
                                  double from_deg) {
  constexpr float kLeft_mm = 18;
  const double turn = from_deg * kRadiansPerDegree;
  const auto compute_out = [&](const glm::vec3& p) { return p.x * std::cos(turn) + p.z * std::sin(turn); };
  std::vector<double> outline(kSteps, -1e9);
  for (const Triangle& t : skin.triangles)
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 &a = positions[t[k]], &b = positions[t[(k + 1) % 3]];
      if (a.x < kLeft_mm || a.y < b.y) continue;  // the neighbour has the edge the other way round
      const int first = std::max(0, static_cast<int>(std::ceil((a.y - kTop_mm) / kStep_mm)));
      for (int i = first; i < kSteps && kTop_mm + i * kStep_mm >= b.y; ++i) {
        const double share = (a.y - (kTop_mm + i * kStep_mm)) / std::max(1e-6f, a.y - b.y);
        outline[i] = std::max(outline[i], std::lerp(compute_out(a), compute_out(b), share));
      }
    }
  return outline;
}

// How deep its deepest hollow is.
double measure_notch_mm(const std::vector<double>& outline) {
  double deepest = 0;
  const auto count = static_cast<int>(outline.size());
  for (int i = 0; i < count; ++i)
    for (int j = i + 2; j < count; ++j)
      for (int k = i + 1; k < j; ++k)
        deepest = std::max(
            deepest, std::lerp(outline[i], outline[j], static_cast<double>(k - i) / (j - i)) - outline[k]);
  return deepest;
}

TEST(cheek, of_a_smile_ends_in_no_step_below_the_lid) {
  constexpr double kFrom_deg = 35, kMost_mm = 1, kFuller_mm = 2;
  const Figure figure = build_figure(shipped().heads, HeadSpec{});
  const Spec spec = load_text("mien: 1\n");
  const auto trace = [&](const Pose& pose) {
    DeformBuffers buffers;
    Drawing drawing;
    deform_figure(figure, pose, TurnKey{}, buffers, drawing);
    return trace_outline(figure.head.skin, drawing.parts[0].positions, kFrom_deg);
  };
  const std::vector<double> rest = trace(Pose{});
  for (const char* name : {"smile", "laugh", "emfacs/joy"}) {
    const std::vector<double> outline = trace(find_expression(spec, name).pose);
    EXPECT_LT(measure_notch_mm(outline), kMost_mm) << name;
    EXPECT_GT(*std::max_element(outline.begin(), outline.end()),
              *std::max_element(rest.begin(), rest.end()) + kFuller_mm)
        << name;
  }
}

}  // namespace
}  // namespace mien
