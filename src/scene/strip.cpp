#include "scene/strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.hpp"

namespace mien {
namespace {

// The page, px.
constexpr double kMargin = 40, kGap = 12;
constexpr double kNameWidth = 150;  // left of the curves: the areas' names and their moves
constexpr double kCaption = 34;     // below a picture: two lines
constexpr double kLine = 13;        // between the baselines of a row's moves
constexpr double kLeastRow = 54;    // a curve's height from one limit to the other
constexpr double kLeastWidth = 1100;
constexpr int kMostAcross = 8;
constexpr std::size_t kMostPoints = 2000;  // of a curve: more lie closer than a pixel
constexpr double kBeyond = 1.15;           // values past a limit are drawn here

constexpr const char* kInk = "#2b2723";
constexpr const char* kPaper = "#fbf8f1";
constexpr const char* kPale = "#d9d2c3";
constexpr const char* kRed = "#b5482f";
constexpr std::array kCurves{"#2f5d8a", "#b5482f", "#5c7f3b"};  // a row's first move, second, third

std::string number(double value) { return format_number(value, 2); }

// What an element's attributes come to: " x=\"12\" y=\"5\"".
std::string at(const char* x_name, double x, const char* y_name, double y) {
  return fmt::format(" {}=\"{}\" {}=\"{}\"", x_name, number(x), y_name, number(y));
}

struct Style {
  double size_px = 12;
  const char* fill = kInk;
  const char* anchor = "start";
  bool is_bold = false;
};

void append_words(std::string& svg, double x, double y, std::string_view words, const Style& style) {
  svg += fmt::format("<text{} font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
                     at("x", x, "y", y), number(style.size_px), style.fill, style.anchor,
                     style.is_bold ? " font-weight=\"bold\"" : "", escape_xml(words));
}

void append_line(std::string& svg, double x1, double y1, double x2, double y2, const char* colour,
                 const char* more = "") {
  svg += fmt::format("<line{}{} stroke=\"{}\"{}/>\n", at("x1", x1, "y1", y1), at("x2", x2, "y2", y2), colour,
                     more);
}

// Where the page's parts stand.
struct Frame {
  int across = 1;
  double width = kLeastWidth, pictures_top = 110, curves_top = 0, height = 0;
  double left = kMargin + kNameWidth, right = 0;  // of the curves
};

double compute_row_height(const StripRow& row) {
  return std::max(kLeastRow, 20 + kLine * static_cast<double>(row.moves.size()));
}

Frame find_frame(const StripPage& page) {
  Frame frame;
  const int count = static_cast<int>(page.pictures.size());
  frame.across = std::clamp(count, 1, kMostAcross);
  frame.width = std::max(kLeastWidth, 2 * kMargin + frame.across * (page.picture_width_px + kGap) - kGap);
  frame.right = frame.width - kMargin;
  const int lines = (count + frame.across - 1) / frame.across;
  frame.curves_top = frame.pictures_top + lines * (page.picture_height_px + kCaption + kGap) + 46;
  frame.height = frame.curves_top + kMargin;
  for (const StripRow& row : page.rows) frame.height += compute_row_height(row) + kGap;
  return frame;
}

double compute_x(const StripPage& page, const Frame& frame, double time_s) {
  const double end_s = static_cast<double>(page.frame_count) / page.fps;
  return frame.left + (frame.right - frame.left) * std::clamp(time_s / end_s, 0.0, 1.0);
}

void append_pictures(std::string& svg, const StripPage& page, const Frame& frame) {
  const double width = page.picture_width_px, height = page.picture_height_px;
  for (std::size_t i = 0; i < page.pictures.size(); ++i) {
    const StripPicture& picture = page.pictures[i];
    const int line = static_cast<int>(i) / frame.across, column = static_cast<int>(i) % frame.across;
    const double x = kMargin + column * (width + kGap);
    const double y = frame.pictures_top + line * (height + kCaption + kGap);
    svg += fmt::format("<image{}{} href=\"data:image/png;base64,{}\"/>\n", at("x", x, "y", y),
                       at("width", width, "height", height), encode_base64(picture.png));
    svg += fmt::format("<rect{}{} fill=\"none\" stroke=\"{}\"{}/>\n", at("x", x, "y", y),
                       at("width", width, "height", height), picture.is_key ? kRed : kPale,
                       picture.is_key ? " stroke-width=\"2\"" : "");
    append_words(svg, x, y + height + 14,
                 fmt::format("{}  frame {}, {} s", i + 1, picture.frame, format_number(picture.time_s, 2)),
                 {11, picture.is_key ? kRed : kInk});
    append_words(svg, x, y + height + 28, picture.caption, {11, kInk, "start", true});
  }
}

void append_ruler(std::string& svg, const StripPage& page, const Frame& frame) {
  const double end_s = static_cast<double>(page.frame_count) / page.fps;
  constexpr std::array kSteps_s{0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 60.0, 300.0, 600.0, 3600.0};
  double step_s = kSteps_s.back();
  for (const double candidate_s : kSteps_s)
    if (end_s / candidate_s <= 16) {  // words stand free of each other
      step_s = candidate_s;
      break;
    }
  for (int i = 0; i * step_s < end_s; ++i) {
    const double x = compute_x(page, frame, i * step_s);
    append_words(svg, x, frame.curves_top - 30, format_number(i * step_s, 2) + " s", {10, kInk, "middle"});
    append_line(svg, x, frame.curves_top - 26, x, frame.height - kMargin, kPale, " stroke-dasharray=\"1 3\"");
  }
}

// Keys as red lines, blinks as grey ones, and the strip's drawings by their numbers.
void append_marks(std::string& svg, const StripPage& page, const Frame& frame) {
  for (const double blink_s : page.blinks_s) {
    const double x = compute_x(page, frame, blink_s);
    append_line(svg, x, frame.curves_top, x, frame.height - kMargin, kPale, " stroke-width=\"3\"");
  }
  for (const StripMark& key : page.keys) {
    const double x = compute_x(page, frame, key.time_s);
    append_line(svg, x, frame.curves_top - 6, x, frame.height - kMargin, kRed, " stroke-opacity=\"0.5\"");
  }
  for (std::size_t i = 0; i < page.pictures.size(); ++i)
    append_words(svg, compute_x(page, frame, page.pictures[i].time_s), frame.curves_top - 10,
                 std::to_string(i + 1), {10, page.pictures[i].is_key ? kRed : kInk, "middle"});
}

void append_curve(std::string& svg, const StripPage& page, const Frame& frame, double middle, double half,
                  const std::vector<double>& values, const char* colour) {
  const std::size_t stride = values.size() / kMostPoints + 1;
  std::string points;
  for (std::size_t i = 0; i < values.size(); i += stride) {
    const double time_s = static_cast<double>(i) / page.fps;
    const double y = middle - half * std::clamp(values[i], -kBeyond, kBeyond);
    points +=
        fmt::format("{}{},{}", points.empty() ? "" : " ", number(compute_x(page, frame, time_s)), number(y));
  }
  svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", points,
                     colour);
}

void append_rows(std::string& svg, const StripPage& page, const Frame& frame) {
  double top = frame.curves_top;
  for (const StripRow& row : page.rows) {
    const double height = compute_row_height(row), middle = top + height / 2;
    append_line(svg, frame.left, middle, frame.right, middle, kPale);
    for (const double limit : {-1.0, 1.0})
      append_line(svg, frame.left, middle + limit * height / 2 / kBeyond, frame.right,
                  middle + limit * height / 2 / kBeyond, kPale, " stroke-dasharray=\"4 4\"");
    append_words(svg, kMargin, top + 14, row.name, {13, kInk, "start", true});
    for (std::size_t i = 0; i < row.values.size(); ++i) {
      const char* colour = kCurves[i % kCurves.size()];
      append_words(svg, kMargin + 10, top + 14 + kLine * static_cast<double>(i + 1), row.moves.at(i),
                   {11, colour});
      append_curve(svg, page, frame, middle, height / 2 / kBeyond, row.values[i], colour);
    }
    top += height + kGap;
  }
}

}  // namespace

std::string build_strip_svg(const StripPage& page) {
  const Frame frame = find_frame(page);
  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" "
      "height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, sans-serif\">\n"
      "<title>{2}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"{3}\"/>\n",
      number(frame.width), number(frame.height), escape_xml(page.title), kPaper);
  append_words(svg, kMargin, 58, page.title, {26, kInk, "start", true});
  append_words(svg, kMargin, 82, page.note, {13, kInk});
  append_pictures(svg, page, frame);
  append_ruler(svg, page, frame);
  append_marks(svg, page, frame);
  append_rows(svg, page, frame);
  return svg + "</svg>\n";
}

std::string escape_xml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '&')
      escaped += "&amp;";
    else if (c == '"')
      escaped += "&quot;";
    else if (c == '\'')
      escaped += "&#39;";
    else if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7F)
      escaped += c;
  }
  return escaped;
}

std::string encode_base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[bits >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

}  // namespace mien
