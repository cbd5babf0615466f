// A drawn head to test: its figure, its ink, and a drawing of both.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "frames/ink.hpp"
#include "frames/ink_strokes.hpp"
#include "head/cage.hpp"
#include "shipped.hpp"
#include "timeline/head_turn.hpp"

namespace mien {

inline HeadSpec make_spec(const std::string& design) {
  HeadSpec spec;
  spec.design = {{design, 1.0}};
  spec.hair = "bob";
  return spec;
}

struct Subject {
  Figure figure;
  Ink ink;
};

inline Subject build_subject(const HeadSpec& spec) {
  Subject made;
  made.figure = build_figure(shipped().heads, spec, FigureUse::ink);
  made.ink = build_ink(made.figure, spec);
  return made;
}

inline Subject build_of_age(const char* age) {
  HeadSpec spec = make_spec("comic");
  spec.age = {{age, 1.0}};
  return build_subject(spec);
}

inline const Subject& comic() {
  static const Subject subject = build_subject(make_spec("comic"));
  return subject;
}

inline Pose make_pose(std::initializer_list<std::pair<const char*, double>> values) {
  Pose pose;
  for (const auto& [name, value] : values) {
    const std::string text = name;
    const std::string area = text.substr(0, text.find('.')), move = text.substr(text.find('.') + 1);
    for (const Side side : {Side::none, Side::left, Side::right})
      if (const auto found = find_move(area, side, move)) pose.values[*found] = value;
  }
  return pose;
}

inline Drawing draw(const Subject& subject, const Pose& pose, const TurnKey& turn, const InkView& view) {
  DeformBuffers deform;
  InkBuffers buffers;
  Drawing drawing;
  deform_figure(subject.figure, pose, turn, deform, drawing);
  draw_ink(subject.ink, pose, view, buffers, drawing);
  return drawing;
}

inline std::size_t find_part(const Model& model, std::string_view name) {
  for (std::size_t i = 0; i < model.parts.size(); ++i)
    if (model.parts[i].name == name) return i;
  ADD_FAILURE() << "no part " << name;
  return 0;
}

// The vertices of a stroke among the lines: the first one of that name.
inline std::vector<glm::vec3> find_stroke(const Subject& subject, const Drawing& drawing,
                                          std::string_view name) {
  std::size_t first = 0;
  for (const InkStroke& stroke : subject.ink.strokes) {
    if (stroke.rule.name == name) break;
    if (!stroke.rule.is_brow) first += kStrokeVertices;
  }
  const std::vector<glm::vec3>& p = drawing.parts[find_part(subject.ink.model, "lines")].positions;
  EXPECT_LE(first + kStrokeVertices, p.size()) << name;
  const auto begin = p.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + kStrokeVertices};
}

// How far the skin's outline stands off the skin, at most, so near to a point of the cage.
inline double measure_outline_mm(const Subject& subject, const char* name, float reach_mm,
                                 const InkView& view, const Pose& pose = {}) {
  const Drawing drawing = draw(subject, pose, TurnKey{}, view);
  const glm::vec3 at = drawing.parts.front().positions[find_point(subject.figure.head.cage, name)];
  double off_mm = 0;
  for (const glm::vec3& p : drawing.parts[subject.ink.first_outline].positions) {
    if (glm::distance(p, at) > reach_mm) continue;
    float nearest = 1e9f;
    for (const glm::vec3& v : drawing.parts.front().positions)
      nearest = std::min(nearest, glm::distance(v, p));
    off_mm = std::max(off_mm, static_cast<double>(nearest));
  }
  return off_mm;
}

// How wide a stroke is at its widest, mm.
inline double measure_width(const std::vector<glm::vec3>& stroke) {
  double most = 0;
  for (std::size_t ring = 0; ring < stroke.size(); ring += kStrokeSpokes)
    most = std::max(most, static_cast<double>(glm::distance(stroke[ring], stroke[ring + kStrokeSpokes / 2])));
  return most;
}

}  // namespace mien
