// Formulas in place of plain numbers: what is drawn is the same to the last bit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "config/config_fixture.hpp"
#include "timeline/drawings.hpp"
#include "timeline/head_track.hpp"
#include "timeline/performance.hpp"
#include "timeline/stage_track.hpp"

namespace mien {
namespace {

// All that a file's clip shows, and what of its head does not change.
std::string draw(const Spec& spec) {
  std::string all;
  for (const ActorSpec& actor : list_actors(spec)) {
    for (const std::string& key : list_drawing_keys(build_performance(actor.clip))) all += key + "\n";
    all += compute_head_key(actor.head) + "\n";
    for (const auto& [name, limit] : actor.head.limits) all += fmt::format("{} {}\n", name, limit);
    for (const SculptStroke& stroke : actor.head.sculpt)
      all += fmt::format("{} {} {} {} {} {}\n", stroke.move_mm.x, stroke.move_mm.y, stroke.move_mm.z,
                         stroke.scale, stroke.turn_deg, stroke.radius_mm);
    all += fmt::format("{} {} {} {}\n", actor.place.at_mm.x, actor.place.at_mm.z, actor.place.turn_deg,
                       actor.clip.enters_s);
  }
  for (const std::string& key : list_drawing_keys(build_performance(spec.clip))) all += key + "\n";
  for (int frame = 0; frame < count_frames(spec.clip); ++frame)
    all += compute_stage_key(sample_stage(spec.clip, compute_drawing_time_s(spec.clip, frame))) + "\n";
  for (const BustSpec& bust : spec.busts)
    all += fmt::format("{} {}\n", bust.height_mm, bust.expression.reach);
  return all + fmt::format("{}x{} {} {}\n", spec.render.width_px, spec.render.height_px, spec.clip.fps,
                           spec.clip.length_s);
}

std::string replace_all(std::string text, const std::string& word, const std::string& with) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + with.size()))
    text.replace(at, word.size(), with);
  return text;
}

