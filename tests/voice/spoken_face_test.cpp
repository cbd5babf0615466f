// A face that speaks: lips meet where they have to, nothing jumps, and the feeling stays in what is not the
// word's.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "config/load_spec.hpp"
#include "frames/figure.hpp"
#include "frames/pose_soundness.hpp"
#include "head/binding.hpp"
#include "head/cage.hpp"
#include "places.hpp"
#include "shipped.hpp"
#include "timeline/performance.hpp"
#include "voice/sentences.hpp"
#include "voice/speech.hpp"

namespace mien {
namespace {

// On a face that smiles, as that parts the lips most.
Spec build_said(const Sentence& sentence, const std::string& express = "smile",
                const std::string& more = "") {
  const std::string text = fmt::format(
      "mien: 1\nclip:\n  fps: 24\n  keys: [{{at: 0s, express: {}}}]\n  say:\n    - {{at: 0.3s, voice: {}, "
      "text: \"{}\"{}}}\n",
      express, sentence.voice, sentence.text, more);
  Spec spec = load_spec("said.yaml", text, *shipped().stock.language);
  add_speech(spec, *shipped().stock.language->speech);
  return spec;
}

struct Probe {
  const Figure& figure;
  DeformBuffers buffers = {};
  Drawing drawing = {};

  void pose(const Pose& asked) { deform_figure(figure, asked, TurnKey{}, buffers, drawing); }
  glm::vec3 at(const char* name) const {
    return drawing.parts[0].positions[find_point(figure.head.cage, name)];
  }
  // Between the inner edges of the lips, in the middle of the mouth.
  double gap_mm() const { return at("M0_0").y - at("M0_12").y; }
  // How far the lower lip's edge stands above the edge of the upper teeth: before them, that is seen of an f.
  double over_teeth_mm() const {
    double edge = 1e9;
    for (std::size_t i = 0; i < figure.model.parts.size(); ++i) {
      if (figure.model.parts[i].name != "teeth_upper") continue;
      for (const glm::vec3& rest : figure.model.parts[i].rest.positions)
        if (std::abs(rest.x) < 8)
          edge = std::min<double>(edge, (drawing.parts[i].world_from_rest * glm::vec4(rest, 1)).y);
    }
    return at("M1_12").y - edge;
  }
  // What is seen between the lips.
  double opening_mm() const { return at("M1_0").y - at("M1_12").y; }

