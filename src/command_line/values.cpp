#include "command_line/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <regex>
#include <set>
#include <string_view>

#include "config/load_spec.hpp"
#include "config/load_takes.hpp"
#include "config/quantity.hpp"
#include "core/seeded.hpp"
#include "core/text.hpp"

namespace mien {
namespace {

constexpr int kMaxJobs = 1024;  // more processes at once are a typing mistake

// All of `text` as a whole number.
std::optional<int> read_whole(std::string_view text) {
  int number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, number);
  return fault == std::errc{} && stop == end ? std::optional(number) : std::nullopt;
}

// "10-20".
std::optional<std::pair<int, int>> read_range(std::string_view text) {
  const std::size_t dash = text.find('-');
  if (dash == std::string_view::npos) return std::nullopt;
  const auto first = read_whole(text.substr(0, dash));
  const auto second = read_whole(text.substr(dash + 1));
  if (!first || !second) return std::nullopt;
  return std::pair{*first, *second};
}

// Each `read_` fills its option and returns what is wrong with `text`; nothing if it is right.
std::string read_frames(const std::string& text, Options& options) {
  const auto single = read_whole(text);
  const auto range = single ? std::pair{*single, *single} : read_range(text);
  if (!range || range->first < 1 || range->second < range->first)
    return "is not a range of frames such as 10-20, counted from 1";
  options.frames = range;
  return {};
}

std::string read_size(const std::string& text, Options& options) {
  const auto size = parse_size(text);
  if (!size) return "is not a size such as 480x600";
  const auto [low, high] = std::minmax(size->first, size->second);
  if (low < kMinSide_px || high > kMaxSide_px)
    return fmt::format("has a side outside {}..{} pixels", kMinSide_px, kMaxSide_px);
  options.size_px = size;
  return {};
}

std::string read_quality(const std::string& text, Options& options) {
  if (text == "sketch") options.quality = Quality::sketch;
  if (text == "draft") options.quality = Quality::draft;
  if (text == "good") options.quality = Quality::good;
  if (text == "best") options.quality = Quality::best;
  return options.quality
             ? ""
             : "is not sketch, draft, good or best" + suggest(text, {"sketch", "draft", "good", "best"});
}

std::string read_jobs(const std::string& text, Options& options) {
  const auto jobs = read_whole(text);
  if (!jobs || *jobs < 1 || *jobs > kMaxJobs)
    return fmt::format("is not a whole number within 1..{}", kMaxJobs);
  options.jobs = *jobs;
  return {};
}

std::string read_port(const std::string& text, Options& options) {
  constexpr int kLowest = 1024, kHighest = 65535;  // those below are the system's
  const auto port = read_whole(text);
  if (!port || *port < kLowest || *port > kHighest)
    return fmt::format("is not a whole number within {}..{}", kLowest, kHighest);
  options.port = *port;
  return {};
}

std::string read_at(const std::string& text, Options& options) {
  // At one frame a second, "36f" is 36; what it is in seconds the file will tell.
  const auto time = parse_quantity(text, build_time_measure(1));
  if (!time || *time < 0) return "is not a time such as 1.2s, 500ms or 36f";
  (text.ends_with('f') ? options.at_frames : options.at_s) = time;
  return {};
}

std::string read_angle(const std::string& text, Options& options) {
  options.camera_angle_deg = parse_quantity(text, build_angle_measure());
  return options.camera_angle_deg ? "" : "is not an angle in degrees such as 30";
}

std::string read_height(const std::string& text, Options& options) {
  constexpr double kLowest_mm = 20, kHighest_mm = 400;  // as in a file
  const auto height = parse_quantity(text, build_length_measure());
  if (!height) return "is not a length such as 80mm or 8cm";
  if (*height < kLowest_mm || *height > kHighest_mm)
    return fmt::format("is outside {}mm..{}mm", kLowest_mm, kHighest_mm);
  options.height_mm = height;
  return {};
}

std::string read_seed(const std::string& text, int most, std::optional<int>& seed) {
  const auto whole = read_whole(text);
  if (!whole || *whole < 0 || *whole > most) return fmt::format("is not a whole number within 0..{}", most);
  seed = whole;
  return {};
}

// Two to four names with commas between; which there are the data say.
std::string read_beside(const std::string& text, Options& options) {
  constexpr std::size_t kFewest = 2, kMost = 4;
  std::size_t from = 0;
  for (std::size_t to = 0; to != text.npos; from = to + 1) {
    to = text.find(',', from);
    options.beside.push_back(text.substr(from, to == text.npos ? to : to - from));
  }
  std::set<std::string> names(options.beside.begin(), options.beside.end());
  names.erase("");
  const bool is_right =
      names.size() == options.beside.size() && names.size() >= kFewest && names.size() <= kMost;
  return is_right ? "" : "is not two to four designs such as real,comic";
}

// "2GB": thousands, as disks are sold.
std::string read_store(const std::string& text, Options& options) {
  constexpr std::pair<std::string_view, std::uintmax_t> kUnits[] = {
      {"GB", 1'000'000'000}, {"MB", 1'000'000}, {"kB", 1'000}, {"", 1}};
  for (const auto& [unit, bytes] : kUnits) {
    if (!text.ends_with(unit)) continue;
    const auto number = read_whole(std::string_view(text).substr(0, text.size() - unit.size()));
    if (!number || *number < 0) break;
    options.store_bytes = static_cast<std::uintmax_t>(*number) * bytes;
    return {};
  }
  return "is not a size such as 2GB or 500MB";
}

// A number from `low` to `high` behind a flag that may stand alone.
std::string read_count(const std::string& text, int low, int high, int otherwise, int& count) {
  const auto whole = text.empty() ? std::optional(otherwise) : read_whole(text);
  if (!whole || *whole < low || *whole > high)
    return fmt::format("is not a whole number within {}..{}", low, high);
  count = *whole;
  return {};
}

std::string read_loop(const std::string& text, Options& options) {
  constexpr int kMostRounds = 100, kRounds = 2;  // the seam is seen once
  const std::string wrong = read_count(text, 1, kMostRounds, kRounds, options.video.rounds);
  if (!text.empty()) options.video.plays = options.video.rounds;
  return wrong;
}

std::string read_nice(const std::string& text, Options& options) {
  constexpr int kWeakest = 19, kNice = 10;  // as nice(1)
  return read_count(text, 1, kWeakest, kNice, options.nice.emplace());
}

std::string read_every(const std::string& text, Options& options) {
  constexpr int kMost = 1000;
  const auto every = read_whole(text);
  if (!every || *every < 1 || *every > kMost) return fmt::format("is not a whole number within 1..{}", kMost);
  options.every = every;
  return {};
}

std::string read_engine(const std::string& text, Options& options) {
  if (text != "local" && text != "slurm") return "is not local or slurm" + suggest(text, {"local", "slurm"});
  options.farm.engine = text == "slurm" ? Engine::slurm : Engine::local;
  return {};
}

constexpr int kLongest_s = 366 * 24 * 3600;  // more is a typing mistake

// "90s", "5m" or "2h".
std::optional<int> read_long_time_s(std::string_view text) {
  constexpr std::pair<char, int> kUnits[] = {{'s', 1}, {'m', 60}, {'h', 3600}};
  for (const auto& [unit, seconds] : kUnits) {
    if (!text.ends_with(unit)) continue;
    const auto number = read_whole(text.substr(0, text.size() - 1));
    if (number && *number > 0 && *number <= kLongest_s / seconds) return *number * seconds;
  }
  return std::nullopt;
}

std::string read_chunk(const std::string& text, Options& options) {
  if (const auto seconds = read_long_time_s(text))
    options.farm.chunk_s = seconds;
  else if (const auto count = read_whole(text); count && *count > 0)
    options.farm.chunk_drawings = count;
  else
    return "is not a time such as 5m or 90s, nor a number of drawings such as 20";
  return {};
}

// As sbatch(1) has it: "minutes", "minutes:seconds", "hours:minutes:seconds", "days-hours" and
// "days-hours:minutes[:seconds]"; and besides "90s", "30m" and "2h".
std::string read_time_limit(const std::string& text, Options& options) {
  static const std::regex kSlurm("[0-9]{1,8}(:[0-9]{1,2}){0,2}|[0-9]{1,3}-[0-9]{1,2}(:[0-9]{1,2}){0,2}");
  if (const auto seconds = read_long_time_s(text))
    options.farm.time_limit =
        fmt::format("{}:{:02}:{:02}", *seconds / 3600, *seconds / 60 % 60, *seconds % 60);
  else if (std::regex_match(text, kSlurm) && text.find_first_of("123456789") != text.npos)
    options.farm.time_limit = text;
  else
    return "is not a time such as 30m, 2h or 1-12:00:00";
  return {};
}

std::string read_partition(const std::string& text, Options& options) {
  static const std::regex kNames("[A-Za-z0-9_.,-]+");
  if (!std::regex_match(text, kNames)) return "is not the name of a partition";
  options.farm.partition = text;
  return {};
}

// "3/8", or "gather".
std::string read_part(const std::string& text, Options& options) {
  options.farm.is_gathering = text == "gather";
  if (options.farm.is_gathering) return {};
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto part = read_whole(std::string_view(text).substr(0, slash));
  const auto count = read_whole(std::string_view(text).substr(std::min(slash + 1, text.size())));
  if (!part || !count || *part < 1 || *part > *count) return "is not a part such as 3/8, nor the word gather";
  options.farm.part = {*part, *count};
  return {};
}

void read_outputs(const std::string& text, Options& options) {
  std::size_t from = 0;
  for (std::size_t to = 0; to != text.npos; from = to + 1) {
    to = text.find(kBetweenOutputs, from);
    options.outputs.emplace_back(text.substr(from, to == text.npos ? to : to - from));
  }
}

std::string read_keys(const std::string& text, Options& options) {
  constexpr double kFinest_mm = 0.01, kCoarsest_mm = 10;  // beyond it a face is not followed at all
  const auto length = parse_quantity(text, build_length_measure());
  if (!length || *length < kFinest_mm || *length > kCoarsest_mm)
    return fmt::format("is not a length from {}mm to {}mm such as 0.5mm", kFinest_mm, kCoarsest_mm);
  options.take.keys_mm = length;
  return {};
}

// A number within two bounds; `percent` may stand behind it.
std::string read_bounded(std::string text, double low, double high, std::optional<double>& into) {
  if (text.ends_with('%')) text.pop_back();
  const auto number = parse_number(text);
  if (!number || *number < low || *number > high)
    return fmt::format("is not a number from {} to {}", low, high);
  into = number;
  return {};
}

std::string read_value(const std::string& name, const std::string& text, Options& options) {
  if (name == "frames") return read_frames(text, options);
  if (name == "size") return read_size(text, options);
  if (name == "quality") return read_quality(text, options);
  if (name == "jobs") return read_jobs(text, options);
  if (name == "port") return read_port(text, options);
  if (name == "at") return read_at(text, options);
  if (name == "angle") return read_angle(text, options);
  if (name == "height") return read_height(text, options);
  if (name == "seed") return read_seed(text, kMaxSeed, options.seed);
  if (name == "beside") return read_beside(text, options);
  if (name == "store") return read_store(text, options);
  if (name == "loop") return read_loop(text, options);
  if (name == "nice") return read_nice(text, options);
  if (name == "every") return read_every(text, options);
  if (name == "engine") return read_engine(text, options);
  if (name == "partition") return read_partition(text, options);
  if (name == "chunk") return read_chunk(text, options);
  if (name == "time") return read_time_limit(text, options);
  if (name == "part") return read_part(text, options);
  if (name == "random-head") return read_seed(text, kMaxSeed, options.random_head);
  if (name == "keys") return read_keys(text, options);
  if (name == "strict") return read_bounded(text, 0, 100, options.take.strict_percent);
  if (name == "smooth") return read_bounded(text, 0, kMostSmooth_hz, options.take.smooth_hz);
  if (name == "fps") return read_bounded(text, 1, kMostTakeRate, options.take.fps);
  if (name == "quiet") options.is_quiet = true;
  if (name == "stl") options.has_stl = true;
  if (name == "no-stl") options.has_stl = false;
  if (name == "3mf") options.has_3mf = true;
  if (name == "preview") options.has_preview = true;
  if (name == "openscad") options.has_openscad = true;
  if (name == "half") options.is_half = true;
  if (name == "wire") options.wire.is_on = true;
  if (name == "cage") options.wire.has_cage = true;
  if (name == "guides") options.wire.has_guides = true;
  if (name == "limits") options.wire.has_limits = true;
  if (name == "exact") options.is_exact = true;
  if (name == "keep-scenes") options.has_scenes = true;
  if (name == "boomerang") options.video.is_boomerang = true;
  if (name == "slate") options.video.has_slate = true;
  if (name == "json") options.is_json = true;
  if (name == "open") options.is_opened = true;
  if (name == "read-only") options.is_read_only = true;
  if (name == "no-wait") options.farm.has_wait = false;
  if (name == "dry-run") options.farm.is_dry_run = true;
  for (const char* flag :
       {"no-wait",   "dry-run", "quiet",   "json",     "half",   "exact",     "stl",
        "no-stl",    "3mf",     "preview", "openscad", "open",   "read-only", "keep-scenes",
        "boomerang", "slate",   "wire",    "cage",     "guides", "limits"})
    if (name == flag) return {};
  if (text.empty()) return "is empty";
  if (name == "output") options.output = text;
  if (name == "targets") options.targets = text;
  if (name == "uv") options.uv = text;
  if (name == "faults") options.faults = text;
  if (name == "landmarks") options.landmarks = text;
  if (name == "express") options.express = text;
  if (name == "area") options.area = text;
  if (name == "actor") options.actor = text;
  return {};
}

// What is only for those who have others render.
void check_farm(const TypedValues& typed, const Options& options, std::vector<Diagnostic>& mistakes) {
  if (options.farm.engine == Engine::slurm && typed.contains("part"))
    add_mistake(mistakes, "--part is what the tasks of --engine slurm run; give one of them");
  if (options.farm.engine == Engine::slurm) return;
  for (const char* name : {"partition", "chunk", "time", "no-wait", "dry-run"})
    if (typed.contains(name))
      add_mistake(mistakes, fmt::format("--{} is for --engine slurm alone; give both or neither", name));
}

}  // namespace

void add_mistake(std::vector<Diagnostic>& mistakes, std::string message) {
  mistakes.emplace_back().message = std::move(message);
}

std::string suggest(const std::string& word, const std::vector<std::string>& names) {
  const std::string nearest = find_nearest(word, names);
  return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
}

Options build_options(const TypedValues& typed, std::vector<Diagnostic>& mistakes) {
  Options options;
  for (const auto& [name, text] : typed)
    if (name == kAllOutputs)
      read_outputs(text, options);
    else if (const std::string wrong = read_value(name, text, options); !wrong.empty())
      add_mistake(mistakes, fmt::format("--{}: '{}' {}", name, text, wrong));
  if (typed.contains("at") && typed.contains("express"))
    add_mistake(mistakes, "--at and --express ask for two things; give one of them");
  for (const char* other : {"at", "express", "landmarks"})
    if (typed.contains("half") && typed.contains(other))
      add_mistake(mistakes,
                  fmt::format("--half is the neutral head's half alone; give it without --{}", other));
  if (typed.contains("no-wait") && typed.contains("dry-run"))
    add_mistake(mistakes, "--dry-run submits nothing that --no-wait could leave; give one of them");
  check_farm(typed, options, mistakes);
  return options;
}

}  // namespace mien
