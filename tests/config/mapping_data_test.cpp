// The vocabularies of other programs.
#include "config/mapping_data.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "config/config_fixture.hpp"
#include "config/data_table.hpp"

namespace mien {
namespace {

const MappingData& find_data() { return *find_language()->libraries.mappings; }
const Mapping& find_mapping(const std::string& name) { return mien::find_mapping(find_data(), name); }

const MappedUnit& find_named(const std::string& mapping, const std::string& unit) {
  const Mapping& found = find_mapping(mapping);
  return found.units.at(find_unit(found, unit).value());
}

double find_moved(const MappedUnit& unit, Area area, Side side, std::string_view move) {
  for (const MappedMove& moved : unit.moves)
    if (moved.move == find_move(area, side, move)) return moved.value;
  return 0;
}

TEST(mappings, arkit_has_its_52_units) {
  EXPECT_EQ(find_mapping("arkit").units.size(), 52u);
  EXPECT_EQ(find_mapping("makehuman").units.size(), 60u);
  EXPECT_FALSE(find_mapping("arkit").source.empty());
}

TEST(mappings, both_sides_do_the_same) {
  const Mapping& arkit = find_mapping("arkit");
  for (const MappedUnit& unit : arkit.units) {
    if (!unit.name.ends_with("Left")) continue;
    const auto right = find_unit(arkit, unit.name.substr(0, unit.name.size() - 4) + "Right");
    ASSERT_TRUE(right) << unit.name;
    EXPECT_EQ(arkit.units[*right].moves.size(), unit.moves.size()) << unit.name;
    for (const MappedMove& moved : unit.moves) {
      const MoveInfo& info = kMoves[moved.move];
      const Side other = info.side == Side::left    ? Side::right
                         : info.side == Side::right ? Side::left
                                                    : Side::none;
      const bool is_aside = info.move == "side";
      EXPECT_NEAR(find_moved(arkit.units[*right], info.of, other, info.move),
                  is_aside ? -moved.value : moved.value, 0.0101)
          << unit.name << " " << name_move(moved.move);
    }
  }
}

TEST(mappings, units_do_what_their_names_say) {
  const auto moved = [](const char* unit, Area area, Side side, std::string_view move) {
    return find_moved(find_named("arkit", unit), area, side, move);
  };
  EXPECT_LT(moved("browDownLeft", Area::brow, Side::left, "up"), -0.2);
  EXPECT_GT(moved("browInnerUp", Area::brow, Side::right, "turn"), 0.2);
  EXPECT_LT(moved("eyeBlinkLeft", Area::lid, Side::left, "upper"), -0.8);
  EXPECT_EQ(moved("eyeBlinkLeft", Area::lid, Side::right, "upper"), 0);
  EXPECT_GT(moved("eyeWideRight", Area::lid, Side::right, "upper"), 0.2);
  EXPECT_GT(moved("jawOpen", Area::chin, Side::none, "down"), 0.5);
  EXPECT_GT(moved("mouthSmileLeft", Area::corner, Side::left, "up"), 0.4);
  EXPECT_LT(moved("mouthFrownRight", Area::corner, Side::right, "up"), -0.2);
  EXPECT_GT(moved("mouthPucker", Area::lips, Side::none, "pucker"), 0.9);
  EXPECT_GT(moved("eyeLookOutLeft", Area::eye, Side::left, "side"), 0.9);  // to the character's left
  EXPECT_LT(moved("eyeLookOutRight", Area::eye, Side::right, "side"), -0.9);
  EXPECT_LT(moved("eyeLookDownLeft", Area::eye, Side::left, "up"), -0.9);
}

TEST(mappings, lips_that_shut_an_open_jaw_are_shut) {
  const Mapping& arkit = find_mapping("arkit");
  std::vector<double> weights(arkit.units.size());
  weights[*find_unit(arkit, "jawOpen")] = 0.4;
  std::array<double, kMoveCount> open{}, shut{};
  add_mapped_moves(arkit, weights, open);
  weights[*find_unit(arkit, "mouthClose")] = 0.9;  // it corrects no more than there is
  add_mapped_moves(arkit, weights, shut);
  const std::size_t down = *find_move(Area::chin, Side::none, "down"),
                    together = *find_move(Area::lips, Side::none, "shut");
  EXPECT_GT(open[down], 0.25);
  EXPECT_EQ(open[together], 0);
  EXPECT_NEAR(shut[down], open[down], 1e-9);  // the jaw stays open
  EXPECT_NEAR(shut[together], 1, 1e-9);
}

TEST(mappings, what_is_lost_of_each_unit_is_measured) {
  for (const MappedUnit& unit : find_mapping("arkit").units) {
    EXPECT_GE(unit.residual, 0) << unit.name;
    if (unit.name == "tongueOut") continue;
    EXPECT_GT(unit.motion_mm2, 0) << unit.name;
    EXPECT_TRUE(!unit.moves.empty() || unit.residual == 1) << unit.name;
  }
  EXPECT_LT(find_named("arkit", "cheekPuff").residual, 0.3);
  EXPECT_LT(find_named("arkit", "jawOpen").residual, 0.3);
  EXPECT_LT(find_named("arkit", "mouthSmileLeft").residual, 0.5);
}

// All of ARKit's 52, each at 1: what people's skin does there, and what ours leaves over.
TEST(mappings, less_than_a_tenth_of_arkits_motion_is_lost) {
  double moved = 0, lost = 0;
  for (const MappedUnit& unit : find_mapping("arkit").units) {
    moved += unit.motion_mm2;
    lost += unit.motion_mm2 * std::min(unit.residual, 1.0);
  }
  EXPECT_GT(moved, 300);
  EXPECT_LT(lost / moved, 0.1);
  EXPECT_LT(find_named("arkit", "mouthClose").residual, 0.1);
}

TEST(mappings, a_unit_that_is_like_others_moves_and_loses_as_they_do) {
  const MappedUnit& smile = find_named("facs", "AU12");
  const MappedUnit& left = find_named("arkit", "mouthSmileLeft");
  EXPECT_NEAR(find_moved(smile, Area::corner, Side::left, "up"),
              find_moved(left, Area::corner, Side::left, "up"), 1e-9);
  EXPECT_NEAR(smile.motion_mm2, left.motion_mm2 + find_named("arkit", "mouthSmileRight").motion_mm2, 1e-9);
  EXPECT_NEAR(find_named("facs", "AU26").motion_mm2, find_named("arkit", "jawOpen").motion_mm2 / 4, 1e-9);
  EXPECT_EQ(find_named("facs", "AU38").residual, 1);
}

TEST(mappings, each_move_has_its_way) {
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    EXPECT_GT(find_data().ways_mm[i], 1) << name_move(i);
    EXPECT_LT(find_data().ways_mm[i], 60) << name_move(i);
  }
}

TEST(mappings, a_gaze_is_measured_as_the_eyes_turn) {
  Findings findings;
  const auto document = load_document(kData / "templates/head/areas.yaml", findings);
  const YamlMapping areas = load_free_mapping(find_root(*document, findings), "");
  const YamlMapping eyes = load_free_mapping(*find_value(areas, "eyes"), "");
  const char* keys[] = {"side_deg", "up_deg", "down_deg"};
  for (std::size_t i = 0; i < 3; ++i) {
    double most = 0;
    ASSERT_TRUE(load_datum(*find_value(eyes, keys[i]), most));
    EXPECT_EQ(find_data().moves.gaze_deg[i], most) << keys[i];
  }
}

// What is said of a mapping in place of ours.
std::string find_mapping_fault(const std::string& from, const std::string& to) {
  const auto folder = make_test_folder();
  std::filesystem::create_directories(folder / "configs");
  std::filesystem::copy(kData / "configs/mappings", folder / "configs/mappings",
                        std::filesystem::copy_options::recursive);
  std::string text = read_file(folder / "configs/mappings/facs.yaml");
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  write_file(folder / "configs/mappings/facs.yaml", text.replace(at, from.size(), to));
  Findings findings;
  load_mapping_data(folder, find_language()->libraries, findings);
  return findings.mistakes.empty() ? "" : findings.mistakes[0].message;
}

TEST(mappings, a_mistake_is_told_at_its_place) {
  EXPECT_EQ(find_mapping_fault("AU1: {like:", "AU1: {lik:"), "unknown key 'lik'; did you mean 'like'?");
  EXPECT_EQ(find_mapping_fault("{jawOpen: 0.5}", "{jawOpn: 0.5}"),
            "unknown unit 'jawOpn'; did you mean 'jawOpen'?");
  EXPECT_EQ(find_mapping_fault("{lids.upper: -0.4}", "{lids.uper: -0.4}"),
            "unknown move 'lids.uper'; did you mean 'lids.upper'?");
  EXPECT_NE(find_mapping_fault("{lids.upper: -0.4}", "{lids.upper: -4}"), "");
  EXPECT_NE(find_mapping_fault("emfacs/joy", "emfacs/joi"), "");
  EXPECT_EQ(find_mapping_fault("AU12+AU25", "AU12+AU25"), "");
}

}  // namespace
}  // namespace mien
