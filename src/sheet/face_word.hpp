// "anna.yaml@smile", "otto.yaml@1.2s": a file and which of its faces.
#pragma once

#include <string>

#include "options.hpp"

namespace mien {

// `options` with the file and the face that the word names instead of its own: behind the last @ a time such
// as 1.2s, 500ms or 36f, or an expression; without an @ the head at rest. A file that has an @ in its own
// name is meant as a whole.
Options take_face_word(const Options& options, const std::string& word);

}  // namespace mien
