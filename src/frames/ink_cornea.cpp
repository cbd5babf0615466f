#include "frames/ink_cornea.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/smooth.hpp"
#include "frames/ink_strokes.hpp"

namespace mien {

namespace {

// Heights along `up` at even steps, the first and the last of them told.
struct Heights {
  glm::vec3 up;
  float low_mm = 0, high_mm = 0;
  float find_step(const glm::vec3& at) const {
    return (kStrokeSteps - 1) * (glm::dot(at, up) - low_mm) / std::max(high_mm - low_mm, 1e-3f);
  }
};

// Where the balls of one side end toward `front` at each height; nothing where there is none of them.
std::array<std::optional<glm::vec3>, kStrokeSteps> find_front(const Ink& ink, const Drawing& drawing,
                                                              std::size_t side, const Heights& heights,
                                                              const glm::vec3& front) {
  std::array<std::optional<glm::vec3>, kStrokeSteps> fronts;
  for (const std::size_t i : ink.balls) {
    const Part& part = ink.model.parts[i];
    const std::vector<glm::vec3>& ball = drawing.parts[i].positions;
    if (ball.empty() || part.name.ends_with("_left") != (side == 0)) continue;
    for (const Triangle& t : part.rest.triangles)
      for (int k = 0; k < 3; ++k) {
        const glm::vec3 &a = ball[t[k]], &b = ball[t[(k + 1) % 3]];
        const float from = heights.find_step(a), to = heights.find_step(b);
        const float first = std::max(std::ceil(std::min(from, to)), 0.0f);
        for (float step = first; step <= std::min(std::max(from, to), kStrokeSteps - 1.0f); ++step) {
          if (from == to) break;
          const glm::vec3 at = glm::mix(a, b, (step - from) / (to - from));
          std::optional<glm::vec3>& most = fronts[static_cast<std::size_t>(step)];
          if (!most || glm::dot(at, front) > glm::dot(*most, front)) most = at;
        }
      }
  }
  return fronts;
}

}  // namespace

void append_cornea(const Ink& ink, const InkSight& sight, double line_mm, const Drawing& drawing,
                   std::vector<glm::vec3>& vertices) {
  constexpr float kHalf = 0.75f, kEnds = 0.6f, kBegins = 0.5f;  // in lines; of it at its ends; of a side view
  const std::size_t side = sight.aside > 0 ? 0 : 1;
  const std::vector<glm::vec3>& skin = drawing.parts.front().positions;
  const glm::vec3 up = glm::normalize(glm::vec3(drawing.parts[ink.teeth].world_from_rest[1]));
  const glm::vec3 front = (sight.aside > 0 ? 1.0f : -1.0f) * glm::normalize(glm::cross(sight.to_camera, up));
  const Heights heights{up, glm::dot(skin[ink.lids[side][1]], up), glm::dot(skin[ink.lids[side][0]], up)};
  const float shown = ink.redraw.lens.is_on() ? smooth_step(kBegins, 1.0f, sight.beside) : 0;
  std::array<std::optional<glm::vec3>, kStrokeSteps> fronts;
  if (shown > 0) fronts = find_front(ink, drawing, side, heights, front);
  Tube tube;
  glm::vec3 last = skin[ink.lids[side][1]];
  for (std::size_t i = 0; i < fronts.size(); ++i) {
    const float at = static_cast<float>(i) / (kStrokeSteps - 1);
    last = fronts[i].value_or(last);
    const float full = std::lerp(kEnds, 1.0f, 1 - std::abs(2 * at - 1));
    tube.centres.push_back(last);
    tube.lifts.push_back(sight.to_camera);
    tube.halves_mm.push_back(kHalf * shown * full * static_cast<float>(line_mm));
  }
  append_tube(tube, 0.5, vertices);
}

}  // namespace mien
