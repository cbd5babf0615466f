#include "config/edit.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "config/edit_steps.hpp"
#include "config/edit_tree.hpp"
#include "config/language.hpp"
#include "config/quantity.hpp"

namespace mien {

namespace {

// What the language lets stand at a path; nullptr if it says nothing of it.
const Forms* find_forms(const YamlPath& path, std::size_t steps) {
  static const Forms whole{[] {
    Form file;
    file.kind = FormKind::section;
    file.section = &find_sections().file;
    return file;
  }()};
  const Forms* forms = &whole;
  for (std::size_t i = 0; i < steps && forms != nullptr; ++i) {
    const std::string* name = std::get_if<std::string>(&path[i]);
    const Form* section = find_form(*forms, FormKind::section);
    const Form* items = find_form(*forms, name == nullptr ? FormKind::list : FormKind::map);
    const Key* key = name == nullptr || section == nullptr ? nullptr : find_key(*section->section, *name);
    forms = key != nullptr ? &key->forms : items != nullptr ? &items->items : nullptr;
  }
  return forms;
}

// Where one value alone stands for a mapping that has it under this key.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kShortForms{{{"drift", "amount"},
                                                                                    {"asymmetry", "amount"},
                                                                                    {"blink", "style"},
                                                                                    {"include", "file"},
                                                                                    {"sound", "file"}}};

// The entry of a mapping that a single word or number stands for: "child: 1", "amount: 0.5"; empty if the
// language has none such.
std::string find_long_form(const EditText& text, std::uint32_t node, const YamlPath& path,
                           std::size_t steps) {
  const YamlNode& value = text.document.nodes[node];
  const Range range = text.ranges[node];
  const std::string words = text.document.source.text.substr(range.begin, range.end - range.begin);
  const Forms* forms = find_forms(path, steps);
  if (value.kind != NodeKind::text || forms == nullptr || words.find('\n') != words.npos) return {};
  const bool is_mix =
      find_form(*forms, FormKind::map) != nullptr &&
      (find_form(*forms, FormKind::word) != nullptr || find_form(*forms, FormKind::tag) != nullptr);
  if (is_mix) return words + ": 1";
  const auto* name = std::get_if<std::string>(&path[steps - 1]);
  const Form* words_of = find_form(*forms, FormKind::word);
  const bool is_number = parse_number(value.text) ||
                         (value.is_quoted && find_form(*forms, FormKind::number) != nullptr &&
                          (words_of == nullptr || std::ranges::find(words_of->words, value.text,
                                                                    &Word::name) == words_of->words.end()));
  for (const auto& [key, member] : kShortForms)
    if (name != nullptr && *name == key && (member == "amount") == is_number &&
        find_form(*forms, FormKind::section))
      return fmt::format("{}: {}", member, words);
  return {};
}

// Sections of a file in the order in which files have them.
constexpr std::array<std::string_view, 12> kSectionOrder{"mien",    "title",      "author", "licence",
                                                         "library", "exaggerate", "head",   "expressions",
                                                         "actors",  "clip",       "render", "busts"};

std::size_t find_section_rank(const std::string& key) {
  return static_cast<std::size_t>(std::ranges::find(kSectionOrder, key) - kSectionOrder.begin());
}

// Before which entry of the file a new section goes.
std::size_t find_section_place(const EditText& text, const std::string& key) {
  const std::vector<std::uint32_t>& children = text.document.nodes[text.document.root].children;
  std::size_t place = 0;
  for (std::size_t i = 0; 2 * i < children.size(); ++i)
    if (find_section_rank(text.document.nodes[children[2 * i]].text) <= find_section_rank(key)) place = i + 1;
  return place;
}

// What is not there yet, as an entry of the last mapping or list on the way.
EntryWords build_missing(const YamlPath& path, std::size_t step, const NewValue& value, int indent,
                         bool is_top) {
  EntryWords words;
  const bool is_last = step + 1 == path.size();
  const EntryWords inner =
      is_last ? EntryWords{value.flow, value.block} : build_missing(path, step + 1, value, indent, false);
  const bool is_inner_item = !is_last && std::holds_alternative<std::size_t>(path[step + 1]);
  if (is_inner_item && std::get<std::size_t>(path[step + 1]) != 0)
    throw InputError(
        fmt::format("there is no {}; expected [0] as the first item of a list", describe_path(path)));
  const std::string flow =
      is_last ? inner.flow : (is_inner_item ? "[" : "{") + inner.flow + (is_inner_item ? "]" : "}");
  const std::string* key = std::get_if<std::string>(&path[step]);
  if (key == nullptr) return {flow, value.block};
  words.flow = fmt::format("{}: {}", quote_key(*key), flow);
  if (is_last || (!is_top && value.block.empty())) return words;
  words.block.push_back(quote_key(*key) + ":");
  const std::string step_words(static_cast<std::size_t>(indent), ' ');
  const std::vector<std::string> lines = inner.block.empty() ? std::vector{inner.flow} : inner.block;
  for (std::size_t i = 0; i < lines.size(); ++i)
    words.block.push_back(step_words + (!is_inner_item ? "" : i == 0 ? "- " : "  ") + lines[i]);
  return words;
}

