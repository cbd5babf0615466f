// OpenFace 2's CSV (FeatureExtraction): a row a frame with timestamp, confidence, success, the action units
// AU01_r to AU45_r from 0 to 5 (and AU28_c, of which there is only whether it is there), the head's angles
// pose_Rx, pose_Ry, pose_Rz and the gaze's gaze_angle_x, gaze_angle_y in radians. Source: OpenFace wiki,
// "Output format". Other columns, among them all landmarks, are passed.
//
// The camera's axes are x to the right of the picture, y down, z away from it, and a face at rest looks along
// -z. R = Rx Ry Rz takes its forward (0, 0, -1) to x = -sin(ry): Ry turns to the character's right, Rx nods,
// Rz tilts to its left, as the picture's right is. A gaze is told in the camera's axes, too: of x to the left
// of the character and of y down; what the head does is taken off.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numbers>
#include <optional>

#include "import/reading.hpp"
#include "import/take_reading.hpp"

namespace mien {

namespace {

constexpr double kMostIntensity = 5;  // E of FACS
constexpr double kLeastConfidence = 0.7;
constexpr double kVideoRate = 30;
constexpr double kHalfTurn = std::numbers::pi;

struct OpenFaceColumns {
  std::optional<std::size_t> time, frame, face, confidence, success;
  std::array<std::optional<std::size_t>, 3> pose;
  std::array<std::optional<std::size_t>, 2> gaze;
  std::vector<std::size_t> units;
  std::vector<double> most;  // of each unit
  std::vector<std::string> names;
};

// "AU06_r": 6; 0 of what is no such name.
int find_unit_number(std::string_view name) {
  if (!name.starts_with("AU") || name.size() < 5) return 0;
  int number = 0;
  const auto [end, error] = std::from_chars(name.data() + 2, name.data() + name.size() - 2, number);
  return error == std::errc() && end == name.data() + name.size() - 2 ? number : 0;
}

OpenFaceColumns find_openface_columns(const TakeRows& rows, Take& take) {
  OpenFaceColumns columns;
  columns.time = find_take_column(rows, "timestamp");
  columns.frame = find_take_column(rows, "frame");
  columns.face = find_take_column(rows, "face_id");
  columns.confidence = find_take_column(rows, "confidence");
  columns.success = find_take_column(rows, "success");
  constexpr std::array<std::string_view, 3> kPose{"pose_Rx", "pose_Ry", "pose_Rz"};
  constexpr std::array<std::string_view, 2> kGaze{"gaze_angle_x", "gaze_angle_y"};
  for (std::size_t i = 0; i < 3; ++i) columns.pose[i] = find_take_column(rows, kPose[i]);
  for (std::size_t i = 0; i < 2; ++i) columns.gaze[i] = find_take_column(rows, kGaze[i]);
  if (!columns.time && !columns.frame)
    fail_take(find_take_place(rows, 0),
              "no column is 'timestamp'; expected the first line of OpenFace's CSV");
  for (std::size_t i = 0; i < rows.cells.size(); ++i) {
    const std::string_view name = rows.cells[i].word;
    columns.names.emplace_back(name);
    const int number = find_unit_number(name);
    const bool is_intensity = name.ends_with("_r");
    // The others are told twice, how much and whether.
    if (number == 0 || (!is_intensity && number != 28)) continue;
    add_take_channel(take, find_take_place(rows, i), fmt::format("AU{}", number));
    columns.units.push_back(i);
    columns.most.push_back(is_intensity ? kMostIntensity : 1);
  }
  if (columns.units.empty())
    fail_take(find_take_place(rows, 0), "no column is an action unit; expected some, such as AU12_r");
  return columns;
}

bool is_face_seen(const TakeRows& rows, const OpenFaceColumns& columns) {
  if (columns.success && parse_take_number(rows, *columns.success, "success", 0, 1) < 0.5) return false;
  return !columns.confidence ||
         parse_take_number(rows, *columns.confidence, "confidence", 0, 1) >= kLeastConfidence;
}

std::array<float, 3> read_pose(const TakeRows& rows, const OpenFaceColumns& columns) {
  std::array<float, 3> turn{};
  constexpr std::array<std::size_t, 3> kTurnOf{1, 0, 2};  // Rx is the nod, Ry the turn
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle =
        parse_take_number(rows, *columns.pose[i], columns.names[*columns.pose[i]], -kHalfTurn, kHalfTurn);
    turn[kTurnOf[i]] = static_cast<float>((i == 1 ? -angle : angle) * 180 / kHalfTurn);
  }
  return turn;
}

std::array<float, 2> read_gaze(const TakeRows& rows, const OpenFaceColumns& columns,
                               const std::array<float, 3>& turn_deg) {
  std::array<double, 2> angle{};
  for (std::size_t i = 0; i < 2; ++i)
    angle[i] =
        parse_take_number(rows, *columns.gaze[i], columns.names[*columns.gaze[i]], -kHalfTurn, kHalfTurn) *
        180 / kHalfTurn;
  return {static_cast<float>(angle[0]) - turn_deg[0], turn_deg[1] - static_cast<float>(angle[1])};
}

// One face: where several are followed, rows are of all of them in turn.
void check_face(const TakeRows& rows, const OpenFaceColumns& columns, std::string& face) {
  if (!columns.face) return;
  const std::string_view word = rows.cells[*columns.face].word;
  if (face.empty()) face = word;
  if (word != face)
    fail_take(find_take_place(rows, *columns.face),
              fmt::format("face {} after face {}; expected the rows of one face", show_found(word), face));
}

}  // namespace

Take read_openface(const std::filesystem::path& file, double fps) {
  TakeRows rows = open_take_rows(file, "a take of OpenFace");
  Take take;
  take.file = rows.file;
  take.mapping = "facs";
  const OpenFaceColumns columns = find_openface_columns(rows, take);
  const auto has_all = [](const auto& cells) {
    return std::ranges::all_of(cells, [](const auto& cell) { return cell.has_value(); });
  };
  const bool has_pose = has_all(columns.pose), has_gaze = has_pose && has_all(columns.gaze);
  const std::size_t time = columns.time ? *columns.time : *columns.frame;
  constexpr double kMostFrame = 1e9;
  double first_s = 0;
  std::string face;
  while (read_take_row(rows)) {
    if (rows.cells.size() != columns.names.size())
      fail_take(find_take_place(rows, 0),
                fmt::format("this line has {} cell{}; expected {} as in the first line", rows.cells.size(),
                            rows.cells.size() == 1 ? "" : "s", columns.names.size()));
    check_face(rows, columns, face);
    double at_s =
        parse_take_number(rows, time, columns.names[time], 0, columns.time ? kMaxTakeTime_s : kMostFrame);
    if (!columns.time) at_s /= fps > 0 ? fps : kVideoRate;
    if (take.row_count == 0) first_s = at_s;
    if (!begin_take_row(take, find_take_place(rows, time), at_s - first_s)) continue;
    if (!is_face_seen(rows, columns)) {
      ++take.unseen_count;
      continue;
    }
    take.at_s.push_back(at_s - first_s);
    for (std::size_t i = 0; i < columns.units.size(); ++i) {
      const std::size_t cell = columns.units[i];
      take.values.push_back(static_cast<float>(
          parse_take_number(rows, cell, columns.names[cell], 0, columns.most[i]) / columns.most[i]));
    }
    if (has_pose) take.turn_deg.push_back(read_pose(rows, columns));
    if (has_gaze) take.gaze_deg.push_back(read_gaze(rows, columns, take.turn_deg.back()));
  }
  return take;
}

}  // namespace mien
