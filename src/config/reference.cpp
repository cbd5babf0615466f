#include "config/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/language_forms.hpp"
#include "config/schema_text.hpp"

namespace mien {

namespace {

constexpr std::string_view kIntroduction = R"md(# The YAML language, key by key

`./run reference` writes this file from the program's own table (`src/config/language.hpp`); `mien schema` prints the same
as a JSON Schema for editors: `# yaml-language-server: $schema=mien.schema.json` as a file's first line names it.

| value | as it is written |
|---|---|
| a time | `1.5s`, `36f` (frames), `500ms`, or a bare number of seconds |
| a length | `80mm`, `8cm`, or a bare number of millimetres |
| an angle | `20deg`, or a bare number of degrees |
| a colour | `"#dcae8f"`, in quotes: an unquoted `#` begins a comment |
| a formula | in quotes where a number could stand: `"0.3*sin(2*pi*t/1.5)"`, of the time `t` in seconds, `runtime`, `fps`, `pi` and inputs |

In place of any other number, time, length or angle may stand a formula that does not use `t`: `from: "runtime/2"`, in the place's own unit
([Timeline](timeline.md#formulas-tables-other-files)).

A key in bold must be there. left and right are the character's own.
)md";

// Mappings that differ from others by formulas alone are told with those.
constexpr std::string_view kLive = "live_";

std::string find_heading(const Section& section) {
  return section.name.starts_with(kLive) ? section.name.substr(kLive.size()) : section.name;
}

std::string link(const Section& section) { return fmt::format("[{0}](#{0})", find_heading(section)); }

std::string quote_words(const std::vector<Word>& words) {
  std::string text;
  for (const Word& word : words) text += fmt::format("{}`{}`", text.empty() ? "" : ", ", word.name);
  return text;
}

std::string describe_data(const std::string& list) {
  if (list == "looks") return "a skin of `mien list looks`";
  if (list == "hair_colours") return "a hair of `mien list looks`";
  if (list == "places") return "a place of `mien list landmarks`";
  if (list == "features") return "a feature of `mien list features`";
  if (list == "libraries") return "a library of expressions";
  return "an expression of `mien list expressions` or of the file's own";
}

std::string describe(const Forms& forms);

std::string add_range(std::string_view noun, const Form& form) {
  const std::string range = describe_range(form);
  return range.empty() ? std::string(noun) : fmt::format("{} {}", noun, range);
}

std::string describe_map(const Form& form) {
  std::string names = "a name";
  if (!form.words.empty())
    names = "these";
  else if (!form.data.empty())
    names = describe_data(form.data);
  else if (form.pattern == build_file_pattern(kYamlEndings))
    names = "a file";
  return fmt::format("a mapping of {} to {}", names, describe(form.items));
}

std::string describe_file(const Form& form) {
  std::string endings;
  for (const std::string& ending : form.endings)
    endings += fmt::format("{}{}", endings.empty() ? "" : ", ", ending);
  return fmt::format("a file ({})", endings);
}

std::string describe(const Form& form) {
  switch (form.kind) {
    case FormKind::version:
      return fmt::format("`{}`", kLanguageVersion);
    case FormKind::word:
      if (form.words.empty()) return describe_data(form.data);
      return quote_words(form.words) + (form.pattern.empty() ? "" : ", " + describe_data(form.data));
    case FormKind::yes_no:
      return "`true`, `false`";
    case FormKind::number:
      return add_range("a number", form);
    case FormKind::whole:
      return add_range("a whole number", form);
    case FormKind::formula:
      return "a formula";
    case FormKind::time:
      return "a time";
    case FormKind::duration:
    case FormKind::seconds:
      return add_range("a length of time", form);
    case FormKind::length:
      return add_range("a length", form);
    case FormKind::angle:
      return add_range("an angle", form);
    case FormKind::lengths:
      return add_range("three lengths [x, y, z], each", form);
    case FormKind::two_lengths:
      return add_range("two lengths such as 6x2mm, each", form);
    case FormKind::size:
      return add_range("a width and a height such as 480x600, each", form);
    case FormKind::colour:
      return "a colour";
    case FormKind::line:
      return fmt::format("one line of text, {:g} bytes at most", form.high);
    case FormKind::tag:
      return form.data.empty() ? "a name" : describe_data(form.data);
    case FormKind::file:
      return describe_file(form);
    case FormKind::curve:
      return fmt::format("four numbers [x1, y1, x2, y2], x from 0 to 1, y {}", describe_range(form));
    case FormKind::list:
      return "a list of " + describe(form.items);
    case FormKind::map:
      return describe_map(form);
    case FormKind::section:
      return link(*form.section);
  }
  return "";
}

std::string describe(const Forms& forms) {
  std::string text;
  for (const Form& form : forms) text += fmt::format("{}{}", text.empty() ? "" : ", or ", describe(form));
  return text;
}

// "`ones`: a new drawing each frame; ...", of words whose meaning the table has.
std::string describe_words(const Forms& forms) {
  std::string text;
  for (const Form& form : forms)
    if (form.kind == FormKind::word)
      for (const Word& word : form.words)
        if (!word.meaning.empty())
          text += fmt::format("{}`{}`: {}", text.empty() ? " " : "; ", word.name, word.meaning);
  return text.empty() ? text : text + ".";
}

std::string describe_rule(const KeyRule& rule) {
  std::string others;
  for (auto key = rule.keys.begin() + (rule.kind == KeyRule::Kind::one_of ? 0 : 1); key != rule.keys.end();
       ++key)
    if (key->find('.') == std::string::npos)
      others += fmt::format("{}`{}`", others.empty() ? "" : ", ", *key);
  switch (rule.kind) {
    case KeyRule::Kind::apart:
      return fmt::format("`{}` does not stand beside {}.", rule.keys.front(), others);
    case KeyRule::Kind::needs:
      return fmt::format("`{}` needs {} beside it.", rule.keys.front(), others);
    case KeyRule::Kind::one_of:
      return fmt::format("One of {} stands there.", others);
  }
  return "";
}

void append_section(const Section& section, std::string& text) {
  text += fmt::format("\n## {}\n\n{}\n", section.name, section.help);
  for (const KeyRule& rule : section.rules) text += describe_rule(rule) + "\n";
  text += "\n| key | value | without it | meaning |\n|---|---|---|---|\n";
  for (const Key& key : section.keys)
    text += fmt::format("| {} | {} | {} | {}{} |\n",
                        key.is_required ? fmt::format("**`{}`**", key.name) : fmt::format("`{}`", key.name),
                        describe(key.forms), key.otherwise.empty() ? "" : fmt::format("`{}`", key.otherwise),
                        key.help, describe_words(key.forms));
}

}  // namespace

std::string build_reference_manual() {
  std::string text(kIntroduction);
  for (const Section* section : list_sections())
    if (!section->name.starts_with(kLive)) append_section(*section, text);
  return text;
}

}  // namespace mien
