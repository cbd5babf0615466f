// The ledger: every value that a limit held back, and the line that had asked for more.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "config/areas.hpp"
#include "core/error.hpp"

namespace mien {

struct Spec;

// One value of one pose that went past its limit.
struct Held {
  std::size_t move = 0;        // in kMoves
  double asked = 0, held = 0;  // fractions of the limit
  Place place;                 // the line that asked
  std::string by;              // what asked: "surprise 1 + fear 0.8"; empty: the value itself, as written

  bool operator==(const Held&) const;
};

// The most that `exaggerate` lifts a limit by, and the furthest that a value may be written: beyond twice the
// limit a face stops being one (Calder et al., 2000, find likeness gone there), and a number is a slip.
inline constexpr double kMaxExaggerate = 2;

// Why `exaggerate` does not lift this limit: "shut is shut". Empty for a limit that it lifts.
std::string_view find_stop(std::size_t move, double sign);

// By places and moves, each once.
void sort_ledger(std::vector<Held>& ledger);

// The ledger of a file, in the order of places and moves, each once: its own expressions, its keys and its
// busts, and of the libraries what these use.
std::vector<Held> list_held(const Spec& spec);

// "brow.left.up"; "brows.up" when both sides are meant.
std::string name_move(std::size_t move, bool is_both = false);

// The way of an area's move to the side of `value`, not 0: "brow.left.down".
std::string name_way(std::size_t move, double value);

// What a user reads of a ledger: a line for each area, move and place; two sides that asked the same in one.
struct HeldNote {
  Held held;
  std::string name;  // "brows.up"
  std::string text;  // "brows.up asked for 1.8 (surprise 1 + fear 0.8); held at its limit, 1"
};
std::vector<HeldNote> build_notes(const std::vector<Held>& ledger);

// "a.yaml:7:12: note: brows.up ...".
std::string format_note(const HeldNote& note);

}  // namespace mien
