// Seeded changes of all examples: the file then says what was asked, and all else as before.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "config/config_fixture.hpp"
#include "config/edit.hpp"
#include "fuzz_rounds.hpp"

namespace mien {
namespace {

// What a file says, by name: "ann.head.age", "keys@1.5".
using Facts = std::map<std::string, std::string>;

std::string format_values(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{:.6g} ", value);
  return text;
}

std::string format_pose(const Pose& pose) { return format_values({pose.values.begin(), pose.values.end()}); }

std::string format_mix(const Mix& mix) {
  std::string text;
  for (const auto& [name, weight] : mix) text += fmt::format("{}: {:.6g} ", name, weight);
  return text;
}

std::string format_colour(const glm::vec3& colour) { return format_values({colour.r, colour.g, colour.b}); }

void add_head(const HeadSpec& head, const std::string& prefix, Facts& facts) {
  facts[prefix + "age"] = format_mix(head.age);
  facts[prefix + "skull"] = format_mix(head.skull);
  facts[prefix + "design"] = format_mix(head.design);
  facts[prefix + "character"] = format_values({head.character});
  facts[prefix + "hair"] = head.hair;
  for (const auto* values : {&head.guides, &head.features, &head.limits})
    for (const auto& [name, value] : *values) facts[prefix + name] = format_values({value});
  facts[prefix + "look.skin"] = format_colour(head.look.skin);
  facts[prefix + "look.iris"] = format_colour(head.look.iris);
  facts[prefix + "look.brow"] = format_colour(head.look.brow);
  facts[prefix + "look.hair"] = format_colour(head.look.hair);
  facts[prefix + "look.lips"] = head.look.lips ? format_colour(*head.look.lips) : "";
  facts[prefix + "look.beard"] = head.look.beard;
  facts[prefix + "look.freckles"] = format_values({head.look.freckles});
  facts[prefix + "rest"] = fmt::format("{} {} {} {}", head.mix.size(), head.sculpt.size(),
                                       head.mesh.has_value(), head.scan.has_value());
}

void add_clip(const ClipSpec& clip, const std::string& prefix, Facts& facts) {
  const auto add = [&](const std::string& track, double at_s, const Ease& ease, const std::string& what) {
    facts[fmt::format("{}{}@{:.6g}", prefix, track, at_s)] =
        fmt::format("{} {}{}", static_cast<int>(ease.kind),
                    format_values({ease.handles.begin(), ease.handles.end()}), what);
  };
  for (const PoseKey& key : clip.keys)
    add("keys", key.at_s, key.ease,
        fmt::format("{}|{}", static_cast<int>(key.between), format_pose(key.pose)));
  for (const TurnKey& key : clip.turn)
    add("turn", key.at_s, key.ease, format_values({key.turn_deg, key.nod_deg, key.tilt_deg}));
  for (const CameraKey& key : clip.camera)
    add("camera", key.at_s, key.ease, format_values({key.angle_deg, key.height_deg, key.distance}));
  for (const LightKey& key : clip.light) add("light", key.at_s, key.ease, key.set);
  for (const BackgroundKey& key : clip.background) add("background", key.at_s, key.ease, key.name);
  for (const HeadKey& key : clip.head) add("head", key.at_s, key.ease, format_mix(key.head.age));
  for (const GazeKey& key : clip.gaze.keys) add("gaze", key.at_s, {}, "");
  for (std::size_t i = 0; i < clip.cues.size(); ++i)
    facts[fmt::format("{}cues{}", prefix, i)] =
        format_values({clip.cues[i].from_s, clip.cues[i].full_s, clip.cues[i].ebb_s, clip.cues[i].end_s}) +
        format_pose(clip.cues[i].what.pose) + clip.cues[i].owns.to_string();
  facts[prefix + "blinks"] = format_values(clip.blinks_s);
  facts[prefix + "length"] = format_values({clip.length_s});
  facts[prefix + "idle"] = format_values({clip.blink.per_minute, clip.drift.amount, clip.asymmetry.amount});
}

Facts list_facts(const Spec& spec) {
  Facts facts{
      {"title", spec.title}, {"library", spec.library}, {"exaggerate", format_values({spec.exaggerate})}};
  for (const ActorSpec& actor : list_actors(spec)) {
    add_head(actor.head, actor.name + ".head.", facts);
    add_clip(actor.clip, actor.name + ".", facts);
  }
  add_clip(spec.clip, "clip.", facts);
  for (const Expression& expression : spec.expressions)
    if (expression.library.empty()) facts["expressions." + expression.name] = format_pose(expression.pose);
  facts["render"] =
      fmt::format("{}x{} {}", spec.render.width_px, spec.render.height_px, spec.render.background);
  for (std::size_t i = 0; i < spec.busts.size(); ++i)
    facts[fmt::format("busts{}", i)] =
        fmt::format("{} {}", spec.busts[i].height_mm, format_pose(spec.busts[i].expression.pose));
  return facts;
}

struct Example {
  std::filesystem::path file;
  std::string text;
  Spec spec;
  Facts facts;
};

const std::vector<Example>& load_examples() {
  static const std::vector<Example> examples = [] {
    std::vector<Example> all;
    for (const auto& entry : std::filesystem::directory_iterator(kData / "configs"))
      if (entry.path().extension() == ".yaml")
        all.push_back({entry.path(), read_file(entry.path()), load_spec(entry.path(), *find_language()), {}});
    for (Example& example : all) example.facts = list_facts(example.spec);
    std::ranges::sort(all, {}, &Example::file);
    return all;
  }();
  return examples;
}

// The names of all that differs.
std::set<std::string> find_changed(const Facts& before, const Facts& after) {
  std::set<std::string> changed;
  for (const auto& [name, value] : before)
    if (const auto found = after.find(name); found == after.end() || found->second != value)
      changed.insert(name);
  for (const auto& [name, value] : after)
    if (!before.contains(name)) changed.insert(name);
  return changed;
}

Spec reload(const Example& example, const std::string& text) {
  try {
    return load_spec(example.file, text, *find_language());
  } catch (const InputError& error) {
    ADD_FAILURE() << example.file << "\n" << format_error(error) << "\n" << text;
    return example.spec;
  }
}

// How many bytes of the old text are gone, and how many came.
std::pair<std::size_t, std::size_t> count_changed(const std::string& before, const std::string& after) {
  const std::size_t most = std::min(before.size(), after.size());
  std::size_t first = 0, last = 0;
  while (first < most && before[first] == after[first]) ++first;
  while (last < most - first && before[before.size() - 1 - last] == after[after.size() - 1 - last]) ++last;
  return {before.size() - first - last, after.size() - first - last};
}

std::vector<YamlPath> list_head_paths(const Example& example) {
  std::vector<YamlPath> paths;
  for (const ActorSpec& actor : list_actors(example.spec))
    paths.push_back(actor.name.empty() ? YamlPath{"head"} : YamlPath{"actors", actor.name, "head"});
  return paths;
}

// Sets a value of a head; expects that nothing changes but what begins so, and that taking it away leaves all
// as it was where it was not there.
Spec expect_dial(const Example& example, YamlPath path, const std::vector<std::string>& steps,
                 const std::string& value, const std::vector<std::string>& may_change) {
  const std::string actor = path.size() > 1 ? std::get<std::string>(path[1]) : "";
  path.insert(path.end(), steps.begin(), steps.end());
  const std::string after = set_value(example.text, path, value);
  const Spec spec = reload(example, after);
  for (const std::string& name : find_changed(example.facts, list_facts(spec)))
    EXPECT_TRUE(
        std::ranges::any_of(
            may_change, [&](const std::string& each) { return name.starts_with(actor + ".head." + each); }) ||
        name.find("clip.head@") != name.npos ||
        (name == "render" && steps[0] == "design"))  // drawn heads are in ink
        << example.file << " " << name << "\n"
        << after;
  EXPECT_EQ(set_value(after, path, value), after);
  bool was_there = true;
  try {
    remove_value(example.text, path);
  } catch (const InputError&) {
    was_there = false;
  }
  if (was_there || after.find(": 1, teenager: 0.5}") != after.npos) return spec;
  EXPECT_EQ(count_changed(example.text, after).first, 0u);
  EXPECT_EQ(remove_value(after, path), example.text) << after;
  return spec;
}

TEST(edit_sweep, sets_each_dial_of_a_head) {
  const HeadWords& words = find_language()->words;
  std::size_t count = 0;
  for (const Example& example : load_examples())
    for (const YamlPath& head : list_head_paths(example)) {
      for (const std::string& feature : words.features) {
        if (++count % 4 != 0) continue;  // each in some file, as there are many
        const Spec spec = expect_dial(example, head, {"features", feature}, "0.25", {feature});
        const std::vector<ActorSpec> actors = list_actors(spec);
        const std::string actor = head.size() > 1 ? std::get<std::string>(head[1]) : "";
        EXPECT_EQ(std::ranges::find(actors, actor, &ActorSpec::name)->head.features.at(feature), 0.25);
      }
      for (const char* colour : {"skin", "lips", "iris", "brow", "hair"})
        expect_dial(example, head, {"look", colour}, "\"#123456\"", {"look."});
      expect_dial(example, head, {"look", "skin"}, "fair", {"look."});
      expect_dial(example, head, {"look", "freckles"}, "0.5", {"look.freckles"});
      expect_dial(example, head, {"look", "beard"}, "none", {"look.beard"});
      expect_dial(example, head, {"age"}, "{child: 0.5, old: 0.5}", {"age"});
      expect_dial(example, head, {"age", "teenager"}, "0.5", {"age"});
      expect_dial(example, head, {"skull"}, "square", {"skull"});
      expect_dial(example, head, {"design"}, "real", {"design"});
      expect_dial(example, head, {"character"}, "-0.75", {"character"});
      expect_dial(example, head, {"hair"}, "bun", {"hair"});
      expect_dial(example, head, {"limits", "brows.up"}, "0.5", {"brow."});
    }
}

std::int64_t count_frame(double at_s, int fps) { return std::llround(at_s * fps); }

Pose make_pose(std::mt19937& random, double reach) {
  Pose pose;
  std::uniform_real_distribution<double> share(0, 1);
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (share(random) < 0.5) {
      const double value = kMoves[i].low + share(random) * (kMoves[i].high - kMoves[i].low);
      pose.values[i] = value * (find_stop(i, value).empty() ? reach : 1);
    }
  return pose;
}

// A new key goes away again without a trace.
void expect_removable(const Example& example, const std::string& after, const std::string& actor,
                      std::size_t key) {
  EXPECT_EQ(count_changed(example.text, after).first, 0u);
  YamlPath path{"clip", "keys", key};
  if (!actor.empty()) path.insert(path.begin(), {"actors", actor});
  EXPECT_EQ(remove_value(after, path), example.text) << after;
}

void expect_key(const Example& example, const std::string& actor, std::int64_t frame, const Pose& pose) {
  const int fps = example.spec.clip.fps;
  const std::string after =
      write_key(example.text, {actor, static_cast<double>(frame) / fps, fps, pose}, *find_language());
  Findings ignored;
  const Spec spec = [&] {
    try {
      return load_spec(example.file, after, *find_language());
    } catch (const InputError& error) {
      // A key between a key with a release and the next one may come too early for it.
      EXPECT_NE(format_error(error).find(".release"), std::string::npos) << format_error(error) << after;
      return Spec{};
    }
  }();
  if (spec.file.empty()) return;
  const std::vector<ActorSpec> actors = list_actors(spec);
  const ClipSpec& clip = std::ranges::find(actors, actor, &ActorSpec::name)->clip;
  const auto is_there = [&](const PoseKey& key) {
    return count_frame(key.at_s, fps) == frame && key.place.line > 0;
  };
  const auto key = std::ranges::find_if(clip.keys, is_there);
  ASSERT_NE(key, clip.keys.end()) << after;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    EXPECT_NEAR(key->pose.values[i], pose.values[i], 2e-3) << name_move(i) << "\n" << after;
  EXPECT_LE(key->at_s, static_cast<double>(frame) / fps + 1.0 / fps);
  const std::string name = fmt::format("{}.keys@{:.6g}", actor, key->at_s);
  for (const std::string& changed : find_changed(example.facts, list_facts(spec)))
    EXPECT_TRUE(changed == name || changed == fmt::format("clip.keys@{:.6g}", key->at_s) ||
                changed.ends_with("length") || changed.ends_with("keys@0"))  // the key that mien itself adds
        << changed << "\n"
        << after;
  const std::vector<ActorSpec> before = list_actors(example.spec);
  if (std::ranges::none_of(std::ranges::find(before, actor, &ActorSpec::name)->clip.keys, is_there))
    expect_removable(example, after, actor, static_cast<std::size_t>(key - clip.keys.begin()));
}

TEST(edit_sweep, writes_keys_at_many_times) {
  std::mt19937 random(1989);
  for (const Example& example : load_examples())
    for (const ActorSpec& actor : list_actors(example.spec))
      for (int frame = 0; frame < count_frames(example.spec.clip) + 10;
           frame += 3 + static_cast<int>(random() % 9))
        expect_key(example, actor.name, frame, make_pose(random, frame % 3 == 0 ? 2 : 1));
}

TEST(edit_sweep, writes_the_pose_that_a_key_has_without_a_change) {
  for (const Example& example : load_examples())
    for (const ActorSpec& actor : list_actors(example.spec))
      for (const PoseKey& key : actor.clip.keys)
        if (key.place.file == example.file.string() && !key.live) {
          const std::string after = write_key(
              example.text, {actor.name, key.at_s, example.spec.clip.fps, key.pose}, *find_language());
          EXPECT_LE(count_changed(example.text, after).first, 200u);
          EXPECT_EQ(find_changed(example.facts, list_facts(reload(example, after))), std::set<std::string>())
              << after;
        }
}

TEST(edit_sweep, writes_expressions) {
  std::mt19937 random(1987);
  for (const Example& example : load_examples())
    for (const double reach : {1.0, 2.0}) {
      const Pose pose = make_pose(random, reach);
      const std::string after = write_expression(example.text, "test_face", pose);
      const Spec spec = reload(example, after);
      EXPECT_EQ(find_changed(example.facts, list_facts(spec)),
                std::set<std::string>{"expressions.test_face"});
      const Pose& written = find_expression(spec, "test_face").pose;
      for (std::size_t i = 0; i < kMoveCount; ++i)
        EXPECT_NEAR(written.values[i], pose.values[i], 2e-3) << name_move(i);
      EXPECT_EQ(remove_value(after, {"expressions", "test_face"}), example.text) << after;
      const Spec again = reload(example, write_expression(after, "test_face", {}));
      EXPECT_EQ(find_expression(again, "test_face").pose, Pose{});
    }
}

// Moves one key or cue by some frames; false if that is refused.
bool try_move(const Example& example, const Place& place, const std::string& member, double from_s,
              int frames) {
  const int fps = example.spec.clip.fps;
  const std::int64_t frame = count_frame(from_s, fps) + frames;
  std::string after;
  try {
    after =
        move_time(example.text, {place.line, place.column, member, static_cast<double>(frame) / fps, fps});
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos) << error.what();
    return false;
  }
  Spec spec;
  try {
    spec = load_spec(example.file, after, *find_language());
  } catch (const InputError& error) {
    EXPECT_EQ(format_error(error).find("rising"), std::string::npos) << format_error(error) << after;
    return true;
  }
  // As many keys and cues as before, and one of them there.
  const std::vector<ActorSpec> before = list_actors(example.spec), now = list_actors(spec);
  bool is_there = false;
  for (std::size_t i = 0; i < now.size(); ++i) {
    EXPECT_EQ(now[i].clip.keys.size(), before[i].clip.keys.size()) << after;
    EXPECT_EQ(now[i].clip.turn.size(), before[i].clip.turn.size());
    EXPECT_EQ(now[i].clip.cues.size(), before[i].clip.cues.size());
    for (const PoseKey& key : now[i].clip.keys) is_there |= count_frame(key.at_s, fps) == frame;
    for (const TurnKey& key : now[i].clip.turn) is_there |= count_frame(key.at_s, fps) == frame;
    for (const CueSpec& cue : now[i].clip.cues) is_there |= count_frame(cue.from_s, fps) == frame;
  }
  EXPECT_TRUE(is_there) << place.line << "\n" << after;
  return true;
}

TEST(edit_sweep, moves_each_key_and_cue) {
  std::mt19937 random(1985);
  int moved = 0;
  for (const Example& example : load_examples())
    for (const ActorSpec& actor : list_actors(example.spec)) {
      const auto try_all = [&](const Place& place, const std::string& member, double at_s) {
        if (place.file != example.file.string()) return;
        for (const int frames : {-5, static_cast<int>(random() % 100) - 50})
          moved += try_move(example, place, member, at_s, frames);
      };
      for (const PoseKey& key : actor.clip.keys) try_all(key.place, "at", key.at_s);
      for (const TurnKey& key : actor.clip.turn) try_all(key.place, "at", key.at_s);
      for (const CueSpec& cue : actor.clip.cues) try_all(cue.what.place, "from", cue.from_s);
    }
  EXPECT_GT(moved, 400);
}

// A text with a few letters changed.
std::string damage(std::string text, std::mt19937& random) {
  constexpr std::string_view kLetters = "{}[]:,-#&*!|>'\"?~ \n\r\t0.\\s";
  for (std::size_t i = 0, count = random() % 4; i < count && !text.empty(); ++i) {
    const std::size_t at = random() % text.size();
    if (random() % 3 == 0) text[at] = kLetters[random() % kLetters.size()];
    if (random() % 3 == 0) text.insert(at, 1, kLetters[random() % kLetters.size()]);
    if (random() % 3 == 0) text.erase(at, 1 + random() % 8);
  }
  return text;
}

YamlPath make_path(std::mt19937& random) {
  static const std::vector<YamlPath> paths{{"head"},
                                           {"head", "age"},
                                           {"head", "look", "skin"},
                                           {"head", "age", "old"},
                                           {"clip"},
                                           {"clip", "keys"},
                                           {"clip", "keys", 0u},
                                           {"clip", "keys", 1u, "at"},
                                           {"clip", "keys", 2u, "areas", "lips", "press"},
                                           {"clip", "turn", 2u},
                                           {"clip", "cues", 1u, "areas"},
                                           {"clip", "blinks", 0u},
                                           {"actors", "ann", "head", "age"},
                                           {"actors", "ann", "clip", "keys", 1u, "express"},
                                           {"expressions", "calm"},
                                           {"render", "size"},
                                           {"busts", 0u, "height"},
                                           {"title"},
                                           {"mien"}};
  return paths[random() % paths.size()];
}

std::string edit_somehow(const std::string& text, std::mt19937& random) {
  const double at_s = static_cast<double>(random() % 300) / 30;
  switch (random() % 5) {
    case 0:
      return set_value(text, make_path(random), random() % 2 == 0 ? "1" : "{a: [1, \"2\"]}");
    case 1:
      return remove_value(text, make_path(random));
    case 2:
      return write_expression(text, "calm", make_pose(random, 1));
    case 3:
      return write_key(text, {"", at_s, 24, make_pose(random, 1)}, *find_language());
    default:
      return move_time(text,
                       {static_cast<int>(random() % 60), static_cast<int>(random() % 60), "at", at_s, 24});
  }
}

TEST(edit_sweep, answers_damaged_texts_with_a_text_or_a_refusal) {
  std::mt19937 random(find_fuzz_seed(1952));
  int done = 0;
  const int rounds = count_fuzz_rounds(1500);
  for (int round = 0; round < rounds; ++round) {
    const auto& examples = load_examples();
    const std::string text = damage(examples[static_cast<std::size_t>(round) % examples.size()].text, random);
    try {
      edit_somehow(text, random);
      ++done;
    } catch (const InputError& error) {
      EXPECT_STRNE(error.what(), "");
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << "\n" << text;
    }
  }
  EXPECT_GT(done, rounds / 10);
}

}  // namespace
}  // namespace mien
