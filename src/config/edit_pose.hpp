// A pose as an author would write it: with as few areas as make it.
#pragma once

#include <string>

#include "config/expressions.hpp"

namespace mien {

struct Language;

// What a key, or an expression, has to say of its pose.
struct PoseWords {
  bool keeps_express = false;  // its own, with all that goes with it
  std::string exaggerate;      // empty: as it is
  std::string areas;           // "brows: {up: 0.5}, lips: {press: 0.2}"; empty: none
};

// What names of expressions mean in a file, and how far its areas go. What is wrong with it is not told.
ExpressionBook load_book(const YamlValue& root, const Language& language);

// `key` is one that stands there, whose `express` stays if fewer areas beside it make the pose than without;
// or nothing. To a thousandth of a limit, and held where no face can go.
PoseWords find_pose_words(const YamlMapping& key, const ExpressionBook& book, const Pose& pose);

}  // namespace mien
