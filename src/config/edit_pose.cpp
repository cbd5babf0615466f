#include "config/edit_pose.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/facs_notation.hpp"
#include "config/load_spec.hpp"
#include "config/sections.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

constexpr int kDecimals = 3;      // of a limit: fewer are seen as a step when a slider is dragged
constexpr double kSame = 0.0005;  // values nearer than that are written alike

// The areas that make one pose of another.
struct AreaWords {
  std::string text;       // "brows: {up: 0.5}, lips: {press: 0.2}"
  std::size_t moves = 0;  // that it sets
};

double find_most(std::size_t move, double value, double reach) {
  const double limit = std::abs(value < 0 ? kMoves[move].low : kMoves[move].high);
  return find_stop(move, value).empty() ? limit * reach : limit;
}

// No face goes further.
Pose hold_within(Pose pose) {
  for (std::size_t i = 0; i < kMoveCount; ++i)
    pose.values[i] =
        std::clamp(pose.values[i], -find_most(i, -1, kMaxExaggerate), find_most(i, 1, kMaxExaggerate));
  return pose;
}

// How many times its limits a pose goes, in hundredths, at least once.
double compute_reach_of(const Pose& pose) {
  double reach = 1;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (find_stop(i, pose.values[i]).empty() && find_most(i, pose.values[i], 1) > 0)
      reach = std::max(reach, std::abs(pose.values[i]) / find_most(i, pose.values[i], 1));
  return std::min(kMaxExaggerate, std::ceil((reach - kSame) * 100) / 100);
}

// What is written of each move; empty where it is as in `base` already.
using MoveWords = std::array<std::string, kMoveCount>;

std::string format_moves(const MoveWords& words, const AreaInfo& area, Side side, bool is_both) {
  std::string text;
  for (const MoveInfo& info : kMovesOfOneSide) {
    if (info.of != area.area) continue;
    std::string value = words[*find_move(area.area, side, info.move)];
    if (side != Side::none) {
      const Side other = side == Side::left ? Side::right : Side::left;
      const bool is_same = value == words[*find_move(area.area, other, info.move)];
      if (is_same != is_both) continue;
    }
    if (!value.empty()) text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", info.move, value);
  }
  return text;
}

std::string format_areas(const MoveWords& words) {
  std::string text;
  const auto append = [&](std::string_view key, const std::string& moves) {
    if (!moves.empty()) text += fmt::format("{}{}: {{{}}}", text.empty() ? "" : ", ", key, moves);
  };
  for (const AreaInfo& area : kAreas) {
    if (!area.has_sides()) {
      append(area.name, format_moves(words, area, Side::none, false));
      continue;
    }
    append(area.plural, format_moves(words, area, Side::left, true));
    append(area.left_key, format_moves(words, area, Side::left, false));
    append(area.right_key, format_moves(words, area, Side::right, false));
  }
  return text;
}

// Empty if the pose is out of reach.
std::optional<AreaWords> find_areas(const Pose& pose, const HeldPose& base, double exaggerate) {
  AreaWords areas;
  MoveWords words;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const double value = pose.values[i];
    if (std::abs(value - base.pose.values[i]) < kSame) continue;
    if (std::abs(value) > find_most(i, value, base.reach) + kSame) return {};
    words[i] = format_number(value / exaggerate, kDecimals);
    ++areas.moves;
  }
  areas.text = format_areas(words);
  return areas;
}

// The face of a key that says nothing but how far its areas may go.
HeldPose compute_rest(const ExpressionBook& book, double exaggerate) {
  const auto neutral = find_expression(book, "neutral");
  return hold_pose({neutral ? book.expressions[*neutral].pose : Pose{}, 1, 1, {}, exaggerate});
}

// With the key's own `express`; empty if no areas beside it make the pose.
std::optional<AreaWords> find_areas_beside(const YamlMapping& key, const ExpressionBook& book,
                                           const Pose& pose) {
  const YamlValue* express = find_value(key, "express");
  if (express == nullptr) return {};
  Findings findings;
  YamlMapping entries;
  for (const YamlEntry& entry : key)
    if (entry.key == "express" || entry.key == "strength" || entry.key == "exaggerate") {
      entries.push_back(entry);
      entries.back().value.findings = &findings;
    }
  const Express shown = load_posed(entries, book);
  if (!findings.mistakes.empty()) return {};  // a formula, too
  double exaggerate = book.exaggerate;
  load_exaggerate(entries, exaggerate);
  return find_areas(pose, {shown.pose, shown.reach, {}}, exaggerate);
}

}  // namespace

ExpressionBook load_book(const YamlValue& root, const Language& language) {
  ExpressionBook book = language.libraries;
  append_notations(*root.document, book);
  const YamlMapping file = load_section(root, find_sections().file);
  if (const YamlValue* library = find_value(file, "library"))
    load_name(*library, "library", book.libraries, book.library);
  else if (const YamlValue* doctrine = find_value(file, "doctrine"))
    if (std::string word; load_name(*doctrine, "doctrine", kDoctrines, word) && word != kDoctrines.front())
      book.library = word;
  load_exaggerate(file, book.exaggerate);
  if (const YamlValue* expressions = find_value(file, "expressions")) {
    std::vector<ExpressionDraft> drafts;
    load_drafts(*expressions, "", book, drafts);
    build_drafts(drafts, book);
  }
  return book;
}

PoseWords find_pose_words(const YamlMapping& key, const ExpressionBook& book, const Pose& asked) {
  const Pose pose = hold_within(asked);
  double exaggerate = book.exaggerate;
  load_exaggerate(key, exaggerate);
  PoseWords words;
  std::optional<AreaWords> alone = find_areas(pose, compute_rest(book, exaggerate), exaggerate);
  if (!alone) {
    exaggerate = compute_reach_of(pose);
    alone = find_areas(pose, compute_rest(book, exaggerate), exaggerate);
    words.exaggerate = format_number(exaggerate, 2);
  }
  words.areas = alone ? alone->text : "";
  const auto beside = find_areas_beside(key, book, pose);
  if (!beside || (alone && beside->moves >= alone->moves)) return words;
  return {true, "", beside->text};
}

}  // namespace mien
