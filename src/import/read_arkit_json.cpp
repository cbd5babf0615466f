// ARKit's units by frames, as JSON. What MediaPipe's face landmarker gives, once for each frame of a list (or
// of the list `frames` of an object, which may have `fps`):
//   {"timestamp_ms": 33, "faceBlendshapes": [{"categories": [{"categoryName": "jawOpen", "score": 0.3},
//   ..]}],
//    "facialTransformationMatrixes": [{"rows": 4, "columns": 4, "data": [..]}]}
// the same by Python's names (face_blendshapes, category_name), and what recorders of ARKit write:
//   {"time": 0.033, "blendShapes": {"jawOpen": 0.3, ..}}
// A matrix leads from the face's axes (x to its left, y up, z forward) to the camera's, by columns or by
// rows: its last row is 0 0 0 1. Times are `time`, `time_s` or `seconds`; `timestamp_ms`, `timestampMs` or
// `time_ms`; `timestamp` is in milliseconds if steps of seconds would be slower than any video. Sources:
// MediaPipe, "Face landmark detection guide"; Apple, ARFaceAnchor.BlendShapeLocation.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/json_stream.hpp"
#include "import/reading.hpp"
#include "import/take_reading.hpp"

namespace mien {

namespace {

constexpr double kMostScore = 10;
constexpr double kJsonRate = 30;

// What an open list or object is.
enum ArkitRole {
  kRolePassed,
  kRoleRoot,
  kRoleFrames,
  kRoleFrame,
  kRoleShapes,
  kRoleShapeList,
  kRoleCategory,
  kRoleMatrix
};

struct ArkitReader {
  std::string file;
  double fps = 0;
  Take take = {};
  // The frame that is open.
  JsonSpot frame_spot = {};
  bool is_root_frame = false;  // the file is one frame
  double frame_time = 0;
  bool has_time = false, is_raw_time = false;
  bool has_shapes = false;
  std::vector<float> row = {};
  std::vector<bool> is_set = {};
  std::vector<double> matrix = {};
  // The category that is open.
  std::string name = {};
  double score = 0;
  bool has_score = false;
  JsonSpot name_spot = {};
  // Times that are seconds or milliseconds: their places, until all are there.
  bool has_raw_times = false;
  double first = 0;
  int frame_count = 0;
};

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

bool is_shapes_key(std::string_view key) {
  return is_one_of(key, {"faceBlendshapes", "face_blendshapes", "blendshapes", "blendShapes", "blend_shapes",
                         "categories"});
}

void begin_frame(ArkitReader& reader, JsonSpot spot) {
  reader.frame_spot = spot;
  reader.has_time = reader.is_raw_time = reader.has_shapes = false;
  std::ranges::fill(reader.row, 0.0F);
  reader.is_set.assign(reader.is_set.size(), false);
  reader.matrix.clear();
}

void set_unit(ArkitReader& reader, std::string_view word, double value, JsonSpot spot) {
  if (word == "_neutral") return;  // how much of no unit at all
  const std::string name = build_arkit_name(word);
  const TakePlace place{reader.file, spot.line, {}, 0, spot.column};
  if (std::abs(value) > kMostScore)
    fail_take(place, fmt::format("'{}' is {:.7g}; expected a number from {} to {}", show_found(name), value,
                                 -kMostScore, kMostScore));
  auto& channels = reader.take.channels;
  auto found = std::ranges::find(channels, name, &TakeChannel::name);
  const auto index = static_cast<std::size_t>(found - channels.begin());
  if (found == channels.end()) {
    add_take_channel(reader.take, place, name);
    widen_take(reader.take, index);
    reader.row.push_back(0);
    reader.is_set.push_back(false);
  }
  if (reader.is_set[index])
    fail_take(place, fmt::format("'{}' is there twice in a frame; expected one face", show_found(name)));
  reader.is_set[index] = true;
  reader.row[index] = static_cast<float>(value);
}

int open_arkit(ArkitReader& reader, const JsonUse::Steps& steps, bool is_list, JsonSpot spot) {
  if (steps.empty()) {
    if (is_list) return kRoleFrames;
    begin_frame(reader, spot);
    return kRoleRoot;
  }
  const JsonStep& around = steps.back();
  switch (around.role) {
    case kRoleRoot:
      if (is_list && is_one_of(around.key, {"frames", "results", "data"})) return kRoleFrames;
      [[fallthrough]];
    case kRoleFrame:
      if (around.key.starts_with("facialTransformation") || around.key.starts_with("facial_transformation"))
        return kRoleMatrix;
      if (!is_shapes_key(around.key)) return kRolePassed;
      reader.is_root_frame = reader.is_root_frame || around.role == kRoleRoot;
      return is_list ? kRoleShapeList : kRoleShapes;
    case kRoleFrames:
      if (is_list)
        fail_json(reader.file, spot, "a list within the list of frames; expected an object for each");
      begin_frame(reader, spot);
      return kRoleFrame;
    case kRoleShapeList:
      if (is_list) return kRoleShapeList;
      reader.name.clear();
      reader.has_score = false;
      return kRoleCategory;
    case kRoleCategory:
      return is_list && around.key == "categories" ? kRoleShapeList : kRolePassed;
    case kRoleMatrix:
      return kRoleMatrix;
    default:
      return kRolePassed;
  }
}

// The matrix of the frame as an angle for each of turn, nod and tilt.
std::array<float, 3> find_matrix_turn(const ArkitReader& reader) {
  const std::vector<double>& m = reader.matrix;
  if (m.size() != 16)
    fail_json(reader.file, reader.frame_spot,
              fmt::format("this frame's matrix has {} numbers; expected 16 of one face", m.size()));
  // 0 0 0 1 is the last column of a list by columns.
  const bool is_by_rows = m[12] == 0 && m[13] == 0 && m[14] == 0 && (m[3] != 0 || m[7] != 0 || m[11] != 0);
  std::array<double, 9> columns{};
  for (std::size_t column = 0; column < 3; ++column)
    for (std::size_t row = 0; row < 3; ++row)
      columns[3 * column + row] = is_by_rows ? m[4 * row + column] : m[4 * column + row];
  return find_turn_deg(columns);
}

void close_frame(ArkitReader& reader) {
  Take& take = reader.take;
  const TakePlace place{reader.file, reader.frame_spot.line, {}, 0, reader.frame_spot.column};
  if (reader.frame_count > 0 && reader.has_raw_times != reader.is_raw_time)
    fail_take(place, "this frame has a time of another kind than those before it; expected one kind");
  reader.has_raw_times = reader.is_raw_time;
  const double frame = reader.frame_count++;
  double at = reader.has_time ? reader.frame_time : frame / (reader.fps > 0 ? reader.fps : kJsonRate);
  if (frame == 0) reader.first = at;  // of a clock
  at -= reader.first;
  if (!begin_take_row(take, place, reader.is_raw_time ? at / 1000 : at)) return;
  if (!reader.has_shapes) {
    ++take.unseen_count;
    return;
  }
  take.at_s.push_back(at);
  take.values.insert(take.values.end(), reader.row.begin(), reader.row.end());
  if (!reader.matrix.empty()) {
    if (take.turn_deg.size() + 1 != take.at_s.size())
      fail_take(place, "this frame has a matrix and those before it have none; expected one in each or none");
    take.turn_deg.push_back(find_matrix_turn(reader));
  } else if (!take.turn_deg.empty()) {
    fail_take(place, "this frame has no matrix as those before it have; expected one in each or none");
  }
}

void close_arkit(ArkitReader& reader, const JsonUse::Steps& steps, JsonSpot) {
  const int role = steps.back().role;
  if (role == kRoleFrame || (role == kRoleRoot && reader.is_root_frame)) close_frame(reader);
  if (role != kRoleCategory) return;
  if (reader.name.empty() && !reader.has_score) return;  // {"categories": [..]} and the like
  if (reader.name.empty() || !reader.has_score)
    fail_json(reader.file, reader.name.empty() ? reader.frame_spot : reader.name_spot,
              reader.name.empty() ? "a score without a categoryName in this frame; expected both"
                                  : fmt::format("'{}' has no score; expected one", show_found(reader.name)));
  set_unit(reader, reader.name, reader.score, reader.name_spot);
  reader.name.clear();
  reader.has_score = false;
}

void take_time(ArkitReader& reader, const std::string& key, double value, JsonSpot spot) {
  const bool is_s = is_one_of(key, {"time", "time_s", "seconds"});
  const bool is_ms = is_one_of(key, {"timestamp_ms", "timestampMs", "time_ms"});
  const bool is_raw = key == "timestamp";
  if (!is_s && !is_ms && !is_raw) return;
  // A clock's time is as good as one from the beginning.
  constexpr double kMostClock = 1e13;
  if (value < 0 || value > kMostClock)
    fail_json(reader.file, spot, fmt::format("'{}' is {:.7g}; expected a time from 0 on", key, value));
  reader.frame_time = is_ms ? value / 1000 : value;
  reader.has_time = true;
  reader.is_raw_time = is_raw;
}

void take_arkit_number(ArkitReader& reader, const JsonUse::Steps& steps, double value, JsonSpot spot) {
  if (steps.empty()) fail_json(reader.file, spot, "a number alone; expected a list of frames");
  const JsonStep& around = steps.back();
  switch (around.role) {
    case kRoleRoot:
      if (is_one_of(around.key, {"fps", "frameRate", "frame_rate"}) && reader.fps <= 0) {
        if (value <= 0 || value > 1000)
          fail_json(reader.file, spot,
                    fmt::format("'{}' is {:.7g}; expected frames a second", around.key, value));
        reader.fps = value;
      }
      [[fallthrough]];
    case kRoleFrame:
      take_time(reader, around.key, value, spot);
      break;
    case kRoleFrames:
      fail_json(reader.file, spot, "a number in the list of frames; expected an object for each");
    case kRoleShapes:
      reader.has_shapes = true;
      set_unit(reader, around.key, value, spot);
      break;
    case kRoleCategory:
      if (around.key != "score") break;
      reader.has_shapes = reader.has_score = true;
      reader.score = value;
      if (reader.name.empty()) reader.name_spot = spot;
      break;
    case kRoleMatrix:
      // {"rows": 4, "columns": 4, "data": [..]}
      if (around.is_list && reader.matrix.size() < 32) reader.matrix.push_back(value);
      break;
    default:
      break;
  }
}

void take_arkit_text(ArkitReader& reader, const JsonUse::Steps& steps, const std::string& value,
                     JsonSpot spot) {
  if (steps.empty()) fail_json(reader.file, spot, "a text alone; expected a list of frames");
  const JsonStep& around = steps.back();
  if (around.role == kRoleShapes || (around.role == kRoleCategory && around.key == "score"))
    fail_json(reader.file, spot,
              fmt::format("'{}' is a text; expected a number from 0 to 1", show_found(around.key)));
  if (around.role != kRoleCategory || !is_one_of(around.key, {"categoryName", "category_name"})) return;
  reader.name = value;
  reader.name_spot = spot;
}

// Steps of seconds and more are no video's.
void settle_times(ArkitReader& reader) {
  Take& take = reader.take;
  if (take.at_s.empty()) return;
  if (reader.has_raw_times) {
    constexpr double kSlowest = 1.5;
    std::vector<double> steps;
    for (std::size_t i = 1; i < take.at_s.size(); ++i) steps.push_back(take.at_s[i] - take.at_s[i - 1]);
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    if (!steps.empty()) std::nth_element(steps.begin(), middle, steps.end());
    const bool is_ms = !steps.empty() && *middle > kSlowest;
    for (double& at : take.at_s) at = is_ms ? at / 1000 : at;
    take.end_s = is_ms ? take.end_s : take.end_s * 1000;
  }
  take.end_s = std::max(take.end_s, take.at_s.back());
}

}  // namespace

Take read_arkit_json(const std::filesystem::path& file, double fps) {
  ArkitReader reader{file.string(), fps};
  reader.take.file = file.string();
  reader.take.mapping = "arkit";
  JsonUse use;
  use.open = [&](const auto& steps, bool is_list, JsonSpot spot) {
    return open_arkit(reader, steps, is_list, spot);
  };
  use.close = [&](const auto& steps, JsonSpot spot) { close_arkit(reader, steps, spot); };
  use.number = [&](const auto& steps, double value, JsonSpot spot) {
    take_arkit_number(reader, steps, value, spot);
  };
  use.text = [&](const auto& steps, const std::string& value, JsonSpot spot) {
    take_arkit_text(reader, steps, value, spot);
  };
  read_json_stream(file, "a take of ARKit", use);
  if (reader.take.row_count == 0)
    fail_file(reader.take.file, "has no frames; expected a list of objects with faceBlendshapes");
  settle_times(reader);
  return std::move(reader.take);
}

}  // namespace mien
