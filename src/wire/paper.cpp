// SVG 1.1, "Paths"; and the same strokes as pixels, by each pixel's distance from the pen's way.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "scene/strip.hpp"
#include "sketch/lettering.hpp"
#include "wire/drawing.hpp"

namespace mien {

namespace {

using Colour = std::array<std::uint8_t, 3>;

std::string format_colour(const Colour& srgb) {
  return fmt::format("#{:02x}{:02x}{:02x}", srgb[0], srgb[1], srgb[2]);
}

// Of one colour and width, one after the other.
bool is_one_pen(const PaperStroke& a, const PaperStroke& b) {
  return a.width_px == b.width_px && a.srgb == b.srgb;
}

std::string number(double value) { return format_number(value, 2); }

// A Helvetica capital's share of the letter's size.
constexpr double kCapital = 0.716;

void append_svg_words(const PaperWords& words, std::string& svg) {
  svg += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n",
                     number(words.at_px.x), number(words.at_px.y), number(words.capital_px / kCapital),
                     words.align == 0   ? "start"
                     : words.align == 1 ? "end"
                                        : "middle",
                     format_colour(words.srgb),
                     words.is_serif ? " font-family=\"Georgia, 'Times New Roman', serif\"" : "",
                     escape_xml(words.words));
}

// How much of each pixel strokes of one pen cover.
struct Cover {
  PictureSize size;
  std::vector<float> share;

  explicit Cover(const PictureSize& size_)
      : size(size_), share(static_cast<std::size_t>(size_.width_px) * size_.height_px, 0.0f) {}

  void add_way(const glm::dvec2& from, const glm::dvec2& to, double width_px) {
    const double half_px = std::max(1.0, width_px) / 2, most = std::min(1.0, width_px);
    const glm::dvec2 low = glm::min(from, to) - (half_px + 0.5), high = glm::max(from, to) + (half_px + 0.5);
    const int left = std::max(0, static_cast<int>(std::floor(low.x))),
              right = std::min(size.width_px, static_cast<int>(std::ceil(high.x))),
              top = std::max(0, static_cast<int>(std::floor(low.y))),
              bottom = std::min(size.height_px, static_cast<int>(std::ceil(high.y)));
    const glm::dvec2 way = to - from;
    const double length = glm::dot(way, way);
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) {
        const glm::dvec2 p(x + 0.5, y + 0.5);
        const double t = length > 0 ? std::clamp(glm::dot(p - from, way) / length, 0.0, 1.0) : 0;
        const double off_px = glm::distance(p, from + t * way);
        const auto cover = static_cast<float>(most * std::clamp(half_px + 0.5 - off_px, 0.0, 1.0));
        float& here = share[static_cast<std::size_t>(y) * size.width_px + x];
        here = std::max(here, cover);
      }
  }
};

}  // namespace

void append_plate(const Plate& plate, Paper& paper) {
  constexpr double kPlateCapital = 0.66;  // of the size that a plate's letters have
  const Colour ink = PaperWords{}.srgb, ground = paper.srgb;
  const auto mix = [&](double strength) {
    Colour mixed{};
    for (std::size_t i = 0; i < 3; ++i)
      mixed[i] = static_cast<std::uint8_t>(std::lround(std::lerp(ground[i], ink[i], strength)));
    return mixed;
  };
  paper.size = {plate.width_px, plate.height_px};
  for (const PlateRule& rule : plate.rules) {
    const double y = rule.y_px + rule.thickness_px / 2;
    paper.strokes.push_back(
        {{{rule.x_px, y}, {rule.x_px + rule.width_px, y}}, rule.thickness_px, mix(rule.strength)});
  }
  for (const PlateLine& line : plate.lines)
    paper.strokes.push_back(
        {{{line.x_px, line.y_px}, {line.to_x_px, line.to_y_px}}, line.thickness_px, mix(line.strength)});
  for (const PlateWords& words : plate.words)
    paper.words.push_back({words.words,
                           {words.x_px, words.y_px},
                           kPlateCapital * words.size_px,
                           words.align,
                           words.room_px,
                           mix(words.strength),
                           words.is_serif});
}

std::string build_paper_svg(const Paper& paper) {
  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" "
      "height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, sans-serif\">\n"
      "<title>{2}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"{3}\"/>\n",
      paper.size.width_px, paper.size.height_px, escape_xml(paper.title), format_colour(paper.srgb));
  const std::vector<PaperStroke>& strokes = paper.strokes;
  for (std::size_t i = 0; i < strokes.size();) {
    svg += fmt::format(
        "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\" d=\"",
        format_colour(strokes[i].srgb), number(strokes[i].width_px));
    const std::size_t first = i;
    for (; i < strokes.size() && is_one_pen(strokes[first], strokes[i]); ++i) {
      const char* word = i == first ? "M" : "\nM";
      for (const glm::dvec2& p : strokes[i].points_px) {
        svg += fmt::format("{}{} {}", word, number(p.x), number(p.y));
        word = " ";
      }
    }
    svg += "\"/>\n";
  }
  for (const PaperWords& words : paper.words) append_svg_words(words, svg);
  return svg + "</svg>\n";
}

void draw_strokes(const std::vector<PaperStroke>& strokes, Pixels& picture) {
  for (std::size_t i = 0; i < strokes.size();) {
    Cover cover(picture.size);
    const std::size_t first = i;
    for (; i < strokes.size() && strokes[first].srgb == strokes[i].srgb; ++i)
      for (std::size_t k = 0; k + 1 < strokes[i].points_px.size(); ++k)
        cover.add_way(strokes[i].points_px[k], strokes[i].points_px[k + 1], strokes[i].width_px);
    for (std::size_t pixel = 0; pixel < cover.share.size(); ++pixel)
      if (cover.share[pixel] > 0)
        cover_pixel(picture, pixel, strokes[first].srgb, static_cast<double>(cover.share[pixel]));
  }
}

Pixels build_paper_pixels(const Paper& paper, const Letters& letters) {
  Pixels picture = make_pixels(paper.size);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) picture.rgb[i] = paper.srgb[i % 3];
  draw_strokes(paper.strokes, picture);
  for (const PaperWords& words : paper.words) {
    WrittenLine line{words.words,   words.at_px.x - words.align * words.room_px,
                     words.at_px.y, words.capital_px,
                     words.room_px, words.align,
                     words.srgb};
    write_line(picture, line, letters);
  }
  return picture;
}

}  // namespace mien
