// Laws of the camera, of the head's turning, of the lights and of an actor's place: laid upon what their keys
// come to, as laws of areas are upon the face.
#pragma once

#include <span>
#include <vector>

#include "config/clip_spec.hpp"
#include "core/ticks.hpp"

namespace mien {

// Lays the laws of one track upon its numbers, which are its own in the order of kLawNumbers; those that
// share a number first, then the others by their time, each by its rule. `laws` are by time.
void apply_laws(const std::vector<TrackLaw>& laws, LawTrack track, Ticks time, std::span<double> numbers);

// How much of a law there is at a time, 0..1. While a later one comes over it, it stays at what it had then:
// between two in a row nothing falls back to the keys.
double compute_law_weight(const std::vector<TrackLaw>& laws, const TrackLaw& law, Ticks time);

}  // namespace mien
