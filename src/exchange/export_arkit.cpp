// Live Link Face's columns: Epic Games, "Recording Facial Animation from an iOS Device"; units: Apple,
// ARFaceAnchor.BlendShapeLocation.
#include "exchange/export_arkit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "config/ledger.hpp"
#include "config/mapping_data.hpp"
#include "core/text.hpp"
#include "exchange/target_sets.hpp"
#include "render/work_folder.hpp"

namespace mien {

namespace {

constexpr std::array kUnits{"eyeBlinkLeft",
                            "eyeLookDownLeft",
                            "eyeLookInLeft",
                            "eyeLookOutLeft",
                            "eyeLookUpLeft",
                            "eyeSquintLeft",
                            "eyeWideLeft",
                            "eyeBlinkRight",
                            "eyeLookDownRight",
                            "eyeLookInRight",
                            "eyeLookOutRight",
                            "eyeLookUpRight",
                            "eyeSquintRight",
                            "eyeWideRight",
                            "jawForward",
                            "jawRight",
                            "jawLeft",
                            "jawOpen",
                            "mouthClose",
                            "mouthFunnel",
                            "mouthPucker",
                            "mouthRight",
                            "mouthLeft",
                            "mouthSmileLeft",
                            "mouthSmileRight",
                            "mouthFrownLeft",
                            "mouthFrownRight",
                            "mouthDimpleLeft",
                            "mouthDimpleRight",
                            "mouthStretchLeft",
                            "mouthStretchRight",
                            "mouthRollLower",
                            "mouthRollUpper",
                            "mouthShrugLower",
                            "mouthShrugUpper",
                            "mouthPressLeft",
                            "mouthPressRight",
                            "mouthLowerDownLeft",
                            "mouthLowerDownRight",
                            "mouthUpperUpLeft",
                            "mouthUpperUpRight",
                            "browDownLeft",
                            "browDownRight",
                            "browInnerUp",
                            "browOuterUpLeft",
                            "browOuterUpRight",
                            "cheekPuff",
                            "cheekSquintLeft",
                            "cheekSquintRight",
                            "noseSneerLeft",
                            "noseSneerRight",
                            "tongueOut"};

constexpr int kDecimals = 6;

// The units of a pose in the order of kUnits, how far the worst move is off, and what they leave over as ways
// of our moves: "lips.press", 1 at its end; below 0 where a unit does too much.
struct WeighedUnits {
  std::array<double, kUnits.size()> weights{};
  double lost = 0;
  std::map<std::string, double> rest;
};

double round_weight(double weight) { return std::round(weight * 1e4) / 1e4; }

// What readers of the rounded weights come to lacks of the pose. Shares of correctives count as they do.
std::map<std::string, double> find_rest(const Mapping& arkit, const WeighedUnits& units, const Pose& asked) {
  constexpr double kSlight = 0.002;
  std::vector<double> weights(arkit.units.size(), 0), moves(kMoveCount, 0);
  for (std::size_t u = 0; u < kUnits.size(); ++u)
    if (const auto unit = find_unit(arkit, kUnits[u])) weights[*unit] = units.weights[u];
  add_mapped_moves(arkit, weights, moves);
  std::map<std::string, double> rest;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const double left = asked.values[i] - moves[i];
    if (std::abs(left) <= kSlight) continue;
    double end = left > 0 ? kMoves[i].high : kMoves[i].low;
    if (end == 0) end = left > 0 ? kMoves[i].low : kMoves[i].high;  // less of its only way
    rest[name_way(i, end)] = round_weight(left / end);
  }
  return rest;
}

WeighedUnits weigh_units(const Spec& spec, const std::vector<TargetPose>& poses, const Pose& asked) {
  // What units that correct others do is a share of those.
  const Mapping& arkit = spec.mappings->mappings.at("arkit");
  Pose pose = asked;
  for (const MappedUnit& unit : arkit.units)
    if (unit.corrects)
      for (const MappedMove& moved : unit.moves) pose.values[moved.move] = 0;
  std::vector<double> shares = share_poses(poses, pose);
  WeighedUnits units;
  units.lost = measure_unshared(poses, pose);
  for (std::size_t i = 0; i < arkit.units.size(); ++i) {
    const MappedUnit& unit = arkit.units[i];
    if (!unit.corrects || unit.moves.empty()) continue;
    const double share = asked.values[unit.moves.front().move] / unit.moves.front().value;
    shares[i] = std::clamp(share, 0.0, 1.0) * shares[*unit.corrects];
  }
  for (std::size_t u = 0; u < kUnits.size(); ++u)
    for (std::size_t i = 0; i < poses.size(); ++i)
      if (poses[i].name == kUnits[u]) units.weights[u] = round_weight(shares[i]);
  units.rest = find_rest(arkit, units, asked);
  return units;
}

// "00:00:01:12.000" at the clip's rate.
std::string format_timecode(int frame, int fps) {
  const int seconds = frame / fps;
  return fmt::format("{:02}:{:02}:{:02}:{:02}.000", seconds / 3600, seconds / 60 % 60, seconds % 60,
                     frame % fps);
}

std::array<double, 9> list_angles_rad(const Figure& figure, const Moment& moment) {
  const auto angle = [](double deg) { return glm::radians(deg); };
  std::array<double, 9> angles{angle(moment.turn.turn_deg), angle(moment.turn.nod_deg),
                               angle(moment.turn.tilt_deg)};
  for (const Side side : {Side::left, Side::right}) {
    const glm::dvec3 look = compute_gaze(figure.face, moment.pose, side) * glm::dvec3(0, 0, 1);
    const std::size_t first = side == Side::left ? 3 : 6;
    angles[first] = std::atan2(look.x, look.z);
    angles[first + 1] = -std::asin(std::clamp(look.y, -1.0, 1.0));
  }
  return angles;
}

}  // namespace

