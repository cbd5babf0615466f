// The table of the language and the loaders are one: each key of the table is read, in its range, and its
// default is what an author could write.
#include "config/language.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "config/common_words.hpp"
#include "config/config_fixture.hpp"
#include "config/data_words.hpp"
#include "config/validator.hpp"
#include "house/sources.hpp"

namespace mien {
namespace {

// A file around the keys of one mapping: "{mien: 1, clip: {keys: [{" + keys + "}]}}".
using Wrap = std::function<std::string(const std::string& keys)>;
using Visit = std::function<void(const Section&, const Key&, const Wrap&)>;

std::string write_sample(const Section& section, const Key& key);

// What has to stand beside a key.
std::string write_beside(const Section& section, const std::string& key) {
  std::set<std::string> names;
  for (const Key& other : section.keys)
    if (other.is_required) names.insert(other.name);
  bool plays = key == "play";
  for (const KeyRule& rule : section.rules)
    if (rule.kind == KeyRule::Kind::needs && rule.keys.front() == key) {
      names.insert(rule.keys[1]);
      plays = plays || rule.keys[1] == "play";
    }
  for (const KeyRule& rule : section.rules)
    if (rule.kind == KeyRule::Kind::one_of && !plays && std::ranges::find(rule.keys, key) == rule.keys.end())
      names.insert(section.name == "track" && (key == "smooth" || key == "fps") ? "live_link"
                                                                                : rule.keys.front());
  // And beside those.
  for (const KeyRule& rule : section.rules)
    if (rule.kind == KeyRule::Kind::needs && names.contains(rule.keys.front())) names.insert(rule.keys[1]);
  names.erase(key);
  std::string text;
  if (section.name == "clip" && key != "scripts") text = ", scripts: {nod: {length: 0.1s}}";
  if (section.name == "clip" && key != "turn") text += ", turn: [{at: 0s, name: hello}]";
  for (const std::string& name : names)
    text += fmt::format(", {}: {}", name, write_sample(section, *find_key(section, name)));
  return text;
}

bool is_number(const Form& form) {
  return form.kind == FormKind::number || form.kind == FormKind::whole || form.kind == FormKind::length ||
         form.kind == FormKind::angle || form.kind == FormKind::seconds || form.kind == FormKind::duration;
}

// The value of a number in its unit.
std::string write_number(const Form& form, double value) {
  const char* unit = form.kind == FormKind::length                                       ? "mm"
                     : form.kind == FormKind::angle                                      ? "deg"
                     : form.kind == FormKind::duration || form.kind == FormKind::seconds ? "s"
                                                                                         : "";
  return fmt::format("{:.12g}{}", value, unit);
}

std::string write_sample(const Section& section, const Key& key) {
  const Form& form = key.forms.front();
  if (section.name == "wait" && key.name == "after") return "hello";
  if (key.name == "play") return "nod";
  if (section.name == "law" && key.name == "value") return "1";  // of a move
  switch (form.kind) {
    case FormKind::version:
      return "1";
    case FormKind::time:
      return "0s";
    case FormKind::word:
      if (!form.words.empty()) return std::string(form.words.front().name);
      return form.data == "places" ? "chin" : form.data == "looks" ? "fair" : "mien";
    case FormKind::tag:
      return "smile";
    case FormKind::lengths:
      return "[0, 1mm, 1mm]";
    case FormKind::file:
      if (section.name == "track" && key.name != "csv") return key.name + form.endings.front();
      return form.endings.front() == ".csv" || form.endings.front() == ".wav" ? "talk" + form.endings.front()
                                                                              : "other.yaml";
    case FormKind::map:
    case FormKind::section:
      return "{}";
    case FormKind::list:
      return "[]";
    default:
      return write_number(form, form.high);
  }
}

void walk(const Section& section, const Wrap& wrap, std::set<const Section*>& seen, const Visit& visit) {
  if (!seen.insert(&section).second) return;
  for (const Key& key : section.keys) {
    const auto wrap_in = [&](const char* before, const char* after) {
      return [=, &section, &key](const std::string& keys) {
        return wrap(
            fmt::format("{}: {}{}{}{}", key.name, before, keys, after, write_beside(section, key.name)));
      };
    };
    visit(section, key, wrap);
    for (const Form& form : key.forms) {
      if (form.kind == FormKind::section) walk(*form.section, wrap_in("{", "}"), seen, visit);
      for (const Form& item : form.items) {
        if (item.kind != FormKind::section) continue;
        const char* after = item.section->name == "pose_key" ? "}, {at: 5s}]" : "}]";
        walk(*item.section, form.kind == FormKind::list ? wrap_in("[{", after) : wrap_in("{ann: {", "}}"),
             seen, visit);
      }
    }
  }
}

// Every key of every mapping, with a file that it may stand in.
std::size_t walk_language(const Visit& visit) {
  std::size_t count = 0;
  std::set<const Section*> seen;
  const auto wrap = [](const std::string& keys) { return fmt::format("{{{}}}\n", keys); };
  const Visit counted = [&](const Section& section, const Key& key, const Wrap& inner) {
    ++count;
    visit(section, key, inner);
  };
  seen.insert(&find_sections().library_file);
  walk(find_sections().file, wrap, seen, counted);
  EXPECT_EQ(seen.size(), list_sections().size());
  return count;
}

// The mistakes of a text beside a table and a file to include.
std::string find_mistakes_of(const std::filesystem::path& folder, const std::string& text) {
  write_file(folder / "test.yaml", text);
  return find_mistakes(folder / "test.yaml");
}

std::filesystem::path make_folder_with_files() {
  const std::filesystem::path folder = make_test_folder();
  write_file(folder / "talk.csv", "time,lips.upper\n0,0\n1,0.5\n");
  write_file(folder / "other.yaml", "mien: 1\nclip: {keys: [{at: 0s, name: other}]}\n");
  write_file(folder / "talk.wav", "a sound");
  for (const auto& [key, sample] : {std::pair{"live_link.csv", "live_link.csv"},
                                    {"arkit.json", "mediapipe.json"},
                                    {"openface.csv", "openface.csv"},
                                    {"openfacefx.json", "openfacefx.json"},
                                    {"vrma.vrma", "gesture.vrma"},
                                    {"gltf.glb", "head.glb"}})
    std::filesystem::copy_file(kData / "tests/import/takes" / sample, folder / key);
  return folder;
}

std::string write_key(const Section& section, const Key& key, const std::string& value) {
  const std::string text = fmt::format("{}: {}{}", key.name, value, write_beside(section, key.name));
  return text;
}

TEST(language, every_key_of_the_table_is_read) {
  const auto folder = make_folder_with_files();
  const std::size_t count = walk_language([&](const Section& section, const Key& key, const Wrap& wrap) {
    const std::string text = wrap(write_key(section, key, "[[[]]]"));
    const std::string mistakes = find_mistakes_of(folder, text);
    EXPECT_NE(mistakes.find(key.name + "'"), std::string::npos) << section.name << "." << key.name << "\n"
                                                                << text << mistakes;
    EXPECT_EQ(mistakes.find("unknown key"), std::string::npos) << text << mistakes;
  });
  EXPECT_GT(count, 200u);
}

TEST(language, a_key_that_the_table_lacks_is_refused) {
  const auto folder = make_folder_with_files();
  std::set<std::string> told;
  walk_language([&](const Section& section, const Key&, const Wrap& wrap) {
    if (!told.insert(section.name).second) return;
    const std::string text = wrap("nobodys: 1" + write_beside(section, ""));
    EXPECT_NE(find_mistakes_of(folder, text).find(fmt::format("unknown {} 'nobodys'", section.noun)),
              std::string::npos)
        << section.name << "\n"
        << text << find_mistakes_of(folder, text);
  });
}

TEST(language, every_default_could_be_written) {
  const auto folder = make_folder_with_files();
  walk_language([&](const Section& section, const Key& key, const Wrap& wrap) {
    if (key.otherwise.empty()) return;
    const std::string colon =
        key.otherwise.starts_with("#") ? fmt::format("\"{}\"", key.otherwise) : key.otherwise;
    const std::string text = wrap(write_key(section, key, colon));
    EXPECT_EQ(find_mistakes_of(folder, text), "") << section.name << "." << key.name << "\n" << text;
  });
}

TEST(language, every_range_is_held_to_by_the_loader) {
  const auto folder = make_folder_with_files();
  std::size_t count = 0;
  walk_language([&](const Section& section, const Key& key, const Wrap& wrap) {
    for (const Form& form : key.forms) {
      if (!is_number(form)) continue;
      if (section.name == "law" && key.name == "value") continue;  // its range is that of what it moves
      for (const auto& [end, further] : {std::pair{form.low, -1.0}, std::pair{form.high, 1.0}}) {
        if (!std::isfinite(end)) continue;
        ++count;
        const std::string inside = wrap(write_key(section, key, write_number(form, end)));
        EXPECT_EQ(find_mistakes_of(folder, inside), "") << section.name << "." << key.name << "\n" << inside;
        const std::string outside = wrap(write_key(section, key, write_number(form, end + further)));
        EXPECT_NE(find_mistakes_of(folder, outside).find("; expected "), std::string::npos)
            << section.name << "." << key.name << "\n"
            << outside;
      }
    }
  });
  EXPECT_GT(count, 200u);
}

// What a number may be and what holds without a key, in as many files.
TEST(language, a_validator_accepts_what_the_loader_accepts) {
  const auto folder = make_test_folder();
  Names files;
  walk_language([&](const Section& section, const Key& key, const Wrap& wrap) {
    Names values;
    if (!key.otherwise.empty())
      values.push_back(key.otherwise.starts_with("#") ? fmt::format("\"{}\"", key.otherwise) : key.otherwise);
    for (const Form& form : key.forms)
      if (is_number(form))
        for (const double end : {form.low, form.high})
          if (std::isfinite(end)) values.push_back(write_number(form, end));
    for (const std::string& value : values) {
      files.push_back((folder / fmt::format("{}_{}_{}.yaml", section.name, key.name, files.size())).string());
      write_file(files.back(), wrap(write_key(section, key, value)));
    }
  });
  const auto said = judge(files);
  if (said.empty()) GTEST_SKIP() << "python3-jsonschema or python3-yaml is not installed";
  for (const auto& [name, judgement] : said) EXPECT_EQ(judgement, "accepted") << name;
  EXPECT_GT(files.size(), 400u);
}

TEST(language, rules_between_keys_are_the_loaders) {
  const auto folder = make_folder_with_files();
  walk_language([&](const Section& section, const Key& key, const Wrap& wrap) {
    for (const KeyRule& rule : section.rules) {
      if (rule.keys.front() != key.name) continue;
      const auto write = [&](const Names& names) {
        std::string text;
        for (const Key& other : section.keys)
          if (other.is_required || std::ranges::find(names, other.name) != names.end())
            text +=
                fmt::format("{}{}: {}", text.empty() ? "" : ", ", other.name, write_sample(section, other));
        return text;
      };
      if (rule.kind == KeyRule::Kind::needs) {
        EXPECT_NE(find_mistakes_of(folder, wrap(write({key.name}))), "") << section.name << "." << key.name;
      } else if (rule.kind == KeyRule::Kind::one_of) {
        EXPECT_NE(find_mistakes_of(folder, wrap(write({}))), "") << section.name;
      } else {
        for (auto other = rule.keys.begin() + 1; other != rule.keys.end(); ++other)
          if (other->find('.') == std::string::npos) {
            const std::string text = wrap(write({key.name, *other}));
            EXPECT_NE(find_mistakes_of(folder, text).find(*other + "'"), std::string::npos)
                << section.name << "." << key.name << " and " << *other << "\n"
                << text << find_mistakes_of(folder, text);
          }
      }
    }
  });
}

// Words in quotes behind find_value and find_required are keys of the table.
TEST(language, loaders_ask_for_no_key_that_the_table_lacks) {
  std::set<std::string> known;
  for (const Section* section : list_sections())
    for (const Key& key : section->keys) known.insert(key.name);
  static const std::regex kAsk(
      R"re((find_value|find_required|load_live|load_duration)\(\*?\w+, "([^"]+)")re");
  std::size_t count = 0;
  for (const SourceFile& source : load_sources("src/config")) {
    // Of data files.
    if (source.path.find("load_people") != std::string::npos ||
        source.path.find("data_words") != std::string::npos ||
        source.path.find("head_words") != std::string::npos)
      continue;
    for (const std::string& line : source.lines)
      for (std::sregex_iterator found(line.begin(), line.end(), kAsk), end; found != end; ++found, ++count)
        EXPECT_TRUE(known.contains((*found)[2])) << source.path << ": " << line;
  }
  EXPECT_GT(count, 90u);
}

TEST(language, keys_stand_once_and_have_help) {
  std::set<std::string> sections;
  for (const Section* section : list_sections()) {
    EXPECT_TRUE(sections.insert(section->name).second) << section->name;
    EXPECT_NE(section->help, "") << section->name;
    EXPECT_NE(section->expected, "") << section->name;
    std::set<std::string> keys;
    for (const Key& key : section->keys) {
      EXPECT_TRUE(keys.insert(key.name).second) << section->name << "." << key.name;
      EXPECT_FALSE(key.forms.empty()) << section->name << "." << key.name;
      EXPECT_NE(key.help, "") << section->name << "." << key.name;
    }
    for (const KeyRule& rule : section->rules)
      for (const std::string& key : rule.keys)
        EXPECT_TRUE(keys.contains(key.substr(0, key.find('.')))) << section->name << "." << key;
  }
  for (const Names* names : {&kSharedClipKeys, &kCommonClipKeys, &kTakes})
    for (const std::string& name : *names) EXPECT_NE(find_key(find_sections().clip, name), nullptr) << name;
}

// Every word that may stand somewhere: keys, fixed words, and what the data define.
std::set<std::string> list_all_names() {
  std::set<std::string> names;
  const std::function<void(const Forms&)> add = [&](const Forms& forms) {
    for (const Form& form : forms) {
      for (const Word& word : form.words) names.insert(std::string(word.name));
      add(form.items);
    }
  };
  for (const Section* section : list_sections())
    for (const Key& key : section->keys) {
      names.insert(key.name);
      add(key.forms);
    }
  for (const auto& [list, words] : load_data_words(kData))
    for (const DataWord& word : words) {
      names.insert(word.name);
      names.insert(word.name.substr(word.name.find('/') + 1));
    }
  return names;
}

std::vector<std::string> split_words(std::string_view words) {
  std::istringstream stream{std::string(words)};
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST(language, common_words_lead_to_names_that_exist) {
  const std::set<std::string> names = list_all_names();
  std::set<std::pair<std::string, std::string>> seen;
  for (const CommonWord& row : kCommonWords) {
    const std::string name(row.name);
    EXPECT_TRUE(names.contains(name)) << name;
    ASSERT_FALSE(split_words(row.words).empty()) << name;
    for (const std::string& word : split_words(row.words)) {
      EXPECT_NE(word, name);
      EXPECT_TRUE(seen.insert({word, name}).second) << word << " leads to " << name << " twice";
      EXPECT_EQ(suggest_name(word, {"xxxxxxxxxxxxxxxx", name}), name) << word;
      EXPECT_EQ(suggest_name(word, {"xxxxxxxxxxxxxxxx"}), "")
          << word;  // nothing is hinted at that is not known
    }
  }
  EXPECT_GT(seen.size(), 200U);
}

TEST(language, a_common_word_gives_way_to_ones_own) {
  EXPECT_EQ(suggest_name("Sad", {"sadness", "sad"}), "sad");
  EXPECT_EQ(suggest_name("Light-Brown", {"black", "brown"}), "brown");
  EXPECT_EQ(suggest_name("light brown", {"black", "brown"}), "brown");
  EXPECT_EQ(describe_suggestion("closed", {"upper", "lower"}), "did you mean 'upper' (below 0 closes it)?");
  EXPECT_EQ(describe_suggestion("closed", {"up", "side"}), "");
}

TEST(language, common_words_are_answered_with_ours) {
  const auto answer = [](const std::string& text) {
    const std::string told = find_text_mistakes("mien: 1\n" + text + "\n");
    const std::size_t at = told.find("error: ");
    return at == told.npos ? told : told.substr(at + 7, told.find('\n', at) - at - 7);
  };
  const std::vector<std::pair<std::string, std::string>> cases{
      {"clip: {keys: [{at: 0s, express: sad}]}", "unknown expression 'sad'; did you mean 'sadness'?"},
      {"clip: {keys: [{at: 0s, express: happy}]}", "unknown expression 'happy'; did you mean 'smile'?"},
      {"clip: {keys: [{at: 0s, express: emfacs/happy}]}",
       "unknown expression 'emfacs/happy'; did you mean 'emfacs/joy'?"},
      {"clip: {keys: [{at: 0s, express: Angry}]}", "unknown expression 'Angry'; did you mean 'anger'?"},
      {"clip: {keys: [{at: 0s, express: {scared: 0.5}}]}",
       "unknown expression 'scared'; did you mean 'fear'?"},
      {"expressions: {mine: {from: surprised}}", "unknown expression 'surprised'; did you mean 'surprise'?"},
      {"busts: [{express: laughing}]", "unknown expression 'laughing'; did you mean 'laugh'?"},
      {"clip: {keys: [{at: 0s, areas: {eyebrows: {up: 1}}}]}",
       "unknown area 'eyebrows' in 'clip.keys.areas'; did you mean 'brows'?"},
      {"clip: {keys: [{at: 0s, areas: {lip: {upper: 1}}}]}",
       "unknown area 'lip' in 'clip.keys.areas'; did you mean 'lips'?"},
      {"clip: {keys: [{at: 0s, areas: {left_eyebrow: {up: 1}}}]}",
       "unknown area 'left_eyebrow' in 'clip.keys.areas'; did you mean 'brow.left'?"},
      {"expressions: {mine: {eyelids: {upper: 1}}}",
       "unknown key 'eyelids' in 'expressions.mine'; did you mean 'lids'?"},
      {"expressions: {mine: {lids: {closed: 1}}}",
       "unknown move 'closed' in 'expressions.mine.lids'; did you mean 'upper' (below 0 closes it)?"},
      {"expressions: {mine: {lids: {open: 1}}}",
       "unknown move 'open' in 'expressions.mine.lids'; did you mean 'upper'?"},
      {"expressions: {mine: {lips: {closed: 1}}}",
       "unknown move 'closed' in 'expressions.mine.lips'; did you mean 'press'?"},
      {"expressions: {mine: {chin: {open: 1}}}",
       "unknown move 'open' in 'expressions.mine.chin'; did you mean 'down'?"},
      {"expressions: {mine: {brows: {down: 1}}}",
       "unknown move 'down' in 'expressions.mine.brows'; did you mean 'up' (below 0 is down)?"},
      {"expressions: {mine: {eyes: {left: 1}}}",
       "unknown move 'left' in 'expressions.mine.eyes'; did you mean 'side' (above 0 is the character's "
       "left)?"},
      {"head: {age: baby}", "unknown age 'baby'; did you mean 'infant'?"},
      {"head: {age: kid}", "unknown age 'kid'; did you mean 'child'?"},
      {"head: {age: elderly}", "unknown age 'elderly'; did you mean 'old'?"},
      {"head: {hair: short}", "unknown cut of hair 'short'; did you mean 'crop'?"},
      {"head: {hair: bald}", "unknown cut of hair 'bald'; did you mean 'none'?"},
      {"head: {look: {beard: full}}", "unknown beard 'full'; did you mean 'short'?"},
      {"head: {look: {skin: dark}}", "'head.look.skin' is 'dark'; did you mean 'deep'?"},
      {"head: {look: {skin: pale}}", "'head.look.skin' is 'pale'; did you mean 'porcelain'?"},
      {"head: {look: {hair: blonde}}", "'head.look.hair' is 'blonde'; did you mean 'blond'?"},
      {"head: {look: {hair: brunette}}", "'head.look.hair' is 'brunette'; did you mean 'brown'?"},
      {"head: {look: {hair: dark}}", "'head.look.hair' is 'dark'; did you mean 'brown'?"},
      {"head: {look: {hair: gray}}", "'head.look.hair' is 'gray'; did you mean 'grey'?"},
      {"head: {look: {hair: auburn}}", "'head.look.hair' is 'auburn'; did you mean 'chestnut'?"},
      {"head: {look: {brow: ginger}}", "'head.look.brow' is 'ginger'; did you mean 'red'?"},
      {"busts: [{hollow: yes}]", "unknown answer 'yes'; did you mean 'true'?"}};
  for (const auto& [text, message] : cases) EXPECT_EQ(answer(text), message) << text;
}

}  // namespace
}  // namespace mien
