#include "timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <random>
#include <string_view>

#include "config/load_spec.hpp"
#include "core/text.hpp"
#include "timeline/performance.hpp"

namespace mien {

namespace {

double read_clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The least of three: the others tell of the machine's mood.
double time_s(const std::function<void()>& work) {
  double least_s = 1e9;
  for (int round = 0; round < 3; ++round) {
    const double start_s = read_clock_s();
    work();
    least_s = std::min(least_s, read_clock_s() - start_s);
  }
  return least_s;
}

}  // namespace

std::string build_hour() {
  constexpr std::array<std::string_view, 8> kFaces{"smile", "surprise", "anger",   "sadness",
                                                   "doubt", "fear",     "neutral", "contempt"};
  constexpr std::array<std::string_view, 5> kGazes{"camera", "left", "right", "up",
                                                   "{side: 12deg, up: 3deg}"};
  std::mt19937_64 random(1990);
  const auto pick = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  std::string text =
      "mien: 1\nclip:\n  length: 3600s\n  blink: natural\n  drift: 0.4\n  asymmetry: 0.05\n"
      "  inputs: {mood: \"0.5 + 0.3*sin(t/7)\"}\n"
      "  scripts: {nod: {turn: [{at: 0s}, {at: 0.2s, nod: 6deg}, {at: 0.5s, nod: 0deg}]}}\n"
      "  laws:\n"
      "    - {area: brows, move: up, value: \"0.2*mood*sin(2*pi*t/3)\", rule: add}\n"
      "    - {area: lids, move: lower, value: \"0.1 + 0.1*sin(2*pi*t/5)\", rule: max}\n";
  text += "  keys:\n";
  for (int i = 0; i < 1800; ++i)
    text += fmt::format("    - {{at: {}s, express: {}, strength: 0.{}}}\n", 2 * i,
                        kFaces[pick(kFaces.size())], 4 + pick(6));
  text += "  turn:\n";
  for (int i = 0; i < 1200; ++i)
    text += fmt::format("    - {{at: {}s, turn: {}deg, nod: {}deg}}\n", 3 * i,
                        static_cast<int>(pick(41)) - 20, static_cast<int>(pick(21)) - 10);
  text += "  camera:\n";
  for (int i = 0; i < 360; ++i)
    text += fmt::format("    - {{at: {}s, angle: {}deg}}\n", 10 * i, static_cast<int>(pick(61)) - 30);
  text += "  cues:\n";
  for (int i = 0; i < 900; ++i) {
    text += fmt::format(
        "    - {{from: {}s, express: {}, areas: [lips, corners, chin], attack: 0.2s, hold: 0.5s}}\n", 4 * i,
        "aeiou"[pick(5)]);
    if (i % 3 == 0) text += fmt::format("    - {{from: {}.3s, play: nod, repeat: 2}}\n", 4 * i);
  }
  text += "  gaze:\n    wander: 0.3\n    keys:\n";
  for (int i = 0; i < 1200; ++i)
    text += fmt::format("      - {{at: {}s, look: {}}}\n", 3 * i, kGazes[pick(kGazes.size())]);
  return text;
}

void measure_timeline(const std::filesystem::path& data, const std::filesystem::path& folder,
                      const std::function<double(const std::filesystem::path&)>& check,
                      const PrintRow& print) {
  const std::filesystem::path file = folder / "hour.yaml";
  write_file(file, build_hour());
  double check_s = 1e9;
  for (int round = 0; round < 3; ++round) check_s = std::min(check_s, check(file));
  print("an hour checked", fmt::format("{:.2f} s", check_s),
        "mien check, 86400 frames, all layers (target 2)");

  const LanguagePointer language = load_language(data);
  Spec spec;
  print("an hour read", fmt::format("{:.2f} s", time_s([&] { spec = load_spec(file, *language); })),
        "of that, the file alone");
  const Performance performance = build_performance(spec.clip);
  const int frames = count_frames(spec.clip);
  double sum = 0;  // so that the work is not left out
  const double sampled_s = time_s([&] {
    for (int frame = 0; frame < frames; ++frame)
      sum += sample_performance(performance, compute_drawing_time_s(spec.clip, frame)).pose.values[0];
  });
  print("poses sampled", fmt::format("{:.0f} /s", frames / sampled_s),
        fmt::format("one core, all layers (target 100000; the mean of a brow is {:.2f})", sum / frames / 3));
}

}  // namespace mien
