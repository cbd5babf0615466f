// Changes of texts, by hand: each style of writing, and each refusal in its words.
#include "config/edit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "config/config_fixture.hpp"

namespace mien {
namespace {

struct SetCase {
  std::string before;
  YamlPath path;
  std::string value, after;
};

void expect_set(const std::vector<SetCase>& cases) {
  for (const SetCase& each : cases)
    EXPECT_EQ(set_value(each.before, each.path, each.value), each.after) << each.before;
}

template <typename Edit>
std::string find_refusal(const Edit& edit) {
  try {
    return "not refused: " + edit();
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string refuse_set(const std::string& text, const YamlPath& path, const std::string& value = "1") {
  return find_refusal([&] { return set_value(text, path, value); });
}

TEST(edit, replaces_a_value_and_nothing_else) {
  const YamlPath age{"head", "age"};
  expect_set({
      {"mien: 1\nhead:\n  age: adult   # how old\n", age, "child",
       "mien: 1\nhead:\n  age: child   # how old\n"},
      {"head: {age: adult, hair: bob}\n", age, "{child: 1, old: 2}",
       "head: {age: {child: 1, old: 2}, hair: bob}\n"},
      {"head: {age: \"adult\", hair: bob}", age, "child", "head: {age: child, hair: bob}"},
      {"head: {age: 'it''s'}", age, "child", "head: {age: child}"},
      {"head: {age: \"a \\\" b\"}  # c", age, "child", "head: {age: child}  # c"},
      {"head:\n  age: {child: 1,  # young\n        old: 1}\n", age, "old", "head:\n  age: old\n"},
      {"head:\n  age:   # a mix\n    child: 1\n    old: 1   # more\n  hair: bob\n", age, "old",
       "head:\n  age: old   # a mix\n  hair: bob\n"},
      {"head:\n  age:\n    child: 1\n    old: 1", age, "old", "head:\n  age: old"},
      {"head:\n  age: young\n    adult  # over lines\n  hair: bob\n", age, "old",
       "head:\n  age: old  # over lines\n  hair: bob\n"},
      {"title: >-\n  one\n\n  two\nhead: {}\n", {"title"}, "three", "title: three\nhead: {}\n"},
      {"head:\n  \"age\": adult\n", age, "old", "head:\n  \"age\": old\n"},
      {"head: {age: ~, hair: bob}\n", age, "old", "head: {age: old, hair: bob}\n"},
      {"head: {age: , hair: bob}\n", age, "old", "head: {age: old , hair: bob}\n"},
      {"head: {age, hair: bob}\n", age, "old", "head: {age: old, hair: bob}\n"},
      {"head:\n  age:   # none\n", age, "old", "head:\n  age: old   # none\n"},
      {"head:\n  age: &a adult\n", age, "old", "head:\n  age: &a old\n"},
      {"--- # begins\nhead: {age: adult}\n...\n", age, "old", "--- # begins\nhead: {age: old}\n...\n"},
      {"head:\t{age:\tadult}\t# tab\n", age, "old", "head:\t{age:\told}\t# tab\n"},
      {"title: \xC3\xA4\xE2\x82\xAC\nhead: {age: adult}\n", age, "old",
       "title: \xC3\xA4\xE2\x82\xAC\nhead: {age: old}\n"},
  });
}

TEST(edit, keeps_line_ends_and_the_byte_order_mark) {
  expect_set({
      {"\xEF\xBB\xBFmien: 1\r\nhead:\r\n  age: adult # c\r\n",
       {"head", "age"},
       "old",
       "\xEF\xBB\xBFmien: 1\r\nhead:\r\n  age: old # c\r\n"},
      {"\xEF\xBB\xBFmien: 1\r\nhead:\r\n  age: adult\r\n",
       {"head", "hair"},
       "bob",
       "\xEF\xBB\xBFmien: 1\r\nhead:\r\n  age: adult\r\n  hair: bob\r\n"},
      {"\xEF\xBB\xBF{mien: 1}", {"title"}, "a", "\xEF\xBB\xBF{mien: 1, title: a}"},
      {"mien: 1\rhead: {}\r", {"head", "hair"}, "bob", "mien: 1\rhead: {hair: bob}\r"},
      {"mien: 1\rtitle: a\r", {"head", "hair"}, "bob", "mien: 1\rtitle: a\rhead:\r  hair: bob\r"},
      {"mien: 1\r\nhead:\n  age: adult\r\n", {"head", "age"}, "old", "mien: 1\r\nhead:\n  age: old\r\n"},
  });
}

TEST(edit, adds_what_is_missing_as_its_neighbours_are_written) {
  const YamlPath nose{"head", "features", "nose_length"};
  expect_set({
      {"mien: 1\n", nose, "0.3", "mien: 1\nhead:\n  features: {nose_length: 0.3}\n"},
      {"mien: 1", nose, "0.3", "mien: 1\nhead:\n  features: {nose_length: 0.3}"},
      {"{mien: 1}\n", nose, "0.3", "{mien: 1, head: {features: {nose_length: 0.3}}}\n"},
      {"mien: 1\nhead:\n", nose, "0.3", "mien: 1\nhead:\n  features: {nose_length: 0.3}\n"},
      {"mien: 1\nhead:   # whose\nclip: {}\n", nose, "0.3",
       "mien: 1\nhead:   # whose\n  features: {nose_length: 0.3}\nclip: {}\n"},
      {"mien: 1\nhead: ~\n", nose, "0.3", "mien: 1\nhead: {features: {nose_length: 0.3}}\n"},
      {"{mien: 1, head: }\n", nose, "0.3", "{mien: 1, head: {features: {nose_length: 0.3}} }\n"},
      {"head: {}\n", nose, "0.3", "head: {features: {nose_length: 0.3}}\n"},
      {"head: {age: old}  # c\n", nose, "0.3", "head: {age: old, features: {nose_length: 0.3}}  # c\n"},
      {"head: {age: old,}\n", nose, "0.3", "head: {age: old, features: {nose_length: 0.3},}\n"},
      {"head: {\n  age: old,  # years\n  hair: bob  # cut\n}\n", nose, "0.3",
       "head: {\n  age: old,  # years\n  hair: bob,  # cut\n  features: {nose_length: 0.3}\n}\n"},
      {"head: {\n  age: old,\n  hair: bob,  # cut\n}\n", nose, "0.3",
       "head: {\n  age: old,\n  hair: bob,  # cut\n  features: {nose_length: 0.3},\n}\n"},
      {"head: {age: old,\n       hair: bob}\n", nose, "0.3",
       "head: {age: old,\n       hair: bob,\n       features: {nose_length: 0.3}}\n"},
      {"head:\n    age: old   # c\n\n# of the clip\nclip: {}\n", nose, "0.3",
       "head:\n    age: old   # c\n    features: {nose_length: 0.3}\n\n# of the clip\nclip: {}\n"},
      {"head:\n    features:\n        nose_width: 1\nclip: {}", nose, "0.3",
       "head:\n    features:\n        nose_width: 1\n        nose_length: 0.3\nclip: {}"},
      {"clip:\n    fps: 24\n", nose, "0.3", "head:\n    features: {nose_length: 0.3}\nclip:\n    fps: 24\n"},
      {"busts:\n- height: 60mm\n  base: none\n",
       {"busts", 0u, "wall"},
       "2mm",
       "busts:\n- height: 60mm\n  base: none\n  wall: 2mm\n"},
      {"busts:\n  - {height: 60mm}\n",
       {"busts", 1u},
       "{height: 80mm}",
       "busts:\n  - {height: 60mm}\n  - {height: 80mm}\n"},
      {"clip: {blinks: [1s, 2s]}\n", {"clip", "blinks", 2u}, "3s", "clip: {blinks: [1s, 2s, 3s]}\n"},
      {"clip: {blinks: []}\n", {"clip", "blinks", 0u}, "3s", "clip: {blinks: [3s]}\n"},
      {"clip:\n  fps: 24\n", {"clip", "blinks", 0u}, "3s", "clip:\n  fps: 24\n  blinks: [3s]\n"},
      {"head:\n  look: {skin: fair}\n",
       {"head", "mix", "a b.yaml"},
       "1",
       "head:\n  look: {skin: fair}\n  mix: {\"a b.yaml\": 1}\n"},
  });
}

TEST(edit, puts_a_section_where_files_have_it) {
  expect_set({
      {"mien: 1\nclip: {}\nrender: {}\n", {"title"}, "Hm", "mien: 1\ntitle: Hm\nclip: {}\nrender: {}\n"},
      {"mien: 1\n\nclip: {}\n\nrender: {}\n",
       {"head"},
       "{age: old}",
       "mien: 1\n\nhead: {age: old}\n\nclip: {}\n\nrender: {}\n"},
      {"mien: 1\n\nclip: {}\n\nrender: {}\n",
       {"busts"},
       "[]",
       "mien: 1\n\nclip: {}\n\nrender: {}\n\nbusts: []\n"},
      {"mien: 1\n\n# it plays\nclip: {}\n",
       {"expressions", "a"},
       "{}",
       "mien: 1\n\nexpressions:\n  a: {}\n\n# it plays\nclip: {}\n"},
      {"clip: {}\n", {"mien"}, "1", "mien: 1\nclip: {}\n"},
      {"# about\nclip: {}\n", {"head", "age"}, "old", "# about\nhead:\n  age: old\nclip: {}\n"},
      {"mien: 1\nclip:\n  fps: 24\n  # of the clip\n# of all\n",
       {"render", "quality"},
       "draft",
       "mien: 1\nclip:\n  fps: 24\n  # of the clip\nrender:\n  quality: draft\n# of all\n"},
      {"mien: 1\nbusts: []\n", {"other"}, "1", "mien: 1\nbusts: []\nother: 1\n"},
  });
}

TEST(edit, begins_an_empty_text) {
  expect_set({
      {"", {"head", "age"}, "old", "mien: 1\nhead:\n  age: old\n"},
      {"# only words", {"title"}, "Hm", "# only words\nmien: 1\ntitle: Hm\n"},
      {"# only words\r\n\r\n", {"mien"}, "1", "# only words\r\n\r\nmien: 1\r\n"},
  });
}

TEST(edit, makes_a_mapping_of_a_word_that_stands_for_one) {
  expect_set({
      {"head: {age: child}\n", {"head", "age", "old"}, "0.5", "head: {age: {child: 1, old: 0.5}}\n"},
      {"head:\n  design: comic  # drawn\n",
       {"head", "design", "real"},
       "1",
       "head:\n  design: {comic: 1, real: 1}  # drawn\n"},
      {"clip: {keys: [{at: 0s, express: smile}]}\n",
       {"clip", "keys", 0u, "express", "fear"},
       "0.3",
       "clip: {keys: [{at: 0s, express: {smile: 1, fear: 0.3}}]}\n"},
      {"clip: {drift: 0.5}\n", {"clip", "drift", "seed"}, "2", "clip: {drift: {amount: 0.5, seed: 2}}\n"},
      {"clip: {blink: natural}\n",
       {"clip", "blink", "seed"},
       "2",
       "clip: {blink: {style: natural, seed: 2}}\n"},
      {"clip: {include: a.yaml}\n",
       {"clip", "include", "at"},
       "2s",
       "clip: {include: {file: a.yaml, at: 2s}}\n"},
  });
  EXPECT_EQ(refuse_set("clip: {gaze: camera}", {"clip", "gaze", "seed"}),
            "'clip.gaze' is 'camera'; expected a mapping, for 'seed' in it");
  EXPECT_EQ(refuse_set("clip: {asymmetry: natural}", {"clip", "asymmetry", "seed"}),
            "'clip.asymmetry' is 'natural'; expected a mapping, for 'seed' in it");
  EXPECT_EQ(refuse_set("actors: {ann: {head: ann.yaml}}", {"actors", "ann", "head", "age"}),
            "'actors.ann.head' is 'ann.yaml'; expected a mapping, for 'age' in it");
}

TEST(edit, removes_an_entry_with_its_line) {
  const auto expect = [](const std::string& before, const YamlPath& path, const std::string& after) {
    EXPECT_EQ(remove_value(before, path), after) << before;
  };
  const YamlPath age{"head", "age"};
  expect("mien: 1\nhead:\n  age: old  # c\n  hair: bob\n", age, "mien: 1\nhead:\n  hair: bob\n");
  expect("mien: 1\nhead:\n  hair: bob\n  age: old", age, "mien: 1\nhead:\n  hair: bob");
  expect("mien: 1\r\nhead:\r\n  hair: bob\r\n  age: old\r\n", age, "mien: 1\r\nhead:\r\n  hair: bob\r\n");
  expect("mien: 1\nhead:\n  age: old\nclip: {}\n", age, "mien: 1\nclip: {}\n");
  expect("mien: 1\n\nhead:\n  age: old\n\nclip: {}\n", age, "mien: 1\n\nclip: {}\n");
  expect("mien: 1\n\nhead: {age: old}\n", age, "mien: 1\n");
  expect("mien: 1\nhead: {age: old, hair: bob}\n", age, "mien: 1\nhead: {hair: bob}\n");
  expect("mien: 1\nhead: {hair: bob, age: old}\n", age, "mien: 1\nhead: {hair: bob}\n");
  expect("mien: 1\nhead: {hair: bob, age: old,}\n", age, "mien: 1\nhead: {hair: bob,}\n");
  expect("mien: 1\nhead: {\n  hair: bob,  # cut\n  age: old\n}\n", age,
         "mien: 1\nhead: {\n  hair: bob  # cut\n}\n");
  expect("mien: 1\nhead: {\n  hair: bob,  # cut\n  age: old}\n", age,
         "mien: 1\nhead: {\n  hair: bob  # cut\n  }\n");
  expect("mien: 1\nclip: {blinks: [1s, 2s, 3s]}\n", {"clip", "blinks", 1u},
         "mien: 1\nclip: {blinks: [1s, 3s]}\n");
  expect("clip:\n  keys:\n    # first\n    - {at: 0s}\n    - {at: 1s}  # second\n  fps: 24\n",
         {"clip", "keys", 1u}, "clip:\n  keys:\n    # first\n    - {at: 0s}\n  fps: 24\n");
  expect("clip:\n  keys:\n  - at: 0s\n    express: smile\n  - at: 1s\n", {"clip", "keys", 0u, "at"},
         "clip:\n  keys:\n  - express: smile\n  - at: 1s\n");
  expect("clip:\n  keys:\n  - at: 0s\n    express: smile\n  - at: 1s\n", {"clip", "keys", 1u, "at"},
         "clip:\n  keys:\n  - at: 0s\n    express: smile\n");
  expect("mien: 1\nclip: {keys: [{at: 0s}]}\n", {"clip", "keys", 0u, "at"}, "mien: 1\n");
  const auto refuse = [](const std::string& text, const YamlPath& path) {
    return find_refusal([&] { return remove_value(text, path); });
  };
  EXPECT_EQ(refuse("mien: 1\n", {"head", "age"}), "there is no 'head.age'; expected something to remove");
  EXPECT_EQ(refuse("", {"head"}), "there is no 'head'; expected something to remove");
  EXPECT_EQ(refuse("mien: 1\n", {}), "there is no the file; expected something to remove");
  EXPECT_EQ(refuse("mien: 1\n", {"mien"}), "without 'mien' the file is empty; expected something to stay");
}

TEST(edit, leaves_what_aliases_repeat) {
  const std::string text =
      "mien: 1\nhead: &h {age: old, look: &l {skin: fair}}\nclip:\n  keys: &k\n    - {at: 0s}\n"
      "  head: [{at: 0s, look: *l}]\n  turn: *k\n";
  EXPECT_EQ(set_value(text, {"head", "age"}, "child"),
            "mien: 1\nhead: &h {age: child, look: &l {skin: fair}}\nclip:\n  keys: &k\n    - {at: 0s}\n"
            "  head: [{at: 0s, look: *l}]\n  turn: *k\n");
  EXPECT_EQ(refuse_set(text, {"head", "look", "skin"}, "dark"),
            "an alias on line 6 repeats 'head.look', or a part of it; expected a value that stands once");
  EXPECT_EQ(refuse_set(text, {"head", "look"}, "{}"),
            "an alias on line 6 repeats 'head.look', or a part of it; expected a value that stands once");
  EXPECT_EQ(refuse_set(text, {"head"}, "{}"),
            "an alias on line 6 repeats 'head', or a part of it; expected a value that stands once");
  EXPECT_EQ(refuse_set(text, {"clip", "turn", 0u, "at"}, "1s"),
            "'clip.turn' is an alias; expected a value of its own to change");
  EXPECT_EQ(refuse_set(text, {"clip", "keys", 1u}, "{at: 1s}"),
            "an alias on line 7 repeats 'clip.keys', or a part of it; expected a value that stands once");
  EXPECT_EQ(find_refusal([&] {
              return remove_value(text, {"clip", "keys"});
            }),
            "an alias on line 7 repeats 'clip.keys', or a part of it; expected a value that stands once");
  EXPECT_EQ(remove_value("a: &x 1\nb: 2\n", {"a"}), "b: 2\n");
}

TEST(edit, refuses_in_words) {
  EXPECT_EQ(refuse_set("head: [\n", {"head"}).substr(0, 46),
            "the text cannot be read for changes: line 1: '");
  EXPECT_EQ(refuse_set("a: 1\na: 2\n", {"a"}),
            "the text cannot be read for changes: line 2: duplicate key 'a'; it stands on line 1 already");
  EXPECT_EQ(refuse_set("hello\n", {"a"}), "the file is 'hello'; expected a mapping, for 'a' in it");
  EXPECT_EQ(refuse_set("- 1\n", {"a"}), "the file is a list; expected a mapping, for 'a' in it");
  EXPECT_EQ(refuse_set("a: {b: 1}\n", {"a", 0u}), "'a' is a mapping; expected a list, for [0] in it");
  EXPECT_EQ(refuse_set("a: [1]\n", {"a", 3u}),
            "'a' has 1 item; expected one of them, or [1] behind the last");
  EXPECT_EQ(refuse_set("a: 1\n", {"b", 3u}), "there is no 'b[3]'; expected [0] as the first item of a list");
  EXPECT_EQ(refuse_set("a: 1\n", {}), "the path is empty; expected keys such as head, age");
  for (const char* value : {"", "a\nb", "[1", "a: b", "1 # one", " 1", "&x 1", "*x", "!t 1", "- 1", "| a"})
    EXPECT_EQ(refuse_set("a: 1\n", {"a"}, value).substr(0, 11), "the value '") << value;
  EXPECT_EQ(refuse_set("a: 1\n", {"a"}, "[1"),
            "the value '[1' is no YAML of one line; expected a word, a number, a text in quotes, or a list "
            "or mapping "
            "in brackets");
  EXPECT_EQ(refuse_set("a: {b: 1}\n", {"a", "b"}, "x, y"),
            "'a.b' cannot be changed alone, as the text is written; expected a change by hand");
}

// One value of a pose, by the words of the language.
Pose build_pose(const std::vector<std::tuple<std::string_view, Side, std::string_view, double>>& values) {
  Pose pose;
  for (const auto& [area, side, move, value] : values)
    pose.values[find_move(area, side, move).value()] = value;
  return pose;
}

const Pose kWry = build_pose({{"brow", Side::left, "up", 0.5},
                              {"brow", Side::right, "up", 0.5},
                              {"brow", Side::left, "turn", 0.25},
                              {"lips", Side::none, "press", 0.12345},
                              {"corner", Side::right, "up", -0.5},
                              {"chin", Side::none, "down", 0.0001}});
const std::string kWryAreas =
    "areas: {brows: {up: 0.5}, brow.left: {turn: 0.25}, lips: {press: 0.123}, corner.right: {up: -0.5}}";

std::string write(const std::string& text, double at_s, const Pose& pose, const std::string& actor = "") {
  return write_key(text, {actor, at_s, 24, pose}, *find_language());
}

TEST(edit, writes_a_key_among_its_neighbours) {
  EXPECT_EQ(write("", 0, {}), "mien: 1\nclip:\n  keys:\n    - {at: 0s}\n");
  EXPECT_EQ(write("mien: 1\n", 0.5, kWry), "mien: 1\nclip:\n  keys:\n    - {at: 0.5s, " + kWryAreas + "}\n");
  EXPECT_EQ(write("mien: 1\nclip:\n  fps: 24\n", 0.5, {}),
            "mien: 1\nclip:\n  fps: 24\n  keys:\n    - {at: 0.5s}\n");
  EXPECT_EQ(write("mien: 1\nclip:\n  keys:\n", 0.5, {}), "mien: 1\nclip:\n  keys:\n    - {at: 0.5s}\n");
  EXPECT_EQ(write("mien: 1\nclip: {keys: []}\n", 0.5, {}), "mien: 1\nclip: {keys: [{at: 0.5s}]}\n");
  EXPECT_EQ(write("mien: 1\nclip: {fps: 24}\n", 0.5, {}), "mien: 1\nclip: {fps: 24, keys: [{at: 0.5s}]}\n");
  EXPECT_EQ(write("clip: {keys: [{at: 0f}, {at: 24f}]}\n", 0.5, {}),
            "clip: {keys: [{at: 0f}, {at: 12f}, {at: 24f}]}\n");
  EXPECT_EQ(write("clip: {keys: [{at: 500ms}]}\n", 0.25, {}), "clip: {keys: [{at: 250ms}, {at: 500ms}]}\n");
  EXPECT_EQ(write("clip: {keys: [{at: 0}]}\n", 7 / 24.0, {}), "clip: {keys: [{at: 0}, {at: 0.29}]}\n");
  const std::string lines =
      "clip:\n  keys:\n    # begins\n    - at: 0s  # here\n      express: smile\n    - at: 2s\n  fps: 24\n";
  EXPECT_EQ(write(lines, 1, kWry),
            "clip:\n  keys:\n    # begins\n    - at: 0s  # here\n      express: smile\n    - at: 1s\n      " +
                kWryAreas + "\n    - at: 2s\n  fps: 24\n");
  EXPECT_EQ(write(lines, 3, {}),
            "clip:\n  keys:\n    # begins\n    - at: 0s  # here\n      express: smile\n    - at: 2s\n    - "
            "at: 3s\n  fps: 24\n");
  EXPECT_EQ(write("clip:\n  keys:\n    # later\n    - {at: 2s}\n", 1, {}),
            "clip:\n  keys:\n    # later\n    - {at: 1s}\n    - {at: 2s}\n");
  EXPECT_EQ(write("actors: {ann: {head: {}}}\n", 1, {}),
            "actors: {ann: {head: {}, clip: {keys: [{at: 1s}]}}}\n");
  EXPECT_EQ(
      write("actors:\n  ann:\n    head: {}\n  bob:\n    head: {}\n", 1, {}, "ann"),
      "actors:\n  ann:\n    head: {}\n    clip:\n      keys:\n        - {at: 1s}\n  bob:\n    head: {}\n");
}

TEST(edit, changes_the_key_that_stands_there) {
  const auto in_clip = [](const std::string& key) {
    return "mien: 1\nclip:\n  keys:\n    - {at: 1s, " + key + "}  # c\n";
  };
  EXPECT_EQ(write(in_clip("ease: out"), 1.01, kWry), in_clip("ease: out, " + kWryAreas));
  EXPECT_EQ(write(in_clip("areas: {lids: {upper: -1}}, ease: out"), 1, {}), in_clip("ease: out"));
  EXPECT_EQ(write(in_clip("express: wink, strength: 0.5, name: a"), 1, kWry),
            in_clip("name: a, " + kWryAreas));
  // What an expression says stays its own.
  const Spec spec = load_text(in_clip("express: smile, strength: 0.5"));
  Pose pose = spec.clip.keys.front().pose;
  EXPECT_EQ(write(in_clip("express: smile, strength: 0.5"), 1, pose),
            in_clip("express: smile, strength: 0.5"));
  EXPECT_EQ(write(in_clip("express: smile, strength: 0.5, areas: {lids: {upper: -1}}"), 1, pose),
            in_clip("express: smile, strength: 0.5"));
  pose.values[find_move("chin", Side::none, "down").value()] = 0.4;
  EXPECT_EQ(write(in_clip("express: smile, strength: 0.5"), 1, pose),
            in_clip("express: smile, strength: 0.5, areas: {chin: {down: 0.4}}"));
  // Further than a face can go.
  const Pose far = build_pose({{"lips", Side::none, "upper", 1.5}, {"chin", Side::none, "down", 0.75}});
  EXPECT_EQ(write(in_clip("ease: in"), 1, far),
            in_clip("ease: in, exaggerate: 1.5, areas: {lips: {upper: 1}, chin: {down: 0.5}}"));
  EXPECT_EQ(write("exaggerate: 2\n" + in_clip("ease: in"), 1, far),
            "exaggerate: 2\n" + in_clip("ease: in, areas: {lips: {upper: 0.75}, chin: {down: 0.375}}"));
}

TEST(edit, writes_an_expression) {
  const std::string areas = kWryAreas.substr(7);
  EXPECT_EQ(write_expression("mien: 1\n", "wry", kWry), "mien: 1\nexpressions:\n  wry: " + areas + "\n");
  EXPECT_EQ(write_expression("mien: 1\nexpressions:\n  a: {from: smile}\n", "wry", kWry),
            "mien: 1\nexpressions:\n  a: {from: smile}\n  wry: " + areas + "\n");
  EXPECT_EQ(
      write_expression("mien: 1\nexpressions:\n  wry:  # so\n    from: smile\n    attack: 1s\nclip: {}\n",
                       "wry", kWry),
      "mien: 1\nexpressions:\n  wry: " + areas + "  # so\nclip: {}\n");
  EXPECT_EQ(write_expression("mien: 1\n", "calm", {}), "mien: 1\nexpressions:\n  calm: {}\n");
  EXPECT_EQ(write_expression("mien: 1\n", "far", build_pose({{"lips", Side::none, "upper", 2}})),
            "mien: 1\nexpressions:\n  far: {lips: {upper: 1}, exaggerate: 2}\n");
  EXPECT_EQ(
      find_refusal([&] { return write_expression("mien: 1\n", "a b", {}); }),
      "'a b' cannot name an expression; expected a letter, then letters, digits, '_' or '-', 64 at most");
}

TEST(edit, refuses_a_key_in_words) {
  const auto refuse = [](const std::string& text, double at_s, const std::string& actor = "") {
    return find_refusal([&] { return write(text, at_s, kWry, actor); });
  };
  EXPECT_EQ(refuse("mien: 1\n", -1), "the key would stand at -1s; expected a time from 0s to 4166.667s");
  EXPECT_EQ(refuse("actors: {ann: {}, bob: {}}\n", 0), "no actor is named; expected one of: ann, bob");
  EXPECT_EQ(refuse("actors: {ann: {}, bob: {}}\n", 0, "bop"), "unknown actor 'bop'; did you mean 'bob'?");
  EXPECT_EQ(refuse("mien: 1\n", 0, "ann"),
            "there is no actor 'ann'; expected none, as the file has no actors");
  EXPECT_EQ(refuse("clip: {turn: &k [{at: 0s}], keys: *k}\n", 1),
            "'clip.keys' is an alias; expected a value of its own to change");
  EXPECT_EQ(refuse("clip: {inputs: &k {at: 0s}, keys: [*k]}\n", 0),
            "'clip.keys[0]' is an alias; expected a value of its own to change");
}

std::string move(const std::string& text, int line, int column, const std::string& member, double to_s,
                 int fps = 24) {
  return move_time(text, {line, column, member, to_s, fps});
}

TEST(edit, moves_a_time_in_its_own_notation) {
  const auto in_clip = [](const std::string& at) {
    return "clip: {keys: [{at: " + at + ", ease: in}]}  # c\n";
  };
  for (const auto& [before, after] : std::vector<std::pair<std::string, std::string>>{{"1.50s", "0.29s"},
                                                                                      {"36f", "7f"},
                                                                                      {"500ms", "291ms"},
                                                                                      {"2", "0.29"},
                                                                                      {"\"2s\"", "\"0.29s\""},
                                                                                      {"'2f'", "'7f'"}})
    EXPECT_EQ(move(in_clip(before), 1, 15, "at", 0.3), in_clip(after));
  EXPECT_EQ(move(in_clip("1s"), 1, 15, "at", 2), in_clip("2s"));
  EXPECT_EQ(move(in_clip("1s"), 1, 15, "at", 2.5), in_clip("2.5s"));
  EXPECT_EQ(move("clip:\n  cues:\n    - from: 1s\n      to: 2s  # c\n      express: smile\n", 3, 7, "to", 3),
            "clip:\n  cues:\n    - from: 1s\n      to: 3s  # c\n      express: smile\n");
  EXPECT_EQ(move("clip: {blinks: [1s, 2s]}\n", 1, 21, "at", 0.5), "clip: {blinks: [1s, 0.5s]}\n");
  EXPECT_EQ(
      move("title: \xC3\xA4\r\nclip: {gaze: {keys: [{at: 1s, look: {up: 1deg}}]}}\r\n", 2, 40, "at", 0.5),
      "title: \xC3\xA4\r\nclip: {gaze: {keys: [{at: 0.5s, look: {up: 1deg}}]}}\r\n");
  EXPECT_EQ(move("clip: {title: \"\xC3\xA4\xC3\xA4\xC3\xA4\", keys: [{at: 1s}]}\n", 1, 29, "at", 0.5),
            "clip: {title: \"\xC3\xA4\xC3\xA4\xC3\xA4\", keys: [{at: 0.5s}]}\n");
}

TEST(edit, moves_an_item_to_its_new_place) {
  const std::string lines =
      "clip:\n  keys:\n    - {at: 0s}  # a\n    # of b\n    - {at: 1s}  # b\n    - at: 2s  # c\n      ease: "
      "in\n  fps: 24\n";
  EXPECT_EQ(move(lines, 3, 7, "at", 1.5),
            "clip:\n  keys:\n    # of b\n    - {at: 1s}  # b\n    - {at: 1.5s}  # a\n    - at: 2s  # c\n     "
            " ease: in\n  fps: 24\n");
  EXPECT_EQ(move(lines, 6, 7, "at", 0.5),
            "clip:\n  keys:\n    - {at: 0s}  # a\n    # of b\n    - at: 0.5s  # c\n      ease: in\n    - "
            "{at: 1s}  # b\n  fps: 24\n");
  EXPECT_EQ(move("clip:\n  keys:\n    - {at: 0s}\n    - {at: 1s}", 3, 7, "at", 2),
            "clip:\n  keys:\n    - {at: 1s}\n    - {at: 2s}");
  EXPECT_EQ(move("clip: {keys: [{at: 0s}, {at: 1s}, {at: 2s}]}\n", 1, 35, "at", 0.5),
            "clip: {keys: [{at: 0s}, {at: 0.5s}, {at: 1s}]}\n");
  // Whoever waits for it comes along.
  const std::string waits =
      "clip:\n  keys:\n    - {at: 0s, name: a}\n    - {at: {after: a, delay: 1s}}\n    - {at: 9s}\n";
  EXPECT_EQ(move(waits, 3, 7, "at", 2),
            "clip:\n  keys:\n    - {at: 2s, name: a}\n    - {at: {after: a, delay: 1s}}\n    - {at: 9s}\n");
  // Cues may stand in any order.
  EXPECT_EQ(move("clip: {cues: [{from: 0s, play: a}, {from: 1s, play: b}]}\n", 1, 15, "from", 2),
            "clip: {cues: [{from: 2s, play: a}, {from: 1s, play: b}]}\n");
}

TEST(edit, refuses_a_move_in_words) {
  const auto refuse = [](const std::string& text, int line, int column, const std::string& member,
                         double to_s) {
    return find_refusal([&] { return move(text, line, column, member, to_s); });
  };
  const std::string keys =
      "clip:\n  keys:\n    - {at: 0s, name: a}\n    - {at: {after: a}}\n    - {at: soon}\n    - {at: "
      "\"3\"}\n";
  EXPECT_EQ(refuse(keys, 4, 7, "at", 1),
            "'clip.keys[1].at' waits for another key; expected a time such as 1.5s, 36f or 500ms");
  EXPECT_EQ(refuse(keys, 5, 7, "at", 1),
            "'clip.keys[2].at' is 'soon'; expected a time such as 1.5s, 36f or 500ms");
  EXPECT_EQ(
      refuse(keys, 6, 7, "at", 1),
      "'clip.keys[3].at' is the formula '3'; expected a time such as 1.5s, 36f or 500ms, which can be moved");
  EXPECT_EQ(refuse(keys, 3, 7, "to", 1), "there is no 'clip.keys[0].to'; expected a key or cue that has it");
  EXPECT_EQ(refuse(keys, 0, 0, "at", 1),
            "it has no place in this text, but comes from another file or from mien itself; expected a key "
            "or cue of "
            "this text");
  EXPECT_EQ(refuse(keys, 60, 1, "at", 1), "there is no line 60; expected the place of a key or cue");
  EXPECT_EQ(refuse(keys, 1, 1, "at", 1),
            "no key or cue stands on line 1, column 1; expected one with a time");
  EXPECT_EQ(refuse(keys, 3, 7, "at", -1), "the time would be -1s; expected one from 0s to 4166.667s");
  EXPECT_EQ(refuse("clip: {keys: [{at: 0s}, {at: 1s}]}\n", 1, 15, "at", 1),
            "another item of 'clip.keys' stands at 1s already; expected another time");
  EXPECT_EQ(refuse("clip: {scripts: {a: {keys: [{at: 0s}]}}}\n", 1, 30, "at", 1),
            "'clip.scripts.a.keys[0]' is in a script, whose times count from its own beginning; expected a "
            "key or cue of "
            "the clip");
  const std::string cue = "clip: {cues: [{from: 1s, to: 2s, express: smile}]}\n";
  EXPECT_EQ(refuse(cue, 1, 15, "from", 3),
            "'from' would be 3s, not before 'to', 2s; expected an earlier time");
  EXPECT_EQ(refuse(cue, 1, 15, "to", 1), "'to' would be 1s, not after 'from', 1s; expected a later time");
  EXPECT_EQ(refuse("clip: {inputs: &k {at: 0s}, keys: [*k]}\n", 1, 36, "at", 1),
            "'clip.keys[0]' is an alias; expected a value of its own to change");
  EXPECT_EQ(refuse("clip: {keys: [&k {at: 0s}], turn: [*k]}\n", 1, 18, "at", 1),
            "an alias on line 1 repeats 'clip.keys[0]', or a part of it; expected a value that stands once");
}

}  // namespace
}  // namespace mien
