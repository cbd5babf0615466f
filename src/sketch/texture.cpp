#include "sketch/texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "core/error.hpp"
#include "sketch/noise.hpp"

namespace mien {

namespace {

SketchColour make_colour(const SdlValue& value) {
  return {glm::vec3(value.vector()), value.size == 1 ? 0.0f : static_cast<float>(value.v[3]),
          value.size == 1 ? 0.0f : static_cast<float>(value.v[4])};
}

// A colour and the words behind it that change it ("rgb 1 filter 1"); `i` stays on the last of them.
SketchColour read_colour(const SdlBlock& block, std::size_t& i) {
  SketchColour colour = make_colour(block.items[i].value);
  while (i + 2 < block.items.size() && block.items[i + 2].is_value) {
    const std::string& word = block.items[i + 1].word;
    if (word != "filter" && word != "transmit") break;
    (word == "filter" ? colour.filter : colour.transmit) =
        static_cast<float>(block.items[i + 2].value.number());
    i += 2;
  }
  return colour;
}

SketchStop read_stop(const SdlBlock& entry) {
  if (entry.items.size() < 2 || !entry.items[0].is_value) throw RunError("a map's entry needs a value first");
  SketchStop stop;
  stop.at = static_cast<float>(entry.items[0].value.number());
  std::size_t second = 1;
  if (entry.items.size() == 2 && entry.items[1].is_value) {
    stop.colour = read_colour(entry, second);
    return stop;
  }
  if (entry.items[1].is_value && entry.items.size() > 2 &&
      (entry.items[2].word == "filter" || entry.items[2].word == "transmit")) {
    stop.colour = read_colour(entry, second);
    return stop;
  }
  SdlBlock inner;
  inner.items.assign(entry.items.begin() + 1, entry.items.end());
  stop.pigment = std::make_shared<SketchPigment>(build_sketch_pigment(inner));
  return stop;
}

bool is_transform(std::string_view word) {
  return word == "scale" || word == "translate" || word == "rotate" || word == "matrix";
}

// The transform at `i` behind those that were read; `i` goes to its last item.
void add_transform(const SdlBlock& block, std::size_t& i, glm::dmat4& place_from_pattern) {
  const SdlItem& item = block.items[i];
  glm::dmat4 step(1);
  if (item.word == "matrix") {
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 3; ++row)
        step[column][row] = item.matrix[static_cast<std::size_t>(3 * column + row)];
  } else {
    if (++i >= block.items.size() || !block.items[i].is_value)
      throw RunError(fmt::format("'{}' without its value", item.word));
    step = build_transform(item.word, block.items[i].value.vector());
  }
  place_from_pattern = step * place_from_pattern;
}

glm::mat4x3 invert(const glm::dmat4& place_from_pattern) {
  return glm::mat4x3(glm::mat4(glm::inverse(place_from_pattern)));
}

glm::vec3 find_pattern_place(bool is_on_grain, const glm::mat4x3& pattern_from_place,
                             const SketchPlace& place) {
  return pattern_from_place * glm::vec4(is_on_grain ? glm::vec3(place.grain, 0) : place.at, 1);
}

// 0..1, of all patterns but `average`.
float compute_pattern(const SketchPigment& pigment, const SketchPlace& place) {
  if (pigment.pattern == SketchPattern::slope) {
    const float cosine = std::clamp(glm::dot(place.normal, pigment.axis), -1.0f, 1.0f);
    const float value = 1 - std::acos(cosine) / std::numbers::pi_v<float>;
    return std::clamp((value - pigment.low) / (pigment.high - pigment.low), 0.0f, 1.0f);
  }
  const glm::vec3 at = find_pattern_place(pigment.is_on_grain, pigment.pattern_from_place, place);
  switch (pigment.pattern) {
    case SketchPattern::gradient: {
      const float along = glm::dot(at, pigment.axis);
      return along - std::floor(along);
    }
    case SketchPattern::bozo:
      return compute_noise(at);
    case SketchPattern::spherical:
      return std::max(0.0f, 1 - glm::length(at));
    case SketchPattern::function:
      return static_cast<float>(evaluate(pigment.function, at));
    default:
      return 0;
  }
}

void add_colour(SketchColour& sum, const SketchColour& colour, float share) {
  sum.rgb += share * colour.rgb;
  sum.filter += share * colour.filter;
  sum.transmit += share * colour.transmit;
}

float read_finish(const SdlBlock& finish, std::string_view word, float otherwise) {
  const SdlValue* const value = find_value(finish, word);
  return value ? static_cast<float>(value->number()) : otherwise;
}

SketchFinish build_finish(const SdlBlock* block) {
  SketchFinish finish;
  if (!block) return finish;
  finish.diffuse = read_finish(*block, "diffuse", 0.6f);
  finish.brilliance = read_finish(*block, "brilliance", 1);
  finish.specular = read_finish(*block, "specular", 0);
  finish.roughness = read_finish(*block, "roughness", 0.05f);
  finish.phong = read_finish(*block, "phong", 0);
  finish.phong_size = read_finish(*block, "phong_size", 40);
  finish.metallic = read_finish(*block, "metallic", 0);
  if (const SdlValue* const emission = find_value(*block, "emission"))
    finish.emission = glm::vec3(emission->vector());
  if (const SdlBlock* const reflection = find_block(*block, "reflection"))
    if (!reflection->items.empty())
      finish.reflection = static_cast<float>(reflection->items[0].value.number());
  return finish;
}

// "normal { uv_mapping bumps DEPTH scale S }"; others (wrinkles, crackle) are finer than a sketch is, and so
// are hills that hardly bend light.
SketchBumps build_bumps(const SdlBlock* block) {
  constexpr float kShallowest = 0.08f;
  SketchBumps bumps;
  if (!block) return bumps;
  if (const SdlValue* const depth = find_value(*block, "bumps"))
    bumps.depth = static_cast<float>(depth->number());
  if (bumps.depth < kShallowest) bumps.depth = 0;
  bumps.is_on_grain = has_word(*block, "uv_mapping");
  glm::dmat4 place_from_pattern(1);
  for (std::size_t i = 0; i < block->items.size(); ++i)
    if (is_transform(block->items[i].word)) add_transform(*block, i, place_from_pattern);
  bumps.pattern_from_place = invert(place_from_pattern);
  return bumps;
}

}  // namespace

