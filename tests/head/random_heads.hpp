// Heads of all kinds from a seed: ages, skulls, character and every feature there is.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <string>

#include "config/spec.hpp"
#include "config/words.hpp"
#include "core/data.hpp"
#include "head/shapes.hpp"

namespace mien {

inline Mix build_random_mix(std::mt19937& random, const Names& names, std::size_t most) {
  std::uniform_real_distribution<double> weight(0.05, 1);
  Mix mix;
  for (std::size_t i = 0, count = 1 + random() % most; i < count; ++i)
    mix[names[random() % names.size()]] = weight(random);
  double sum = 0;
  for (const auto& [name, value] : mix) sum += value;
  for (auto& [name, value] : mix) value /= sum;
  return mix;
}

// Every feature of templates/head/features.yaml has a value in its range.
inline HeadSpec build_random_spec(unsigned seed, const HeadShapes& shapes) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  HeadSpec spec;
  spec.age = build_random_mix(random, kAges, 3);
  spec.skull = build_random_mix(random, kSkulls, 2);
  spec.character = value(random);
  for (const auto& [name, handles] : shapes.features) spec.features[name] = value(random);
  return spec;
}

// As it would stand in a file, to look at a head that failed.
inline std::string describe_spec(const HeadSpec& spec) {
  const auto list = [](const std::map<std::string, double>& values) {
    std::string text;
    for (const auto& [name, value] : values)
      text += fmt::format("{}{}: {:.9g}", text.empty() ? "" : ", ", name, value);
    return text;
  };
  return fmt::format("head: {{age: {{{}}}, skull: {{{}}}, character: {:.9g}, features: {{{}}}}}",
                     list(spec.age), list(spec.skull), spec.character, list(spec.features));
}

}  // namespace mien
