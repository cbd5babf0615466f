#include "timeline/exposure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/text.hpp"
#include "timeline/chart.hpp"
#include "timeline/drawings.hpp"

namespace mien {
namespace {

constexpr double kSame = 1e-9;  // rounding is no move
constexpr double kSameTime_s = 1e-6;

bool has_changed(const ChartRow& row, int frame) {
  const auto now = static_cast<std::size_t>(frame);
  return std::ranges::any_of(row.values, [&](const std::vector<double>& values) {
    return std::abs(values[now] - values[now - 1]) > kSame;
  });
}

bool has_changed(const CameraKey& from, const CameraKey& to) {
  return std::abs(to.angle_deg - from.angle_deg) > kSame ||
         std::abs(to.height_deg - from.height_deg) > kSame || std::abs(to.distance - from.distance) > kSame;
}

std::map<int, std::string> find_key_labels(const ClipSpec& clip) {
  std::map<int, std::string> labels;
  for (const PoseKey& key : clip.keys) {
    const int frame = compute_key_frame(clip, key.at_s);
    if (compute_drawing_time_s(clip, frame) < key.at_s - kSameTime_s) continue;  // after the last drawing
    std::string& label = labels[frame];
    label += (label.empty() ? "" : ", ") + key.label;
  }
  return labels;
}

// The sounds that begin with each frame.
std::map<int, std::string> find_sounds(const ClipSpec& clip) {
  std::map<int, std::string> sounds;
  for (const SpokenWord& phoneme : clip.phonemes)
    sounds[static_cast<int>(std::floor(phoneme.from_s * clip.fps + kSameTime_s))] += phoneme.text;
  return sounds;
}

// A word of the sheet. One that a table program might take for a formula is made plain text.
std::string quote(const std::string& word) {
  const bool is_formula = !word.empty() && std::string_view("=+-@\t").find(word[0]) != std::string_view::npos;
  std::string quoted = is_formula ? "'" : "";
  for (const char c : word) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted.find_first_of(",\"\n\r") == std::string::npos ? quoted : "\"" + quoted + "\"";
}

// The rows that changed; of an area whose sides both did, its plural.
std::vector<std::string> list_changed(const std::vector<ChartRow>& rows, int frame) {
  std::vector<std::string> changed;
  for (const ChartRow& row : rows) {
    if (!has_changed(row, frame)) continue;
    const std::string stem = row.name.substr(0, row.name.find('.'));
    if (row.name == stem + ".right" && !changed.empty() && changed.back() == stem + ".left")
      changed.back() = stem + "s";
    else
      changed.push_back(row.name);
  }
  return changed;
}

}  // namespace

int compute_key_frame(const ClipSpec& clip, double time_s) {
  const int last = count_frames(clip) - 1;
  int frame = std::clamp(static_cast<int>(std::ceil(time_s * clip.fps - kSameTime_s)), 0, last);
  while (frame < last && compute_drawing_time_s(clip, frame) < time_s - kSameTime_s) ++frame;
  return frame;
}

std::vector<ExposureLine> build_exposure(const Performance& performance) {
  const Rehearsal rehearsal = rehearse(performance);
  const std::vector<int> first = compute_drawings(performance.clip, {rehearsal.drawings});
  const std::vector<ChartRow> rows = list_chart_rows(rehearsal.shown);
  const std::map<int, std::string> labels = find_key_labels(performance.clip);
  const std::map<int, std::string> sounds = find_sounds(performance.clip);
  std::map<int, int> numbers;  // of drawings, by their first frames
  std::vector<ExposureLine> lines;
  CameraKey before;
  for (int frame = 0; frame < static_cast<int>(first.size()); ++frame) {
    ExposureLine line;
    line.frame = frame + 1;
    line.time_s = static_cast<double>(frame) / performance.clip.fps;
    const int shown = first[static_cast<std::size_t>(frame)];
    line.drawing = numbers.emplace(shown, static_cast<int>(numbers.size()) + 1).first->second;
    line.is_held = frame > 0 && shown == first[static_cast<std::size_t>(frame - 1)];
    if (const auto label = labels.find(frame); label != labels.end()) line.key = label->second;
    if (const auto sound = sounds.find(frame); sound != sounds.end()) line.sound = sound->second;
    const CameraKey camera =
        sample_performance(performance, compute_drawing_time_s(performance.clip, frame)).camera;
    if (frame > 0) line.changed = list_changed(rows, frame);
    if (frame > 0 && has_changed(before, camera)) line.changed.emplace_back("camera");
    before = camera;
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string build_exposure_csv(const std::vector<ExposureLine>& lines) {
  const bool speaks =
      std::ranges::any_of(lines, [](const ExposureLine& line) { return !line.sound.empty(); });
  std::string csv = fmt::format("frame,time_s,drawing,held,key,changed{}\n", speaks ? ",sound" : "");
  for (const ExposureLine& line : lines) {
    std::string changed;
    for (const std::string& area : line.changed) changed += (changed.empty() ? "" : " ") + area;
    csv += fmt::format("{},{},{},{},{},{}{}\n", line.frame, format_number(line.time_s, 6), line.drawing,
                       line.is_held ? "held" : "", quote(line.key), quote(changed),
                       speaks ? "," + quote(line.sound) : "");
  }
  return csv;
}

}  // namespace mien
