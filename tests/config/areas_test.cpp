// Every row of the tables of areas and moves is full and fits the others: what a new area forgets fails here.
#include "config/areas.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

#include "config/clip_spec.hpp"
#include "config/ledger.hpp"
#include "config/limits.hpp"
#include "config/words.hpp"
#include "places.hpp"

namespace mien {
namespace {

// "EYELID_{L,R}U_U_VERT_LIMIT" for "EYELID_@U_U_VERT_LIMIT": one word of the thesis whatever the side.
bool is_thesis_name(std::string_view name) {
  static const std::regex kName("[A-Z]+(_([A-Z]+|@|~|@[UD]))*_(LIMIT|LEVEL|RANGE)");
  return std::regex_match(name.begin(), name.end(), kName);
}

// A landmark, a point of the cage, or a run of such points.
void expect_places(PlaceText text, std::string_view of) {
  static const std::string kPlace = "((R:)?[A-Za-z]+[0-9]*_[A-Za-z]*[0-9]+(\\.\\.[0-9]+)?|[a-z]+(_[a-z]+)*)";
  static const std::regex kPlaces(kPlace + "( " + kPlace + ")*");
  EXPECT_TRUE(std::regex_match(text.begin(), text.end(), kPlaces)) << of << ": '" << text << "'";
}

bool has_move(const AreaInfo& area, std::string_view move) {
  return std::ranges::any_of(kMoves,
                             [&](const MoveInfo& info) { return info.of == area.area && info.move == move; });
}

TEST(areas, rows_stand_in_the_order_of_their_names) {
  for (std::size_t i = 0; i < kAreas.size(); ++i) EXPECT_EQ(static_cast<std::size_t>(kAreas[i].area), i);
  std::set<std::string_view> keys;
  for (const AreaKey& key : kAreaKeys) EXPECT_TRUE(keys.insert(key.key).second) << key.key;
}

TEST(areas, every_area_fills_its_row) {
  std::set<LeadPart> parts;
  std::set<int> orders;
  for (const AreaInfo& area : kAreas) {
    SCOPED_TRACE(area.name);
    EXPECT_FALSE(area.name.empty());
    EXPECT_EQ(area.left_key.empty(), !area.has_sides());
    EXPECT_EQ(area.right_key.empty(), !area.has_sides());
    EXPECT_FALSE(area.title.empty());
    EXPECT_TRUE(area.has_sides() || area.is_one_column);
    EXPECT_TRUE(area.aside.empty() || has_move(area, area.aside));
    EXPECT_EQ(area.aside.empty(), area.sign != AreaSign::way && area.sign != AreaSign::turned_way);
    const std::vector<std::string_view> drawn =
        area.sign == AreaSign::words  ? std::vector<std::string_view>{}
        : area.sign == AreaSign::pair ? std::vector<std::string_view>{"upper", "lower"}
        : area.sign == AreaSign::lift ? std::vector<std::string_view>{"up", "down"}
                                      : std::vector<std::string_view>{"up", area.aside};
    for (const std::string_view move : drawn) EXPECT_TRUE(has_move(area, move)) << move;

    EXPECT_TRUE(parts.insert(area.lead.part).second);
    EXPECT_LT(static_cast<std::size_t>(area.lead.part), kFacePartCount);
    EXPECT_EQ(&find_area(area.lead.part), &area);
    for (const double after_s :
         {area.lead.natural_s, area.lead.rounds_s, area.lead.unrounds_s, area.lead.falls_s}) {
      EXPECT_GE(after_s, 0);
      EXPECT_LE(after_s, 0.3);  // longer, and it is no overlap but another move
    }
    EXPECT_GE(area.lean.weakness, 0);
    EXPECT_LE(area.lean.weakness, 1);
    EXPECT_TRUE(area.has_sides() || area.lean.weakness == 0);

    expect_places(area.framing.around, "framing");
    EXPECT_GT(area.framing.spread, 0);
    for (const PlaceText outline : area.outlines)
      if (!outline.empty()) expect_places(outline, "outline");

    EXPECT_TRUE(orders.insert(area.limits.order).second);
    EXPECT_FALSE(area.limits.heading.empty());
    EXPECT_FALSE(area.limits.caption.empty());
    expect_places(area.limits.framing.around, "framing of the limits");
    EXPECT_GT(area.limits.framing.spread, 0);
    EXPECT_FALSE(area.limits.marks.empty());
    for (const LimitMark& mark : area.limits.marks) {
      expect_places(mark.places, "mark");
      EXPECT_TRUE(mark.move.empty() ? mark.value == 0 : has_move(area, mark.move)) << mark.move;
      EXPECT_EQ(mark.shape == LimitShape::level, !mark.word.empty());
      EXPECT_TRUE(mark.shape != LimitShape::box || has_move(area, "up"));
    }
  }
  EXPECT_EQ(*orders.begin(), 0);
  EXPECT_EQ(*orders.rbegin(), static_cast<int>(kAreas.size()) - 1);
}

TEST(areas, every_move_fills_its_row) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const MoveInfo& info = kMoves[i];
    SCOPED_TRACE(name_move(i));
    EXPECT_TRUE(names.insert(name_move(i)).second);
    EXPECT_EQ(info.area, find_area(info.of).name);
    EXPECT_EQ(info.side != Side::none, find_area(info.of).has_sides());
    EXPECT_EQ(find_move(info.area, info.side, info.move), i);
    EXPECT_LE(info.low, 0);
    EXPECT_GT(info.high, 0);
    EXPECT_FALSE(info.meaning.empty());
    EXPECT_FALSE(info.landmark.empty());
    expect_places(info.arrows, "arrows");
    EXPECT_FALSE(info.plus.name.empty());
    EXPECT_EQ(info.minus.name.empty(), info.low == 0);
    for (const MoveWay* way : {&info.plus, &info.minus})
      EXPECT_TRUE(way->thesis.empty() || is_thesis_name(way->thesis)) << way->thesis;
    // Of the thesis's areas the eyeballs alone have no limits of their own: the lids' outline bounds them.
    EXPECT_EQ(info.plus.thesis.empty(), info.of == Area::eye || info.is_beyond);
  }
}

