// The sections of the file, each from its value in the tree to its struct of spec.hpp.
#pragma once

#include "config/expressions.hpp"
#include "config/head_files.hpp"
#include "config/named_times.hpp"
#include "config/spec.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

HeadSpec load_head(const YamlValue& value, const HeadSource& source);

// What of a head may change in a clip (the keys of a head_key), over what `head` has already.
void load_growth(const YamlMapping& entries, const HeadWords& words, HeadSpec& head);

// `clip.head`: keys of a head that changes, from `first` on. Without a `length` the clip lasts until the
// last.
void load_head_track(const YamlMapping& entries, const HeadSource& source, const HeadSpec& first,
                     const NamedTimes& times, ClipSpec& clip);

// `look_at` and `lens` of the camera's keys, over those of the key before.
struct AimWords {
  Names places;
  Names actors;  // whose places they are; none: the only one's
};
void load_camera_sights(const YamlMapping& entries, const AimWords& words, ClipSpec& clip);

// `clip.light` and `clip.background`.
void load_light_tracks(const YamlMapping& entries, const NamedTimes& times, ClipSpec& clip);

// `mien: 1` in a file's entries.
void check_version(const YamlValue& root, const YamlMapping& entries);

// What all clips of a file have together.
struct ClipCounts {
  std::size_t parts = 0;     // keys, cues, laws and tracks that were read
  std::size_t formulas = 0;  // that were read
  double work = 0;           // of trying them (kMaxWork)
};

// A clip without keys on a track gets one at 0 s. `value` is empty if the file has no clip.
// What a clip is told by those around it.
struct ClipSetting {
  const ClipSpec* shared = nullptr;   // of an actor's clip the file's own
  bool is_everybodys = false;         // there are actors, with clips of their own
  const NamedTimes* times = nullptr;  // that its keys may wait for
  Names others = {};                  // actors that one may look at
  ClipCounts* counts = nullptr;       // of the file; none: its own
  const Inputs* inputs = nullptr;     // everybody's
  Inputs* found = nullptr;            // filled with the clip's own and those of its files
};
ClipSpec load_clip(const YamlValue* value, const ExpressionBook& book, const ClipSetting& setting = {});

// `actors:` and the clip they share, or `head` and `clip` of the only one.
struct StageSource {
  const ExpressionBook* book = nullptr;
  HeadSource head;
};
void load_stage(const YamlMapping& file, const StageSource& source, Spec& spec);

RenderSpec load_render(const YamlValue& value);

// A list of busts, or a set: all expressions of a library or those of a list, each with its name on the base.
void load_busts(const YamlValue& value, const ExpressionBook& book, Spec& spec);

}  // namespace mien
