// Many poses on many heads, and the worst of each check among them. Tests run a part, ./run bench the whole.
#pragma once

#include <string>
#include <vector>

#include "frames/pose_soundness.hpp"

namespace mien {

// Six ages times four skulls, and drawn heads of six ages; every other head has every feature somewhere in
// its range. What is measured on a drawn head are shares of its own eyes and mouth, as millimetres of the
// real head that it is drawn after, without the lens, which moves skin and parts alike.
struct SweepHead {
  std::string name;
  HeadSpec spec;
};
std::vector<SweepHead> list_sweep_heads();

// Those of real heads among them, or those of drawn ones, by their indices.
std::vector<std::size_t> list_sweep_indices(bool is_drawn);

// A pose within the limits: a third of them with a few areas, a third with some at their limits, a third with
// all anywhere. One eye in three is shut. Poses with `is_exaggerated` go up to twice as far, as `exaggerate`
// lets them.
Pose build_sweep_pose(unsigned seed, bool is_exaggerated);

// A face that speaks: one to three of the mouths of speech as they stand by each other, half of the time over
// a feeling that leaves its brows, lids and a third of its corners.
Pose build_speech_pose(unsigned seed);

// "brow.left.up 0.93, lips.press 0.6": the values over a half.
std::string describe_pose(const Pose& pose);

struct SweepWorst {
  Finding finding;
  std::size_t head = 0;   // in list_sweep_heads
  unsigned seed = 0;      // of the pose
  std::string place;      // the cage's nearest point
  std::size_t count = 0;  // poses past the bound
};
using SweepTable = std::array<SweepWorst, kPoseCheckCount>;

// How many poses a head, within the limits and past them.
struct SweepSize {
  unsigned within = 0, exaggerated = 0;
};

// Poses of the seeds from `first` on, on each of the heads named by their indices. Two tables: within the
// limits, exaggerated.
std::array<SweepTable, 2> run_sweep(const std::vector<std::size_t>& heads, unsigned first,
                                    const SweepSize& size);

// An adult, a child, and a digitised head.
std::vector<SweepHead> list_speech_heads();

// Speaking poses of the seeds from `first` on, on each of those.
SweepTable run_speech_sweep(unsigned first, unsigned count);

// A face of a doctrine's muscles or units alone ("muscles", "candide"): a third with a few, a third with some
// at their limits, a third with all anywhere.
Pose build_doctrine_pose(std::string_view doctrine, unsigned seed);

// Heads of four ages and a digitised one.
std::vector<SweepHead> list_doctrine_heads();

// Poses of a doctrine of the seeds from `first` on, on each of those.
SweepTable run_doctrine_sweep(std::string_view doctrine, unsigned first, unsigned count);

}  // namespace mien
