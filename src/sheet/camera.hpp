// How a sheet's cells see their heads: the camera that a framing asks for, and Loomis' lines in its picture.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "frames/figure.hpp"
#include "scene/povray.hpp"
#include "sheet/plans.hpp"

namespace mien {

// Where a head's landmarks are in some pose, mm; and the cage's points on the skin, by their names.
using PlacesOfPose = std::map<std::string, glm::dvec3>;
using FigurePlaces = std::function<PlacesOfPose(const Pose& pose)>;

FigurePlaces build_places(const Figure& figure);

// What framing and captions need to know of a head, mm.
struct HeadMeasures {
  PlacesOfPose landmarks;                              // at rest
  std::vector<std::pair<std::string, double>> guides;  // heights from chin to crown, both included
  Box head;                                            // of the skin above the chin
  std::vector<Limit> limits;                           // of its areas
  double above_mm = 0;  // how much higher a drawn head gets, with its hair; 0 of a real one

  double chin_mm() const { return guides.front().second; }
  double height_mm() const { return guides.back().second - guides.front().second; }
};

HeadMeasures measure_head(const Figure& figure);

// Level, of length 1.
glm::vec3 compute_toward_camera(const CameraView& view);

// `scale` is the head that `cell.framing.scale_of` names.
CameraView compute_cell_view(const SheetCell& cell, const HeadMeasures& own, const HeadMeasures& scale);

// How thick a line is drawn in a picture `height_px` high that holds `tall_mm`: this share of its height, but
// not so thin that it breaks up.
double compute_line_radius_mm(double share, double tall_mm, int height_px);

// Andrew Loomis, "Drawing the Head and Hands" (1956): the guide lines as contours on the skin, drawn on to
// the picture's edges and named there; the middle line; the frame 3 (from the side 3.5) units wide and 3.5
// high. `size_px`: of the picture.
Overlay build_guides(const HeadMeasures& head, const Mesh& skin, const CameraView& view,
                     std::pair<int, int> size_px, bool has_frame);

}  // namespace mien
