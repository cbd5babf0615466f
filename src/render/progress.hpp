// How long work is told: a bar on a terminal, plain lines elsewhere, JSON lines on request, or nothing.
#pragma once

#include <cstdio>
#include <mutex>
#include <string>

namespace mien {

enum class ProgressStyle { bar, lines, json, quiet };

// bar if `stream` is a terminal that can erase a line, else lines. Quiet wins over JSON.
ProgressStyle compute_progress_style(std::FILE* stream, bool is_quiet, bool is_json);

// Counts frames done; shows frames, frames a second and the time left. All writes go to one stream; one that
// takes nothing keeps nobody from working. Not copied. Safe to call from several threads.
//
// bar: redrawn ten times a second at most; erased by finish(), or by the destructor if work ended early, so
// that an error message begins on a clean line. Drawn in UTF-8 where the locale has it, coloured unless
// NO_COLOR is set.
//
// lines: at each tenth and at least once a minute, but five seconds apart, so that a log stays short.
//
// json: {"event":"frame","stage":"frames","frame":18,"done":18,"total":48,"kept":4} for each frame, and at
// the end {"event":"stage","stage":"frames","rendered":44,"kept":4,"total":48,"seconds":20.9}.
struct Progress {
  Progress(std::FILE* stream, ProgressStyle style, std::string label, int total);
  ~Progress();
  void advance(bool was_kept, int frame_number = 0);  // one frame more; a number above 0 goes into JSON
  void
  clear();  // takes the bar away, so that something else can be printed; the next advance() draws it again
  void finish();  // closes the bar; says how many were rendered and kept, and the time

  std::FILE* stream;
  ProgressStyle style;
  std::string label;  // the stage: "frames", "scenes"; shown as the unit too
  int total;
  int rendered = 0, kept = 0;
  double started_s = 0, last_shown_s = 0;
  int last_shown_tenth = 0;
  bool is_finished = false;
  std::mutex mutex;
};

// What a bar shows at one moment. Kept frames cost no time, so speed and time left are those of the rendered
// ones.
struct ProgressState {
  std::string label;
  int rendered = 0, kept = 0, total = 0;
  double elapsed_s = 0;
};

// "frames  [#########-----------]  18/48  2.1 frames/s  14 s left": the bar's text, `width` columns at most.
// On a narrow terminal the bar shortens first, then the words behind it go.
std::string format_progress_bar(const ProgressState& state, int width);

// "14 s", "2 min 05 s", "1 h 12 min".
std::string format_duration(double seconds);

}  // namespace mien
