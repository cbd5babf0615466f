// What pages see of a text: its figures as graphics take them, their drawings, and what stands about them.
#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "clip/staging.hpp"
#include "live/documents.hpp"
#include "live/view_model.hpp"
#include "sketch/stage.hpp"

namespace mien {

// Everybody who is in a picture.
struct ViewScene {
  std::string key;                     // another one for other figures or other materials
  std::string include;                 // the stage's text that the colours were taken from
  std::shared_ptr<const Heads> heads;  // whose figures they are
  std::vector<ViewModel> models;       // one an actor
};
using ScenePointer = std::shared_ptr<const ViewScene>;

// The stage of a moment, read.
struct ViewStage {
  std::string text;
  std::shared_ptr<const SketchStage> stage;
};

// Any number of threads may ask.
struct ViewStore {
  std::mutex mutex;                                   // of all that follows
  int count = 0;                                      // of scenes that were made
  std::list<ScenePointer> scenes;                     // the one used last comes first
  std::list<ViewStage> stages;                        // the same
  std::vector<std::unique_ptr<DrawBuffers>> buffers;  // that no thread uses now
};

// A moment of a text: its heads, its lights and where its camera stands.
struct ViewMoment {
  double time_s = 0;
  std::shared_ptr<const Cast> cast;
  std::shared_ptr<const Heads> heads;
  FrameStart start;
  std::string include;
  std::shared_ptr<const SketchStage> stage;
};

// With a `camera` instead of the clip's own. Throws InputError on a head that cannot be built.
ViewMoment find_moment(LiveShelf& shelf, ViewStore& store, LiveDocument& document, double time_s,
                       const std::optional<CameraKey>& camera);

// The figures of a moment as graphics take them; made once.
ScenePointer find_scene(ViewStore& store, const ViewMoment& moment);

// Buffers for one thread, until they go.
struct BorrowedBuffers {
  explicit BorrowedBuffers(ViewStore& from);
  ~BorrowedBuffers();
  BorrowedBuffers(const BorrowedBuffers&) = delete;
  BorrowedBuffers& operator=(const BorrowedBuffers&) = delete;

  ViewStore& store;
  std::unique_ptr<DrawBuffers> buffers;
};

}  // namespace mien
