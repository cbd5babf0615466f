// What keeps a face alive between its keys, as plain values: blinks, gaze, drift, asymmetry. Each has its
// own seed: the same file gives the same life on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "core/error.hpp"

namespace mien {

struct BlinkSpec {
  double per_minute = 0;  // 0: no blinks of their own
  std::uint64_t seed = 1;
  double doubles = 0;  // the share of them that a second one follows at once, 0..1
  double partial = 0;  // the share of them that do not shut the eye, 0..1
  double shifts = 0;   // how surely a great move of the eyes or the head takes a blink along, 0..1
};

// `blink: natural`. About half of people's own blinks do not shut the eye (face-facts 3.5: Ousler); doubles
// are rare.
inline constexpr BlinkSpec kNaturalBlink{15, 1, 0.1, 0.5, 1};

enum class LookAt {
  ahead,      // straight out of the head, wherever it turns
  camera,     // into the lens
  direction,  // of the room: by `side_deg` and `up_deg` from where the unturned head looks
  point,      // of the room: `point_mm`
};

// What the eyes rest on from `at_s` on. All but `ahead` stay where they are while the head turns.
struct GazeKey {
  double at_s = 0;  // the eyes are there; they leave 21 ms and more before (gaze.hpp)
  LookAt look = LookAt::ahead;
  double side_deg = 0;     // + to the character's left
  double up_deg = 0;       // + up
  glm::dvec3 point_mm{0};  // as conventions.hpp has space, seen from where the character stands
  std::string actor = {};  // whose eyes `point_mm` is; empty: nobody's
  Place place = {};        // in the file
};

struct GazeSpec {
  std::vector<GazeKey> keys;  // by time; none: the eyes are where the poses have them
  double wander = 0;          // small seeded fixations about it, 0..1: 0 none, 1 restless
  std::uint64_t seed = 1;
};

struct DriftSpec {
  double amount = 0;  // 0: as still as stone, 1: restless
  std::uint64_t seed = 1;
  double breaths_per_minute = 0;  // 0: none; grown-ups at rest 12 to 16, infants 30 and more
};

struct AsymmetrySpec {
  double amount = 0;  // how much less than the other one side does at most: 0.2 is a fifth
  std::uint64_t seed = 1;
};

// `asymmetry: natural`, and of one who gives a seed alone. Under 0.15 nobody sees it (asymmetry.cpp takes
// three quarters of the amount and more); from 0.3 on it reads as contempt.
inline constexpr double kNaturalAsymmetry = 0.2;

}  // namespace mien
