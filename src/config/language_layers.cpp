// The table of language.hpp: what lies on a clip's keys, and where it comes from.
#include <fmt/format.h>

#include "config/areas.hpp"
#include "config/language_forms.hpp"
#include "config/law_numbers.hpp"
#include "config/load_clip.hpp"
#include "config/load_takes.hpp"

namespace mien {

namespace {

constexpr int kMaxRepeat = 10000;
constexpr double kMaxInput = 1e6;

// Without meanings: those of moves differ from area to area.
std::vector<Word> list_area_words() {
  std::vector<Word> words;
  for (const AreaKey& key : kAreaKeys) words.push_back({key.key});
  return words;
}

std::vector<Word> list_move_words() {
  std::vector<Word> words;
  for (const MoveInfo& move : kMoves) {
    bool is_new = true;
    for (const Word& word : words) is_new = is_new && word.name != move.move;
    if (is_new) words.push_back({move.move});
  }
  return words;
}

Key build_rule() {
  return {"rule",
          {as_word("rule", kRuleWords)},
          "Who has an area that several ask for.",
          std::string(kRuleWords[0].name)};
}

void fill_cue(Sections& all) {
  Section& cue = all.cue;
  cue.name = "cue";
  cue.help = "An expression or a script that comes, stays and goes.";
  cue.expected = "a cue such as {from: 1s, express: smile}";
  Key express = build_express_key(true);
  express.otherwise.clear();
  cue.keys = {
      {"from", as_waiting_time(all.wait), "When it begins to come.", "", true},
      {"to", as_waiting_time(all.wait), "When it is cut: it begins to go."},
      express,
      {"play", {as_tag("")}, "A script's name."},
      {"with", {as_map("", {as_number(-kMaxInput, kMaxInput)})}, "The script's parameters."},
      {"repeat", {as_whole(1, kMaxRepeat, "times")}, "How many times the script is played.", "1"},
      {"attack", {as_duration()}, "How long it takes to come; without it the expression's own."},
      {"hold", {as_duration()}, "How long it is all there; without it until the next cue on its areas."},
      {"release",
       {as_duration()},
       fmt::format("How long it takes to go; without it {:g} times the attack.", kReleasePerAttack)},
      build_strength_key("How much of the expression.", true),
      build_exaggerate_key("How far past their limits the areas may go; without it as the file's."),
      {"areas",
       {as_list({as_word("area", list_area_words())}), as_section(all.live_areas)},
       "The areas that it takes, as a list; or values, as in keys. Without it those that it moves."},
      build_rule(),
      build_name_key()};
  cue.rules = {{KeyRule::Kind::one_of, {"express", "areas", "play"}},
               {KeyRule::Kind::apart, {"play", "strength", "exaggerate", "express", "hold"}},
               {KeyRule::Kind::needs, {"with", "play"}},
               {KeyRule::Kind::needs, {"repeat", "play"}},
               {KeyRule::Kind::needs, {"strength", "express"}}};
}

void fill_law(Sections& all) {
  Section& law = all.law;
  law.name = "law";
  law.help =
      "One move of an area, or one number of the camera, the head's turning, the lights or an actor's place, "
      "that follows a formula.";
  law.expected = "a law such as {area: brows, move: up, value: \"0.3*sin(t)\"}";
  const auto words = [](LawTrack track) { return Forms{as_word("number", list_law_words(track))}; };
  const Form number = as_number(-kMostPlace_mm, kMostPlace_mm), angle = as_angle(kRoundBounds),
             length = as_length(-kMostPlace_mm, kMostPlace_mm);
  law.keys = {
      {"area", {as_word("area", list_area_words())}, "The area."},
      {"move", {as_word("move", list_move_words())}, "The move of the area."},
      {"camera", words(LawTrack::camera), "Of the camera; with actors in the clip at the top of the file."},
      {"turn", words(LawTrack::turn), "Of the head's turning."},
      {"light", words(LawTrack::light), "Of the lights; with actors in the clip at the top of the file."},
      {"place", words(LawTrack::place), "Of where the actor stands whose clip it is in."},
      {"value",
       {number, angle, length, as_formula()},
       "Its law: of a move from -1 to 1, of other numbers as in keys.",
       "",
       true},
      {"from", as_waiting_time(all.wait), "When it begins; without it, from the start."},
      {"to", as_waiting_time(all.wait), "When it is over; without it, at the end."},
      {"range",
       {as_list({number, angle, length}, 2, 2)},
       "The value is held between these two, the lower one first."},
      {"attack",
       {as_duration()},
       "How long it takes to come, within its time, if it has a `from`; at once without it.",
       "0"},
      {"release",
       {as_duration()},
       "How long it takes to go, within its time, if it has a `to`; at once without it.",
       "0"},
      build_rule()};
  law.rules = {{KeyRule::Kind::one_of, {"area", "camera", "turn", "light", "place"}},
               {KeyRule::Kind::needs, {"area", "move"}},
               {KeyRule::Kind::needs, {"move", "area"}},
               {KeyRule::Kind::apart, {"area", "camera", "turn", "light", "place"}},
               {KeyRule::Kind::apart, {"camera", "turn", "light", "place"}},
               {KeyRule::Kind::apart, {"turn", "light", "place"}},
               {KeyRule::Kind::apart, {"light", "place"}}};
}

void fill_sources(Sections& all) {
  Section& track = all.track;
  track.name = "track";
  track.help = "A table of moves in time, or a take of another program.";
  track.expected = "a track such as {csv: talk.csv} or {live_link: take.csv}";
  track.keys = {
      {"csv",
       {as_file({".csv"})},
       "A file whose first line names its columns: time (in seconds) or frame, and moves such as "
       "brow.left.up, "
       "brows.up, lips.upper."},
      {"live_link", {as_file({".csv"})}, "A take of Live Link Face."},
      {"arkit",
       {as_file({".json"})},
       "ARKit's units by frames, as MediaPipe and recorders of ARKit write them."},
      {"openface", {as_file({".csv"})}, "A take of OpenFace 2."},
      {"openfacefx", {as_file({".json"})}, "Tracks of OpenFaceFX."},
      {"vrma", {as_file({".vrma"})}, "An animation of VRM."},
      {"gltf",
       {as_file({".glb", ".gltf"})},
       "A head that glTF animates, by targets of mien's names, of ARKit's or of VRM's."},
      {"smooth",
       {as_number(0, kMostSmooth_hz, "Hz")},
       "How quick a change of a take may be noise: lower is calmer, 0 leaves it as it is, which `gltf` has "
       "without it.",
       say(SmoothSpec{}.cutoff_hz)},
      {"fps",
       {as_number(1, kMostTakeRate)},
       "Frames a second of a take whose file does not say them: of a timecode at 59.94, or of rows without "
       "times."},
      {"at", as_waiting_time(all.wait), "When its time is 0.", "0"},
      {"between", {as_word("between", kBetweenWords)}, "Between its rows.", "linear"},
      {"attack",
       {as_duration()},
       "How long before its first row it begins to come.",
       say(kTableAttack_s, "s")},
      {"release", {as_duration()}, "How long after its last row it is gone.", say(kTableRelease_s, "s")},
      build_rule()};
  track.rules = {
      {KeyRule::Kind::one_of, {"csv", "live_link", "arkit", "openface", "openfacefx", "vrma", "gltf"}},
      {KeyRule::Kind::apart,
       {"csv", "live_link", "arkit", "openface", "openfacefx", "vrma", "gltf", "smooth", "fps"}},
      {KeyRule::Kind::apart, {"live_link", "arkit", "openface", "openfacefx", "vrma", "gltf"}},
      {KeyRule::Kind::apart, {"arkit", "openface", "openfacefx", "vrma", "gltf"}},
      {KeyRule::Kind::apart, {"openface", "openfacefx", "vrma", "gltf"}},
      {KeyRule::Kind::apart, {"openfacefx", "vrma", "gltf"}},
      {KeyRule::Kind::apart, {"vrma", "gltf"}}};

  Section& include = all.include;
  include.name = "include";
  include.help = "A file, or parts of it.";
  include.expected = "a file such as {file: nods.yaml, take: [scripts]}";
  include.keys = {
      {"file", {as_file(kYamlEndings)}, "A mien file with a clip, as seen from this file.", "", true},
      {"at", as_waiting_time(all.wait), "When it begins.", "0"},
      {"take", {as_list({as_word("part", kTakeWords)})}, "Only these parts of it."}};

  Section& script = all.script;
  const auto list = [](const Section& section) { return Forms{as_list({as_section(section)})}; };
  script.name = "script";
  script.help = "A little clip. Its formulas count t from its beginning.";
  script.expected = "a script such as {length: 1s, keys: [...]}";
  script.keys = {{"length", {as_duration()}, "How long it is; without it, until its last key or cue."},
                 {"parameters",
                  {as_map("^[A-Za-z_][A-Za-z0-9_]*$", {as_number(-kMaxInput, kMaxInput), as_formula()})},
                  "Numbers by name that its formulas use, with what they are unless a cue says otherwise."},
                 {"keys", list(all.pose_key), "The face, by rising time."},
                 {"cues", list(all.cue), "What comes and goes on top of the keys."},
                 {"turn", list(all.turn_key), "The head's turning, on top of the clip's."},
                 {"laws", list(all.law), "Moves that follow a formula."},
                 {"between",
                  {as_word("between", kBetweenWords)},
                  "What the ways to its keys are that say nothing of it; without it as the clip has it."}};

  Section& wait = all.wait;
  wait.name = "wait";
  wait.help = "A time that counts from a key with a name: of this clip, or ann.hello of another actor.";
  wait.expected = "a time";
  wait.keys = {{"after", {as_tag("")}, "The other key's name.", "", true},
               {"delay",
                {as_duration(-std::numeric_limits<double>::infinity())},
                "How much later; less than 0: earlier.",
                "0"}};
}

}  // namespace

void fill_layer_sections(Sections& all) {
  fill_cue(all);
  fill_law(all);
  fill_sources(all);
}

}  // namespace mien
