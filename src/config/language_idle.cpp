// The table of language.hpp: what a face does by itself.
#include "config/idle_spec.hpp"
#include "config/language_forms.hpp"

namespace mien {

namespace {

constexpr double kMaxPerMinute = 60;   // blinks; people come to 15 or 20
constexpr double kMaxAsymmetry = 0.3;  // more is no life but contempt: say it with `brow.left` and the like
constexpr double kMaxBreaths = 60;     // a minute: more is panting, which the head's turn says better
constexpr double kMaxSide_deg = 90, kMaxUp_deg = 60;  // eyes and head together look no further
constexpr double kFurthest_mm = 100'000;              // beyond, the two eyes look the same way

void fill_blink(Section& blink) {
  blink.name = "blink";
  blink.help = "Blinks of their own.";
  blink.expected = "natural, none or a mapping such as {per_minute: 15, seed: 7}";
  blink.keys = {{"per_minute",
                 {as_number(0, kMaxPerMinute, "blinks a minute")},
                 "Blinks a minute; 0: none. People at rest come to about 15.",
                 say(BlinkSpec{}.per_minute)},
                build_seed_key(),
                {"style", {as_word("blink", kBlinkWords)}, "Where to begin; the other keys change it."},
                {"doubles",
                 {as_number(0, 1)},
                 "The share of blinks that a second one follows at once.",
                 say(BlinkSpec{}.doubles)},
                {"partial",
                 {as_number(0, 1)},
                 "The share of blinks that do not shut the eye.",
                 say(BlinkSpec{}.partial)},
                {"shifts",
                 {as_number(0, 1)},
                 "How surely a great move of the eyes or the head takes a blink along.",
                 say(BlinkSpec{}.shifts)}};
}

void fill_gaze(Sections& all) {
  Section& direction = all.direction;
  direction.name = "direction";
  direction.help = "Angles of the room, as from a head that is not turned.";
  direction.expected = "a word such as camera, a mapping such as {side: 20deg, up: -5deg} or a point";
  direction.keys = {
      {"side",
       {as_angle({-kMaxSide_deg, kMaxSide_deg})},
       "To the character's left (+) or right (-).",
       say(GazeKey{}.side_deg)},
      {"up", {as_angle({-kMaxUp_deg, kMaxUp_deg})}, "Up (+) or down (-).", say(GazeKey{}.up_deg)}};

  Key look{
      "look",
      {as_word("look", kLookWords), as_section(direction), as_lengths(kFurthest_mm),
       as_tag(build_actor_name_pattern())},
      "With the head (ahead), into the lens (camera), to a side, at a point (left, up and forward of the "
      "middle between the ears at the eyes' height), or at another actor."};
  Section& gaze = all.gaze;
  gaze.name = "gaze";
  gaze.help = "Where the eyes look, and how quietly.";
  gaze.expected = "wander, camera, a list of keys or a mapping such as {wander: 0.5}";
  gaze.keys = {
      {"keys", {as_list({as_section(all.gaze_key)})}, "What the eyes rest on, by rising time."},
      look,
      {"wander", {as_number(0, 1)}, "Small fixations about it: 0 none, 1 restless.", say(GazeSpec{}.wander)},
      build_seed_key()};
  gaze.rules = {{KeyRule::Kind::apart, {"keys", "look"}}};

  look.is_required = true;
  Section& key = all.gaze_key;
  key.name = "gaze_key";
  key.help = "One key of the gaze.";
  key.expected = "a key such as {at: 1s, look: left}";
  key.keys = {
      {"at", as_waiting_time(all.wait), "When the eyes are there; each later than the one before.", "", true},
      look};
}

void fill_dials(Section& drift, Section& asymmetry) {
  drift.name = "drift";
  drift.help = "Small slow motion of the head and the brows.";
  drift.expected = "a number from 0 to 1 or a mapping such as {amount: 0.5, seed: 3}";
  drift.keys = {
      {"amount", {as_number(0, 1)}, "How much: 0 as still as stone, 1 restless.", say(DriftSpec{}.amount)},
      build_seed_key(),
      {"stillness", {as_number(0, 1)}, "The other way to say it: 1 as still as stone, 0 restless."},
      {"breath",
       {as_number(0, kMaxBreaths, "breaths a minute")},
       "Breaths a minute: shoulders and head rise by a millimetre or two. People at rest 12 to 16; 0 none.",
       say(DriftSpec{}.breaths_per_minute)}};
  drift.rules = {{KeyRule::Kind::apart, {"amount", "stillness"}}};

  asymmetry.name = "asymmetry";
  asymmetry.help = "How much less than the other one side of the face does.";
  asymmetry.expected = "a number from 0 to 0.3 or a mapping such as {amount: 0.2, seed: 3}";
  asymmetry.keys = {{"amount", {as_number(0, kMaxAsymmetry)}, "How much.", say(kNaturalAsymmetry)},
                    build_seed_key()};
}

}  // namespace

void fill_idle_sections(Sections& all) {
  fill_blink(all.blink);
  fill_gaze(all);
  fill_dials(all.drift, all.asymmetry);
}

}  // namespace mien
