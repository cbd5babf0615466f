// Figures that are kept from one look at a file to the next: whoever edits a clip seldom changes its heads.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "config/head_spec.hpp"
#include "core/staging.hpp"
#include "frames/drawn_figure.hpp"

namespace mien {

using FigurePointer = std::shared_ptr<const DrawnFigure>;

// The newest ones used; a figure with its model and face is some tens of megabytes. Any number of threads may
// ask.
struct FigureStore {
  struct Kept {
    std::string key;
    FigurePointer figure;
  };
  std::mutex mutex;
  std::list<Kept> kept;  // the one used last comes first
  std::size_t most = 6;
};

// All that a figure depends on but mien's own data, with size and time of the files that its head names.
std::string compute_figure_key(const HeadSpec& head, const RenderSpec& render, const std::string& actor);

// The one kept under `key`, else what `build` makes. Throws what that throws.
FigurePointer take_figure(FigureStore& store, const std::string& key,
                          const std::function<FigurePointer()>& build);

}  // namespace mien
