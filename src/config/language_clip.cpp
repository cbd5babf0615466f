// The table of language.hpp: `clip` and its keys.
#include <fmt/format.h>

#include "config/conformation.hpp"
#include "config/language_forms.hpp"
#include "config/law_numbers.hpp"

namespace mien {

namespace {

constexpr int kMaxFps = 120;
constexpr int kMaxDraw = 12;      // held longer, a clip is a row of stills
constexpr double kMaxLead_s = 1;  // an area later than that no longer belongs to the same move
constexpr double kMostPast = 2;   // how far a curve's y may pass the way at either end: further is no ease
constexpr double kMostAim_mm = 5000;  // as far off as an actor may stand

constexpr std::array kWholeFrame{Word{"all", "the middle of all that is to be seen"}};

Key build_at(const Section& wait) {
  return {"at", as_waiting_time(wait), "When; each key later than the one before.", "", true};
}

Key build_ease() {
  return {
      "ease",
      {as_word("ease", kEasingWords), as_curve(-kMostPast, 1 + kMostPast)},
      "How the way from the key before to this one is gone; four numbers are the handles of a curve, as in "
      "CSS.",
      std::string(kEasingWords[static_cast<std::size_t>(Ease{}.kind)].name)};
}

Key build_between(std::string help, std::string otherwise = {}) {
  return {"between", {as_word("between", kBetweenWords)}, std::move(help), std::move(otherwise)};
}

Key build_key_between() {
  return build_between("What the way to this key is; without it as the clip has it.");
}

std::vector<Key> build_parts(std::span<const Word> parts, const Form& form, const std::string& help,
                             const std::string& otherwise) {
  std::vector<Key> keys;
  for (const Word& part : parts) keys.push_back({std::string(part.name), {form}, help, otherwise});
  return keys;
}

void fill_pose_keys(Sections& all) {
  all.release.name = "release";
  all.release.help = "How long parts of the face take to come off a key.";
  all.release.expected = "a time, or times such as {brows: 12f}";
  all.release.keys = build_parts(std::span(kPartWords).first(kFacePartCount), as_duration(),
                                 "How long it takes to come off; without it as `lead` has it.", "");
  all.lead.name = "lead";
  all.lead.help = "Offsets: how much later than the first each part sets out.";
  all.lead.expected = "none, natural, or offsets such as {brows: 2f}";
  all.lead.keys = build_parts(kPartWords, as_duration(0, kMaxLead_s), "How much later it sets out.", "0");

  Section& key = all.pose_key;
  key.name = "pose_key";
  key.help = "One key of the performance.";
  key.expected = "a key such as {at: 1s, express: smile}";
  key.keys = {
      build_at(all.wait),
      build_express_key(true),
      build_strength_key("How much of the expression: 0 is neutral, 1 all of it. Areas set beside it are "
                         "not weakened.",
                         true),
      build_exaggerate_key("How far past their limits the areas may go: every value times this; without "
                           "it as the file's."),
      {"areas", {as_section(all.live_areas)}, all.live_areas.help},
      build_ease(),
      build_key_between(),
      build_name_key(),
      {"release",
       {as_duration(), as_section(all.release)},
       "How long the face, or each part of it, takes to come off this key once it is left for the next "
       "one; it has arrived by then and waits."}};
  key.rules = {{KeyRule::Kind::needs, {"strength", "express"}}};
}

void fill_stage_keys(Sections& all) {
  Section& camera = all.camera_key;
  camera.name = "camera_key";
  camera.help = "One key of the camera; a missing number keeps the one of the key before.";
  camera.expected = "a key such as {at: 1s, angle: 20deg}";
  camera.keys = {
      build_at(all.wait),
      {"angle",
       {as_angle(kCameraBounds[0]), as_formula()},
       "About the head; + shows more of the character's left side.",
       say(CameraKey{}.angle_deg)},
      {"height",
       {as_angle(kCameraBounds[1]), as_formula()},
       "+ looks down from above.",
       say(CameraKey{}.height_deg)},
      {"distance",
       {as_number(kCameraBounds[2].low, kCameraBounds[2].high), as_formula()},
       "1 frames the whole bust; 0.5 is half as far.",
       say(CameraKey{}.distance)},
      {"look_at",
       {as_word("place", kWholeFrame), as_lengths(kMostAim_mm)},
       "What stands in the middle: all, a place of the face such as nose_tip (with actors "
       "ann.nose_tip), or a point x y z.",
       "all"},
      {"lens",
       {as_length(kShortestLens_mm, kLongestLens_mm)},
       "For film of 24 x 36. The frame stays the same: a short lens comes near and makes the nose big.",
       say(kPortraitLens_mm, "mm")},
      build_ease(),
      build_key_between()};
  Form& place = find_first_form(camera, "look_at");
  place.data = "places";
  place.pattern = "^[a-z][a-z0-9_]*\\.[a-z_]+$";  // ann.nose_tip

  Section& turn = all.turn_key;
  turn.name = "turn_key";
  turn.help = "One key of the head's turning; a missing number keeps the one of the key before.";
  turn.expected = "a key such as {at: 1s, turn: 20deg}";
  turn.keys = {
      build_at(all.wait),
      {"turn",
       {as_angle(kTurnBounds[0]), as_formula()},
       "To the character's left (+) or right (-).",
       say(TurnKey{}.turn_deg)},
      {"nod", {as_angle(kTurnBounds[1]), as_formula()}, "Chin down (+) or up (-).", say(TurnKey{}.nod_deg)},
      {"tilt",
       {as_angle(kTurnBounds[2]), as_formula()},
       "Crown toward the character's left shoulder (+) or right (-).",
       say(TurnKey{}.tilt_deg)},
      build_ease(),
      build_key_between(),
      build_name_key()};

  Section& light = all.light_key;
  light.name = "light_key";
  light.help = "One key of the lights; what it leaves out stays as it was.";
  light.expected = "a key such as {at: 1s, set: candle}";
  light.keys = {
      build_at(all.wait),
      {"set",
       {as_word("light set", kLightSetWords)},
       "The light set, faded from the one before.",
       LightKey{}.set},
      {"brightness", {as_number(0, kMostBrightness)}, "1: as the set is.", say(LightKey{}.brightness)},
      {"angle",
       {as_angle({-360, 360})},
       "About the head: + brings the light round to the character's left.",
       say(LightKey{}.angle_deg)},
      build_ease()};

  Section& background = all.background_key;
  background.name = "background_key";
  background.help = "One key of what lies behind, faded from the one before.";
  background.expected = "a key such as {at: 1s, show: dark}";
  background.keys = {build_at(all.wait),
                     {"show",
                      {as_word("background", kBackgroundWords), as_colour()},
                      "A background by name, or a colour in quotes.",
                      BackgroundKey{}.name},
                     build_ease()};
}

void fill_head_key(Sections& all) {
  Section& head = all.head_key;
  head.name = "head_key";
  head.help = "One key of a head that changes; what it leaves out stays as it was.";
  head.expected = "a key such as {at: 1s, age: child}";
  head.keys = copy_keys(all.head, {"age", "skull", "character", "design", "guides", "features",
                                   std::string(kConformationKey), "look"});
  for (Key& key : head.keys) key.otherwise.clear();
  head.keys.insert(head.keys.begin(), build_at(all.wait));
  Key file = {
      "file", {as_file(kYamlEndings)}, "Another file's head; what stands beside it is changed of it."};
  Key mix = *std::ranges::find(all.head.keys, "mix", &Key::name);
  mix.help = "Heads of other files, mixed, as under `head`; what stands beside it is changed of them.";
  head.keys.push_back(file);
  head.keys.push_back(mix);
  head.rules = {{KeyRule::Kind::apart, {"file", "mix"}}};
  head.keys.push_back(build_ease());
  head.keys.push_back(build_name_key());
}

void fill_inputs(Sections& all) {
  Section& point = all.input_point;
  point.name = "input_point";
  point.help = "One point of an input that changes with time.";
  point.expected = "a point such as {at: 1s, value: 0.5}";
  point.keys = {build_at(all.wait), {"value", {as_number(-1e6, 1e6)}, "The number there.", "", true}};
  Section& input = all.input;
  input.name = "input";
  input.help = "A number that changes with time: a ramp, a curve, or what a device recorded.";
  input.expected = "an input such as {points: [{at: 0s, value: 0}, {at: 1s, value: 1}]}";
  input.keys = {{"points", {as_list({as_section(point)})}, "The number at some times, by rising time."},
                {"csv",
                 {as_file({".csv", ".tsv", ".txt"})},
                 "A table whose first line names its columns, one of them time or frame."},
                {"column", {as_line(kMaxTitleLength)}, "The table's column."},
                build_between("What the way from one number to the next is; straight without it.")};
  input.rules = {{KeyRule::Kind::apart, {"points", "csv"}}, {KeyRule::Kind::needs, {"column", "csv"}}};
}

void fill_sound(Section& sound) {
  sound.name = "sound";
  sound.help = "What is heard.";
  sound.expected = "a file such as voice.wav or a mapping such as {file: voice.wav, at: 0.5s}";
  sound.keys = {{"file", {as_file({".wav", ".mp3", ".ogg", ".flac", ".m4a"})}, "The sound's file.", "", true},
                {"at", {as_duration()}, "When it begins.", "0"}};
}

void fill_say(Sections& all) {
  Section& say_line = all.say;
  say_line.name = "say";
  say_line.help = "A line that the mouth says.";
  say_line.expected = "a line such as {at: 1s, text: \"I'm fine.\"}";
  say_line.keys = {
      {"at", as_waiting_time(all.wait), "When it begins.", "0"},
      {"text",
       {as_line(kMaxSaidLength)},
       "What is said; \"*so*\" stresses a word. Without a `sound` eSpeak NG speaks it."},
      {"voice",
       {as_tag("^[A-Za-z0-9_+-]{1,40}$")},
       "A voice or language of eSpeak NG, such as de or en-gb.",
       SaySpec{}.voice},
      {"pace", {as_number(0.4, 2.5)}, "How quickly: 2 is twice as quick.", say(SaySpec{}.pace)},
      {"sound", {find_key(all.sound, "file")->forms[0]}, "A recording of it."},
      {"mouths",
       {as_file({".tsv", ".xml", ".json", ".dat", ".pgo", ".TextGrid", ".vtt", ".csv"})},
       "What the mouth does when, from Rhubarb Lip Sync, Papagayo, the Montreal Forced Aligner or WebVTT."},
      build_strength_key("How much the mouth moves.", false),
      {"share", {as_number(0, 1)}, "How much of the feeling's the mouth's corners keep.", "0.33"},
      {"still",
       {as_number(0, 1)},
       "1: nothing moves but the mouth; 0: stressed words nod, questions raise the brows, pauses blink.",
       say(SaySpec{}.still)}};
  say_line.rules = {{KeyRule::Kind::one_of, {"text", "mouths"}},
                    {KeyRule::Kind::apart, {"text", "mouths"}},
                    {KeyRule::Kind::needs, {"voice", "text"}},
                    {KeyRule::Kind::needs, {"pace", "text"}}};
}

void fill_clip(Sections& all) {
  Section& change = all.draw_change;
  const Forms frames{as_word("draw", kDrawWords), as_whole(1, kMaxDraw, "frames a drawing")};
  change.name = "draw_change";
  change.help = "From a time on.";
  change.expected = "a change such as {at: 2s, on: ones}";
  change.keys = {{"at", as_waiting_time(all.wait), "From when; each later than the one before.", "", true},
                 {"on", frames, "How many frames each drawing is held.", "", true}};
  Forms draws = frames;
  draws.push_back(as_list({as_section(change)}));

  const auto list = [](const Section& section) { return Forms{as_list({as_section(section)})}; };
  Section& clip = all.clip;
  clip.name = "clip";
  clip.help = "The performance.";
  clip.expected = "a mapping such as {fps: 24, keys: [...]}";
  Form inputs =
      as_map("^[A-Za-z_][A-Za-z0-9_]*$", {as_number(-1e6, 1e6), as_formula(), as_section(all.input)});
  clip.keys = {
      {"fps", {as_whole(1, kMaxFps, "frames a second")}, "Frames a second.", say(ClipSpec{}.fps)},
      {"draw", draws,
       "Limited animation: for how many frames each drawing is held; a list changes that in time.",
       std::string(kDrawWords[static_cast<std::size_t>(ClipSpec{}.draw) - 1].name)},
      {"keys", list(all.pose_key), "The face, by rising time."},
      {"camera", list(all.camera_key), "The camera, by rising time."},
      {"turn", list(all.turn_key), "The head's turning, by rising time."},
      {"blink",
       {as_word("blink", kBlinkWords), as_section(all.blink)},
       "Blinks of their own, at seeded random times.",
       "none"},
      {"blinks",
       {as_list(as_waiting_time(all.wait))},
       "Blinks at exact times: the moments the eyes are shut."},
      {"length", {as_duration()}, "How long the clip is; without it, it ends at the last key of any track."},
      build_between("What the ways to all keys are that say nothing of it.",
                    std::string(kBetweenWords[0].name)),
      {"lead",
       {as_word("lead", kLeadWords), as_section(all.lead)},
       "Eyes set out first, then lids and brows, then the mouth, then jaw and head; corners come before the "
       "jaw "
       "where a mouth goes round, and after it where a laugh falls; all have arrived at the key.",
       "natural"},
      {"cues", list(all.cue), "What comes and goes on top of the keys."},
      {"laws", list(all.law), "Moves, and numbers of camera, turn, light and place, that follow a formula."},
      {"tracks", list(all.track), "Moves from tables."},
      {"scripts", {as_map("", {as_section(all.script)})}, "Little clips by name, for cues to play."},
      {"inputs", {inputs}, "Numbers by name, for formulas; each may use those before it."},
      {"include",
       {as_file(kYamlEndings), as_section(all.include),
        as_list({as_file(kYamlEndings), as_section(all.include)})},
       "Clips of other files: their keys, camera, turn, cues, laws, tracks, scripts and inputs. A key of "
       "this file "
       "replaces an included one of the same time."},
      {"gaze",
       {as_word("gaze", kGazeModeWords), as_list({as_section(all.gaze_key)}), as_section(all.gaze)},
       "Where the eyes look. What expressions say of the eyes is added to it."},
      {"drift",
       {find_key(all.drift, "amount")->forms[0], as_section(all.drift)},
       "Small slow motion of the head and the brows: 0 as still as stone, 1 restless.",
       say(DriftSpec{}.amount)},
      {"asymmetry",
       {as_word("asymmetry", kAsymmetryWords), find_key(all.asymmetry, "amount")->forms[0],
        as_section(all.asymmetry)},
       "How much less than the other one side of the face does at most; its areas start 20 to 60 ms apart.",
       "none"},
      {"sound",
       {find_key(all.sound, "file")->forms[0], as_section(all.sound)},
       "What is heard: a sound file that the clip is given. It is cut where the clip ends."},
      {"say", list(all.say), "What is said: the mouth speaks it, and it is heard."},
      {"head", list(all.head_key),
       "The head in time: each key says what of it changes. In between all is mixed."},
      {"light", list(all.light_key), "The lights, by rising time."},
      {"background", list(all.background_key),
       "What lies behind, by rising time; without it as `render` says."}};
}

}  // namespace

void fill_clip_sections(Sections& all) {
  fill_pose_keys(all);
  fill_stage_keys(all);
  fill_inputs(all);
  fill_head_key(all);
  fill_idle_sections(all);
  fill_layer_sections(all);
  fill_sound(all.sound);
  fill_say(all);
  fill_clip(all);
}

}  // namespace mien
