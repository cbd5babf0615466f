#include "frames/ink_cornea.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/smooth.hpp"
#include "frames/ink_strokes.hpp"

namespace mien {

namespace {

// Where the balls of one side end toward `front` at a height along `up`; nothing where there is none of them.
std::optional<glm::vec3> find_front(const Ink& ink, const Drawing& drawing, std::size_t side,
                                    const glm::vec3& up, const glm::vec3& front, float high_mm) {
  std::optional<glm::vec3> most;
  for (const std::size_t i : ink.balls) {
    const Part& part = ink.model.parts[i];
    const std::vector<glm::vec3>& ball = drawing.parts[i].positions;
    if (ball.empty() || part.name.ends_with("_left") != (side == 0)) continue;
    for (const Triangle& t : part.rest.triangles)
      for (int k = 0; k < 3; ++k) {
        const glm::vec3 &a = ball[t[k]], &b = ball[t[(k + 1) % 3]];
        const float from = glm::dot(a, up) - high_mm, to = glm::dot(b, up) - high_mm;
        if ((from < 0) == (to < 0)) continue;
        const glm::vec3 at = glm::mix(a, b, from / (from - to));
        if (!most || glm::dot(at, front) > glm::dot(*most, front)) most = at;
      }
  }
  return most;
}

}  // namespace

void append_cornea(const Ink& ink, const InkSight& sight, double line_mm, const Drawing& drawing,
                   std::vector<glm::vec3>& vertices) {
  constexpr float kHalf = 0.75f, kEnds = 0.6f, kBegins = 0.5f;  // in lines; of it at its ends; of a side view
  const std::size_t side = sight.aside > 0 ? 0 : 1;
  const std::vector<glm::vec3>& skin = drawing.parts.front().positions;
  const glm::vec3 up = glm::normalize(glm::vec3(drawing.parts[ink.teeth].world_from_rest[1]));
  const glm::vec3 front = (sight.aside > 0 ? 1.0f : -1.0f) * glm::normalize(glm::cross(sight.to_camera, up));
  const float high_mm = glm::dot(skin[ink.lids[side][0]], up), low_mm = glm::dot(skin[ink.lids[side][1]], up);
  const float shown = ink.redraw.lens.is_on() ? smooth_step(kBegins, 1.0f, sight.beside) : 0;
  Tube tube;
  glm::vec3 last = skin[ink.lids[side][1]];
  for (int i = 0; i < kStrokeSteps; ++i) {
    const float at = static_cast<float>(i) / (kStrokeSteps - 1);
    if (shown > 0)
      last = find_front(ink, drawing, side, up, front, std::lerp(low_mm, high_mm, at)).value_or(last);
    const float full = std::lerp(kEnds, 1.0f, 1 - std::abs(2 * at - 1));
    tube.centres.push_back(last);
    tube.lifts.push_back(sight.to_camera);
    tube.halves_mm.push_back(kHalf * shown * full * static_cast<float>(line_mm));
  }
  append_tube(tube, 0.5, vertices);
}

}  // namespace mien