ExportNotes export_live_link(const ExportWork& work, const std::filesystem::path& path) {
  const std::vector<TargetPose> poses = build_target_set("arkit", work.clip.spec);
  std::string text = "Timecode,BlendShapeCount";
  for (std::string unit : kUnits) {
    unit[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(unit[0])));
    text += "," + unit;
  }
  for (const char* of : {"Head", "LeftEye", "RightEye"})
    for (const char* angle : {"Yaw", "Pitch", "Roll"}) text += fmt::format(",{}{}", of, angle);
  std::vector<Moment> moments;
  std::vector<WeighedUnits> weighed;
  std::set<std::string> rests;  // columns of what is ever left over
  double lost = 0;
  for (int frame = work.first; frame <= work.last; ++frame) {
    moments.push_back(sample_performance(work.performance, work.compute_time_s(frame)));
    weighed.push_back(weigh_units(work.clip.spec, poses, moments.back().pose));
    lost = std::max(lost, weighed.back().lost);
    for (const auto& [way, share] : weighed.back().rest) rests.insert(way);
  }
  for (const std::string& way : rests) text += fmt::format(",{}{}", kOwnUnit, way);
  text += "\n";
  for (int frame = work.first; frame <= work.last; ++frame) {
    const auto at = static_cast<std::size_t>(frame - work.first);
    const WeighedUnits& units = weighed[at];
    text += fmt::format("{},{}", format_timecode(frame - work.first, static_cast<int>(work.fps())),
                        kUnits.size() + 9);
    for (const double weight : units.weights) text += "," + format_number(weight, kDecimals);
    for (const double angle : list_angles_rad(work.figure, moments[at]))
      text += "," + format_number(angle, kDecimals);
    for (const std::string& way : rests) {
      const auto rest = units.rest.find(way);
      text += "," + format_number(rest == units.rest.end() ? 0 : rest->second, kDecimals);
    }
    text += "\n";
  }
  write_file(path, text);
  return {fmt::format(
      "{} rows of ARKit's {} units; a move is off by at most {:.0f} % of its limit, for which there is no "
      "unit{}",
      work.frame_count(), kUnits.size(), 100 * lost,
      rests.empty() ? "" : "; columns of mien's own say the rest")};
}

ExportNotes export_face_units(const ExportWork& work, const std::filesystem::path& path) {
  const std::vector<TargetPose> poses = build_target_set("arkit", work.clip.spec);
  const Pose pose = sample_performance(work.performance, work.compute_time_s(work.first)).pose;
  const WeighedUnits weighed = weigh_units(work.clip.spec, poses, pose);
  nlohmann::ordered_json units = nlohmann::ordered_json::object();
  for (std::size_t u = 0; u < kUnits.size(); ++u)
    if (weighed.weights[u] > 0) units[kUnits[u]] = weighed.weights[u];
  nlohmann::ordered_json face{{"name", work.title()},
                              {"description", ""},
                              {"author", work.clip.spec.author},
                              {"license", work.clip.spec.licence},
                              {"face_units", units}};
  // Others read the units; what these leave over is there for mien.
  if (!weighed.rest.empty()) face["mien"] = weighed.rest;
  write_file(path, face.dump(2) + "\n");
  return {fmt::format(
      "{} of ARKit's {} units, frame {}; a move is off by at most {:.0f} % of its limit, for which there "
      "is no unit{}",
      units.size(), kUnits.size(), work.first, 100 * weighed.lost,
      weighed.rest.empty() ? "" : "; 'mien' says the rest")};
}

}  // namespace mien
