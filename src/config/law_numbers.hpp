// What laws move besides the areas: numbers of the camera, of the head's turning, of the lights and of an
// actor's place, each of its track's own in the order of the rows.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "config/clip_spec.hpp"
#include "config/words.hpp"

namespace mien {

inline constexpr double kMostPlace_mm = 5000;   // farther off nobody is seen
inline constexpr double kMostBrightness = 2;    // more only burns the skin out
inline constexpr double kShortestLens_mm = 28;  // a shorter one is inside the nose
inline constexpr double kLongestLens_mm = 400;

enum class LawUnit { plain, angle, length };

struct LawNumber {
  LawTrack track;
  std::string_view name;
  LawUnit unit;
  Bounds bounds;          // where an author's values and what comes of them lie
  double rest;            // what `max` tells further and less far from
  std::string_view what;  // in one line of help
};

inline constexpr Bounds kRoundBounds{-360, 360}, kPlaceBounds{-kMostPlace_mm, kMostPlace_mm};

inline constexpr std::array kLawNumbers{
    LawNumber{LawTrack::camera, "angle", LawUnit::angle, kCameraBounds[0], 0, "about the head"},
    LawNumber{LawTrack::camera, "height", LawUnit::angle, kCameraBounds[1], 0, "+ from above"},
    LawNumber{LawTrack::camera, "distance", LawUnit::plain, kCameraBounds[2], 1, "1 frames the whole bust"},
    LawNumber{LawTrack::camera,
              "lens",
              LawUnit::length,
              {kShortestLens_mm, kLongestLens_mm},
              kPortraitLens_mm,
              "for film of 24 x 36"},
    LawNumber{LawTrack::turn, "turn", LawUnit::angle, kTurnBounds[0], 0, "+ to the character's left"},
    LawNumber{LawTrack::turn, "nod", LawUnit::angle, kTurnBounds[1], 0, "+ chin down"},
    LawNumber{LawTrack::turn, "tilt", LawUnit::angle, kTurnBounds[2], 0, "+ to the left shoulder"},
    LawNumber{LawTrack::light, "brightness", LawUnit::plain, {0, kMostBrightness}, 1, "1: as the set is"},
    LawNumber{LawTrack::light, "angle", LawUnit::angle, kRoundBounds, 0, "about the head"},
    LawNumber{LawTrack::place, "x", LawUnit::length, kPlaceBounds, 0, "to the left of who looks out"},
    LawNumber{LawTrack::place, "y", LawUnit::length, kPlaceBounds, 0, "up"},
    LawNumber{LawTrack::place, "z", LawUnit::length, kPlaceBounds, 0, "toward the camera"},
    LawNumber{LawTrack::place, "turn", LawUnit::angle, kRoundBounds, 0, "about the upright axis"}};

// As LawTrack: the keys of a law that name them.
inline constexpr std::array<std::string_view, 4> kLawTracks{"camera", "turn", "light", "place"};

inline constexpr std::size_t kLensNumber = 3, kBrightnessNumber = 0, kLightAngleNumber = 1;

// Those of one track.
constexpr std::span<const LawNumber> list_law_numbers(LawTrack track) {
  const auto begin = std::ranges::find(kLawNumbers, track, &LawNumber::track);
  const auto end = std::ranges::find_if(begin, kLawNumbers.end(),
                                        [&](const LawNumber& number) { return number.track != track; });
  return {begin, end};
}

inline std::vector<Word> list_law_words(LawTrack track) {
  std::vector<Word> words;
  for (const LawNumber& number : list_law_numbers(track)) words.push_back({number.name, number.what});
  return words;
}

}  // namespace mien
