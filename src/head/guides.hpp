// Loomis' guide lines: where they lie on a head, and a head moved so that they lie where they are wanted.
// Source: Loomis, "Drawing the Head and Hands" (1956): the heights of the lines at each age are his charts.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "config/shape_data.hpp"
#include "head/head.hpp"

namespace mien {

inline constexpr double kAdultHairline = 5.0;  // at 0.857 of the shipped adult's height

// One head as what is summed and mixed: control points in the cage's order, the eye, and marks.
struct HeadForm {
  std::vector<glm::dvec3> points;  // mm
  Eye eye;
  double hairline = kAdultHairline;  // where it crosses the forehead's mid-line; see compute_hairline
  double brow_thickness = 1;         // width of the brows against the adult's
  double shortened_mm = 0;           // by a design: how much nearer to the eyes the chin has come
};

// The hairline is a mark on the skull, not a form of it: a place between two points of the mid-line, counted
// upward from the glabella (0: p_g ... 4: p_F4 ...), 5.3 being three tenths of the way from the sixth to the
// seventh.
struct HairlineMark {
  std::uint32_t below = 0, above = 0;  // points of the cage
  double share = 0;                    // of the one above
};
HairlineMark compute_hairline(const Cage& cage, double hairline);

// Chin (x) and crown (y) of a shape on the skin, mm.
glm::dvec2 find_height(const Cage& cage, const HeadForm& shape);

// Where all the lines lie on `shape`, measured on the skin at the landmarks tr, g, sn, sto, sa and sba; the
// eye line at the ball's centre. `cage` lends names and quads only.
GuideLines measure_guides(const Cage& cage, const HeadForm& shape);

// Moves `shape` so that the lines of `wanted` lie where they are wanted and all others stay; chin and crown
// stay. The whole head follows smoothly: heights by one monotone curve, the eye and its lids as a similarity,
// the ears as wholes. A line with a share goes only so much of its way. Throws InputError, naming the line,
// if lines meet.
void move_guides(const Cage& cage, const GuideLines& wanted, HeadForm& shape, const GuideLines& shares = {});

// The chart of a shape as it is.
GuideChart measure_chart(const Cage& cage, const HeadForm& shape);

// Makes `shape` as tall as the chart says and moves its lines onto the chart's, the eye staying at its
// height. The chart's hairline only moves the mark: the skull keeps its form.
void fit_chart(const Cage& cage, const GuideChart& chart, HeadForm& shape);

}  // namespace mien
