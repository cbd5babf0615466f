#include "config/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/load_clip.hpp"
#include "config/named_file.hpp"
#include "core/curves.hpp"

namespace mien {

namespace {

constexpr std::size_t kMaxPoints = 1000;  // of one input; what has more is a table

std::shared_ptr<const Series> finish_series(Series series) {
  if (series.between == Between::spline)
    series.slopes = compute_spline_slopes(series.at_s, series.values);
  else if (series.between == Between::smooth)
    series.slopes = compute_smooth_slopes(series.at_s, series.values);
  return std::make_shared<const Series>(std::move(series));
}

void load_points(const YamlValue& value, const ClipClock& clock, Series& series) {
  std::optional<double> before_s;
  for (const YamlValue& item : load_list(value, "points such as [{at: 0s, value: 0}, {at: 1s, value: 1}]")) {
    if (series.at_s.size() == kMaxPoints)
      return add_mistake(item, fmt::format("more than {} points; expected fewer, or a 'csv'", kMaxPoints));
    const YamlMapping entries = load_section(item);
    double at_s = 0, number = 0;
    load_key_time(entries, item, clock, before_s, at_s);
    if (const YamlValue* own = find_required(entries, "value", item, "a number")) load_number(*own, number);
    series.at_s.push_back(at_s);
    series.values.push_back(number);
  }
}

// A table's times count from where the clip's own time begins; points are told in the whole clip's.
void load_recorded(const std::filesystem::path& path, const std::string& name, const YamlValue& column,
                   const ClipClock& clock, Series& series) {
  series.start_s = clock.start_s;
  load_series_table(path, name, column, clock, series);
}

std::size_t count_mistakes(const Findings& findings) { return findings.mistakes.size() + findings.untold; }

}  // namespace

double sample_series(const Series& series, double time_s) {
  const double at_s = time_s - series.start_s;
  const auto next = std::ranges::upper_bound(series.at_s, at_s);
  if (next == series.at_s.begin()) return series.values.front();
  if (next == series.at_s.end()) return series.values.back();
  const auto i = static_cast<std::size_t>(next - series.at_s.begin());
  const double length_s = series.at_s[i] - series.at_s[i - 1], u = (at_s - series.at_s[i - 1]) / length_s;
  if (!series.slopes.empty())
    return sample_cubic(series.values[i - 1], series.values[i], series.slopes[i - 1], series.slopes[i],
                        length_s, u);
  const double share = series.between == Between::ease ? u * u * (3 - 2 * u) : u;
  return std::lerp(series.values[i - 1], series.values[i], share);
}

std::shared_ptr<const Series> load_series(const YamlValue& value, const ClipClock& clock) {
  const YamlMapping entries = load_section(value);
  if (find_node(value).kind != NodeKind::mapping) return {};
  const std::size_t before = count_mistakes(*value.findings);
  Series series;
  if (find_value(entries, "between") != nullptr) load_between(entries, series.between);
  const YamlValue* points = find_value(entries, "points");
  const YamlValue* csv = find_value(entries, "csv");
  const YamlValue* column = find_value(entries, "column");
  if ((points == nullptr) == (csv == nullptr))
    add_mistake(value, points == nullptr ? "an input of neither 'points' nor 'csv'; expected one of them"
                                         : "'csv' stands beside 'points'; expected one of them");
  else if (points != nullptr && column != nullptr)
    add_mistake(*column, "'column' is of a 'csv'; expected none beside 'points'");
  else if (points != nullptr)
    load_points(*points, clock, series);
  else if (std::string name; column == nullptr)
    add_mistake(value, "'column' is missing; expected the name of a column of the 'csv'");
  else if (std::optional<FileReference> file; load_text(*column, "the name of a column", name) &&
                                              load_file(*csv, file) && has_room(*csv, file->path))
    load_recorded(file->path, name, *column, clock, series);
  if (count_mistakes(*value.findings) != before || series.at_s.empty()) return {};
  return finish_series(std::move(series));
}

}  // namespace mien
