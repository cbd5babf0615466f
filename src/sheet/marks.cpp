#include "sheet/marks.hpp"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

// Shares of the picture's height.
constexpr double kLineRadius = 0.0028, kArrowRadius = 0.0042;
constexpr double kDotRadius = 0.0085;  // where an arrow begins
constexpr double kTip = 0.042;         // an arrow's tip; of a short arrow two thirds
constexpr double kWords = 0.042, kWordsGap = 0.014;
constexpr double kCapital = 0.7;                     // of a letter's size: how high it stands
constexpr int kSteps = 8;                            // of a smooth line between two places
constexpr glm::vec3 kLimitInk{0.72f, 0.15f, 0.10f};  // the red pencil
constexpr glm::vec3 kRestInk{0.20f, 0.33f, 0.55f};   // the blue one
constexpr double kAway = 0.5;  // of the way from the face to the camera: before all of the head

// The picture's plane: places of the head as right and up from its middle, mm.
struct Sketch {
  const CameraView& view;
  glm::dvec3 right, toward;
  double tall_mm, wide_mm;
  int height_px;
  Overlay overlay;

  glm::dvec2 flatten(const glm::dvec3& place) const {
    return {glm::dot(place - glm::dvec3(view.look_at), right), place.y - view.look_at.y};
  }
  glm::vec3 lift(const glm::dvec2& place) const {
    return glm::vec3(glm::dvec3(view.look_at) + right * place.x + glm::dvec3(0, place.y, 0) +
                     toward * (kAway * compute_camera_distance_mm(view)));
  }
  OverlayLine& begin(double radius, bool is_rest) {
    const double radius_mm = compute_line_radius_mm(radius, tall_mm, height_px);
    overlay.lines.push_back({{}, {}, radius_mm, is_rest ? kRestInk : kLimitInk});
    return overlay.lines.back();
  }
  void write(const std::string& words, const glm::dvec2& at, double align, bool is_rest) {
    overlay.words.push_back({words, lift(at), tall_mm * kWords, is_rest ? kRestInk : kLimitInk, align});
  }
};

using Line = std::vector<glm::dvec2>;

void append_line(const Line& line, const Sketch& sketch, OverlayLine& into) {
  for (std::size_t i = 1; i < line.size(); ++i)
    into.segments.push_back({sketch.lift(line[i - 1]), sketch.lift(line[i])});
}

// Catmull and Rom's curve through the places: E. Catmull, R. Rom, "A class of local interpolating splines"
// (1974).
Line smooth(const Line& line) {
  Line curve;
  const auto at = [&](std::ptrdiff_t i) {
    return line[std::clamp<std::ptrdiff_t>(i, 0, static_cast<std::ptrdiff_t>(line.size()) - 1)];
  };
  for (std::ptrdiff_t i = 0; i + 1 < static_cast<std::ptrdiff_t>(line.size()); ++i)
    for (int k = 0; k < kSteps; ++k) {
      const double t = static_cast<double>(k) / kSteps;
      const glm::dvec2 a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
      curve.push_back(0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t * t +
                             (3.0 * b - a - 3.0 * c + d) * t * t * t));
    }
  if (!line.empty()) curve.push_back(line.back());
  return curve;
}

Line find_line(const SheetMark& mark, const PlacesOfPose& places, const Sketch& sketch) {
  Line line;
  for (const std::string& name : mark.places)
    if (const auto found = places.find(name); found != places.end())
      line.push_back(sketch.flatten(found->second));
  return line;
}

void draw_level(const SheetMark& mark, const Line& line, Sketch& sketch) {
  double y = 0;
  for (const glm::dvec2& place : line) y += place.y / static_cast<double>(line.size());
  append_line({{-sketch.wide_mm / 2, y}, {sketch.wide_mm / 2, y}}, sketch,
              sketch.begin(kLineRadius, mark.is_rest));
  const double gap = kWordsGap * sketch.tall_mm;
  sketch.write(mark.words.at(0), {sketch.wide_mm / 2 - 2 * gap, y + gap}, 1, mark.is_rest);
}

void draw_box(const SheetMark& mark, const std::vector<Line>& lines, Sketch& sketch) {
  glm::dvec2 low = lines.front().front(), high = low;
  for (const Line& line : lines)
    for (const glm::dvec2& place : line) low = glm::min(low, place), high = glm::max(high, place);
  append_line({low, {high.x, low.y}, high, {low.x, high.y}, low}, sketch,
              sketch.begin(kLineRadius, mark.is_rest));
  const double gap = kWordsGap * sketch.tall_mm, letter = kWords * kCapital * sketch.tall_mm;
  const glm::dvec2 middle = (low + high) / 2.0;
  sketch.write(mark.words.at(0), {middle.x, high.y + gap}, 0.5, mark.is_rest);
  sketch.write(mark.words.at(1), {middle.x, low.y - gap - letter}, 0.5, mark.is_rest);
  sketch.write(mark.words.at(2), {low.x - gap, middle.y - letter / 2}, 1, mark.is_rest);
  sketch.write(mark.words.at(3), {high.x + gap, middle.y - letter / 2}, 0, mark.is_rest);
}

void draw_arrow(const glm::dvec2& from, const glm::dvec2& to, Sketch& sketch) {
  OverlayLine& dot = sketch.begin(kDotRadius, false);
  const glm::vec3 place = sketch.lift(from);
  dot.segments.push_back({place, place + glm::vec3(sketch.toward)});
  const double way = glm::distance(from, to);
  if (way < kDotRadius * sketch.tall_mm) return;  // a dot hides it
  const double tip = std::min(kTip * sketch.tall_mm, way * 2 / 3);
  const glm::dvec2 neck = to - (to - from) / way * tip;
  OverlayLine& line = sketch.begin(kArrowRadius, false);
  line.segments.push_back({place, sketch.lift(neck)});
  line.tips.push_back({sketch.lift(neck), sketch.lift(to)});
}

}  // namespace

DrawnMarks draw_marks(const SheetCell& cell, const FigurePlaces& places, const CameraView& view,
                      std::pair<int, int> size_px) {
  const glm::dvec3 toward = compute_toward_camera(view);
  const double aspect = static_cast<double>(size_px.first) / size_px.second;
  const double tall_mm = std::max(view.frame_height_mm, view.frame_width_mm / aspect);
  Sketch sketch{view, {toward.z, 0, -toward.x}, toward, tall_mm, tall_mm * aspect, size_px.second, {}};
  DrawnMarks drawn;
  for (const SheetMark& mark : cell.marks) {
    std::vector<PlacesOfPose> poses;
    std::vector<Line> lines;
    for (const Pose& pose : mark.poses) {
      poses.push_back(places(pose));
      lines.push_back(find_line(mark, poses.back(), sketch));
    }
    if (lines.front().empty()) continue;
    if (mark.shape == MarkShape::line)
      append_line(smooth(lines[0]), sketch, sketch.begin(kLineRadius, mark.is_rest));
    if (mark.shape == MarkShape::level) draw_level(mark, lines[0], sketch);
    if (mark.shape == MarkShape::box) draw_box(mark, lines, sketch);
    if (mark.shape != MarkShape::arrow) continue;
    for (std::size_t i = 0; i < lines[0].size(); ++i) draw_arrow(lines[0][i], lines[1][i], sketch);
    const std::string& first = mark.places.front();
    drawn.way_mm = glm::distance(poses[0].at(first), poses[1].at(first));
  }
  drawn.overlay = std::move(sketch.overlay);
  return drawn;
}

}  // namespace mien
