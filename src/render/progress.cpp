#include "render/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/clock.hpp"
#include "core/streams.hpp"
#include "render/terminal.hpp"

namespace mien {

namespace {

constexpr double kRedraw_s = 0.1;      // faster flickers and costs
constexpr double kLineGap_s = 5;       // between two lines of a log
constexpr double kLineSilence_s = 60;  // after which a log wants a sign of life
constexpr int kWidest = 80;            // columns; a longer bar is not easier to read
constexpr int kLongestBar = 32, kShortestBar = 8;

constexpr const char* kEraseLine = "\r\x1b[2K";

ProgressState find_state(const Progress& progress) {
  return {progress.label, progress.rendered, progress.kept, progress.total,
          read_clock_s() - progress.started_s};
}

double compute_speed(const ProgressState& state) {
  return state.elapsed_s > 0 ? state.rendered / state.elapsed_s : 0;
}

std::string format_speed(const ProgressState& state) {
  const double speed = compute_speed(state);
  if (speed >= 99.5) return fmt::format("{:.0f} {}/s", speed, state.label);
  return fmt::format("{:.{}f} {}/s", speed, speed >= 0.95 ? 1 : 2, state.label);
}

std::string format_time_left(const ProgressState& state) {
  return format_duration(std::ceil((state.total - state.rendered - state.kept) / compute_speed(state))) +
         " left";
}

std::string repeat(std::string_view text, std::size_t count) {
  std::string repeated;
  for (std::size_t i = 0; i < count; ++i) repeated += text;
  return repeated;
}

// The bar's "[####----]" as a coloured line, if the terminal's letters and the user's taste allow.
std::string paint_bar(const std::string& text) {
  const std::size_t open = text.find('['), close = text.find(']');
  if (open == std::string::npos || close == std::string::npos) return text;
  const auto full = static_cast<std::size_t>(std::count(text.begin() + open, text.begin() + close, '#'));
  const std::size_t rest = close - open - 1 - full;
  const bool is_utf8 = has_utf8(), has_colour = std::getenv("NO_COLOR") == nullptr;
  if (!is_utf8 && !has_colour) return text;
  std::string bar = is_utf8 ? repeat("━", full) : repeat("#", full);
  std::string track = is_utf8 ? repeat(has_colour ? "━" : "╌", rest) : repeat("-", rest);
  if (has_colour) {
    bar = "\x1b[36m" + bar + "\x1b[0m";
    track = "\x1b[2m" + track + "\x1b[0m";
  }
  if (!is_utf8) {
    bar = "[" + bar;
    track += "]";
  }
  return text.substr(0, open) + bar + track + text.substr(close + 1);
}

void draw_bar(const Progress& progress) {
  const std::string text =
      format_progress_bar(find_state(progress), compute_terminal_width(progress.stream, kWidest));
  write_stream(progress.stream, kEraseLine + paint_bar(text));
}

void print_line(const Progress& progress) {
  const ProgressState state = find_state(progress);
  const int done = state.rendered + state.kept;
  std::string line =
      fmt::format("{}: {}/{} ({} %)", state.label, done, state.total, 100 * done / state.total);
  if (state.rendered > 0) line += fmt::format(", {}, {}", format_speed(state), format_time_left(state));
  write_stream(progress.stream, line + "\n");
}

void print_json(const Progress& progress, const nlohmann::ordered_json& event) {
  write_stream(progress.stream, event.dump() + "\n");
}

}  // namespace

ProgressStyle compute_progress_style(std::FILE* stream, bool is_quiet, bool is_json) {
  if (is_quiet) return ProgressStyle::quiet;
  if (is_json) return ProgressStyle::json;
  const char* terminal = std::getenv("TERM");
  const bool can_erase = terminal != nullptr && std::string_view(terminal) != "dumb";
  return can_erase && is_terminal(stream) ? ProgressStyle::bar : ProgressStyle::lines;
}

Progress::Progress(std::FILE* stream_, ProgressStyle style_, std::string label_, int total_)
    : stream(stream_), style(style_), label(std::move(label_)), total(total_), started_s(read_clock_s()) {
  last_shown_s = started_s;
  if (style == ProgressStyle::bar && total > 0) draw_bar(*this);
}

Progress::~Progress() {
  if (style != ProgressStyle::bar || is_finished) return;
  write_stream(stream, kEraseLine);
}

void Progress::clear() {
  const std::lock_guard lock(mutex);
  if (style != ProgressStyle::bar || is_finished) return;
  write_stream(stream, kEraseLine);
  last_shown_s = 0;
}

void Progress::advance(bool was_kept, int frame_number) {
  const std::lock_guard lock(mutex);
  (was_kept ? kept : rendered) += 1;
  const int done = rendered + kept;
  if (style == ProgressStyle::json) {
    nlohmann::ordered_json event{{"event", "frame"}, {"stage", label}};
    if (frame_number > 0) event["frame"] = frame_number;
    event.update({{"done", done}, {"total", total}, {"kept", kept}});
    return print_json(*this, event);
  }
  const double now_s = read_clock_s(), silence_s = now_s - last_shown_s;
  const int tenth = 10 * done / std::max(total, 1);
  const bool is_line_due =
      done < total && silence_s >= kLineGap_s && (tenth > last_shown_tenth || silence_s >= kLineSilence_s);
  if (style == ProgressStyle::bar && silence_s >= kRedraw_s)
    draw_bar(*this);
  else if (style == ProgressStyle::lines && is_line_due)
    print_line(*this);
  else
    return;
  last_shown_s = now_s;
  last_shown_tenth = tenth;
}

void Progress::finish() {
  const std::lock_guard lock(mutex);
  if (is_finished) return;
  is_finished = true;
  const double elapsed_s = read_clock_s() - started_s;
  if (style == ProgressStyle::quiet) return;
  if (style == ProgressStyle::json)
    return print_json(*this, {{"event", "stage"},
                              {"stage", label},
                              {"rendered", rendered},
                              {"kept", kept},
                              {"total", total},
                              {"seconds", std::round(elapsed_s * 1000) / 1000}});
  std::string text = fmt::format("{}: {} done", label, rendered);
  if (kept > 0) text += fmt::format(", {} kept", kept);
  text += elapsed_s < 9.95 ? fmt::format(" in {:.1f} s", elapsed_s) : " in " + format_duration(elapsed_s);
  write_stream(stream, fmt::format("{}{}\n", style == ProgressStyle::bar ? kEraseLine : "", text));
}

std::string format_progress_bar(const ProgressState& state, int width) {
  const int done = state.rendered + state.kept, total = std::max(state.total, 1);
  const int label_width = static_cast<int>(state.label.size());
  const std::string count = fmt::format("{}/{}", done, state.total);
  // Room for the longest words, so that the bar keeps its length: "48/48", "99.9 frames/s", "59 min 59 s
  // left".
  const int count_width = 2 * static_cast<int>(std::to_string(state.total).size()) + 1;
  const int speed_width = label_width + 7, time_width = 16, gap = 2;
  const int bare =
      width - label_width - gap - 2 - gap - count_width;  // for the bar if no word follows the count
  if (bare < kShortestBar) return fmt::format("{} {}", state.label, count).substr(0, std::max(width, 0));
  const bool has_speed = bare - gap - speed_width >= kShortestBar;
  const bool has_time = has_speed && bare - gap - speed_width - gap - time_width >= kShortestBar;
  const int length =
      std::min(bare - has_speed * (gap + speed_width) - has_time * (gap + time_width), kLongestBar);

  const int full = static_cast<int>(static_cast<long long>(length) * std::min(done, total) / total);
  std::string text = fmt::format("{}  [{}{}]  {:>{}}", state.label, repeat("#", full),
                                 repeat("-", length - full), count, count_width);
  if (state.rendered == 0 || done >= state.total) return text;
  if (has_speed) text += fmt::format("  {}", format_speed(state));
  if (has_time) text += fmt::format("  {}", format_time_left(state));
  return text.substr(0, width);
}

std::string format_duration(double seconds) {
  if (!std::isfinite(seconds)) return "?";
  const long long whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace mien
