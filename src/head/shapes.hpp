// Ages, skulls and character: the adult cage made into another head, by the tables of
// templates/head/heads.yaml.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "config/head_spec.hpp"
#include "config/shape_data.hpp"
#include "head/fields.hpp"
#include "head/guides.hpp"
#include "head/head.hpp"

namespace mien {

// The cage and the eye under a warp: the eye's rings and lids follow the ball as a similarity.
HeadForm apply_warp(const Cage& cage, const Eye& eye, const Warp& warp);

// Makes `form`, the adult or a head that stands for it, into the head of `spec`: ages mixed, each with its
// guide lines as far from the adult's as its chart says, then skulls, character and features added at the
// head's size, then guide lines moved. `adult` is the shipped one. Throws InputError if moved guide lines
// cross.
void shape_head(const HeadShapes& shapes, const HeadSpec& spec, const Cage& adult, HeadForm& form);

// Forms are mixed as sums: from nothing, each addition with its weight.
HeadForm make_empty_form(const Cage& cage);
void add_form(HeadForm& sum, const HeadForm& addition, double weight);

// Fuller lips part and thinner ones bare the teeth: brings the two to the contact they have on `adult`,
// column by column, at the form's size against it. What one lip moves its rings share, so the borders hardly
// know.
void close_lips(const Cage& adult, double size, HeadForm& form);

// The guide lines of a head made by `spec` without its own guides.
GuideLines compute_guides(const HeadShapes& shapes, const HeadSpec& spec, const Cage& adult, const Eye& eye);

// Where the guide lines stand on a head as it was built, mm: chin, mouth_line, nose_base, eye_line,
// brow_line, hairline and crown (the skin's highest place), upward.
std::vector<std::pair<std::string, double>> measure_guide_heights(const NeutralHead& head);

}  // namespace mien
