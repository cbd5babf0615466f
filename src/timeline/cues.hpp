// Cues: what comes and goes on top of the keys, with a rule for each area that several ask for. After the
// actors and cues of ASAS (C. Reynolds, "Computer animation with scripts and actors", 1982), as Yen (1990),
// chapter 2, tells of them; onset, apex and offset as in BML.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "timeline/track.hpp"

namespace mien {

struct Layers;
struct LayerStore;

// While another cue comes over it, a cue stays at what it had then: between two cues in a row there is no
// rest.
struct Freeze {
  Ticks from = 0, until = 0;
  std::bitset<kChannelCount> moves;
};

// A CueSpec made ready to be sampled.
struct Cue {
  CueSpec spec;
  Ticks from = 0, full = 0, ebb = 0, end = 0, start = 0;
  std::shared_ptr<const Layers> script;   // what it shows: this,
  std::shared_ptr<const KeyTrack> table;  // else this, else `spec.what`
  // By time; of one move each begins after the one before it has ended.
  std::vector<Freeze> freezes;
  Ticks gone = 0;                // when it ends, or the last freeze does
  std::size_t come = 0, go = 0;  // which lead it comes and goes with
};

// The cues of a clip in the order in which they lie upon each other.
struct CueStack {
  std::vector<Cue> cues;
  std::vector<Ticks> latest_end;          // of this one and all before it, within its layer
  std::vector<std::size_t> layer_begins;  // where each layer begins, and the end
  std::vector<Moves> layer_moves;         // what the cues of each may move
  std::vector<Lead> leads;                // none, the clip's, and those of the kinds of ways
};

// `store` holds the scripts and tables that cues share (layers.hpp).
CueStack build_cue_stack(const ClipSpec& clip, LayerStore& store);

// A face while it is put together: each move's value, and how many times its limit it may go.
struct FaceState {
  std::array<double, kChannelCount> values{}, reach{};
  std::array<double, 3> turn_deg{};  // of scripts, on top of the head's own
};

// Lays the cues upon the face. With `only` some of the moves: the others and the head's turn are left as they
// are.
void apply_cues(const CueStack& stack, Ticks time, FaceState& face);
void apply_cues(const CueStack& stack, Ticks time, const Moves& only, FaceState& face);

// A layer's cues among which all are that are there at a time: most of a long clip's are left out.
std::size_t count_layers(const CueStack& stack);
std::span<const Cue> find_cues(const CueStack& stack, std::size_t layer, Ticks time);

// How much of a cue there is at a time, for a move: 0..1.
double compute_weight(const CueStack& stack, const Cue& cue, std::size_t move, Ticks time);

// A script's own time: since it began, again and again if it is repeated.
Ticks compute_script_time(const Cue& cue, Ticks time);

}  // namespace mien