Tree build_missing_tree(const YamlPath& path, std::size_t step, const NewValue& value) {
  EntryWords words = build_missing(path, step, {value.flow, {}}, 0, false);
  const bool is_item = std::holds_alternative<std::size_t>(path[step]);
  return read_value(is_item ? "[" + words.flow + "]" : "{" + words.flow + "}");
}

[[noreturn]] void refuse_step(const EditText& text, std::uint32_t node, const YamlPath& path,
                              std::size_t steps) {
  const YamlNode& found = text.document.nodes[node];
  const bool is_item = std::holds_alternative<std::size_t>(path[steps]);
  const std::string subject = describe_path(path, steps);
  const std::string what = found.kind == NodeKind::list      ? "is a list"
                           : found.kind == NodeKind::mapping ? "is a mapping"
                                                             : fmt::format("is '{}'", show_word(found.text));
  if (found.kind == NodeKind::list && is_item)
    throw InputError(fmt::format("{} has {} item{}; expected one of them, or [{}] behind the last", subject,
                                 found.children.size(), found.children.size() == 1 ? "" : "s",
                                 found.children.size()));
  throw InputError(fmt::format("{} {}; expected a {}, for {} in it", subject, what,
                               is_item ? "list" : "mapping",
                               is_item ? fmt::format("[{}]", std::get<std::size_t>(path[steps]))
                                       : fmt::format("'{}'", show_word(std::get<std::string>(path[steps])))));
}

// Into an empty text: its first line says what it is.
std::string begin_text(const EditText& text, const YamlPath& path, const NewValue& value) {
  const bool is_version =
      std::get_if<std::string>(&path[0]) != nullptr && std::get<std::string>(path[0]) == "mien";
  const EntryWords words = build_missing(path, 0, value, find_indent_step(text), true);
  const std::string& old = text.document.source.text;
  std::string lines = old.empty() || old.back() == '\n' ? "" : "\n";
  if (!is_version) lines += fmt::format("mien: {}\n", kLanguageVersion);
  for (const std::string& line : words.block.empty() ? std::vector{words.flow} : words.block)
    lines += line + "\n";
  Tree expected = build_missing_tree(path, 0, value);
  if (!is_version) {
    expected.children.push_back(build_key_tree("mien"));
    expected.children.push_back(read_value(std::to_string(kLanguageVersion)));
  }
  return check_edit(replace_range(text, {old.size(), old.size()}, lines), expected, path);
}

std::string replace_at(const EditText& text, const YamlPath& path, const Trail& trail, std::size_t steps,
                       const std::string& value) {
  const std::uint32_t node = trail.nodes[steps];
  check_unrepeated(text, text.ranges[node],
                   {path.begin(), path.begin() + static_cast<std::ptrdiff_t>(steps)});
  const Splice splice = replace_value(text, trail.nodes[steps - 1], trail.entries[steps - 1], value);
  Tree expected = build_tree(text);
  find_branch(expected, trail.entries) = read_value(value);
  return check_edit(replace_range(text, splice.range, splice.words), expected, path);
}

// A new entry of a list or mapping that is there.
std::string add_entry(const EditText& text, const YamlPath& path, const Trail& trail, const NewValue& value) {
  const std::size_t steps = trail.entries.size();
  const std::uint32_t owner = trail.nodes[steps];
  const bool is_list = text.document.nodes[owner].kind == NodeKind::list;
  const std::size_t* number = std::get_if<std::size_t>(&path[steps]);
  if (is_list != (number != nullptr)) refuse_step(text, owner, path, steps);
  std::size_t entry = count_entries(text, owner);
  if (is_list && *number > entry) refuse_step(text, owner, path, steps);
  if (is_list) entry = *number;
  if (owner == text.document.root && !is_list)
    entry = find_section_place(text, std::get<std::string>(path[0]));
  const EntryWords words = build_missing(path, steps, value, find_indent_step(text), steps == 0);
  const Splice splice = insert_entry(text, owner, entry, words);
  Tree expected = build_tree(text);
  Tree& branch = find_branch(expected, trail.entries);
  const Tree added = build_missing_tree(path, steps, value);
  const std::size_t at = is_list ? entry : branch.children.size();
  branch.children.insert(branch.children.begin() + static_cast<std::ptrdiff_t>(at), added.children.begin(),
                         added.children.end());
  return check_edit(replace_range(text, splice.range, splice.words), expected, path);
}

