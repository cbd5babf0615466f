#include "timeline/chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "timeline/exposure.hpp"

namespace mien {
namespace {

PoseKey build_key(double at_s, std::string label, double brows, double lips) {
  PoseKey key;
  key.at_s = at_s;
  key.ease = Easing::linear;
  key.label = std::move(label);
  for (const Side side : {Side::left, Side::right})
    key.pose.values[*find_move(Area::brow, side, "up")] = brows;
  key.pose.values[*find_move(Area::lips, Side::none, "upper")] = lips;
  return key;
}

ClipSpec build_clip() {
  ClipSpec clip;
  clip.length_s = 2;
  clip.keys = {build_key(0, "neutral", 0, 0), build_key(1, "surprise", 1, -0.5),
               build_key(2, "neutral", 0, 0)};
  return clip;
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string chart(const ClipSpec& clip, const ChartStyle& style) {
  const Performance performance = build_performance(clip);
  return build_chart(performance.clip, rehearse(performance).shown, style);
}

int count_columns(const std::string& line) {
  return static_cast<int>(std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; }));
}

TEST(chart, shows_times_keys_and_areas) {
  EXPECT_EQ(chart(build_clip(), {61, true}),
            "             0s          0.5s        1s          1.5s\n"
            "keys         neutral                 surprise\n"
            "             v                       v                      v\n"
            "brows        .::::---===+++***###%%%@@@%%%###***+++===---::::\n"
            "lids         ................................................\n"
            "eyes         ................................................\n"
            "lips         .::::::::------======+++++++======------::::::::\n"
            "corners      ................................................\n"
            "chin         ................................................\n"
            "head         ................................................\n");
}

TEST(chart, is_as_wide_as_asked_and_not_narrower_than_it_can_be) {
  for (const bool is_ascii : {true, false})
    for (const int width : {1, 40, 80, 133, 200}) {
      ClipSpec clip = build_clip();
      for (const double length_s : {0.0, 0.3, 2.0, 300.0}) {
        clip.length_s = length_s;
        for (const std::string& line : split_lines(chart(clip, {width, is_ascii})))
          EXPECT_LE(count_columns(line), std::max(width, 40)) << line;
      }
    }
}

TEST(chart, has_a_row_for_each_side_where_they_differ) {
  ClipSpec clip = build_clip();
  clip.keys[1].pose.values[*find_move(Area::brow, Side::left, "up")] = 0.2;
  std::vector<std::string> names;
  for (const ChartRow& row : list_chart_rows(rehearse(build_performance(clip)).shown))
    names.push_back(row.name);
  EXPECT_EQ(names, (std::vector<std::string>{"brow.left", "brow.right", "lids", "eyes", "lips", "corners",
                                             "chin", "head"}));
}

TEST(chart, shows_a_blink_even_where_a_column_holds_many_frames) {
  ClipSpec clip;
  clip.length_s = 100;
  clip.blinks_s = {50};
  const auto lines = split_lines(chart(clip, {80, true}));
  const auto lids =
      std::ranges::find_if(lines, [](const std::string& line) { return line.starts_with("lids"); });
  EXPECT_EQ(std::ranges::count(*lids, '@'), 1);
}

TEST(exposure, numbers_drawings_and_tells_what_changed) {
  ClipSpec clip = build_clip();
  clip.draw = 2;
  clip.length_s = 0.25;
  clip.turn = {{0.125, {}, 0, 0, 0}, {0.25, {}, 10, 0, 0}};
  EXPECT_EQ(build_exposure_csv(build_exposure(build_performance(clip))),
            "frame,time_s,drawing,held,key,changed\n"
            "1,0,1,,neutral,\n"
            "2,0.041667,1,held,,\n"
            "3,0.083333,2,,,brows lips\n"
            "4,0.125,2,held,,\n"
            "5,0.166667,3,,,brows lips head\n"
            "6,0.208333,3,held,,\n");
}

TEST(exposure, labels_the_last_frame_and_no_moment_after_it) {
  ClipSpec clip;
  clip.length_s = 0.25;  // frames 0 to 5, the last one at 5/24 s
  const auto list_labels = [&](double at_s) {
    clip.keys = {build_key(0, "first", 0, 0), build_key(at_s, "last", 1, 0)};
    std::string labels;
    for (const ExposureLine& line : build_exposure(build_performance(clip)))
      labels += line.key.empty() ? "-" : "[" + line.key + "]";
    return labels;
  };
  EXPECT_EQ(compute_key_frame(clip, 4.5 / 24), 5);
  EXPECT_EQ(compute_key_frame(clip, 5.0 / 24), 5);
  EXPECT_EQ(compute_key_frame(clip, 0.25), 5);
  EXPECT_EQ(list_labels(4.0 / 24), "[first]---[last]-");
  EXPECT_EQ(list_labels(4.5 / 24), "[first]----[last]");
  EXPECT_EQ(list_labels(5.0 / 24), "[first]----[last]");
  EXPECT_EQ(list_labels(0.25), "[first]-----");
  clip.draw = 2;  // frame 5 holds the drawing of frame 4
  EXPECT_EQ(list_labels(4.0 / 24), "[first]---[last]-");
  EXPECT_EQ(list_labels(5.0 / 24), "[first]-----");
  EXPECT_EQ(list_labels(1.0 / 24), "[first]-[last]---") << "the drawing of frame 1 is that of frame 0";
}

TEST(exposure, gives_a_drawing_that_comes_back_its_number_again) {
  ClipSpec clip = build_clip();
  clip.keys = {build_key(0, "a", 0, 0), build_key(0.25, "b", 1, 0), build_key(0.5, "a", 0, 0)};
  for (PoseKey& key : clip.keys) key.ease = Easing::hold;
  clip.length_s = 1;
  std::vector<int> drawings;
  for (const ExposureLine& line : build_exposure(build_performance(clip))) drawings.push_back(line.drawing);
  std::vector<int> expected(24, 1);
  std::fill(expected.begin() + 6, expected.begin() + 12, 2);
  EXPECT_EQ(drawings, expected);
}

TEST(exposure, quotes_what_a_table_would_take_for_more_than_a_word) {
  const auto line = [](std::string key) {
    const std::string csv = build_exposure_csv({{1, 0, 1, false, std::move(key), {}}});
    return csv.substr(csv.find('\n') + 1);
  };
  EXPECT_EQ(line("a, \"b\""), "1,0,1,,\"a, \"\"b\"\"\",\n");
  EXPECT_EQ(line("=1+1"), "1,0,1,,'=1+1,\n");
}

}  // namespace
}  // namespace mien
