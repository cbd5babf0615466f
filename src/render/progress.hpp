// How long work is told: a bar on a terminal, plain lines elsewhere, JSON lines on request, or nothing.
#pragma once

#include <cstdio>
#include <mutex>
#include <string>

namespace mien {

enum class ProgressStyle { bar, lines, json, quiet };

// bar if `stream` is a terminal, else lines.
ProgressStyle find_progress_style(std::FILE* stream, bool is_quiet, bool is_json);

// Counts frames done; shows frames, frames a second and the time left. All writes go to one stream. Not
// copied. Safe to call from several threads.
struct Progress {
  Progress(std::FILE* stream, ProgressStyle style, std::string label, int total);
  void advance(bool was_kept);  // one frame more
  void finish();                // closes the bar; says how many were rendered and kept, and the time

  std::FILE* stream;
  ProgressStyle style;
  std::string label;
  int total;
  int rendered = 0, kept = 0;
  double started_s = 0, last_shown_s = 0;
  std::mutex mutex;
};

// "frames  [#########-----------]  18/48  2.1 frames/s  14 s left": the bar's text, `width` columns at most.
std::string format_progress_bar(const std::string& label, int done, int total, double elapsed_s, int width);

}  // namespace mien
