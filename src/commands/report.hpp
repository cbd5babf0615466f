// What commands tell who runs the program: results, what limits held back, progress.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "clip/cast.hpp"
#include "config/ledger.hpp"
#include "options.hpp"
#include "render/progress.hpp"
#include "timeline/rehearsal.hpp"

namespace mien {

// One result a line to standard output: its path, or {"clip": "out/hello/hello.mp4"}; with --quiet and
// without
// --json nothing.
void report_result(const Options& options, const std::string& kind, const std::filesystem::path& path);

// One line a note of a ledger in any order, to standard output, with --json one object; with --quiet nothing.
void report_held(const Options& options, std::vector<Held> ledger);

// The same of a whole clip, however few of its frames are asked for.
void report_clip_held(const Options& options, const Clip& clip, const Cast& cast, const HeadStock& stock);

// Why the scans and meshes that the heads are made from may be no good heads, each warning once, to standard
// output, with --json one object a line; with --quiet nothing.
void report_starts(const Options& options, const std::vector<HeadSpec>& heads, const HeadStock& stock);

// Those of all who play.
std::vector<HeadSpec> list_heads(const Clip& clip);

// "file:line:col: warning: ..." or a line of --json.
void report_warning(const Options& options, const Diagnostic& warning);

// A line of --json of one note of a ledger.
std::string format_json(const HeldNote& note);

// One line of --json; of a path that is no UTF-8 its wrong bytes become U+FFFD.
std::string format_object(const nlohmann::ordered_json& object);

// To `decimals`, with -0 folded.
double round_to(double value, int decimals);

// A count of `total` things on standard error, in the style that --quiet and --json leave.
Progress start_progress(const Options& options, const char* label, std::size_t total);

}  // namespace mien
