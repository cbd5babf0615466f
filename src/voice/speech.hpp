// What a clip's lines come to: the mouth's cues, what stress and questions do to brows and head, blinks in
// pauses, what is heard, and how long the clip is.
#pragma once

#include "config/load_spec.hpp"

namespace mien {

// Adds it to the clip and to those of all actors. Each phrase, which is what stands between pauses of a
// quarter of a second, is a cue of its own, so that the face that means it is seen between them. Throws
// InputError with every mistake.
void add_speech(Spec& spec, const SpeechData& data);

}  // namespace mien
