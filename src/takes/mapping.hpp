// Another program's units of a face in moves of ours: numbers alone, by their places in tables.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

// So much of a move (its index) when the unit is at 1.
struct MappedMove {
  std::size_t move = 0;
  double value = 0;
};

struct MappedUnit {
  std::string name;  // "jawOpen", "AU12"
  std::vector<MappedMove> moves = {};
  // At 1 the mean over the face's points of the square of their way, mm2, and the share of it that our moves
  // leave over.
  double motion_mm2 = 0, residual = 1;
  // Another unit, than which it counts no more, and of which it does a share: its moves are what they are
  // where it is as much as that one, and so are motion and residual, of both together.
  std::optional<std::size_t> corrects = {};
};

// Units that together do something else than their sum: the least of them takes so much of each.
struct MappedBlend {
  std::vector<std::size_t> units;
  std::vector<MappedMove> moves;
};

struct Mapping {
  std::string name;    // "arkit"
  std::string source;  // in one line
  std::vector<MappedUnit> units = {};
  std::vector<MappedBlend> blends = {};
};

std::optional<std::size_t> find_unit(const Mapping& mapping, std::string_view name);

// Adds to `moves` what the units come to, one weight each; the weights become what each counts for by itself:
// of a unit that another one corrects, what that leaves of it.
void add_mapped_moves(const Mapping& mapping, std::span<double> weights, std::span<double> moves);

}  // namespace mien
