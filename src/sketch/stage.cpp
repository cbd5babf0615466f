#include "sketch/stage.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace mien {

namespace {

// The values of a block that stand before its first word, or behind a word.
std::vector<SdlValue> list_values(const SdlBlock& block, std::string_view word) {
  std::vector<SdlValue> values;
  bool is_here = word.empty();
  for (const SdlItem& item : block.items) {
    if (!item.is_value && is_here && !values.empty()) break;
    if (item.is_value && is_here) values.push_back(item.value);
    if (!item.is_value && item.word == word) is_here = true;
  }
  return values;
}

SketchLamp build_lamp(const SdlBlock& block) {
  SketchLamp lamp;
  const std::vector<SdlValue> values = list_values(block, "");
  if (values.size() < 2) throw RunError("a light needs a place and a colour");
  lamp.at = glm::vec3(values[0].vector());
  lamp.colour = glm::vec3(values[1].vector());
  lamp.has_shadow = !has_word(block, "shadowless");
  if (const std::vector<SdlValue> area = list_values(block, "area_light"); area.size() >= 4) {
    lamp.side = glm::vec3(area[0].vector());
    lamp.other_side = glm::vec3(area[1].vector());
  }
  if (const SdlValue* const value = find_value(block, "fade_distance"))
    lamp.fade_distance = static_cast<float>(value->number());
  if (const SdlValue* const value = find_value(block, "fade_power"))
    lamp.fade_power = static_cast<float>(value->number());
  return lamp;
}

SketchCard build_card(const SdlBlock& block) {
  SketchCard card;
  const std::vector<SdlValue> values = list_values(block, "");
  card.is_ball = block.name == "sphere";
  if (values.size() < 2) throw RunError("a card needs two values");
  card.low = glm::vec3(values[0].vector());
  card.high = glm::vec3(values[1].vector());
  glm::dmat4 place_from_card(1);
  for (std::size_t i = 0; i + 1 < block.items.size(); ++i) {
    const std::string& word = block.items[i].word;
    if (word != "scale" && word != "rotate" && word != "translate") continue;
    place_from_card = build_transform(word, block.items[i + 1].value.vector()) * place_from_card;
  }
  card.card_from_place = glm::mat4x3(glm::mat4(glm::inverse(place_from_card)));
  if (const SdlBlock* const pigment = find_block(block, "pigment"))
    card.colour = build_sketch_pigment(*pigment).colour.rgb;
  return card;
}

SketchCamera build_camera(const SdlBlock& block) {
  SketchCamera camera;
  const auto find = [&](const char* word) {
    const SdlValue* const value = find_value(block, word);
    if (!value) throw RunError("a camera without " + std::string(word));
    return value->vector();
  };
  const glm::dvec3 at = find("location"), forward = glm::normalize(find("look_at") - at);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), forward));
  camera.at = glm::vec3(at);
  camera.forward = glm::vec3(forward * glm::length(find("direction")));
  camera.right = glm::vec3(right * glm::length(find("right")));
  camera.up = glm::vec3(glm::cross(forward, right) * glm::length(find("up")));
  camera.is_orthographic = has_word(block, "orthographic");
  return camera;
}

// How far along a ray a card is met, in the ray's own length; negative if it is not.
float find_card(const SketchCard& card, const glm::vec3& from, const glm::vec3& direction) {
  const glm::vec3 o = card.card_from_place * glm::vec4(from, 1),
                  d = card.card_from_place * glm::vec4(direction, 0);
  if (card.is_ball) {
    const float a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - 1, root = b * b - a * c;
    return root < 0 ? -1 : (-b - std::sqrt(root)) / a;
  }
  float first = 0, last = 1e9f;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(d[i]) < 1e-12f) {
      if (o[i] < card.low[i] || o[i] > card.high[i]) return -1;
      continue;
    }
    const float a = (card.low[i] - o[i]) / d[i], b = (card.high[i] - o[i]) / d[i];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last ? first : -1;
}

}  // namespace

SketchStage build_sketch_stage(const std::string& include, const std::string& start, int width_px,
                               int height_px) {
  SketchStage stage;
  const auto set = [&](const char* name, double value) {
    stage.names.values[name] = {{value, value, value, value, value}, 1};
  };
  set("image_width", width_px);
  set("image_height", height_px);
  read_sdl(include, "head.inc", stage.names);
  const SdlBlock all = read_sdl(start, "frame", stage.names);
  for (const SdlItem& item : all.items) {
    if (!item.block) continue;
    const SdlBlock& block = *item.block;
    if (item.word == "camera") stage.camera = build_camera(block);
    if (item.word == "light_source") stage.lamps.push_back(build_lamp(block));
    if (item.word == "box" || item.word == "sphere") stage.cards.push_back(build_card(block));
    if (item.word == "sky_sphere")
      if (const SdlBlock* const pigment = find_block(block, "pigment"))
        stage.sky = build_sketch_pigment(*pigment);
  }
  return stage;
}

glm::vec4 sample_sky(const SketchStage& stage, const glm::vec3& direction) {
  const SketchColour sky = sample_pigment(stage.sky, {glm::normalize(direction), {}, {}});
  const float there = 1 - sky.transmit;
  return {there * sky.rgb, there};
}

glm::vec3 sample_cards(const SketchStage& stage, const glm::vec3& from, const glm::vec3& direction) {
  float nearest = 1e9f;
  glm::vec3 colour(0);
  for (const SketchCard& card : stage.cards) {
    const float at = find_card(card, from, direction);
    if (at <= 0 || at >= nearest) continue;
    nearest = at;
    colour = card.colour;
  }
  return colour;
}

}  // namespace mien
