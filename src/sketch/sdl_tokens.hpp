// The words of POV-Ray's scene description language, as far as templates/povray uses it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mien {

enum class SdlKind { number, word, text, sign, directive };

struct SdlToken {
  SdlKind kind = SdlKind::sign;
  double number = 0;
  std::string word;  // of a sign its one or two characters, of a directive its name without the '#'
  int line = 0;      // from 1
};

// Comments are left out. Throws RunError "NAME:line: ..." on what is no word of the language.
std::vector<SdlToken> list_sdl_tokens(std::string_view text, std::string_view name);

}  // namespace mien
