#include "sheet/asked_face.hpp"

#include <fmt/format.h>

#include "clip/moment.hpp"
#include "core/text.hpp"
#include "sheet/plans.hpp"

namespace mien {

AskedFace find_asked_face(const Options& options, const Clip& clip, const Resources& resources) {
  const Actor& actor = find_actor(clip, options);
  AskedFace face{actor.head, {}, "", {}};
  if (options.express) {
    const Expression expression = take_expression(clip.spec, *options.express);
    face.pose = expression.pose;
    face.held = expression.held;
    face.words = build_caption(expression.name.empty() ? *options.express : expression.name);
  } else if (options.at_s || options.at_frames) {
    face.head = find_asked_head(clip, actor, options);
    const Figure figure = build_figure(resources.heads, face.head, FigureUse::print);
    face.pose = compute_moment(options, clip, actor, figure, face.held).pose;
    face.words = fmt::format("at {} s", format_number(compute_time_s(clip, options), 2));
  }
  return face;
}

}  // namespace mien
