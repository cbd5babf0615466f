// The way of a mouth through what it says: each mouth stands by its neighbours as firmly as it insists, which
// is Cohen and Massaro's coarticulation ("Modeling coarticulation in synthetic visual speech", 1993); what
// has to touch, touches.
#pragma once

#include <memory>
#include <vector>

#include "config/clip_spec.hpp"
#include "voice/sounds.hpp"

namespace mien {

struct MouthSettings {
  double strength = 1;
  double corners = 1;         // what the table's corners are multiplied with
  double frame_s = 1.0 / 24;  // contacts last as long, so that a drawing shows them
};

// The moves that speech takes: those of lips, chin and tongue, without what is beyond Tezuka's nine areas
// where a file keeps to them, and those of the corners.
std::vector<std::size_t> list_lip_moves(bool keeps_to_nine = false);
std::vector<std::size_t> list_corner_moves();

// From the first segment's beginning to the last one's end, a hundred rows a second; times as the segments
// have them. The jaw opens and shuts by no more than 1.8 of its limits a second: quick speech opens less.
TimeTable build_mouth_table(const SpeechData& data, const std::vector<MouthSegment>& segments,
                            const std::vector<std::size_t>& moves, const MouthSettings& settings);

}  // namespace mien
