#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/clip_spec.hpp"
#include "config/load_clip.hpp"
#include "config/load_takes.hpp"
#include "config/named_file.hpp"
#include "config/series.hpp"
#include "core/ticks.hpp"

namespace mien {

namespace {

constexpr double kMaxTime_s = 100000;

struct Cell {
  std::string text;
  Spot spot;
};

struct CsvFile {
  SourceText source;
  Findings* findings = nullptr;
};

void report(const CsvFile& file, Spot spot, std::string message) {
  add_mistake(*file.findings, file.source, spot, std::move(message));
}

// The cells of a line, without blanks and quotes around them.
std::vector<Cell> split(std::string_view line, int number, char separator) {
  std::vector<Cell> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    std::size_t first = begin, last = end;
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '"'; };
    while (first < last && is_blank(line[first])) ++first;
    while (last > first && is_blank(line[last - 1])) --last;
    cells.push_back({std::string(line.substr(first, last - first)), {number, static_cast<int>(first)}});
    begin = end + 1;
  }
  return cells;
}

char find_separator(std::string_view line) {
  for (const char c : {';', '\t'})
    if (line.find(c) != std::string_view::npos) return c;
  return ',';
}

// The moves that "brow.left.up" or "brows.up" means; empty if it is none.
std::vector<std::size_t> find_moves(const std::string& column) {
  std::vector<std::size_t> moves;
  for (std::size_t i = 0; i < kChannelCount; ++i)
    if (column == name_move(i) || (kChannels[i].side != Side::none && column == name_move(i, true)))
      moves.push_back(i);
  if (!moves.empty() || !column.starts_with(kCandideKey)) return moves;
  // By the action unit that it stands for: "candide.AU10".
  for (const ChannelRow& row : kUnitRows)
    if (column == fmt::format("{}.{}", kCandideKey, row.alias))
      moves.push_back(find_channel(kCandideKey, Side::none, row.name).value());
  return moves;
}

Names list_columns() {
  Names names{"time", "frame"};
  for (std::size_t i = 0; i < kChannelCount; ++i) {
    names.push_back(name_move(i));
    if (kChannels[i].side == Side::left) names.push_back(name_move(i, true));
  }
  return names;
}

// What the columns of the first line are.
struct Columns {
  std::size_t time = 0;
  bool is_frames = false;
  std::vector<std::vector<std::size_t>> moves;  // column by column; none for the time
};

bool load_columns(const CsvFile& file, const std::vector<Cell>& cells, Columns& columns) {
  const Names known = list_columns();
  if (cells.size() > known.size()) {
    report(file, cells.front().spot,
           fmt::format("this line has {} columns; expected {} at most", cells.size(), known.size()));
    return false;
  }
  bool has_time = false, is_right = true;
  std::bitset<kChannelCount> seen;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    columns.moves.push_back(find_moves(cell.text));
    std::string mistake;
    if (cell.text == "time" || cell.text == "frame") {
      if (has_time) mistake = fmt::format("'{}' is a second time; expected one", cell.text);
      has_time = true;
      columns.time = i;
      columns.is_frames = cell.text == "frame";
    } else if (columns.moves.back().empty()) {
      const std::string nearest = suggest_name(cell.text, known);
      mistake =
          fmt::format("unknown column '{}'; {}", show_word(cell.text),
                      nearest.empty() ? "expected time, frame, or a move such as brow.left.up or lips.upper"
                                      : "did you mean '" + nearest + "'?");
    }
    for (const std::size_t move : columns.moves.back()) {
      if (seen[move]) mistake = fmt::format("'{}' has a column already", name_move(move));
      if (file.findings->keeps_to_nine && kChannels[move].is_beyond)
        mistake = fmt::format(
            "'{}' is beyond the nine areas, which 'head' says with 'areas: nine'; expected one of "
            "them, or 'areas: all'",
            name_move(move));
      seen.set(move);
    }
    if (!mistake.empty()) report(file, cell.spot, mistake);
    is_right &= mistake.empty();
  }
  if (!has_time) report(file, {1, 0}, "no column is the time; expected 'time' in seconds, or 'frame'");
  if (has_time && seen.none() && is_right)
    report(file, {1, 0}, "no column is a move; expected one such as lips.upper");
  return is_right && has_time && seen.any();
}