TEST(areas, nine_are_tezukas_and_come_first) {
  std::size_t nine = 0;
  bool is_past = false;
  for (const AreaInfo& area : kAreas) {
    if (is_beyond(area)) {
      is_past = true;
      continue;
    }
    EXPECT_FALSE(is_past) << area.name;
    nine += area.has_sides() && area.area != Area::eye && area.area != Area::lid ? 2 : 1;
  }
  EXPECT_EQ(nine, 8u);  // with both eyes' lids as one and both eyeballs as one
}

TEST(areas, landmarks_of_moves_are_landmarks_of_the_head) {
  std::ifstream file(std::filesystem::path(source_folder()) / "templates/head/landmarks.yaml");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  for (const MoveInfo& info : kMoves)
    EXPECT_NE(text.find("\n  " + std::string(info.landmark) + ":"), text.npos) << info.landmark;
}

TEST(areas, limits_are_named_once_and_by_the_thesis) {
  std::set<std::string> names;
  std::size_t ways = 0;
  for (const MoveInfo& info : kMoves) ways += info.plus.is_limit() + info.minus.is_limit();
  EXPECT_EQ(list_limits().size(), ways);
  for (const LimitName& limit : list_limits()) {
    EXPECT_TRUE(names.insert(limit.name).second) << limit.name;
    EXPECT_EQ(limit.thesis.find_first_of("@~"), std::string::npos) << limit.thesis;
  }
}

TEST(areas, parts_of_a_lead_are_the_areas_and_the_head) {
  ASSERT_EQ(kLeadKeys.size(), kLeadCount);
  EXPECT_EQ(kReleaseKeys, Names(kLeadKeys.begin(), kLeadKeys.end() - 1));
  EXPECT_EQ(kLeadKeys.back(), "head");
  for (const AreaInfo& area : kAreas)
    EXPECT_EQ(kNaturalLead.after_s[static_cast<std::size_t>(area.lead.part)], area.lead.natural_s);
  EXPECT_EQ(kNaturalLead.after_s.back(), kHeadLead.natural_s);
}

}  // namespace
}  // namespace mien
