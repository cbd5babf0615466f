// Sources: MPFB, docs/fileformats/expression.md; MakeHuman, data/expressions/*.mhpose.
#include "import/unit_pose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/text.hpp"
#include "import/json_stream.hpp"
#include "import/reading.hpp"
#include "import/take_reading.hpp"

namespace mien {

namespace {

constexpr std::uintmax_t kMostPoseBytes = 1 << 20;  // an expression has some kilobytes
constexpr std::size_t kMostPosedUnits = 200;
constexpr double kMostPosed = 2;  // ranges are 0 to 1

enum PoseRole { kPoseOther, kPoseWhole, kPoseUnits, kPoseOwn };

bool is_of_units(const JsonStep& step) { return step.role == kPoseUnits || step.role == kPoseOwn; }

void take_posed_unit(UnitPose& pose, const std::string& key, bool is_own, double value, JsonSpot spot) {
  if (std::abs(value) > kMostPosed)
    fail_json(pose.file, spot,
              fmt::format("'{}' is {:.7g}; expected a number from {} to 1", show_found(key), value,
                          is_own ? -1 : 0));
  if (pose.units.size() >= kMostPosedUnits)
    fail_json(pose.file, spot, fmt::format("more than {} units; expected those of a face", kMostPosedUnits));
  std::string name = is_own                    ? fmt::format("{}{}", kOwnUnit, key)
                     : pose.mapping == "arkit" ? build_arkit_name(key)
                                               : key;
  if (std::ranges::find(pose.units, name, &PosedUnit::name) != pose.units.end())
    fail_json(pose.file, spot, fmt::format("'{}' is there twice; expected it once", show_found(key)));
  pose.units.push_back({std::move(name), value, spot.line, spot.column});
}

}  // namespace

UnitPose load_unit_pose(const std::filesystem::path& file) {
  const std::string expected = "an expression of MPFB or MakeHuman";
  read_plain_file(file, file.string(), expected, kMostPoseBytes);  // or tells why not
  UnitPose pose;
  pose.file = file.string();
  bool has_units = false;
  JsonUse use;
  use.open = [&](const JsonUse::Steps& steps, bool is_list, JsonSpot spot) -> int {
    if (steps.empty() && is_list) fail_json(pose.file, spot, "a list; expected an object");
    if (steps.empty()) return kPoseWhole;
    const JsonStep& around = steps.back();
    if (is_of_units(around))
      fail_json(pose.file, spot,
                fmt::format("'{}' is no number; expected one from 0 to 1", show_found(around.key)));
    if (around.role == kPoseWhole && around.key == "mien" && !is_list) return kPoseOwn;
    if (around.role != kPoseWhole || (around.key != "face_units" && around.key != "unit_poses"))
      return kPoseOther;
    if (is_list || has_units)
      fail_json(pose.file, spot,
                fmt::format("'{}' is {}; expected one object of units", around.key,
                            is_list ? "a list" : "there after other units"));
    has_units = true;
    pose.mapping = around.key == "face_units" ? "arkit" : "makehuman";
    return kPoseUnits;
  };
  use.number = [&](const JsonUse::Steps& steps, double value, JsonSpot spot) {
    if (steps.empty()) fail_json(pose.file, spot, "a number alone; expected an object");
    if (is_of_units(steps.back()))
      take_posed_unit(pose, steps.back().key, steps.back().role == kPoseOwn, value, spot);
  };
  use.text = [&](const JsonUse::Steps& steps, const std::string& value, JsonSpot spot) {
    if (steps.empty()) fail_json(pose.file, spot, "a text alone; expected an object");
    const JsonStep& around = steps.back();
    if (is_of_units(around))
      fail_json(pose.file, spot,
                fmt::format("'{}' is a text; expected a number from 0 to 1", show_found(around.key)));
    if (around.role == kPoseWhole && around.key == "name") pose.name = value;
  };
  read_json_stream(file, expected, use);
  if (!has_units)
    fail_json(pose.file, {}, "the object has no 'face_units' and no 'unit_poses'; expected one of them");
  return pose;
}

Take build_unit_take(const UnitPose& pose) {
  Take take;
  take.file = pose.file;
  take.mapping = pose.mapping;
  for (const PosedUnit& unit : pose.units) {
    take.channels.push_back({unit.name, unit.line, unit.column});
    take.values.push_back(static_cast<float>(unit.value));
  }
  take.at_s = {0};
  take.row_count = 1;
  return take;
}

bool is_unit_pose(const std::filesystem::path& file) {
  const std::string ending = find_ending(file);
  if (ending == ".mhpose") return true;
  if (ending != ".json") return false;
  std::ifstream stream(file, std::ios::binary);
  constexpr std::size_t kGlimpse = 4096;  // bytes
  std::string text(kGlimpse, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text.find("\"face_units\"") != text.npos || text.find("\"unit_poses\"") != text.npos;
}

}  // namespace mien
