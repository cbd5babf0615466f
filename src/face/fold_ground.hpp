// What folds are pressed into: the adult's fine skin, and how high each set of folds is there. The same for
// every head, whatever its shape.
#pragma once

#include <array>
#include <vector>

#include "face/folds.hpp"

namespace mien {

// A vertex of the left half in whole folds of a set, at the adult's size.
struct FoldHeight {
  std::uint32_t vertex = 0;
  std::array<double, 2> mm{};  // there and at its mirror image
  double own = 0;              // what part of it belongs to the left side
};

struct FoldGround {
  FineSkin skin;
  std::vector<std::vector<FoldHeight>> sets;  // as FoldData has them; places without a height are left out
};

// Any head of a stock gives the same. Throws RunError for data that do not fit.
FoldGround build_fold_ground(const NeutralHead& head);

// The folds of a head whose stock has this ground.
Folds build_folds(const FoldGround& ground, const NeutralHead& head, const HeadSpec& spec);

}  // namespace mien
