#include "sheet/face_word.hpp"

#include <cctype>

#include "config/quantity.hpp"
#include "core/error.hpp"

namespace mien {

Options take_face_word(const Options& options, const std::string& word) {
  Options taken = options;
  taken.file = word;
  taken.express.reset();
  taken.at_s.reset();
  taken.at_frames.reset();
  std::error_code ignored;
  const std::size_t at = word.rfind('@');
  if (at == word.npos || std::filesystem::exists(word, ignored)) return taken;
  taken.file = word.substr(0, at);
  const std::string face = word.substr(at + 1);
  if (face.empty())
    throw InputError(word + ": nothing stands behind the '@'; expected an expression or a time such as 1.2s");
  if (!std::isdigit(static_cast<unsigned char>(face.front()))) {
    taken.express = face;
    return taken;
  }
  const auto time = parse_quantity(face, build_time_measure(1));
  if (!time) throw InputError(word + ": '" + face + "' is not a time such as 1.2s, 500ms or 36f");
  (face.ends_with('f') ? taken.at_frames : taken.at_s) = time;
  return taken;
}

}  // namespace mien
