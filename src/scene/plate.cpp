// POV-Ray 3.7 reference, 2.1.4 and 3.4.5.1.13: strings and text objects. Measured on 3.7.0.10: its built-in
// fonts have ASCII; other letters show as boxes or as letters of another script.
#include "scene/plate.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "core/text.hpp"
#include "core/utf8.hpp"

namespace mien {

namespace {

constexpr int kSerif = 1, kSans = 2;  // POV-Ray's numbers of its fonts
constexpr int kDecimals = 2;          // of a pixel

// What stands for U+00C0 to U+00FF, letter by letter.
constexpr std::string_view kLatin = "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty";

std::string find_plain(std::uint32_t letter) {
  if (letter >= ' ' && letter < 127) return {static_cast<char>(letter)};
  if (letter >= 0xc0 && letter <= 0xff) return {kLatin[letter - 0xc0]};
  if (letter == 0x2018 || letter == 0x2019) return "'";
  if (letter == 0x201c || letter == 0x201d) return "\"";
  if (letter >= 0x2010 && letter <= 0x2015) return "-";
  if (letter == 0x2212) return "-";
  if (letter == 0x2026) return "...";
  return letter == '\t' || letter == '\n' || letter == 0xa0 ? " " : "";
}

}  // namespace

std::string simplify_letters(std::string_view utf8) {
  std::string plain;
  for (std::size_t at = 0; at < utf8.size();) {
    Character letter = find_character(utf8, at);
    if (letter.length == 0) letter = {static_cast<unsigned char>(utf8[at]), 1};  // as in Latin-1
    plain += find_plain(letter.code);
    at += letter.length;
  }
  return plain;
}

std::string quote_povray(std::string_view words) {
  std::string quoted = "\"";
  for (const char letter : simplify_letters(words)) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + "\"";
}

std::string build_plate_scene(const Plate& plate, const Templates& templates) {
  std::string marks;
  const auto number = [](double value) { return format_number(value, kDecimals); };
  for (const PlateRule& rule : plate.rules)
    marks += fmt::format("plate_rule({}, {}, {}, {}, {})\n", number(rule.x_px), number(rule.y_px),
                         number(rule.width_px), number(rule.thickness_px), number(rule.strength));
  for (const PlateLine& line : plate.lines)
    marks += fmt::format("plate_{}({}, {}, {}, {}, {}, {})\n", line.has_tip ? "arrow" : "line",
                         number(line.x_px), number(line.y_px), number(line.to_x_px), number(line.to_y_px),
                         number(line.thickness_px), number(line.strength));
  for (const PlateWords& words : plate.words) {
    const std::string plain = simplify_letters(words.words);
    if (plain.find_first_not_of(' ') == plain.npos) continue;  // POV-Ray knows no text without a letter
    marks += fmt::format("plate_words({}, {}, {}, {}, {}, {}, {}, {})\n", words.is_serif ? kSerif : kSans,
                         quote_povray(plain), number(words.x_px), number(words.y_px), number(words.size_px),
                         number(words.align), number(words.room_px), number(words.strength));
  }
  return fill_template(templates, "povray/plate.pov",
                       {{"width", std::to_string(plate.width_px)},
                        {"height", std::to_string(plate.height_px)},
                        {"marks", marks}});
}

}  // namespace mien
