#include "voice/speech.hpp"

#include <algorithm>
#include <cmath>

#include "core/seeded.hpp"
#include "core/ticks.hpp"
#include "voice/line.hpp"
#include "voice/mouth.hpp"

namespace mien {

namespace {

constexpr double kPause_s = 0.25;  // between two phrases
constexpr double kCome_s = 0.18;   // a mouth is on its way before it is heard
constexpr double kGo_s = 0.22;
constexpr double kFadeShare = 0.45;       // of a pause
constexpr double kBlinkAfter_s = 0.06;    // into a pause
constexpr double kBlinks = 0.5;           // of all pauses
constexpr std::uint64_t kPauseUse = 401;  // of seeds
constexpr double kStressBrow = 0.22, kStressNod_deg = 3.5, kAskBrow = 0.3;
constexpr double kStressBefore_s = 0.12, kStressAfter_s = 0.3;
constexpr double kAskCome_s = 0.25, kAskHold_s = 0.25, kAskGo_s = 0.4;

double round_s(double time_s) { return compute_seconds(compute_ticks(std::max(time_s, 0.0))); }

std::vector<std::vector<MouthSegment>> list_phrases(const std::vector<MouthSegment>& segments) {
  std::vector<std::vector<MouthSegment>> phrases;
  for (const MouthSegment& segment : segments) {
    if (phrases.empty() || segment.from_s - phrases.back().back().to_s >= kPause_s) phrases.emplace_back();
    phrases.back().push_back(segment);
  }
  return phrases;
}

// How long a phrase takes to come and to go: of a pause between two, each has less than half.
struct PhraseFades {
  double come_s = kCome_s, go_s = kGo_s;
};

PhraseFades find_fades(const std::vector<std::vector<MouthSegment>>& phrases, std::size_t phrase) {
  PhraseFades fades;
  const double from_s = phrases[phrase].front().from_s, to_s = phrases[phrase].back().to_s;
  if (phrase > 0) fades.come_s = std::min(kCome_s, kFadeShare * (from_s - phrases[phrase - 1].back().to_s));
  if (phrase + 1 < phrases.size())
    fades.go_s = std::min(kGo_s, kFadeShare * (phrases[phrase + 1].front().from_s - to_s));
  return fades;
}

// One phrase on some of the moves.
CueSpec build_phrase_cue(const SaySpec& line, const SpeechData& data, const std::vector<MouthSegment>& phrase,
                         const std::vector<std::size_t>& moves, const MouthSettings& settings, double amount,
                         const PhraseFades& fades) {
  CueSpec cue;
  cue.full_s = cue.start_s = round_s(phrase.front().from_s);
  cue.from_s = round_s(cue.full_s - fades.come_s);
  cue.ebb_s = round_s(phrase.back().to_s);
  cue.end_s = round_s(cue.ebb_s + fades.go_s);
  cue.layer = Layer::speech;
  cue.has_lead = false;
  cue.amount = amount;
  for (const std::size_t move : moves) cue.owns.set(move);
  std::vector<MouthSegment> own = phrase;
  for (MouthSegment& segment : own) {
    segment.from_s -= cue.start_s;
    segment.to_s -= cue.start_s;
  }
  cue.table = std::make_shared<const TimeTable>(build_mouth_table(data, own, moves, settings));
  cue.what.label = line.text.empty() ? "speech" : line.text;
  cue.what.place = line.place;
  return cue;
}

Pose raise_brows(double amount) {
  Pose pose;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (kMoves[i].of == Area::brow && kMoves[i].move == "up") pose.values[i] = amount;
  return pose;
}

// Brows that rise, for a while, upon what they do.
CueSpec build_brow_cue(const SaySpec& line, double amount) {
  CueSpec cue;
  cue.layer = Layer::speech;
  cue.rule = Rule::add;
  cue.has_lead = false;
  cue.what.pose = raise_brows(amount);
  for (std::size_t i = 0; i < kMoveCount; ++i) cue.owns[i] = cue.what.pose.values[i] != 0;
  cue.what.label = "stress";
  cue.what.place = line.place;
  return cue;
}

// A nod and brows, on a word that is stressed.
CueSpec build_stress_cue(const SaySpec& line, const LineWord& word, double amount) {
  CueSpec cue = build_brow_cue(line, 0);
  auto script = std::make_shared<ClipSpec>();
  const double length_s = kStressBefore_s + kStressAfter_s + (word.to_s - word.from_s);
  const auto add = [&](double at_s, double share) {
    PoseKey key;
    key.at_s = at_s;
    key.pose = raise_brows(share * kStressBrow * amount);
    script->keys.push_back(key);
    TurnKey turn;
    turn.at_s = at_s;
    turn.nod_deg = share * kStressNod_deg * amount;
    script->turn.push_back(turn);
  };
  add(0, 0);
  add(kStressBefore_s + (word.to_s - word.from_s) / 3, 1);
  add(length_s, 0);
  script->length_s = length_s;
  cue.script = std::move(script);
  cue.owns.reset();
  for (std::size_t i = 0; i < kMoveCount; ++i) cue.owns[i] = raise_brows(1).values[i] != 0;
  cue.from_s = cue.full_s = cue.start_s = round_s(word.from_s - kStressBefore_s);
  cue.ebb_s = cue.end_s = round_s(cue.from_s + length_s);
  return cue;
}

// Brows that rise to the end of a question, and stay until it is over.
CueSpec build_question_cue(const SaySpec& line, const LineWord& word, double amount) {
  CueSpec cue = build_brow_cue(line, kAskBrow * amount);
  cue.what.label = "question";
  cue.from_s = cue.start_s = round_s(word.from_s - kAskCome_s / 2);
  cue.full_s = round_s(cue.from_s + kAskCome_s);
  cue.ebb_s = round_s(std::max(cue.full_s, word.to_s + kAskHold_s));
  cue.end_s = round_s(cue.ebb_s + kAskGo_s);
  return cue;
}

void add_life(const SaySpec& line, const SpokenLine& spoken, ClipSpec& clip) {
  const double amount = 1 - line.still;
  if (amount == 0) return;
  for (const LineWord& word : spoken.words) {
    if (word.is_stressed) clip.cues.push_back(build_stress_cue(line, word, amount));
    if (word.asks) clip.cues.push_back(build_question_cue(line, word, amount));
  }
  const auto phrases = list_phrases(spoken.segments);
  for (std::size_t i = 0; i + 1 < phrases.size(); ++i) {
    std::mt19937_64 random = build_random(i, kPauseUse);
    if (sample_uniform(random) < kBlinks * amount)
      clip.blinks_s.push_back(round_s(phrases[i].back().to_s + kBlinkAfter_s));
  }
}

void add_line(const SaySpec& line, const SpeechData& data, bool keeps_to_nine, ClipSpec& clip) {
  const SpokenLine spoken = understand_line(line, data, clip.fps);
  const double kept = std::clamp(line.share, 0.0, 1.0);
  MouthSettings settings;
  settings.strength = line.strength;
  settings.frame_s = 1.0 / clip.fps;
  const auto phrases = list_phrases(spoken.segments);
  for (std::size_t i = 0; i < phrases.size(); ++i) {
    const auto add = [&](const std::vector<std::size_t>& moves, double amount) {
      clip.cues.push_back(
          build_phrase_cue(line, data, phrases[i], moves, settings, amount, find_fades(phrases, i)));
    };
    settings.corners = 1;
    add(list_lip_moves(keeps_to_nine), 1);
    if (kept == 1) continue;
    settings.corners = 1 / (1 - kept);  // all of the word's own, beside what is left of the feeling's
    add(list_corner_moves(), 1 - kept);
  }
  add_life(line, spoken, clip);
  for (const SpokenSound& sound : spoken.sounds) clip.spoken.push_back(sound);
  for (const LineWord& word : spoken.words)
    clip.words.push_back({word.from_s, word.to_s, word.text, line.place});
  for (const SpokenWord& phoneme : spoken.phonemes)
    clip.phonemes.push_back({phoneme.from_s, phoneme.to_s, phoneme.text, line.place});
  const double most_s = static_cast<double>(kMaxFrames) / clip.fps;
  if (!clip.has_length)
    clip.length_s = std::max(clip.length_s, std::min(round_s(spoken.to_s + kGo_s), most_s));
}

void add_lines(const SpeechData& data, bool keeps_to_nine, ClipSpec& clip,
               std::vector<Diagnostic>& mistakes) {
  for (const SaySpec& line : clip.say) try {
      add_line(line, data, keeps_to_nine, clip);
    } catch (const InputError& error) {
      mistakes.insert(mistakes.end(), error.diagnostics.begin(), error.diagnostics.end());
    }
  std::ranges::stable_sort(clip.cues, [](const CueSpec& a, const CueSpec& b) {
    return std::pair(a.layer, a.from_s) < std::pair(b.layer, b.from_s);
  });
  std::ranges::sort(clip.blinks_s);
}

}  // namespace

void add_speech(Spec& spec, const SpeechData& data) {
  std::vector<Diagnostic> mistakes;
  add_lines(data, spec.keeps_to_nine, spec.clip, mistakes);
  for (ActorSpec& actor : spec.actors) {
    const bool is_given = spec.clip.has_length;
    actor.clip.has_length = is_given;
    add_lines(data, spec.keeps_to_nine, actor.clip, mistakes);
    spec.clip.spoken.insert(spec.clip.spoken.end(), actor.clip.spoken.begin(), actor.clip.spoken.end());
    if (!is_given) spec.clip.length_s = std::max(spec.clip.length_s, actor.clip.length_s);
  }
  for (ActorSpec& actor : spec.actors) actor.clip.length_s = spec.clip.length_s;
  if (!mistakes.empty()) throw InputError(std::move(mistakes));
}

}  // namespace mien
