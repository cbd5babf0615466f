// What a clip's drawings show of blinks, saccades and expressions takes as long as people's do
// (face-facts 3.4 to 3.6). Measured from poses alone, frame by frame, as one would measure a film.
#include <cmath>

#include "config/config_fixture.hpp"
#include "timeline/performance.hpp"

namespace mien {
namespace {

constexpr int kFilm_fps = 1000;  // of the camera that measures

std::vector<Pose> film(const std::string& clip) {
  const Spec spec = load_text("mien: 1\nclip:\n" + clip);
  const Performance performance = build_performance(spec.clip);
  std::vector<Pose> poses;
  for (int i = 0; i <= spec.clip.length_s * kFilm_fps; ++i)
    poses.push_back(sample_performance(performance, static_cast<double>(i) / kFilm_fps).pose);
  return poses;
}

double compute_distance(const Pose& a, const Pose& b) {
  double most = 0;
  for (std::size_t i = 0; i < kMoveCount; ++i) most = std::max(most, std::abs(a.values[i] - b.values[i]));
  return most;
}

// How much of a face there is, over all moves.
double find_sum(const Pose& a, const Pose& b) {
  double sum = 0;
  for (std::size_t i = 0; i < kMoveCount; ++i) sum += std::abs(a.values[i] - b.values[i]);
  return sum;
}

// Seconds from rest to a face that stands, how long it stands, and back to rest.
struct Measured {
  double onset_s = 0, apex_s = 0, offset_s = 0;
};

// Of a film that rests, shows a face once and rests again.
Measured measure(const std::vector<Pose>& poses) {
  constexpr double kSeen = 1e-3;
  const Pose& rest = poses.front();
  const auto is_rest = [&](const Pose& pose) { return compute_distance(pose, rest) < kSeen; };
  std::size_t apex = 0;
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (find_sum(poses[i], rest) > find_sum(poses[apex], rest)) apex = i;
  const auto is_apex = [&](std::size_t i) { return compute_distance(poses[i], poses[apex]) < 5 * kSeen; };
  std::size_t begin = 0, full = apex, ebb = apex, end = poses.size() - 1;
  while (is_rest(poses[begin + 1])) ++begin;
  while (full > begin && is_apex(full - 1)) --full;
  while (ebb + 1 < poses.size() && is_apex(ebb + 1)) ++ebb;
  while (is_rest(poses[end - 1])) --end;
  const auto seconds = [](std::size_t from, std::size_t to) {
    return static_cast<double>(to - from) / kFilm_fps;
  };
  return {seconds(begin, full), seconds(full, ebb), seconds(ebb, end)};
}

struct Range {
  const char* name;
  double least_s, most_s;
};

TEST(timings, expressions_come_as_quickly_as_peoples_and_go_more_slowly) {
  // Neutral to apex: face-facts 3.6, after Recio et al. (2013) and Tarantili et al. (2005).
  for (const Range& range :
       {Range{"surprise", 0.2, 0.35}, Range{"fear", 0.3, 0.45}, Range{"anger", 0.4, 0.6},
        Range{"disgust", 0.4, 0.6}, Range{"smile", 0.5, 0.7}, Range{"sadness", 0.8, 1.5}}) {
    const Measured measured = measure(
        film(std::string("  length: 6s\n  cues: [{from: 0.5s, express: ") + range.name + ", hold: 1s}]\n"));
    // The last hundredth of an ease is not seen: a face reads as arrived a little before it has.
    constexpr double kUnseen = 0.1;  // of the time
    EXPECT_GE(measured.onset_s, range.least_s * (1 - kUnseen)) << range.name;
    EXPECT_LE(measured.onset_s, range.most_s) << range.name;
    EXPECT_GE(measured.offset_s, 1.5 * measured.onset_s) << range.name;
    EXPECT_LE(measured.offset_s, 2 * measured.onset_s) << range.name;
    EXPECT_GE(measured.apex_s, 1) << range.name;
    EXPECT_LE(measured.apex_s, 1.4) << range.name;
  }
}

TEST(timings, blinks_close_in_a_few_hundredths_and_open_in_twice_that) {
  const Measured measured = measure(film("  length: 2s\n  blinks: [1s]\n"));
  EXPECT_GE(measured.onset_s, 0.066);
  EXPECT_LE(measured.onset_s, 0.0876) << "voluntary: 77.6 ms, give or take 10";
  EXPECT_GE(measured.offset_s, 0.1);
  EXPECT_LE(measured.offset_s, 0.24);
  EXPECT_GE(measured.offset_s, 1.4 * measured.onset_s);
}

TEST(timings, saccades_take_longer_the_further_they_go) {
  for (const double degrees : {2.0, 5.0, 10.0, 20.0, 28.0}) {
    const std::vector<Pose> poses = film(
        "  length: 2s\n  gaze: [{at: 0s, look: ahead}, {at: 1s, look: {side: " + std::to_string(degrees) +
        "deg}}]\n");
    std::size_t begin = 0, end = poses.size() - 1;
    while (poses[begin + 1] == poses.front()) ++begin;
    while (poses[end - 1] == poses.back()) --end;
    const double taken_s = static_cast<double>(end - begin) / kFilm_fps;
    EXPECT_NEAR(taken_s, 0.021 + 0.0022 * degrees, 2.0 / kFilm_fps) << degrees;
    EXPECT_EQ(end, std::size_t{kFilm_fps}) << "there at the key's time";
  }
}

TEST(timings, a_great_shift_is_one_to_three_frames_of_a_clip) {
  const Spec spec = load_text(
      "mien: 1\nclip: {length: 2s, gaze: [{at: 0s, look: {side: -14deg}}, {at: 1.01s, look: {side: "
      "14deg}}]}\n");
  const Performance performance = build_performance(spec.clip);
  int moving = 0;
  Pose before = sample_performance(performance, 0).pose;
  for (int frame = 1; frame < count_frames(spec.clip); ++frame) {
    const Pose now = sample_performance(performance, compute_drawing_time_s(spec.clip, frame)).pose;
    moving += now != before;
    before = now;
  }
  EXPECT_GE(moving, 1);
  EXPECT_LE(moving, 3);
}

TEST(timings, an_hour_of_every_frame_rate_shows_the_same_seconds) {
  // Cues, laws, scripts, gaze, blinks and drift as well as keys: nothing adds up errors.
  const std::string clip =
      "  length: 3600s\n  blink: {style: natural, seed: 3}\n  drift: 0.5\n  asymmetry: 0.05\n"
      "  gaze: {keys: [{at: 0s, look: left}, {at: 3599s, look: right}], wander: 0.5}\n"
      "  keys: [{at: 0s}, {at: 3598.4s, express: smile}, {at: 3600s, express: fear}]\n"
      "  scripts: {nod: {turn: [{at: 0s}, {at: 0.3s, nod: 6deg}, {at: 0.7s, nod: 0deg}]}}\n"
      "  cues: [{from: 0.1s, play: nod, repeat: 5142}]\n"
      "  laws: [{area: brows, move: up, value: \"0.2*sin(2*pi*t/0.7)\", rule: add}]\n";
  const auto build = [&](int fps) {
    return build_performance(load_text("mien: 1\nclip:\n  fps: " + std::to_string(fps) + "\n" + clip).clip);
  };
  // The clip's own blinks fall on its own drawings: off where rates are compared.
  Performance film = build(24);
  film.idle.blinks.clear();
  for (const int fps : {12, 25}) {
    Performance other = build(fps);
    other.idle.blinks.clear();
    for (const int second : {0, 1, 60, 3598, 3599, 3600}) {
      const Moment a = sample_performance(film, compute_drawing_time_s(film.clip, 24 * second));
      const Moment b = sample_performance(other, compute_drawing_time_s(other.clip, fps * second));
      EXPECT_EQ(a.pose, b.pose) << fps << " at " << second;
      EXPECT_EQ(a.turn.nod_deg, b.turn.nod_deg) << fps << " at " << second;
    }
  }
  // An hour of more frames is longer than a clip may be; their times are the same all the same.
  for (const int fps : {30, 60}) {
    ClipSpec clip_of = film.clip;
    clip_of.fps = fps;
    for (const int half : {1, 3, 7199, 7200})
      EXPECT_EQ(sample_performance(film, compute_drawing_time_s(clip_of, half * fps / 2)).pose,
                sample_performance(film, compute_drawing_time_s(film.clip, half * 12)).pose)
          << fps << " at half second " << half;
  }
}

}  // namespace
}  // namespace mien
