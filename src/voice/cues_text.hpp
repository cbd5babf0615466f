// What another program says of a mouth, written as a file of ours: cues that one can read and change.
#pragma once

#include <string>

#include "config/speech_data.hpp"
#include "import/mouth_track.hpp"

namespace mien {

// A YAML file whose script `name` says the track: a key in the middle of each mouth, with the word that
// begins there beside it; the mouths are expressions of the file's own. `source` is told in its first line.
std::string build_cues_text(const MouthTrack& track, const SpeechData& data, const std::string& name,
                            const std::string& source);

}  // namespace mien
