#include "clip/cast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "frames/place.hpp"
#include "head/form.hpp"
#include "render/process.hpp"
#include "timeline/head_track.hpp"

namespace mien {

namespace {

bool is_growing(const Actor& actor) { return !actor.performance.clip.head.empty(); }

// With the actor's name in the names of its parts: one scene holds everybody's.
FigurePointer make_actor_figure(const Actor& actor, const HeadSpec& head, const RenderSpec& render,
                                const HeadStock& stock) {
  DrawnFigure figure = build_drawn_figure(stock, head, render);
  if (!actor.name.empty()) {
    for (Part& part : figure.model.parts) part.name += "_of_" + actor.name;
    if (figure.ink)
      for (Part& part : figure.ink->model.parts) part.name += "_of_" + actor.name;
  }
  return std::make_shared<const DrawnFigure>(std::move(figure));
}

FigurePointer build_actor_figure(const Actor& actor, const HeadSpec& head, const RenderSpec& render,
                                 const HeadStock& stock, FigureStore* store) {
  const auto make = [&] { return make_actor_figure(actor, head, render, stock); };
  return store ? take_figure(*store, compute_figure_key(head, render, actor.name), make) : make();
}

// Adds where the landmarks lie that the camera looks at.
void add_places(const Clip& clip, const Actor& actor, const Figure& figure, Framing& framing) {
  for (const CameraKey& key : clip.spec.clip.camera)
    if (key.aim.kind == Aim::Kind::landmark && key.aim.actor == actor.name)
      framing.places[{actor.name, key.aim.landmark}] = glm::dvec3(
          find_place(actor.place) * glm::dvec4(compute_resting_place(figure.head, key.aim.landmark), 1));
}

// Throws InputError unless every head that the actor has between its keys can be built.
void check_heads(const Clip& clip, const Actor& actor, const HeadStock& stock) {
  if (!is_growing(actor)) return;
  constexpr int kMostChecks =
      240;  // a form takes milliseconds; a day of growth needs no more than a minute's
  const int frames = clip.frame_count, step = 1 + frames / kMostChecks;
  std::set<std::string> seen;
  for (int frame = 0; frame < frames; frame += step) {
    const double time_s = compute_drawing_time_s(clip.spec.clip, frame);
    const HeadSpec head = compute_head(actor, time_s);
    if (!seen.insert(compute_head_key(head)).second) continue;
    try {
      build_form(stock, head);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: the head{} at {:.4g}s: {}", clip.spec.file.string(),
                                   actor.name.empty() ? "" : " of " + actor.name, time_s, error.what()));
    }
  }
}

}  // namespace

Cast build_cast(const Clip& clip, const HeadStock& stock, FigureStore* store) {
  Cast cast;
  cast.store = store;
  for (const Actor& actor : clip.actors) {
    check_heads(clip, actor, stock);
    std::vector<HeadSpec> heads;  // that it is seen to have
    for (const HeadKey& key : actor.performance.clip.head) heads.push_back(key.head);
    if (!is_growing(actor)) heads.push_back(actor.head);
    std::set<std::string> seen;
    std::vector<FigurePointer> figures;
    std::vector<const Figure*> framed;
    for (const HeadSpec& head : heads) {
      throw_if_interrupted();
      if (!seen.insert(compute_head_key(head)).second) continue;
      figures.push_back(build_actor_figure(actor, head, clip.spec.render, stock, store));
      framed.push_back(figures.back().get());
      add_places(clip, actor, *figures.back(), cast.framing);
    }
    add_growing_figure(framed, find_place(actor.place), cast.framing);
    cast.figures.push_back(is_growing(actor) ? nullptr : figures.front());
  }
  return cast;
}

Heads build_heads(const Clip& clip, const Cast& cast, double time_s, const HeadStock& stock) {
  Heads heads{cast.figures, {}, {}, {}};
  const RenderSpec& render = clip.spec.render;
  for (std::size_t i = 0; i < clip.actors.size(); ++i) {
    const Actor& actor = clip.actors[i];
    glm::dmat4& place = heads.places.emplace_back(find_place(actor.place));
    if (!heads.figures[i]) {
      heads.figures[i] = build_actor_figure(actor, compute_head(actor, time_s), render, stock, cast.store);
      heads.changing.push_back(heads.figures[i]);
      place[3].y += compute_lowering_mm(*heads.figures[i], place, cast.framing, render);
    }
    heads.performances.push_back(actor.performance);
    heads.performances.back().idle.eyes = compute_eyes(*heads.figures[i], place, cast.framing, render);
  }
  return heads;
}

std::vector<Performance> list_performances(const Clip& clip, const Cast& cast, const HeadStock& stock) {
  return build_heads(clip, cast, 0, stock).performances;
}

DrawingGroups group_drawings(const Clip& clip) {
  DrawingGroups groups;
  std::map<std::string, std::size_t> known;
  for (const int frame : clip.plan.drawings) {
    const double time_s = compute_drawing_time_s(clip.spec.clip, frame - 1);
    std::string key;
    for (const Actor& actor : clip.actors)
      if (is_growing(actor)) key += compute_head_key(compute_head(actor, time_s));
    const std::size_t drawing = groups.group.size();
    groups.group.push_back(known.emplace(key, known.size()).first->second);
    if (groups.group.back() == groups.first.size()) groups.first.push_back(drawing);
    groups.order.push_back(drawing);
  }
  std::ranges::stable_sort(groups.order, {}, [&](std::size_t drawing) { return groups.group[drawing]; });
  return groups;
}

}  // namespace mien