  // Vertices of a part as they are drawn.
  std::vector<glm::vec3> places(std::string_view name) const {
    std::vector<glm::vec3> all;
    for (std::size_t i = 0; i < figure.model.parts.size(); ++i) {
      const Part& part = figure.model.parts[i];
      if (part.name != name) continue;
      if (!is_carried(part, drawing.parts[i])) return drawing.parts[i].positions;
      for (const glm::vec3& rest : part.rest.positions)
        all.emplace_back(drawing.parts[i].world_from_rest * glm::vec4(rest, 1));
    }
    return all;
  }
  // How high of the tongue's front is seen from before: between the edges of the teeth and of the lips, in
  // the middle.
  double seen_tongue_mm() const {
    double above = at("M1_0").y, below = at("M1_12").y, back = -1e9;
    for (const glm::vec3& p : places("teeth_upper"))
      if (std::abs(p.x) < 4) above = std::min<double>(above, p.y);
    for (const glm::vec3& p : places("teeth_lower"))
      if (std::abs(p.x) < 4) {
        below = std::max<double>(below, p.y);
        back = std::max<double>(back, p.z);
      }
    double high = -1e9, low = 1e9;
    for (const glm::vec3& p : places("tongue"))
      if (std::abs(p.x) < 4 && p.z > back - 9) {
        high = std::max<double>(high, p.y);
        low = std::min<double>(low, p.y);
      }
    return std::min(high, above) - std::max(low, below);
  }
  // From the edge of the upper teeth to the skin of the lower lip.
  double bite_mm() const {
    double edge = 1e9, least = 1e9;
    const std::vector<glm::vec3> teeth = places("teeth_upper");
    for (const glm::vec3& p : teeth)
      if (std::abs(p.x) < 6) edge = std::min<double>(edge, p.y);
    const Mesh skin{drawing.parts[0].positions, drawing.parts[0].normals, figure.head.skin.triangles};
    const glm::vec3 lip = at("M1_12");
    const SkinPatch patch = build_skin_patch(skin, {lip - glm::vec3(14, 10, 12), lip + glm::vec3(14, 4, 8)});
    for (const glm::vec3& p : teeth) {
      if (std::abs(p.x) > 6 || p.y > edge + 1) continue;
      const SkinPlace place = find_nearest_place(patch, p);
      least = std::min<double>(least, glm::distance(p, place.point));
    }
    return least;
  }
};

const Figure& adult() {
  static const Figure figure = build_figure(shipped().heads, HeadSpec{});
  return figure;
}

bool is_bilabial(const std::string& ipa) { return ipa == "p" || ipa == "b" || ipa == "m"; }
bool is_labiodental(const std::string& ipa) { return ipa == "f" || ipa == "v"; }

// Whether lips that shut or bite stand right beside a sound: they hide what the tongue does.
bool is_hidden(const ClipSpec& clip, const SpokenWord& sound) {
  constexpr double kBeside_s = 0.03;
  return std::ranges::any_of(clip.phonemes, [&](const SpokenWord& other) {
    return (is_bilabial(other.text) || is_labiodental(other.text) || other.text == "β") &&
           other.to_s > sound.from_s - kBeside_s && other.from_s < sound.to_s + kBeside_s;
  });
}

// Does `work(performance, sound, where)` for each sound of all sentences that `is_wanted`.
template <typename Wanted, typename Work>
void for_each_sound(const Wanted& is_wanted, const Work& work) {
  for (const Sentence& sentence : kSentences) {
    const Spec spec = build_said(sentence);
    const Performance performance = build_performance(spec.clip);
    for (const SpokenWord& sound : spec.clip.phonemes)
      if (is_wanted(sound.text))
        work(performance, sound, fmt::format("{} '{}' at {:.2f} s", sentence.text, sound.text, sound.from_s));
  }
}

TEST(spoken_face, shuts_its_lips) {
  Probe probe{adult()};
  probe.pose({});
  const double rest_mm = probe.gap_mm();
  for_each_sound(is_bilabial,
                 [&](const Performance& performance, const SpokenWord& sound, const std::string& where) {
                   probe.pose(sample_performance(performance, (sound.from_s + sound.to_s) / 2).pose);
                   EXPECT_LE(probe.gap_mm() - rest_mm, 0.3) << where;
                   double least_mm = 1e9;
                   const int first = static_cast<int>(std::floor(sound.from_s * 24)),
                             last = static_cast<int>(std::ceil(sound.to_s * 24));
                   for (int frame = first; frame <= last; ++frame) {
                     probe.pose(sample_performance(performance, frame / 24.0).pose);
                     least_mm = std::min(least_mm, probe.gap_mm() - rest_mm);
                   }
                   EXPECT_LE(least_mm, 0.5) << where << ": no frame shows it";
                 });
}

TEST(spoken_face, shows_its_teeth_over_the_lower_lip) {
  Probe probe{adult()};
  for_each_sound(is_labiodental,
                 [&](const Performance& performance, const SpokenWord& sound, const std::string& where) {
                   probe.pose(sample_performance(performance, (sound.from_s + sound.to_s) / 2).pose);
                   EXPECT_GE(probe.over_teeth_mm(), 0.5) << where;
                   EXPECT_GE(probe.opening_mm(), 1.5) << where << ": the teeth are to be seen";
                 });
}

bool is_tongues(const std::string& ipa) { return ipa == "l" || ipa == "θ" || ipa == "ð" || ipa == "n"; }

TEST(spoken_face, shows_the_tongue_where_it_speaks) {
  constexpr double kSeen_mm = 0.8;
  Probe probe{adult()};
  std::map<std::string, std::pair<int, double>> sums;
  int all = 0;
  for_each_sound(
      is_tongues, [&](const Performance& performance, const SpokenWord& sound, const std::string& where) {
        double seen_mm = -1e9;
        for (int step = 1; step <= 7; ++step) {
          probe.pose(sample_performance(performance, std::lerp(sound.from_s, sound.to_s, step / 8.0)).pose);
          seen_mm = std::max(seen_mm, probe.seen_tongue_mm());
        }
        if (!is_hidden(performance.clip, sound)) {
          EXPECT_GE(seen_mm, kSeen_mm) << where;
          ++all;
        }
        auto& [count, sum] = sums[sound.text];
        ++count;
        sum += seen_mm;
      });
  EXPECT_GE(all, 30);
  for (const auto& [sound, sum] : sums)
    RecordProperty("seen of the tongue at " + sound + ", mm", std::to_string(sum.second / sum.first));
}

TEST(spoken_face, bites_its_lower_lip) {
  constexpr double kNear_mm = 1;
  Probe probe{adult()};
  double most = 0;
  for_each_sound(is_labiodental,
                 [&](const Performance& performance, const SpokenWord& sound, const std::string& where) {
                   probe.pose(sample_performance(performance, (sound.from_s + sound.to_s) / 2).pose);
                   EXPECT_LE(probe.bite_mm(), kNear_mm) << where;
                   most = std::max(most, probe.bite_mm());
                 });
  RecordProperty("from the teeth to the lip at f and v, mm at most", std::to_string(most));
}

// In a file that keeps to the nine areas, speech does without what is beyond them.
TEST(spoken_face, keeps_to_the_nine_areas) {
  Spec spec = load_spec(
      "said.yaml",
      "mien: 1\nhead: {areas: nine}\nclip:\n  keys: [{at: 0s, express: smile}]\n  say: [{at: 0s, text: "
      "\"five thin lilies\"}]\n",
      *shipped().stock.language);
  add_speech(spec, *shipped().stock.language->speech);
  const Performance performance = build_performance(spec.clip);
  for (int frame = 0; frame < count_frames(spec.clip); ++frame) {
    const Pose pose = sample_performance(performance, frame / 24.0).pose;
    for (std::size_t i = 0; i < kMoveCount; ++i)
      if (kMoves[i].is_beyond) {
        EXPECT_EQ(pose.values[i], 0) << name_move(i);
      }
  }
}

TEST(spoken_face, never_jumps) {
  Probe probe{adult()};
  double most_mm = 0;
  for (const Sentence& sentence : kSentences) {
    const Spec spec = build_said(sentence, "neutral", ", still: 1");
    const Performance performance = build_performance(spec.clip);
    std::vector<glm::vec3> before;
    for (int frame = 0; frame < count_frames(spec.clip); ++frame) {
      const Moment moment = sample_performance(performance, frame / 24.0);
      for (std::size_t i = 0; i < kMoveCount; ++i) {
        EXPECT_GE(moment.pose.values[i], kMoves[i].low);
        EXPECT_LE(moment.pose.values[i], kMoves[i].high);
      }
      probe.pose(moment.pose);
      const std::vector<glm::vec3>& now = probe.drawing.parts[0].positions;
      for (std::size_t v = 0; v < before.size(); ++v)
        most_mm = std::max<double>(most_mm, glm::length(now[v] - before[v]));
      before = now;
    }
  }
  EXPECT_LE(most_mm, 6) << "between two frames of 24 a second";
  EXPECT_GE(most_mm, 2) << "but it speaks";
}

// Every mouth, and the drawings of a smile and of a laugh that speak: teeth, lips, tongue and lids hold the
// bounds of all poses.
TEST(spoken_face, is_as_sound_as_all_faces) {
  HeadSpec child;
  child.age = {{"child", 1.0}};
  const std::filesystem::path folder = source_folder();
  const Spec scan = load_spec(folder / "configs/scan.yaml", *shipped().stock.language);
  for (const auto& [name, head] :
       {std::pair{"adult", HeadSpec{}}, std::pair{"child", child}, std::pair{"scan", scan.head}}) {
    const Figure figure = build_figure(shipped().heads, head);
    const PoseProbe probe = build_pose_probe(figure);
    DeformBuffers buffers;
    Drawing drawing;
    const auto judge = [&](const Pose& pose, const std::string& where) {
      const PoseFindings found = measure_pose(probe, pose, buffers, drawing);
      for (std::size_t check = 0; check < kPoseCheckCount; ++check)
        EXPECT_LE(found[check].value, kPoseChecks[check].bound)
            << name << ", " << kPoseChecks[check].name << ", " << where;
    };
    for (const Viseme& viseme : shipped().stock.language->speech->visemes) judge(viseme.pose, viseme.name);
    for (const char* express : {"smile", "laugh"}) {
      const Performance performance = build_performance(build_said(kSentences[4], express).clip);
      for (int frame = 0; frame < count_frames(performance.clip); frame += 2)
        judge(sample_performance(performance, frame / 24.0).pose,
              fmt::format("{} in frame {}", express, frame));
    }
  }
}

TEST(spoken_face, keeps_the_feeling) {
  const Sentence sentence{"en-us", "See me. And see *you*."};
  const Spec spec = build_said(sentence, "smile", ", still: 1");
  const Performance performance = build_performance(spec.clip);
  const Pose smile = sample_performance(performance, 0).pose;
  for (int frame = 0; frame < count_frames(spec.clip); ++frame) {
    const Pose pose = sample_performance(performance, frame / 24.0).pose;
    for (std::size_t i = 0; i < kMoveCount; ++i) {
      const MoveInfo& move = kMoves[i];
      const std::string where = fmt::format("{} in frame {}", name_move(i), frame);
      if (move.of == Area::brow || move.of == Area::lid) {
        EXPECT_EQ(pose.values[i], smile.values[i]) << where;
      }
      if (move.of == Area::corner && move.move == "up") {
        EXPECT_GE(pose.values[i], smile.values[i] / 3 - 1e-6) << where;
      }
    }
  }
  // In the pause between the sentences the mouth smiles again.
  double pause_s = 0;
  for (std::size_t i = 0; i + 1 < spec.clip.phonemes.size(); ++i)
    if (spec.clip.phonemes[i + 1].from_s - spec.clip.phonemes[i].to_s > 0.3)
      pause_s = (spec.clip.phonemes[i].to_s + spec.clip.phonemes[i + 1].from_s) / 2;
  ASSERT_GT(pause_s, 0);
  const Pose pause = sample_performance(performance, pause_s).pose;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    EXPECT_NEAR(pause.values[i], smile.values[i], 0.05) << name_move(i);
}

TEST(spoken_face, nods_asks_and_blinks_unless_it_is_still) {
  const Sentence sentence{"en-us", "Is it *you*?"};
  const Performance lively = build_performance(build_said(sentence).clip);
  const Performance still = build_performance(build_said(sentence, "smile", ", still: 1").clip);
  double nod_deg = 0, brow = 0;
  const auto up = static_cast<std::size_t>(
      std::ranges::find_if(kMoves,
                           [](const MoveInfo& move) { return move.of == Area::brow && move.move == "up"; }) -
      kMoves.begin());
  for (double time_s = 0; time_s < lively.clip.length_s; time_s += 0.02) {
    const Moment moved = sample_performance(lively, time_s), calm = sample_performance(still, time_s);
    EXPECT_EQ(calm.turn.nod_deg, 0);
    nod_deg = std::max(nod_deg, moved.turn.nod_deg);
    brow = std::max(brow, moved.pose.values[up] - calm.pose.values[up]);
  }
  EXPECT_NEAR(nod_deg, 3.5, 0.5);
  EXPECT_GE(brow, 0.3);
}

TEST(spoken_face, says_the_same_twice) {
  const auto describe = [](const Spec& spec) {
    std::string all;
    for (const CueSpec& cue : spec.clip.cues) {
      all += fmt::format("{} {} ", cue.from_s, cue.end_s);
      if (cue.table) all += fmt::format("{}", fmt::join(cue.table->values, " "));
    }
    return all;
  };
  EXPECT_EQ(describe(build_said(kSentences[1])), describe(build_said(kSentences[1])));
}

}  // namespace
}  // namespace mien
