#include "voice/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/process.hpp"
#include "render/work_folder.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr int kRate = 16000;
constexpr double kWindow_s = 0.01, kSilence_s = 0.2;
constexpr double kLoud = 0.05;      // of the loudest moments
constexpr double kLoudest = 0.95;   // of all windows are quieter than those
constexpr double kQuietest = 1e-4;  // of full scale: below it is no voice at all

// The loudness of each window, 0..1.
std::vector<double> read_loudness(const fs::path& sound) {
  const WorkFolder work(fs::temp_directory_path());
  const fs::path raw = work.path / "samples";
  const ProcessResult result =
      run_process({"ffmpeg", "-v", "error", "-y", "-i", fs::absolute(sound).string(), "-ac", "1", "-ar",
                   fmt::format("{}", kRate), "-f", "s16le", raw.string()},
                  work.path);
  if (result.exit_code != 0)
    throw RunError(format_failure("cannot read " + sound.string(), "ffmpeg", result.output));
  const std::string bytes = read_file(raw);
  constexpr auto kCount = static_cast<std::size_t>(kRate * kWindow_s);
  std::vector<double> loudness;
  for (std::size_t at = 0; at + 2 * kCount <= bytes.size(); at += 2 * kCount) {
    double sum = 0;
    for (std::size_t i = 0; i < kCount; ++i) {
      std::int16_t sample = 0;
      std::memcpy(&sample, bytes.data() + at + 2 * i, 2);
      sum += std::pow(sample / 32768.0, 2);
    }
    loudness.push_back(std::sqrt(sum / kCount));
  }
  return loudness;
}

// Spans that are nearer to each other than a pause are one.
void append_span(double from_s, double to_s, std::vector<VoicedSpan>& spans) {
  if (!spans.empty() && from_s - spans.back().to_s < kSilence_s)
    spans.back().to_s = std::max(spans.back().to_s, to_s);
  else
    spans.push_back({from_s, to_s});
}

double compute_share(double time_s, const VoicedSpan& span) {
  return span.to_s > span.from_s ? (time_s - span.from_s) / (span.to_s - span.from_s) : 0;
}

}  // namespace

std::vector<VoicedSpan> find_voiced(const fs::path& sound) {
  const std::vector<double> loudness = read_loudness(sound);
  std::vector<double> sorted = loudness;
  std::ranges::sort(sorted);
  const double loudest =
      sorted.empty() ? 0
                     : sorted[static_cast<std::size_t>(kLoudest * static_cast<double>(sorted.size() - 1))];
  std::vector<VoicedSpan> spans;
  for (std::size_t i = 0; i < loudness.size(); ++i)
    if (loudness[i] > std::max(kLoud * loudest, kQuietest))
      append_span(kWindow_s * static_cast<double>(i), kWindow_s * static_cast<double>(i + 1), spans);
  return spans;
}

std::vector<VoicedSpan> find_voiced(const std::vector<SpeechSound>& sounds) {
  std::vector<VoicedSpan> spans;
  for (const SpeechSound& sound : sounds)
    if (!sound.ipa.empty()) append_span(sound.from_s, sound.to_s, spans);
  return spans;
}

double warp_time_s(double time_s, const std::vector<VoicedSpan>& from, const std::vector<VoicedSpan>& to) {
  if (from.empty() || to.empty()) return time_s;
  if (from.size() != to.size()) {
    const double share = compute_share(time_s, {from.front().from_s, from.back().to_s});
    return std::lerp(to.front().from_s, to.back().to_s, std::clamp(share, 0.0, 1.0));
  }
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (time_s > from[i].to_s && i + 1 < from.size()) {
      if (time_s >= from[i + 1].from_s) continue;
      return std::lerp(to[i].to_s, to[i + 1].from_s,
                       compute_share(time_s, {from[i].to_s, from[i + 1].from_s}));
    }
    return std::lerp(to[i].from_s, to[i].to_s, std::clamp(compute_share(time_s, from[i]), 0.0, 1.0));
  }
  return to.back().to_s;
}

}  // namespace mien