glm::dmat4 build_transform(std::string_view word, const glm::dvec3& v) {
  glm::dmat4 step(1);
  if (word == "scale") return glm::scale(step, v);
  if (word == "translate") return glm::translate(step, v);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 around(0);
    around[axis] = 1;
    step = glm::rotate(glm::dmat4(1), glm::radians(v[axis]), around) * step;
  }
  return step;
}

SketchPigment build_sketch_pigment(const SdlBlock& block) {
  SketchPigment pigment;
  glm::dmat4 place_from_pattern(1);
  for (std::size_t i = 0; i < block.items.size(); ++i) {
    const SdlItem& item = block.items[i];
    if (item.is_value) {
      pigment.colour = read_colour(block, i);
    } else if (item.word == "uv_mapping") {
      pigment.is_on_grain = true;
    } else if (item.word == "gradient" && i + 1 < block.items.size()) {
      pigment.pattern = SketchPattern::gradient;
      pigment.axis = glm::vec3(block.items[++i].value.vector());
    } else if (item.word == "bozo") {
      pigment.pattern = SketchPattern::bozo;
    } else if (item.word == "spherical") {
      pigment.pattern = SketchPattern::spherical;
    } else if (item.word == "average") {
      pigment.pattern = SketchPattern::average;
    } else if (item.word == "slope" && item.block) {
      pigment.pattern = SketchPattern::slope;
      std::vector<const SdlValue*> values;
      for (const SdlItem& inner : item.block->items)
        if (inner.is_value) values.push_back(&inner.value);
      if (values.size() != 3) throw RunError("slope needs a direction and two numbers");
      pigment.axis = glm::normalize(glm::vec3(values[0]->vector()));
      pigment.low = static_cast<float>(values[1]->number());
      pigment.high = static_cast<float>(values[2]->number());
    } else if (item.word == "function" && item.block) {
      pigment.pattern = SketchPattern::function;
      pigment.function = item.block->function;
    } else if (item.word == "color_map" || item.word == "pigment_map") {
      for (const SdlItem& entry : item.block->items) pigment.stops.push_back(read_stop(*entry.block));
    } else if (is_transform(item.word)) {
      add_transform(block, i, place_from_pattern);
    } else {
      throw RunError(fmt::format("a pigment's '{}' is not known here", item.word));
    }
  }
  pigment.pattern_from_place = invert(place_from_pattern);
  return pigment;
}

