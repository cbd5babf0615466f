// A strip of drawings with the curves of what moves under it, as one SVG file that needs no other.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mien {

// One drawing of the strip.
struct StripPicture {
  std::string png;      // the file's content
  std::string caption;  // "smile 0.8"; in-betweens have none
  double time_s = 0;
  int frame = 1;  // from 1
  bool is_key = false;
};

// One area: a curve for each of its moves.
struct StripRow {
  std::string name;
  std::vector<std::string> moves;
  std::vector<std::vector<double>> values;  // by frame from 0; 1 and -1 are the limits
};

struct StripMark {
  double time_s = 0;
  std::string label;
};

struct StripPage {
  std::string title, note;
  int fps = 24, frame_count = 1;
  int picture_width_px = 160, picture_height_px = 200;
  std::vector<StripPicture> pictures;  // by time
  std::vector<StripMark> keys;
  std::vector<double> blinks_s;
  std::vector<StripRow> rows;
};

// The page. The same page gives the same bytes; whatever the words hold, they stay words.
std::string build_strip_svg(const StripPage& page);

// `text` as XML shows it, in elements and in attributes: '<', '>', '&' and both quotes are written as
// entities, control characters are left out.
std::string escape_xml(std::string_view text);

// RFC 4648, with padding.
std::string encode_base64(std::string_view bytes);

}  // namespace mien
