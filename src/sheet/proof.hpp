// What the thesis shows in chapter 6 (Yen, "Animation of Human Faces", Tamkang University, 1990, figures 6-1
// to 6-14), made anew and measured: each figure with its claim and a verdict that is computed.
#pragma once

#include <string>
#include <vector>

#include "frames/resources.hpp"

namespace mien {

struct ProofPicture {
  std::string caption;
  std::string png;
};

struct Proof {
  std::string number, title;  // "6-1", "The square head"
  std::string claim;          // what the figure is to show
  std::string verdict;        // what was measured
  bool is_met = false;
  std::vector<ProofPicture> pictures;
};

// 6-1 to 6-4: a skull's drawn outline, as templates/head/heads.yaml has it against the average's, over the
// mesh. Met if the mesh is within `kOutline_units` of it everywhere, and not within that of the average.
Proof prove_skull(const Resources& resources, const std::string& number, const std::string& skull, int jobs);
inline constexpr double kOutline_units = 0.06;  // of a head 3.5 units high: a pencil line's width on paper

// 6-5 and 6-6: a head on the guide lines of its age's chart. Met if all lines lie within `kGuide_units`.
Proof prove_guides(const Resources& resources, const std::string& number, const std::string& age, int jobs);
inline constexpr double kGuide_units = 0.03;

// What the thesis tells of below 6-6: one age becomes another. Met if the head only grows and no step of the
// way is more than twice the mean one.
Proof prove_growth(const Resources& resources);

// 6-7 to 6-13: expressions of the library tezuka. Met if each uses the areas of the thesis's section 4.2 and
// no other, and is symmetric if the thesis's is.
Proof prove_expressions(const Resources& resources, const std::string& number, const std::string& title,
                        const std::vector<std::string>& names, int jobs);

// 6-14: a clip as stills. Met if each key's face is hit at its frame and the skin goes from one face to the
// next without a jump.
Proof prove_clip(const Resources& resources);

// A page of its own: pictures and style are inside. Titles and verdicts may hold any letters.
std::string build_proof_page(const std::vector<Proof>& proofs);

}  // namespace mien