SketchTexture build_sketch_texture(const SdlBlock& block) {
  SketchTexture texture;
  if (const SdlBlock* const map = find_block(block, "texture_map")) {
    SdlBlock pattern = block;
    std::erase_if(pattern.items, [](const SdlItem& item) { return item.word == "texture_map"; });
    texture.choice = build_sketch_pigment(pattern);
    for (const SdlItem& entry : map->items) {
      if (!entry.block || entry.block->items.empty()) throw RunError("a texture_map's entry is empty");
      texture.from.push_back(static_cast<float>(entry.block->items[0].value.number()));
      texture.others.push_back(build_sketch_texture(*entry.block));
    }
    return texture;
  }
  if (const SdlBlock* const pigment = find_block(block, "pigment"))
    texture.pigment = build_sketch_pigment(*pigment);
  texture.finish = build_finish(find_block(block, "finish"));
  texture.bumps = build_bumps(find_block(block, "normal"));
  return texture;
}

SketchColour sample_pigment(const SketchPigment& pigment, const SketchPlace& place) {
  if (pigment.pattern == SketchPattern::plain) return pigment.colour;
  const std::vector<SketchStop>& stops = pigment.stops;
  SketchColour sum;
  if (stops.empty()) return sum;
  // What lies within is turned and scaled with it.
  SketchPlace within = place;
  within.at = find_pattern_place(pigment.is_on_grain, pigment.pattern_from_place, place);
  const auto sample_stop = [&](const SketchStop& stop) {
    return stop.pigment ? sample_pigment(*stop.pigment, within) : stop.colour;
  };
  if (pigment.pattern == SketchPattern::average) {
    float weights = 0;
    for (const SketchStop& stop : stops) weights += stop.at;
    for (const SketchStop& stop : stops) add_colour(sum, sample_stop(stop), stop.at / weights);
    return sum;
  }
  const float value = compute_pattern(pigment, place);
  std::size_t above = 0;
  while (above < stops.size() && stops[above].at <= value) ++above;
  if (above == 0) return sample_stop(stops.front());
  if (above == stops.size()) return sample_stop(stops.back());
  const SketchStop &low = stops[above - 1], &high = stops[above];
  const float share = (value - low.at) / (high.at - low.at);
  add_colour(sum, sample_stop(low), 1 - share);
  add_colour(sum, sample_stop(high), share);
  return sum;
}

const SketchTexture& find_texture(const SketchTexture& texture, const SketchPlace& place) {
  if (texture.others.empty()) return texture;
  const float value = compute_pattern(texture.choice, place);
  std::size_t above = 0;
  while (above < texture.from.size() && texture.from[above] <= value) ++above;
  return find_texture(texture.others[above == 0 ? 0 : above - 1], place);
}

glm::vec3 bend_normal(const SketchBumps& bumps, const SketchPlace& place) {
  if (bumps.depth == 0) return place.normal;
  const glm::vec3 at = find_pattern_place(bumps.is_on_grain, bumps.pattern_from_place, place);
  return glm::normalize(place.normal + bumps.depth * compute_vector_noise(at));
}

}  // namespace mien
