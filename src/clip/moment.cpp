#include "clip/moment.hpp"

#include "clip/view.hpp"
#include "timeline/parts.hpp"

namespace mien {

Moment compute_moment(const Options& options, const Clip& clip, const Actor& actor, const Figure& figure,
                      std::vector<Held>& held) {
  if (options.express) {
    const Expression expression = take_expression(clip.spec, *options.express);
    held = expression.held;
    return {expression.pose, {}, {}};
  }
  Performance performance = actor.performance;
  performance.idle.eyes = compute_eyes(figure, clip.spec.render);
  held = list_held_at(performance, compute_time_s(clip, options));
  return sample_performance(performance, compute_time_s(clip, options));
}

Drawing draw_moment(const Figure& figure, const Moment& moment) {
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(figure, moment.pose, moment.turn, buffers, drawing);
  return drawing;
}

}  // namespace mien