bool load_cell(const CsvFile& file, const Cell& cell, double low, double high, const std::string& what,
               double& into) {
  const auto number = parse_number(cell.text);
  if (number && *number >= low && *number <= high) {
    into = *number;
    return true;
  }
  report(file, cell.spot,
         fmt::format("'{}' is '{}'; expected a number from {:.7g} to {:.7g}", what, show_word(cell.text), low,
                     high));
  return false;
}

void load_row(const CsvFile& file, const std::vector<Cell>& cells, const std::vector<Cell>& head,
              const Columns& columns, int fps, TimeTable& table) {
  if (cells.size() != head.size())
    return report(file, cells.front().spot,
                  fmt::format("this line has {} cell{}; expected {} as in the first line", cells.size(),
                              cells.size() == 1 ? "" : "s", head.size()));
  double at_s = 0;
  const double most = columns.is_frames ? kMaxTime_s * fps : kMaxTime_s;
  if (!load_cell(file, cells[columns.time], 0, most, head[columns.time].text, at_s)) return;
  if (columns.is_frames) at_s /= fps;
  at_s = compute_seconds(compute_ticks(at_s));
  if (!table.at_s.empty() && at_s <= table.at_s.back())
    return report(file, cells[columns.time].spot,
                  "this time is not after the one of the line before; expected rising times");
  table.at_s.push_back(at_s);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (columns.moves[i].empty()) continue;
    const MoveInfo& info = kChannels[columns.moves[i][0]];
    double value = 0;
    load_cell(file, cells[i], info.low * kMaxExaggerate, info.high * kMaxExaggerate, head[i].text, value);
    for (std::size_t side = 0; side < columns.moves[i].size(); ++side) table.values.push_back(value);
  }
}

// Whether one of the first line's words is a column's, or nearly.
bool has_columns(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n,;";
  const std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  const std::string_view line = text.substr(begin, text.find_first_of("\r\n", begin) - begin);
  const Names known = list_columns();
  std::vector<Cell> cells = split(line, 1, find_separator(line));
  if (cells.size() > known.size()) cells.resize(known.size());  // a word takes some microseconds
  return std::ranges::any_of(cells,
                             [&](const Cell& cell) { return !suggest_name(cell.text, known).empty(); });
}

const NamedKind kTableFile{
    has_columns,
    "is no table: none of the words of its first line is a column; expected time, frame or a move such as "
    "lips.upper",
    "the file is empty; expected a line of names such as time,lips.upper and a line for each time"};

}  // namespace

std::shared_ptr<const TimeTable> load_move_table(const std::filesystem::path& path, int fps,
                                                 Findings& findings) {
  auto source = load_named_source(path, kTableFile, findings);
  if (!source) return {};
  const CsvFile file{std::move(*source), &findings};
  const auto before = findings.mistakes.size() + findings.untold;
  TimeTable table;
  Columns columns;
  std::vector<Cell> head;
  char separator = ',';
  for (int number = 1; number <= static_cast<int>(file.source.line_starts.size()); ++number) {
    const std::string_view line = find_line(file.source, number);
    if (line.find_first_not_of(" \t,;") == std::string_view::npos) continue;
    if (head.empty()) {
      separator = find_separator(line);
      head = split(line, number, separator);
      if (!load_columns(file, head, columns)) return {};
      for (const auto& moves : columns.moves)
        table.moves.insert(table.moves.end(), moves.begin(), moves.end());
    } else {
      load_row(file, split(line, number, separator), head, columns, fps, table);
    }
  }
  if (table.at_s.empty() && findings.mistakes.size() + findings.untold == before)
    report(file, {1, 0}, "there are no rows; expected a line of names and a line for each time");
  if (findings.mistakes.size() + findings.untold != before) return {};
  return std::make_shared<const TimeTable>(std::move(table));
}

