// A drawn head to test: its figure, its ink, and a drawing of both.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <utility>

#include "frames/ink.hpp"
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

}  // namespace mien
