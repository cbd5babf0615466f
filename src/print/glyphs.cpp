#include "print/glyphs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/error.hpp"
#include "core/print_numbers.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"

namespace mien {

namespace {

std::vector<std::string_view> split(std::string_view text, char by) {
  std::vector<std::string_view> parts;
  for (std::size_t end = 0; end != std::string_view::npos; text.remove_prefix(end + 1)) {
    end = text.find(by);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) break;
  }
  return parts;
}

std::optional<double> read_number(std::string_view word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<Stroke> read_stroke(std::string_view text) {
  Stroke stroke;
  const auto words = split(text, ' ');
  if (words.size() < 4 || words.size() % 2 != 0) return std::nullopt;
  for (std::size_t i = 0; i < words.size(); i += 2) {
    const auto x = read_number(words[i]), y = read_number(words[i + 1]);
    if (!x || !y) return std::nullopt;
    stroke.emplace_back(*x, *y);
  }
  return stroke;
}

bool read_letter(std::string_view line, Letters& letters) {
  const auto fields = split(line, ';');
  if (fields.size() != 3) return false;
  const auto width = read_number(fields[1]);
  if (!width) return false;
  Glyph glyph{*width, {}};
  if (!fields[2].empty())
    for (const std::string_view part : split(fields[2], '|')) {
      const auto stroke = read_stroke(part);
      if (!stroke) return false;
      glyph.strokes.push_back(*stroke);
    }
  if (fields[0] == "box")
    letters.box = glyph;
  else if (fields[0] == "space")
    letters.glyphs[U' '] = glyph;
  else if (fields[0].size() == 1)
    letters.glyphs[static_cast<unsigned char>(fields[0][0])] = glyph;
  else
    return false;
  return true;
}

// A character and its bytes.
struct Letter {
  char32_t code = 0;
  std::string bytes;
};

// What is no UTF-8 is U+FFFD, a letter a byte, and what cannot be seen a blank.
std::vector<Letter> list_letters(const std::string& text) {
  std::vector<Letter> letters;
  for (std::size_t at = 0; at < text.size();) {
    const auto [code, length] = find_character(text, at);
    if (length == 0)
      letters.push_back({0xFFFD, "\xEF\xBF\xBD"});
    else if (code < 32 || code == 127)
      letters.push_back({U' ', " "});
    else
      letters.push_back({code, text.substr(at, length)});
    at += std::max<std::size_t>(length, 1);
  }
  return letters;
}

const Glyph& find_glyph(const Letters& letters, char32_t code) {
  const char32_t capital = code >= U'a' && code <= U'z' ? code - 32 : code;
  const auto found = letters.glyphs.find(capital);
  return found == letters.glyphs.end() ? letters.box : found->second;
}

struct Setting {
  double unit_mm = 0, pen_mm = 0, gap_mm = 0;
  explicit Setting(double size_mm)
      : unit_mm((size_mm - compute_pen_mm(size_mm)) / kCapital),
        pen_mm(compute_pen_mm(size_mm)),
        gap_mm(std::max(kLeastLetterGap_mm, kLetterGap * unit_mm)) {}
  double measure(const Letters& letters, const std::vector<Letter>& line) const {
    double width = line.empty() ? 0 : -gap_mm;
    for (const Letter& c : line) width += find_glyph(letters, c.code).width * unit_mm + pen_mm + gap_mm;
    return width;
  }
};

}  // namespace

double compute_pen_mm(double size_mm) { return std::max(kLeastPen_mm, kPenShare * size_mm); }

Letters build_letters(const Template& table) {
  Letters letters;
  int number = 0;
  for (const std::string_view line : split(table.text, '\n')) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    if (!read_letter(line, letters)) throw RunError(fmt::format("{}:{}: not a letter", table.origin, number));
  }
  return letters;
}

Letters find_letters(const Templates& templates) {
  return build_letters(find_template(templates, "openscad/letters.csv"));
}

Label set_label(const Letters& letters, const std::string& text, double size_mm, double least_mm,
                double width_mm) {
  std::vector<Letter> line = list_letters(text);
  while (!line.empty() && line.back().code == U' ') line.pop_back();
  Label label;
  label.size_mm = size_mm;
  const auto is_wide = [&] { return Setting(label.size_mm).measure(letters, line) > width_mm; };
  // Beyond so many letters it cannot fit, whatever they are: a dot is as wide as a pen.
  const auto most =
      static_cast<std::size_t>(std::max(0.0, width_mm / (kLeastPen_mm + kLeastLetterGap_mm))) + 1;
  if (line.size() > most) line.resize(most), label.is_cut = true;
  while (is_wide() && label.size_mm * kLetterShrink >= least_mm) label.size_mm *= kLetterShrink;
  while (is_wide() && !line.empty()) line.pop_back(), label.is_cut = true;
  if (!line.empty() && label.size_mm < least_mm) line.clear(), label.is_cut = true;

  const Setting setting(label.size_mm);
  label.pen_mm = setting.pen_mm;
  label.width_mm = setting.measure(letters, line);
  double x = -label.width_mm / 2 + setting.pen_mm / 2;
  for (const Letter& c : line) {
    const Glyph& glyph = find_glyph(letters, c.code);
    for (const Stroke& stroke : glyph.strokes) {
      Stroke& set = label.strokes.emplace_back();
      for (const glm::dvec2& p : stroke)
        set.emplace_back(x + p.x * setting.unit_mm, setting.pen_mm / 2 + p.y * setting.unit_mm);
    }
    x += glyph.width * setting.unit_mm + setting.pen_mm + setting.gap_mm;
    label.text += c.bytes;
  }
  return label;
}

double compute_stroke_distance(const std::vector<Stroke>& strokes, const glm::dvec2& p) {
  double least = 1e9;
  for (const Stroke& stroke : strokes)
    for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
      const glm::dvec2 way = stroke[i + 1] - stroke[i], to = p - stroke[i];
      const double square = glm::dot(way, way);
      const double share = square > 0 ? std::clamp(glm::dot(to, way) / square, 0.0, 1.0) : 0;
      least = std::min(least, glm::length(to - share * way));
    }
  return least;
}

std::string build_openscad_strokes(const std::vector<Stroke>& strokes) {
  std::string text = "[";
  for (const Stroke& stroke : strokes) {
    text += text.size() > 1 ? ", [" : "[";
    for (std::size_t i = 0; i < stroke.size(); ++i) {
      text += i > 0 ? ", [" : "[";
      append_number(text, stroke[i].x, 3);
      text += ", ";
      append_number(text, stroke[i].y, 3);
      text += "]";
    }
    text += "]";
  }
  return text + "]";
}

std::string build_openscad_letters(const Letters& letters) {
  std::string text = "letters = [\n";
  for (const auto& [code, glyph] : letters.glyphs)
    text += fmt::format("  [\"{}\", {}, {}],\n", static_cast<char>(code), format_number(glyph.width, 3),
                        build_openscad_strokes(glyph.strokes));
  text += fmt::format("  [\"\", {}, {}]];\n", format_number(letters.box.width, 3),
                      build_openscad_strokes(letters.box.strokes));
  return text;
}

}  // namespace mien