namespace {

// Of any table with a time: its columns are what a device calls them.
const NamedKind kSeriesFile{
    [](std::string_view text) { return text.find_first_of(",;\t") != text.npos; },
    "is no table: its first line has no columns; expected time or frame and others",
    "the file is empty; expected a line of names such as time,joyz and a line for each "
    "time"};

// Which columns of the first line are the time and the one that is asked for.
struct SeriesColumns {
  std::size_t time = 0, value = 0;
  bool is_frames = false;
};

std::optional<SeriesColumns> find_series_columns(const CsvFile& file, const std::vector<Cell>& head,
                                                 const std::string& name, const YamlValue& asked) {
  SeriesColumns columns;
  bool has_time = false, has_value = false;
  Names others;
  for (std::size_t i = 0; i < head.size(); ++i) {
    const std::string& word = head[i].text;
    if ((word == "time" || word == "frame") && !has_time) {
      has_time = true;
      columns.time = i;
      columns.is_frames = word == "frame";
    } else {
      others.push_back(word);
    }
    if (word == name && !has_value) {
      has_value = true;
      columns.value = i;
    }
  }
  if (!has_time)
    report(file, {head.front().spot.line, 0},
           "no column is the time; expected 'time' in seconds, or 'frame'");
  if (!has_value) add_mistake(asked, describe_unknown("column", name, others));
  return has_time && has_value ? std::optional(columns) : std::nullopt;
}

}  // namespace

void load_series_table(const std::filesystem::path& path, const std::string& name, const YamlValue& asked,
                       const ClipClock& clock, Series& series) {
  constexpr double kMostValue = 1e9;
  auto source = load_named_source(path, kSeriesFile, *asked.findings);
  if (!source) return;
  const double fps = clock.measure.units[2].over;
  const CsvFile file{std::move(*source), asked.findings};
  std::vector<Cell> head;
  std::optional<SeriesColumns> columns;
  char separator = ',';
  for (int number = 1; number <= static_cast<int>(file.source.line_starts.size()); ++number) {
    const std::string_view line = find_line(file.source, number);
    if (line.find_first_not_of(" \t,;") == std::string_view::npos) continue;
    if (head.empty()) {
      separator = find_separator(line);
      head = split(line, number, separator);
      columns = find_series_columns(file, head, name, asked);
      if (!columns) return;
      continue;
    }
    const std::vector<Cell> cells = split(line, number, separator);
    double at_s = 0, value = 0;
    if (cells.size() != head.size()) {
      report(file, cells.front().spot,
             fmt::format("this line has {} cell{}; expected {} as in the first line", cells.size(),
                         cells.size() == 1 ? "" : "s", head.size()));
      return;
    }
    if (!load_cell(file, cells[columns->time], 0, columns->is_frames ? kMaxTime_s * fps : kMaxTime_s,
                   head[columns->time].text, at_s) ||
        !load_cell(file, cells[columns->value], -kMostValue, kMostValue, head[columns->value].text, value))
      return;
    if (columns->is_frames) at_s /= fps;
    if (!series.at_s.empty() && at_s <= series.at_s.back())
      return report(file, cells[columns->time].spot,
                    "this time is not after the one of the line before; expected rising times");
    series.at_s.push_back(at_s);
    series.values.push_back(value);
  }
  if (series.at_s.empty())
    report(file, {1, 0}, "there are no rows; expected a line of names and a line for each time");
}

namespace {

// The table as a track shows it, from the library if it was read for another one. Empty, with mistakes told,
// if it is wrong.
std::shared_ptr<const TimeTable> find_table(const YamlValue& csv, const std::filesystem::path& file,
                                            Between between, const ClipReader& reader) {
  auto& tables = reader.library->tables;
  const int fps = static_cast<int>(std::lround(reader.clock.measure.units[2].over));
  const std::tuple key(file.string(), fps, between);
  if (const auto known = tables.find(key); known != tables.end()) return known->second;
  if (!has_room(csv, file)) return tables[key] = nullptr;
  const auto table = load_move_table(file, fps, *csv.findings);
  if (!table) return tables[key] = nullptr;
  TimeTable timed = *table;
  timed.between = between;
  return tables[key] = std::make_shared<const TimeTable>(std::move(timed));
}

}  // namespace