TEST(formula_places, a_cue_at_half_of_the_runtime_is_one_at_the_plain_time) {
  const std::string text = R"Y(mien: 1
clip:
  length: 3s
  keys: [{at: 0s}, {at: 1s, express: smile}]
  cues: [{from: @, express: anger, attack: #, hold: 0.5s}]
)Y";
  const std::string plain = draw(load_text(replace_all(replace_all(text, "@", "1.5s"), "#", "0.3s")));
  EXPECT_EQ(draw(load_text(replace_all(replace_all(text, "@", "\"runtime/2\""), "#", "\"0.1*runtime\""))),
            plain);
  EXPECT_NE(draw(load_text(replace_all(replace_all(text, "@", "\"runtime/3\""), "#", "\"0.1*runtime\""))),
            plain);
}

// A place for a number: between which ends, in which unit; whole numbers have no fraction.
struct Slot {
  const char* name;
  double low, high;
  const char* unit = "";
  bool is_whole = false;
  bool is_live = false;  // a formula of time may stand there: it is held within its range, not refused
};

constexpr std::array kSlots{
    Slot{"age", 0.1, 5},
    Slot{"character", -1, 1},
    Slot{"guide", 0.47, 0.5},
    Slot{"feature", -1, 1},
    Slot{"limit", 0.3, 1},
    Slot{"freckles", 0, 1},
    Slot{"move", -3, 3, "mm"},
    Slot{"scale", 0.9, 1.1},
    Slot{"stroke", -10, 10, "deg"},
    Slot{"radius", 10, 30, "mm"},
    Slot{"far", 1, 1.5},
    Slot{"own", 0.2, 0.9},
    Slot{"fps", 12, 30, "", true},
    Slot{"length", 2.5, 4, "s"},
    Slot{"draw", 1, 3, "", true},
    Slot{"key1", 0.2, 0.8, "s"},
    Slot{"key2", 1, 1.6, "s"},
    Slot{"strength", 0.2, 0.9, "", false, true},
    Slot{"press", 0, 0.8, "", false, true},
    Slot{"ease", 0, 1},
    Slot{"release", 0.05, 0.15, "s"},
    Slot{"angle", -90, 90, "deg"},
    Slot{"distance", 0.5, 2, "", false, true},
    Slot{"lens", 40, 200, "mm"},
    Slot{"point", -90, 90, "mm"},
    Slot{"nod", -30, 30, "deg", false, true},
    Slot{"bright", 0.2, 2},
    Slot{"blink", 5, 40},
    Slot{"seed", 0, 1000, "", true},
    Slot{"shut", 0.3, 2, "s"},
    Slot{"side", -20, 20, "deg"},
    Slot{"drift", 0, 1},
    Slot{"uneven", 0, 0.3},
    Slot{"from", 0.3, 1.2, "s"},
    Slot{"attack", 0.05, 0.4, "s"},
    Slot{"hold", 0.1, 0.5, "s"},
    Slot{"go", 0.1, 0.5, "s"},
    Slot{"times", 1, 3, "", true},
    Slot{"depth", -20, 20, "", false, true},
    Slot{"little", 0.2, 0.6, "s"},
    Slot{"law", -0.8, 0.8, "", false, true},
    Slot{"least", -0.5, 0},
    Slot{"delay", 0.01, 0.2, "s"},
    Slot{"lead", 0, 0.1, "s"},
    Slot{"grown", -1, 1},
    Slot{"bust", 30, 120, "mm"},
};

constexpr const char* kAll = R"Y(mien: 1
head:
  age: {child: @age, adult: 1}
  character: @character
  guides: {eye_line: @guide}
  features: {nose_length: @feature}
  limits: {brow.left.up: @limit}
  look: {freckles: @freckles}
  sculpt: [{at: cheek, move: [@move, 0, @move], scale: @scale, turn: @stroke, about: y, radius: @radius}]
exaggerate: @far
expressions: {sly: {from: smile, brow.left: {up: @own}}}
clip:
  fps: @fps
  length: @length
  draw: @draw
  inputs: {a: 0.37, b: 3, c: "a*b", d: "runtime + fps"}
  lead: {head: @lead}
  keys:
    - {at: 0s, name: first}
    - {at: @key1, express: {sly: @strength}, areas: {lips: {press: @press}}, ease: [@ease, 0, 0.4, 1], release: {brows: @release}}
    - {at: @key2, express: surprise, strength: @strength}
  camera: [{at: 0s, angle: @angle, distance: @distance, lens: @lens, look_at: [@point, 0, @point]}, {at: @key1}]
  turn: [{at: 0s}, {at: {after: first, delay: @delay}, nod: @nod}]
  light: [{at: 0s}, {at: @key2, set: moon, brightness: @bright, angle: @angle}]
  blink: {per_minute: @blink, seed: @seed}
  blinks: [@shut]
  gaze: [{at: 0s, look: ahead}, {at: @key2, look: {side: @side}}]
  drift: {amount: @drift, seed: @seed}
  asymmetry: @uneven
  cues:
    - {from: @from, express: anger, attack: @attack, hold: @hold, release: @go, strength: @strength, areas: [brows]}
    - {from: @key2, play: nod_yes, repeat: @times, with: {depth: @depth}}
  scripts:
    nod_yes: {length: @little, parameters: {depth: 3}, turn: [{at: 0s}, {at: 0.1s, nod: "depth"}]}
  laws:
    - {area: corners, move: up, value: @law, from: @from, attack: @attack, range: [@least, 0.9], rule: add}
    - {turn: tilt, value: @nod, from: @from, attack: @attack, range: [-5deg, 5deg]}
    - {camera: angle, value: @angle, to: @key2, release: @attack, rule: add}
    - {light: brightness, value: @bright, from: @from}
  head: [{at: @key1, features: {nose_length: @grown}}]
render: {size: 64x64}
busts: [{express: smile, height: @bust}]
)Y";

struct Dice {
  std::mt19937_64 random;

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  }
  std::size_t pick(std::size_t count) { return random() % count; }
};

