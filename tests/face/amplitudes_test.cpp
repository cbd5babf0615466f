// docs/amplitudes.md says how far the adult's face moves beside what was measured on people. Each of its rows
// is measured again here.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "config/config_fixture.hpp"
#include "core/text.hpp"
#include "frames/figure.hpp"
#include "head/landmarks.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const Figure& adult() {
  static const Figure figure = build_figure(shipped().heads, HeadSpec{});
  return figure;
}

std::string trim(const std::string& text) {
  const auto first = text.find_first_not_of(" `"), last = text.find_last_not_of(" `");
  return first == text.npos ? "" : text.substr(first, last - first + 1);
}

std::vector<std::string> split_cells(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, '|');) cells.push_back(trim(cell));
  if (!cells.empty()) cells.erase(cells.begin());
  return cells;
}

// Each landmark of the adult in a pose, and "incisor": the middle of the lower teeth's edge.
std::map<std::string, glm::dvec3> find_places(const Pose& pose) {
  static const std::vector<Landmark> landmarks = find_landmarks(adult().head);
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(adult(), pose, TurnKey{}, buffers, drawing);
  auto places = measure_landmarks(adult().head, landmarks, adult().model, drawing);
  for (std::size_t i = 0; i < adult().model.parts.size(); ++i) {
    const Part& part = adult().model.parts[i];
    if (part.name != "teeth_lower") continue;
    glm::vec3 edge(0, -1e9f, 0);
    for (const glm::vec3& p : part.rest.positions)
      if (std::abs(p.x) < 3 && p.y > edge.y) edge = p;
    places["incisor"] = glm::dvec3(drawing.parts[i].world_from_rest * glm::vec4(edge, 1));
  }
  return places;
}

double compute_way_mm(const glm::dvec3& from, const glm::dvec3& to, const std::string& way) {
  const glm::dvec3 moved = to - from;
  if (way == "up") return moved.y;
  if (way == "down") return -moved.y;
  if (way == "out") return moved.x;
  if (way == "back") return -moved.z;
  if (way == "all") return glm::length(moved);
  ADD_FAILURE() << "unknown way '" << way << "'";
  return 0;
}

TEST(amplitudes, each_pupil_goes_with_its_own_eye) {
  Pose pose;
  pose.values[*find_move("eye", Side::left, "side")] = 1;
  const auto rest = find_places(Pose{}), posed = find_places(pose);
  EXPECT_GT(glm::distance(posed.at("pupil_l"), rest.at("pupil_l")), 3);
  EXPECT_LT(glm::distance(posed.at("pupil_r"), rest.at("pupil_r")), 1e-4);
}

TEST(amplitudes, are_as_the_table_says_and_where_it_says_so_as_people_move) {
  std::istringstream table(read_file(kData / "docs/amplitudes.md"));
  const auto rest = find_places(Pose{});
  int rows = 0;
  for (std::string line; std::getline(table, line);) {
    // | movement | areas | landmark | way | mien, mm | people, mm | source |
    const std::vector<std::string> cells = split_cells(line);
    if (cells.size() < 7 || cells[0] == "movement" || cells[0].starts_with("--")) continue;
    ++rows;
    const Spec spec = load_text("mien: 1\nexpressions: {row: {" + cells[1] + "}}\n");
    const auto posed = find_places(find_expression(spec, "row").pose);
    ASSERT_TRUE(rest.contains(cells[2])) << line;
    const double mm = compute_way_mm(rest.at(cells[2]), posed.at(cells[2]), cells[3]);
    EXPECT_NEAR(mm, std::stod(cells[4]), 0.051) << line;
    const double low = std::stod(cells[5]), high = std::stod(cells[5].substr(cells[5].find("to") + 2));
    const bool is_within = low <= mm && mm <= high;
    EXPECT_EQ(is_within, cells[6].find("; more on purpose") == std::string::npos) << line;
  }
  EXPECT_GE(rows, 12);
}

}  // namespace
}  // namespace mien
