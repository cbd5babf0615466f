#include "doctrines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "config/load_spec.hpp"
#include "core/data.hpp"
#include "frames/pose_sweep.hpp"
#include "frames/skin_motion.hpp"
#include "poses.hpp"
#include "shipped.hpp"

namespace mien {

namespace {

double read_core_s() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

double measure_frame_ms(const Figure& figure, const Pose& pose) {
  constexpr int kTimes = 200;
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(figure, pose, {}, buffers, drawing);
  const double start_s = read_core_s();
  for (int i = 0; i < kTimes; ++i) deform_figure(figure, pose, {}, buffers, drawing);
  return 1000 * (read_core_s() - start_s) / kTimes;
}

// How much deeper than at rest the one lip lies in the other in the worst column, if nothing keeps them
// apart.
double measure_bare_crossing_mm(const Figure& figure, const Pose& pose) {
  std::vector<glm::dvec3> points;
  pose_cage_bare(figure.head, figure.face, limit_pose(figure, pose), points);
  double worst_mm = 0;
  for (const LipColumn& column : figure.face.lips)
    worst_mm = std::max(worst_mm, column.rest_skin_gap_mm - compute_skin_gap_mm(column, points));
  return worst_mm;
}

void print_feelings(const HeadSpec& head) {
  const Figure figure = build_figure(shipped().heads, head);
  Spec spec;
  spec.expressions = shipped().stock.language->libraries.expressions;
  for (const char* feeling : {"smile", "anger", "surprise", "fear", "sadness", "disgust"}) {
    const SkinMotion ours =
        measure_motion(figure, find_expression(spec, "mien/" + std::string(feeling)).pose);
    for (const char* library : {"mien", "muscles", "candide", "parke"}) {
      const Expression& expression = find_expression(spec, fmt::format("{}/{}", library, feeling));
      const SkinMotion motion = measure_motion(figure, expression.pose);
      fmt::print("{:<9} {:<8} {:>2} numbers ", feeling, library, expression.numbers);
      for (std::size_t i = 0; i < kSkinRegions.size(); ++i)
        fmt::print(" {} {:.1f}", kSkinRegions[i], motion.mean_mm[i]);
      fmt::print("  as areas {:.2f}  lips cross {:.1f} mm bare  {:.2f} ms\n", compute_likeness(motion, ours),
                 measure_bare_crossing_mm(figure, expression.pose),
                 measure_frame_ms(figure, expression.pose));
    }
  }
}

void print_sweep(std::string_view doctrine) {
  constexpr unsigned kPoses = 600;
  const std::vector<SweepHead> heads = list_doctrine_heads();
  const SweepTable table = run_doctrine_sweep(doctrine, 1, kPoses);
  fmt::print("\nposes of {}: {} on each of {} heads\n", doctrine, kPoses, heads.size());
  print_sweep_table(table, heads, [&](unsigned seed) { return build_doctrine_pose(doctrine, seed); });
}

}  // namespace

void measure_doctrines() {
  print_feelings({});
  for (const std::string_view doctrine : {kMusclesKey, kCandideKey}) print_sweep(doctrine);
  std::fflush(stdout);
}

}  // namespace mien
