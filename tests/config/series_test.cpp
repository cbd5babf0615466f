// Inputs that change with time: ramps, curves, and columns of a table.
#include "config/series.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "config/config_fixture.hpp"
#include "config/live_pose.hpp"

namespace mien {
namespace {

// What `lips.upper` of a law is at a time.
double sample_law(const Spec& spec, double time_s) {
  const CueSpec& law = spec.clip.cues.front();
  for (const LivePose::Value& value : law.what.live->values)
    if (value.formula) return evaluate(*value.formula, time_s);
  ADD_FAILURE();
  return 0;
}

std::string clip_with(const std::string& input, const std::string& formula = "push") {
  return fmt::format(
      "mien: 1\nclip:\n  length: 4s\n  inputs:\n    push: {}\n  laws: [{{area: lips, move: upper, value: "
      "\"{}\"}}]\n",
      input, formula);
}

Spec load(const std::filesystem::path& folder, const std::string& text) {
  write_file(folder / "face.yaml", text);
  return load_spec(folder / "face.yaml", *find_language());
}

std::string tell(const std::filesystem::path& folder, const std::string& text) {
  try {
    load(folder, text);
  } catch (const InputError& error) {
    std::string told = error.what();
    const std::size_t at = told.find("face.yaml:");
    return at == told.npos ? told : told.substr(at, told.find('\n', at) - at);
  }
  return "nothing";
}

TEST(series, ramps_from_point_to_point_and_stays_at_its_ends) {
  const Spec spec =
      load(make_test_folder(), clip_with("{points: [{at: 1s, value: 0.2}, {at: 3s, value: 0.6}]}"));
  EXPECT_EQ(sample_law(spec, 0), 0.2);
  EXPECT_EQ(sample_law(spec, 1), 0.2);
  EXPECT_NEAR(sample_law(spec, 1.5), 0.3, 1e-12);
  EXPECT_EQ(sample_law(spec, 3), 0.6);
  EXPECT_EQ(sample_law(spec, 4), 0.6);
}

TEST(series, curves_are_those_of_tracks) {
  const auto folder = make_test_folder();
  const auto with = [&](const char* between) {
    return load(folder,
                clip_with(fmt::format("{{points: [{{at: 0s, value: 0}}, {{at: 1s, value: 1}}, {{at: 3s, "
                                      "value: 0}}], between: {}}}",
                                      between)));
  };
  EXPECT_EQ(sample_law(with("ease"), 0.5), 0.5);
  EXPECT_LT(sample_law(with("ease"), 0.25), 0.25);
  EXPECT_LE(sample_law(with("smooth"), 1.2), 1);  // never passes its points
  const Spec spline = with("spline");
  EXPECT_GT(sample_law(spline, 1.2), 1);  // goes on as it came
  EXPECT_EQ(sample_law(spline, 1), 1);
}

TEST(series, reads_a_column_as_a_device_recorded_it) {
  const auto folder = make_test_folder();
  write_file(folder / "stick.csv", "time,wheelx,joyz\n0,1,0\n0.5,1,0.25\n2,1,-0.5\n");
  const Spec spec = load(folder, clip_with("{csv: stick.csv, column: joyz}", "2*push"));
  EXPECT_EQ(sample_law(spec, 0.5), 0.5);
  EXPECT_EQ(sample_law(spec, 2), -1);
  EXPECT_NEAR(sample_law(spec, 0.25), 0.25, 1e-12);
  write_file(folder / "stick.csv", "frame;joyz\n0;0\n24;1\n");
  EXPECT_NEAR(sample_law(load(folder, clip_with("{csv: stick.csv, column: joyz}")), 0.5), 0.5, 1e-12);
  EXPECT_GE(load(folder, clip_with("{csv: stick.csv, column: joyz}")).files.size(), 2u);  // is watched, too
}

TEST(series, counts_from_where_an_included_file_begins) {
  const auto folder = make_test_folder();
  write_file(folder / "stick.csv", "time,joyz\n0,0\n1,1\n");
  for (const char* input :
       {"{points: [{at: 0s, value: 0}, {at: 1s, value: 1}]}", "{csv: stick.csv, column: joyz}"}) {
    write_file(folder / "part.yaml", clip_with(input));
    const Spec spec = load(folder, "mien: 1\nclip: {length: 8s, include: {file: part.yaml, at: 3s}}\n");
    EXPECT_EQ(sample_law(spec, 3), 0) << input;
    EXPECT_NEAR(sample_law(spec, 3.5), 0.5, 1e-12) << input;
    EXPECT_EQ(sample_law(spec, 4), 1) << input;
  }
}

TEST(series, tells_what_is_wrong) {
  const auto folder = make_test_folder();
  write_file(folder / "stick.csv", "time,joyz\n0,0\n1,1\n");
  write_file(folder / "back.csv", "time,joyz\n1,0\n0,1\n");
  write_file(folder / "word.csv", "time,joyz\n0,up\n");
  write_file(folder / "none.csv", "joyz,wheelx\n0,1\n");
  const auto told = [&](const std::string& input) { return tell(folder, clip_with(input)); };
  EXPECT_EQ(told("{}"),
            "face.yaml:5:11: error: an input of neither 'points' nor 'csv'; expected one of them");
  EXPECT_EQ(told("{csv: stick.csv, points: [{at: 0s, value: 1}]}"),
            "face.yaml:5:11: error: 'csv' stands beside 'points'; expected one of them");
  EXPECT_EQ(told("{csv: stick.csv}"),
            "face.yaml:5:11: error: 'column' is missing; expected the name of a column of the 'csv'");
  EXPECT_EQ(told("{points: [{at: 0s, value: 1}], column: joyz}"),
            "face.yaml:5:50: error: 'column' is of a 'csv'; expected none beside 'points'");
  EXPECT_EQ(told("{points: [{at: 0s}]}"),
            "face.yaml:5:21: error: an item of 'clip.inputs.push.points' has no 'value'; expected a number");
  EXPECT_EQ(told("{csv: stick.csv, column: joyx}"),
            "face.yaml:5:36: error: unknown column 'joyx'; did you mean 'joyz'?");
  const auto of_table = [&](const std::string& table) {
    try {
      load(folder, clip_with("{csv: " + table + ", column: joyz}"));
    } catch (const InputError& error) {
      const std::string text = error.what();
      return text.substr(text.find(table), text.find('\n') - text.find(table));
    }
    return std::string("nothing");
  };
  EXPECT_EQ(of_table("back.csv"),
            "back.csv:3:1: error: this time is not after the one of the line before; expected rising times");
  EXPECT_EQ(of_table("word.csv"),
            "word.csv:2:3: error: 'joyz' is 'up'; expected a number from -1e+09 to 1e+09");
  EXPECT_EQ(of_table("none.csv"),
            "none.csv:1:1: error: no column is the time; expected 'time' in seconds, or 'frame'");
}

}  // namespace
}  // namespace mien
