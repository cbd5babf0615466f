#include "sheet/limit_lines.hpp"

#include <algorithm>

#include "sheet/camera.hpp"
#include "sheet/plan_kinds.hpp"

namespace mien {

namespace {

using MarkPlaces = std::vector<glm::dvec3>;

constexpr double kBefore_mm = 1;  // of the skin that a rectangle is about: nearer, and brows lie over it

MarkPlaces find_places_of(const SheetMark& mark, const PlacesOfPose& all) {
  MarkPlaces places;
  for (const std::string& name : mark.places)
    if (const auto found = all.find(name); found != all.end()) places.push_back(found->second);
  return places;
}

// In the plane of the face, around the places in all poses.
MarkPlaces build_box(const std::vector<MarkPlaces>& poses) {
  glm::dvec3 low = poses.front().front(), high = low;
  for (const MarkPlaces& places : poses)
    for (const glm::dvec3& place : places) low = glm::min(low, place), high = glm::max(high, place);
  const double z = high.z + kBefore_mm;
  return {{low.x, low.y, z}, {high.x, low.y, z}, {high.x, high.y, z}, {low.x, high.y, z}, {low.x, low.y, z}};
}

}  // namespace

void append_limit_lines(const Figure& figure, const glm::dmat4& world, WireModel& model) {
  const FigurePlaces find = build_places(figure);
  const glm::mat4 turn(world);
  for (const SheetMark& mark : list_limit_marks()) {
    std::vector<MarkPlaces> poses;
    for (const Pose& pose : mark.poses) poses.push_back(find_places_of(mark, find(pose)));
    if (poses.front().empty()) continue;
    WireLine line{{}, Pen::limit, true};
    for (const glm::dvec3& p : mark.shape == MarkShape::box ? build_box(poses) : poses.front())
      line.points.emplace_back(turn * glm::vec4(glm::vec3(p), 1));
    if (line.points.size() > 1) model.lines.push_back(std::move(line));
  }
}

}  // namespace mien