// A formula, and what it comes to by C++'s arithmetic: about `about`.
std::pair<std::string, double> build_formula_about(double about, bool is_whole, Dice& dice) {
  constexpr double kA = 0.37, kB = 3, kC = 0.37 * 3;
  const std::string n = fmt::format("{:.17g}", about);
  if (is_whole) {
    switch (dice.pick(3)) {
      case 0:
        return {fmt::format("({} + b) - 3", n), (about + kB) - 3};
      case 1:
        return {fmt::format("b*{}/b", n), kB * about / kB};
      default:
        return {fmt::format("max({}, -b)", n), std::max(about, -kB)};
    }
  }
  switch (dice.pick(6)) {
    case 0:
      return {n, about};
    case 1:
      return {fmt::format("{} + a*1e-3", n), about + kA * 1e-3};
    case 2:
      return {fmt::format("({})/b*3", n), about / kB * 3};
    case 3:
      return {fmt::format("c > 1 ? {} : 7", n), kC > 1 ? about : 7};
    case 4:
      return {fmt::format("clamp({}, -1000, b*1000)", n), std::clamp(about, -1000.0, kB * 1000)};
    default:
      return {fmt::format("({}) - c*1e-4", n), about - kC * 1e-4};
  }
}

TEST(formula_places, come_to_what_plain_numbers_are_in_every_place) {
  Dice dice{std::mt19937_64(20)};
  std::size_t differing = 0;
  std::string before;
  for (int round = 0; round < 12; ++round) {
    std::string plain = kAll, formula = kAll;
    std::vector<Slot> slots(kSlots.begin(), kSlots.end());
    // Longer names first: none begins as another one does then.
    std::ranges::sort(slots, [](const Slot& a, const Slot& b) {
      return std::string_view(a.name).size() > std::string_view(b.name).size();
    });
    for (const Slot& slot : slots) {
      const double margin = slot.is_whole ? 0 : 0.005 * (slot.high - slot.low);
      double about = dice.uniform(slot.low + margin, slot.high - margin);
      if (slot.is_whole) about = std::floor(about);
      const auto [text, number] = build_formula_about(about, slot.is_whole, dice);
      const std::string word = std::string("@") + slot.name;
      plain = replace_all(plain, word, fmt::format("{:.17g}{}", number, slot.unit));
      formula = replace_all(formula, word, "\"" + text + "\"");
    }
    const std::string drawn = draw(load_text(plain));
    ASSERT_EQ(draw(load_text(formula)), drawn) << formula;
    differing += drawn != before;
    before = drawn;
  }
  EXPECT_EQ(differing, 12u);
}

// Each place by itself: the file reads it, in its range and no further.
TEST(formula_places, are_judged_by_the_ranges_of_plain_numbers) {
  for (const Slot& slot : kSlots) {
    if (slot.is_live) continue;
    std::string plain = kAll, formula = kAll;
    for (const Slot& other : kSlots) {
      const bool is_it = &other == &slot;
      const double middle =
          other.is_whole ? std::floor((other.low + other.high) / 2) : (other.low + other.high) / 2;
      const double number = is_it ? -12345678.5 : middle;
      const std::string word = std::string("@") + other.name;
      // As long as each other, so that both mistakes stand in the same columns.
      for (const char behind : {',', '}', ']', '\n'}) {
        plain = replace_all(plain, word + behind, fmt::format("{:.17g}{}{}", number, other.unit, behind));
        formula = replace_all(formula, word + behind,
                              is_it ? fmt::format("\"-12345678 - 0.5\"{}", behind)
                                    : fmt::format("{:.17g}{}{}", number, other.unit, behind));
      }
    }
    const std::string said = find_text_mistakes(formula), told = find_text_mistakes(plain);
    ASSERT_NE(told, "") << slot.name;
    // A limit may be a length, too, which no formula is.
    const auto expected = [](std::string mistakes) {
      mistakes = replace_all(mistakes, ", or a length such as 12mm or 0.3eye_nose", "");
      const std::size_t begin = mistakes.find("; expected");
      return begin == std::string::npos ? mistakes : mistakes.substr(begin, mistakes.find('\n') - begin);
    };
    EXPECT_EQ(expected(said), expected(told)) << slot.name << "\n" << said;
    EXPECT_NE(said.find(" is the formula '-12345678 - 0.5', which comes to -1.234568e+07"), std::string::npos)
        << slot.name << "\n"
        << said;
  }
}

}  // namespace
}  // namespace mien