namespace {

// The key of a track that names its file; null, with a mistake told, if it is not one.
const YamlEntry* find_track_file(const YamlMapping& entries, const YamlValue& item) {
  const YamlEntry* named = nullptr;
  for (const YamlEntry& entry : entries) {
    if (entry.key != "csv" && !find_take_key(entry.key)) continue;
    if (named == nullptr) {
      named = &entry;
      continue;
    }
    add_mistake(entry.value, fmt::format("'{}' and '{}' name two files of one track; expected one of them",
                                         named->key, entry.key));
    return nullptr;
  }
  if (named == nullptr)
    add_mistake(item, fmt::format("{} names no file; expected 'csv', 'live_link', 'arkit', 'openface', "
                                  "'openfacefx', 'vrma' or 'gltf' and a file such as talk.csv",
                                  describe_subject(item)));
  return named;
}

// The head's turn of a take, where the clip has none of its own.
void append_turn(const TakeTable& take, double start_s, ClipSpec& into) {
  if (!into.turn.empty()) return;
  const Ticks start = compute_ticks(start_s);
  for (TurnKey key : take.turn) {
    key.at_s = compute_seconds(start + compute_ticks(key.at_s));
    into.turn.push_back(key);
  }
}

}  // namespace

void load_tables(const YamlMapping& clip, const ClipReader& reader, ClipSpec& into) {
  const YamlValue* list = find_value(clip, "tracks");
  if (list == nullptr) return;
  for (const YamlValue& item : load_list(*list, "a list of tracks such as [{csv: talk.csv}]")) {
    if (!count_part(item, reader)) break;
    const YamlMapping entries = load_section(item);
    CueSpec cue;
    cue.layer = Layer::table;
    cue.has_lead = false;
    cue.start_s = reader.clock.start_s;
    cue.what.place = find_place(item.document->source, item.spot);
    load_rule(entries, cue.rule);
    if (const YamlValue* at = find_value(entries, "at")) load_time(*at, reader.clock, cue.start_s);
    double attack_s = kTableAttack_s, release_s = kTableRelease_s;
    load_duration(entries, "attack", reader.clock, attack_s);
    load_duration(entries, "release", reader.clock, release_s);
    Between between = Between::linear;
    load_between(entries, between);
    const YamlEntry* named = find_track_file(entries, item);
    const TakeReading reading =
        load_take_reading(entries, named == nullptr ? std::nullopt : find_take_key(named->key));
    std::optional<FileReference> file;
    if (named == nullptr || !load_file(named->value, file)) continue;
    if (named->key == "csv") {
      for (const char* key : {"smooth", "fps"})
        if (const YamlValue* value = find_value(entries, key))
          add_mistake(*value, fmt::format("'{}' is for takes; expected none beside 'csv'", key));
      cue.table = find_table(named->value, file->path, between, reader);
    } else if (const auto take = find_take(*named, reading, file->path, between, reader)) {
      cue.table = std::shared_ptr<const TimeTable>(take, &take->table);
      append_turn(*take, cue.start_s, into);
    }
    if (!cue.table) continue;
    const Ticks start = compute_ticks(cue.start_s);
    cue.full_s = compute_seconds(start + compute_ticks(cue.table->at_s.front()));
    cue.ebb_s = compute_seconds(start + compute_ticks(cue.table->at_s.back()));
    cue.from_s = cue.full_s - attack_s;
    cue.end_s = cue.ebb_s + release_s;
    for (const std::size_t move : cue.table->moves) cue.owns.set(move);
    cue.what.label = file->path.filename().string();
    into.cues.push_back(std::move(cue));
  }
}

}  // namespace mien
