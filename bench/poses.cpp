#include "poses.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace mien {

void print_sweep_table(const SweepTable& table, const std::vector<SweepHead>& heads,
                       const std::function<Pose(unsigned)>& build_pose) {
  for (std::size_t check = 0; check < kPoseCheckCount; ++check) {
    const SweepWorst& worst = table[check];
    const PoseCheck& info = kPoseChecks[check];
    fmt::print("{:<28} {:>8.3f} {:<9}  {} poses past {:g}", info.name, worst.finding.value, info.unit,
               worst.count, info.bound);
    if (worst.seed > 0)
      fmt::print("; {}, pose {} at {}: {}", heads[worst.head].name, worst.seed, worst.place,
                 describe_pose(build_pose(worst.seed)));
    fmt::print("\n");
  }
}

void measure_poses() {
  constexpr SweepSize kSize{500, 100};
  const std::vector<SweepHead> all = list_sweep_heads();
  const std::vector<std::size_t> heads = list_sweep_indices(false);
  const std::array<SweepTable, 2> tables = run_sweep(heads, 1, kSize);
  for (const bool is_exaggerated : {false, true}) {
    fmt::print("\nposes {}: {} on each of {} heads\n", is_exaggerated ? "exaggerated" : "within the limits",
               is_exaggerated ? kSize.exaggerated : kSize.within, heads.size());
    print_sweep_table(tables[is_exaggerated ? 1 : 0], all,
                      [&](unsigned seed) { return build_sweep_pose(seed, is_exaggerated); });
  }
  constexpr unsigned kSpoken = 2000;
  fmt::print("\nposes of speech: {} on each of {} heads\n", kSpoken, list_speech_heads().size());
  print_sweep_table(run_speech_sweep(1, kSpoken), list_speech_heads(), build_speech_pose);
  std::fflush(stdout);
}

}  // namespace mien
