// Who plays in a clip: the heads that its drawings show, and what they do.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "clip/clip.hpp"
#include "clip/figure_store.hpp"
#include "clip/view.hpp"
#include "frames/resources.hpp"

namespace mien {

// What all scenes of a clip share.
struct Cast {
  // One an actor; empty for one whose head changes, which is built anew for each head it has.
  std::vector<FigurePointer> figures;
  Framing framing;
  FigureStore* store = nullptr;  // where figures are kept, if they are
};

// Builds every head that does not change, and of the others those at their keys: their sizes make the
// framing. Their mistakes, and those of the heads between the keys, are told before anything is written.
// With a store, those that it has are taken from there. Throws InputError.
Cast build_cast(const Clip& clip, const HeadStock& stock, FigureStore* store = nullptr);

// Everybody's figure as some drawings show it.
struct Heads {
  std::vector<FigurePointer> figures;     // one an actor
  std::vector<glm::dmat4> places;         // world from figure
  std::vector<Performance> performances;  // with the eyes of these figures
  std::vector<FigurePointer> changing;    // those of `figures` that are not the cast's
};

Heads build_heads(const Clip& clip, const Cast& cast, double time_s, const HeadStock& stock);

// What everybody does, with the eyes of the heads that they have (at the beginning, if they change).
std::vector<Performance> list_performances(const Clip& clip, const Cast& cast, const HeadStock& stock);

// The clip's drawings by the heads that they show.
struct DrawingGroups {
  std::vector<std::size_t> group;  // of each drawing of the plan, from 0 by time
  std::vector<std::size_t> order;  // all drawings, group after group, so that few heads are in use at once
  std::vector<std::size_t> first;  // of each group its first drawing
};

DrawingGroups group_drawings(const Clip& clip);

}  // namespace mien
