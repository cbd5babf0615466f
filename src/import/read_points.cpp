// Points as text, a line each, as digitisers, Leica's and CloudCompare's programs and tables write them: x y
// z, more columns behind. Slices are runs of points with blank lines between them, or each behind a line that
// begins with a word such as 'slice'.
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "import/reading.hpp"
#include "import/slices.hpp"

namespace mien {

namespace {

// Lines that begin a slice; what stands behind the word, such as a number or a height, is passed.
constexpr std::array<std::string_view, 6> kSliceWords{"slice", "contour",  "section",
                                                      "curve", "polyline", "layer"};
// Blank lines stand in clouds, too: there, points follow each other at random, and not in little steps.
constexpr double kTracedStep = 0.1;  // of the run's size, as a rule
constexpr std::size_t kLeastTraced = 8;
constexpr std::size_t kMostPointWords = 1000;  // of a line: no table of points is so wide

struct PointReader {
  LineReader lines;
  std::vector<std::string_view> words;
  std::array<std::size_t, 3> columns{0, 1, 2}, normal_columns{};
  bool has_heading = false, has_normals = false;
  std::optional<std::size_t> wanted;  // how many points the file says that there are
  std::size_t counted = 0;            // points behind that line
  int count_line = 0;
  std::vector<std::size_t> runs;  // where each begins; empty runs are dropped later
  bool are_slices_told = false;
  Polygons mesh;
};

std::string_view trim(std::string_view word) {
  const std::size_t begin = word.find_first_not_of(" \t\"");
  if (begin == word.npos) return {};
  return word.substr(begin, word.find_last_not_of(" \t\"") - begin + 1);
}

// By semicolons, else commas, else blanks.
void split_fields(std::string_view line, std::vector<std::string_view>& words) {
  const char mark = line.find(';') != line.npos ? ';' : ',';
  if (line.find(mark) == line.npos) return split_words(line, words);
  words.clear();
  while (words.size() <= kMostPointWords) {
    const std::size_t end = line.find(mark);
    words.push_back(trim(line.substr(0, end)));
    if (end == line.npos) return;
    line.remove_prefix(end + 1);
  }
}

// "X", "x (mm)", "//x": x.
std::string read_column_name(std::string_view word) {
  while (!word.empty() && (word.front() == '/' || word.front() == '#')) word.remove_prefix(1);
  std::string name;
  for (const char c : word) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_') break;
    name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

// Whether the words name columns, x, y and z among them.
bool read_heading(PointReader& reader, bool is_comment) {
  std::vector<std::string> names;
  for (const std::string_view word : reader.words) names.push_back(read_column_name(word));
  const auto find = [&](const std::array<const char*, 3>& wanted, std::array<std::size_t, 3>& columns) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto found = std::ranges::find(names, wanted[axis]);
      if (found == names.end()) return false;
      columns[axis] = static_cast<std::size_t>(found - names.begin());
    }
    return true;
  };
  // A remark may speak of x, y and z: one that is a heading begins with them.
  if (is_comment && (names.size() < 3 || names[0] != "x" || names[1] != "y" || names[2] != "z")) return false;
  if (!find({"x", "y", "z"}, reader.columns)) return false;
  reader.has_heading = true;
  reader.has_normals = find({"nx", "ny", "nz"}, reader.normal_columns) ||
                       find({"normal_x", "normal_y", "normal_z"}, reader.normal_columns);
  return true;
}

void begin_run(PointReader& reader) {
  if (reader.runs.empty() || reader.runs.back() != reader.mesh.positions.size())
    reader.runs.push_back(reader.mesh.positions.size());
}

void check_count(const PointReader& reader) {
  if (reader.wanted && reader.counted < *reader.wanted)
    fail_line(reader.lines.file, reader.count_line,
              fmt::format("says {} points; {} follow", *reader.wanted, reader.counted));
}

// A line of one whole number, before the points that it counts.
bool read_count(PointReader& reader) {
  const auto count = reader.words.size() == 1 ? parse_index(reader.words.front()) : std::nullopt;
  const bool is_expected = reader.wanted ? reader.counted == *reader.wanted : reader.mesh.positions.empty();
  if (!count || *count < 0 || !is_expected) return false;
  reader.wanted = static_cast<std::size_t>(*count);
  reader.counted = 0;
  reader.count_line = reader.lines.number;
  return true;
}

void read_row(PointReader& reader) {
  const std::string& file = reader.lines.file;
  const int line = reader.lines.number;
  const auto& words = reader.words;
  const std::size_t most = std::ranges::max(reader.columns);
  if (words.size() > kMostPointWords)
    fail_line(file, line, fmt::format("more than {} numbers; expected X Y Z", kMostPointWords));
  // What is no file of points is none of this message's business.
  if (reader.mesh.positions.empty() && !reader.has_heading &&
      (words.size() < 3 || !parse_coordinate(words.front())))
    fail_line(file, line, "no point; expected lines of X Y Z, or first a heading that names x, y and z");
  if (words.size() <= most)
    fail_line(
        file, line,
        fmt::format("a point of {} number{}; expected {}", words.size(), words.size() == 1 ? "" : "s",
                    reader.has_heading ? fmt::format("{} columns at least, as the heading has them", most + 1)
                                       : std::string("X Y Z")));
  const auto& at = reader.columns;
  reader.mesh.positions.push_back(parse_position(file, line, words[at[0]], words[at[1]], words[at[2]]));
  reader.mesh.lines.push_back(static_cast<std::uint32_t>(line));
  check_point_count(file, line, reader.mesh.positions.size());
  ++reader.counted;
  if (!reader.has_normals) return;
  glm::dvec3 normal{0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t column = reader.normal_columns[axis];
    normal[static_cast<glm::length_t>(axis)] =
        column < words.size() ? parse_coordinate(words[column]).value_or(0) : 0;
  }
  reader.mesh.normals.push_back(normal);
}

void read_point_line(PointReader& reader) {
  const std::string_view line = trim(reader.lines.line);
  if (line.empty()) return begin_run(reader);
  const bool is_comment = line.starts_with('#') || line.starts_with("//");
  if (is_comment) {
    if (reader.has_heading || !reader.mesh.positions.empty()) return;
    std::string_view rest = line;
    rest.remove_prefix(std::min(rest.find_first_not_of("#/ \t"), rest.size()));
    split_fields(rest, reader.words);
    read_heading(reader, true);
    return;
  }
  split_fields(line.substr(0, line.find('#')), reader.words);
  const std::string first = read_column_name(reader.words.front());
  if (std::ranges::find(kSliceWords, first) != kSliceWords.end()) {
    reader.are_slices_told = true;
    return begin_run(reader);
  }
  if (reader.mesh.positions.empty() && !reader.has_heading && read_heading(reader, false)) return;
  if (!read_count(reader)) read_row(reader);
}

std::vector<Slice> list_runs(const PointReader& reader) {
  std::vector<Slice> runs;
  const std::vector<glm::dvec3>& points = reader.mesh.positions;
  for (std::size_t i = 0; i < reader.runs.size(); ++i) {
    const std::size_t end = i + 1 < reader.runs.size() ? reader.runs[i + 1] : points.size();
    if (end > reader.runs[i])
      runs.emplace_back(points.begin() + static_cast<std::ptrdiff_t>(reader.runs[i]),
                        points.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return runs;
}

bool is_traced(const Slice& run) {
  if (run.size() < kLeastTraced) return false;
  glm::dvec3 low(1e300), high(-1e300);
  double length = 0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    low = glm::min(low, run[i]);
    high = glm::max(high, run[i]);
    if (i > 0) length += glm::distance(run[i - 1], run[i]);
  }
  return length / static_cast<double>(run.size() - 1) <= kTracedStep * glm::distance(low, high);
}

// Most of the points lie in runs that were led along something.
bool are_slices(const std::vector<Slice>& runs) {
  std::size_t traced = 0, all = 0;
  for (const Slice& run : runs) {
    all += run.size();
    if (is_traced(run)) traced += run.size();
  }
  return runs.size() >= 3 && 10 * traced >= 9 * all;
}

}  // namespace

Polygons read_points(const std::string& file, std::string_view bytes) {
  PointReader reader;
  reader.lines = {file, bytes, {}, 0};
  reader.runs.push_back(0);
  while (read_line(reader.lines)) read_point_line(reader);
  check_count(reader);
  reader.mesh.file = file;
  const std::vector<Slice> runs = list_runs(reader);
  if (!runs.empty() && (reader.are_slices_told || are_slices(runs))) fill_slices(runs, reader.mesh);
  return std::move(reader.mesh);
}

}  // namespace mien