// The first entry of what has no value yet.
std::string fill_at(const EditText& text, const YamlPath& path, const Trail& trail, const NewValue& value) {
  const std::size_t steps = trail.entries.size();
  const bool is_list = std::holds_alternative<std::size_t>(path[steps]);
  if (is_list && std::get<std::size_t>(path[steps]) != 0)
    throw InputError(
        fmt::format("there is no {}; expected [0] as the first item of a list", describe_path(path)));
  const EntryWords words = build_missing(path, steps, value, find_indent_step(text), false);
  const Splice splice =
      trail.is_in_brackets || !is_absent(text, trail.nodes[steps])
          ? replace_value(text, trail.nodes[steps - 1], trail.entries[steps - 1],
                          is_list ? "[" + words.flow + "]" : "{" + words.flow + "}")
          : fill_absent(text, trail.nodes[steps - 1], trail.entries[steps - 1], words, is_list);
  Tree expected = build_tree(text);
  find_branch(expected, trail.entries) = build_missing_tree(path, steps, value);
  return check_edit(replace_range(text, splice.range, splice.words), expected, path);
}

}  // namespace

std::string put_value(const std::string& bytes, const YamlPath& path, const NewValue& value,
                      bool is_new_item) {
  if (path.empty()) throw InputError("the path is empty; expected keys such as head, age");
  read_value(value.flow);
  const EditText text = open_text(bytes);
  if (text.is_empty) return begin_text(text, path, value);
  YamlPath way = path;
  if (is_new_item) way.pop_back();
  Trail trail = find_trail(text, way);
  const std::size_t steps = trail.entries.size();
  if (steps == path.size()) return replace_at(text, path, trail, steps, value.flow);
  const std::uint32_t last = trail.nodes.back();
  const NodeKind kind = text.document.nodes[last].kind;
  if (kind == NodeKind::list || kind == NodeKind::mapping) return add_entry(text, path, trail, value);
  if (steps > 0 && kind == NodeKind::nothing) return fill_at(text, path, trail, value);
  const bool is_key = steps > 0 && std::holds_alternative<std::string>(path[steps]);
  const std::string long_form = is_key ? find_long_form(text, last, path, steps) : "";
  if (long_form.empty()) refuse_step(text, last, path, steps);
  const EntryWords words = build_missing(path, steps, {value.flow, {}}, 0, false);
  return replace_at(text, path, trail, steps, fmt::format("{{{}, {}}}", long_form, words.flow));
}

std::string set_value(const std::string& text, const YamlPath& path, const std::string& value) {
  return put_value(text, path, {value, {}}, false);
}

std::string remove_value(const std::string& bytes, const YamlPath& path) {
  const EditText text = open_text(bytes);
  const Trail trail = text.is_empty ? Trail{} : find_trail(text, path);
  std::size_t steps = trail.entries.size();
  if (path.empty() || steps < path.size())
    throw InputError(fmt::format("there is no {}; expected something to remove", describe_path(path)));
  while (steps > 1 && count_entries(text, trail.nodes[steps - 1]) == 1) --steps;
  const std::uint32_t owner = trail.nodes[steps - 1];
  const std::size_t entry = trail.entries[steps - 1];
  if (count_entries(text, owner) == 1)
    throw InputError(
        fmt::format("without {} the file is empty; expected something to stay", describe_path(path)));
  check_unrepeated(text, text.ranges[trail.nodes[steps]], path);
  const Splice splice = remove_entry(text, owner, entry);
  Tree expected = build_tree(text);
  Tree& branch = find_branch(
      expected, {trail.entries.begin(), trail.entries.begin() + static_cast<std::ptrdiff_t>(steps) - 1});
  const bool is_list = branch.kind == NodeKind::list;
  const auto first = branch.children.begin() + static_cast<std::ptrdiff_t>(is_list ? entry : 2 * entry);
  branch.children.erase(first, first + (is_list ? 1 : 2));
  return check_edit(replace_range(text, splice.range, splice.words), expected, path);
}

}  // namespace mien
