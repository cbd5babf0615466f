#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/constants.hpp"
#include "config/sections.hpp"

namespace mien {

namespace {

// "240*k x 300*k".
void load_size_formula(const YamlValue& value, RenderSpec& render) {
  const auto size = load_two_constants(value);
  if (!size) return;
  const Form& form = find_form(value, FormKind::size);
  const auto is_right = [&](double side_px) {
    return side_px >= form.low && side_px <= form.high && side_px == std::floor(side_px);
  };
  if (!is_right(size->first) || !is_right(size->second))
    return add_mistake(value,
                       fmt::format("{} is the formula '{}', which comes to {:.7g}x{:.7g}; expected a width "
                                   "and a height from {} to {} pixels",
                                   describe_subject(value), show_word(find_node(value).text), size->first,
                                   size->second, form.low, form.high));
  render.width_px = static_cast<int>(size->first);
  render.height_px = static_cast<int>(size->second);
}

void load_size(const YamlValue& value, RenderSpec& render) {
  if (is_two_constants(value)) return load_size_formula(value, render);
  const YamlNode& node = find_node(value);
  const auto size = node.kind == NodeKind::text ? parse_size(node.text) : std::nullopt;
  if (!size) {
    add_unexpected(value, "a width and a height such as 480x600");
    return;
  }
  const Form& form = find_form(value, FormKind::size);
  const auto is_right = [&](int side_px) { return side_px >= form.low && side_px <= form.high; };
  if (!is_right(size->first) || !is_right(size->second)) {
    add_unexpected(value, fmt::format("a width and a height from {} to {} pixels", form.low, form.high));
    return;
  }
  render.width_px = size->first;
  render.height_px = size->second;
}

InkColours load_ink(const YamlValue& value) {
  InkColours ink;
  const YamlMapping entries = load_section(value);
  const auto load = [&](const char* key, glm::vec3& into) {
    const YamlValue* colour = find_value(entries, key);
    return colour != nullptr && load_colour(*colour, into);
  };
  load("line", ink.line);
  load("mouth", ink.cavity);
  load("tongue", ink.flesh);
  load("teeth", ink.bone);
  glm::vec3 colour;
  if (load("shade", colour)) ink.shade = colour;
  if (load("blush", colour)) ink.blush = colour;
  return ink;
}

}  // namespace

RenderSpec load_render(const YamlValue& value) {
  RenderSpec render;
  const YamlMapping entries = load_section(value);
  if (const YamlValue* size = find_value(entries, "size")) load_size(*size, render);
  std::string quality;
  if (const YamlValue* name = find_value(entries, "quality"); name != nullptr && load_name(*name, quality))
    render.quality = static_cast<Quality>(std::ranges::find(kQualities, quality) - kQualities.begin());
  if (const YamlValue* name = find_value(entries, "background"))
    render.is_background_given = load_name(*name, render.background);
  std::string style;
  if (const YamlValue* name = find_value(entries, "style"); name != nullptr && load_name(*name, style)) {
    render.style = find_style(style);
    render.is_style_given = true;
  }
  if (const YamlValue* line = find_value(entries, "line")) load_number(*line, render.line);
  if (const YamlValue* ink = find_value(entries, "ink")) render.ink = load_ink(*ink);
  return render;
}

}  // namespace mien
