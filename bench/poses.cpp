#include "poses.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "frames/pose_sweep.hpp"

namespace mien {

void measure_poses() {
  constexpr SweepSize kSize{500, 100};
  const std::vector<SweepHead> all = list_sweep_heads();
  const std::vector<std::size_t> heads = list_sweep_indices(false);
  const std::array<SweepTable, 2> tables = run_sweep(heads, 1, kSize);
  for (const bool is_exaggerated : {false, true}) {
    fmt::print("\nposes {}: {} on each of {} heads\n", is_exaggerated ? "exaggerated" : "within the limits",
               is_exaggerated ? kSize.exaggerated : kSize.within, heads.size());
    for (std::size_t check = 0; check < kPoseCheckCount; ++check) {
      const SweepWorst& worst = tables[is_exaggerated ? 1 : 0][check];
      const PoseCheck& info = kPoseChecks[check];
      fmt::print("{:<28} {:>8.3f} {:<9}  {} poses past {:g}", info.name, worst.finding.value, info.unit,
                 worst.count, info.bound);
      if (worst.seed > 0)
        fmt::print("; {}, pose {} at {}: {}", all[worst.head].name, worst.seed, worst.place,
                   describe_pose(build_sweep_pose(worst.seed, is_exaggerated)));
      fmt::print("\n");
    }
  }
  std::fflush(stdout);
}

}  // namespace mien
