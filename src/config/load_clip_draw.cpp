#include <algorithm>

#include "config/load_clip.hpp"

namespace mien {

namespace {

constexpr int kMaxDraw = 12;  // held longer, a clip is a row of stills

}  // namespace

void load_draw(const YamlMapping& entries, ClipSpec& clip) {
  const YamlValue* value = find_value(entries, "draw");
  if (value == nullptr) return;
  const YamlNode& node = find_node(*value);
  if (node.kind == NodeKind::text && !parse_number(node.text)) {
    std::string name;
    if (load_name(*value, "draw", kDraws, name))
      clip.draw = 1 + static_cast<int>(std::ranges::find(kDraws, name) - kDraws.begin());
  } else {
    load_whole(*value, 1, kMaxDraw, clip.draw, "frames a drawing");
  }
}

}  // namespace mien
