// The table of the language and the loaders are one: each key of the table is read, in its range, and its
// default is what an author could write.
#include "config/language.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <regex>
#include <set>

#include "config/config_fixture.hpp"
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
      names.insert(rule.keys.front());
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
      return form.endings.front() == ".csv" ? "talk.csv" : "other.yaml";
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
  for (const Names* names : {&kSharedClipKeys, &kTakes})
    for (const std::string& name : *names) EXPECT_NE(find_key(find_sections().clip, name), nullptr) << name;
}

}  // namespace
}  // namespace mien
