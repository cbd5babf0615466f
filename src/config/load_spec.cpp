#include "config/load_spec.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <deque>
#include <tuple>

#include "config/constants.hpp"
#include "config/data_table.hpp"
#include "config/expressions.hpp"
#include "config/facs_notation.hpp"
#include "config/mapping_data.hpp"
#include "config/named_file.hpp"
#include "config/sections.hpp"
#include "core/ticks.hpp"
#include "core/utf8.hpp"

namespace mien {

namespace {

// The files of expression libraries, by name.
std::vector<std::filesystem::path> list_library_files(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  if (error) throw RunError(fmt::format("cannot read {}: {}", folder.string(), error.message()));
  std::ranges::sort(files);
  return files;
}

// One line of text: it is written into scenes, as a comment.
void load_title(const YamlValue& value, std::string& title) {
  const std::string expected = fmt::format("one line of text, {} bytes at most", kMaxTitleLength);
  std::string text;
  if (!load_text(value, expected, text)) return;
  const bool is_one_line =
      std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
  if (is_one_line && text.size() <= kMaxTitleLength)
    title = text;
  else
    add_unexpected(value, expected);
}

void load_library(const YamlValue& root, const std::string& name, ExpressionBook& book,
                  std::vector<ExpressionDraft>& drafts) {
  const YamlMapping entries = load_section(root, find_sections().library_file);
  if (find_node(root).kind != NodeKind::mapping) return;
  check_version(root, entries);
  if (const YamlValue* library = find_required(entries, "library", root, "the file's name, '" + name + "'"))
    if (std::string word; load_text(*library, "the file's name", word) && word != name)
      add_mistake(*library, fmt::format("library '{}' stands in another file's name; expected '{}'",
                                        show_word(word), name));
  std::string line;
  if (const YamlValue* source = find_value(entries, "source")) load_title(*source, line);
  if (const YamlValue* expressions =
          find_required(entries, "expressions", root, "a mapping of names to areas"))
    load_drafts(*expressions, name, book, drafts);
  std::string rules;
  if (const YamlValue* choice = find_value(entries, "rules")) load_name(*choice, rules);
  for (Expression& expression : book.expressions)
    if (expression.library == name) expression.follows_thesis = rules == kAreaRuleWords[1].name;
}

// What the file does not say of how it is drawn: heads that are mostly of a drawn design are in ink, and ink
// stands on a plain ground.
void settle_style(const HeadWords& words, Spec& spec) {
  const auto is_drawn = [&](const ActorSpec& actor) {
    double drawn = 0;
    for (const auto& [name, weight] : actor.head.design)
      if (std::ranges::find(words.inked, name) != words.inked.end()) drawn += weight;
    return drawn > 0.5;
  };
  if (!spec.render.is_style_given && std::ranges::any_of(list_actors(spec), is_drawn))
    spec.render.style = Style::ink;
  if (!spec.render.is_background_given && spec.render.style == Style::ink)
    spec.render.background = kInkGround;
}

// Heads that do not say their rules have those of the file's library.
void settle_rules(const ExpressionBook& book, Spec& spec) {
  const auto is_thesis = [&](const Expression& expression) {
    return expression.library == spec.library && expression.follows_thesis;
  };
  if (std::ranges::none_of(book.expressions, is_thesis)) return;
  const auto settle = [](HeadSpec& head) {
    if (!head.said.contains("rules")) head.follows_thesis = true;
  };
  settle(spec.head);
  for (HeadKey& key : spec.clip.head) settle(key.head);
  for (ActorSpec& actor : spec.actors) {
    settle(actor.head);
    for (HeadKey& key : actor.clip.head) settle(key.head);
  }
}

// Whether a head of the file keeps to the nine areas: then all of the file does.
bool keeps_to_nine(const YamlMapping& file) {
  const auto is_nine = [](const YamlMapping& entries) {
    const YamlValue* head = find_value(entries, "head");
    if (head == nullptr || find_node(*head).kind != NodeKind::mapping) return false;
    return std::ranges::any_of(load_free_mapping(*head, "a mapping"), [](const YamlEntry& entry) {
      return entry.key == "areas" && find_node(entry.value).text == kAreasWords[1].name;
    });
  };
  if (is_nine(file)) return true;
  const YamlValue* actors = find_value(file, "actors");
  if (actors == nullptr || find_node(*actors).kind != NodeKind::mapping) return false;
  return std::ranges::any_of(load_free_mapping(*actors, "a mapping"), [&](const YamlEntry& actor) {
    return find_node(actor.value).kind == NodeKind::mapping &&
           is_nine(load_free_mapping(actor.value, "a mapping"));
  });
}

void load_sections(const YamlValue& root, const YamlMapping& entries, const HeadWords& words,
                   ExpressionBook& book, Spec& spec) {
  root.findings->keeps_to_nine = spec.keeps_to_nine = keeps_to_nine(entries);
  if (const YamlValue* title = find_value(entries, "title")) load_title(*title, spec.title);
  if (const YamlValue* author = find_value(entries, "author")) load_title(*author, spec.author);
  if (const YamlValue* licence = find_value(entries, "licence")) load_title(*licence, spec.licence);
  if (const YamlValue* library = find_value(entries, "library")) {
    load_name(*library, "library", book.libraries, spec.library);
    if (const YamlValue* doctrine = find_value(entries, "doctrine"))
      add_mistake(*doctrine,
                  "'doctrine' and 'library' both say whose expressions a name means; expected one of them");
  } else if (const YamlValue* doctrine = find_value(entries, "doctrine"))
    if (std::string word; load_name(*doctrine, "doctrine", kDoctrines, word) && word != kDoctrines.front())
      spec.library = word;
  book.library = spec.library;
  load_exaggerate(entries, spec.exaggerate);
  book.exaggerate = spec.exaggerate;
  if (const YamlValue* expressions = find_value(entries, "expressions")) {
    std::vector<ExpressionDraft> drafts;
    load_drafts(*expressions, "", book, drafts);
    build_drafts(drafts, book);
  }
  HeadCounts counts;
  load_stage(entries, {&book, {&words, {find_canonical(spec.file)}, &counts}}, spec);
  if (const YamlValue* render = find_value(entries, "render")) {
    spec.render = load_render(*render);
    if (has_alpha(spec.render) && !spec.clip.background.empty())
      add_mistake(
          *render,
          "background: none is for the whole clip, whose `background` has keys; expected one of both");
  }
  settle_style(words, spec);
  settle_rules(book, spec);
  if (const YamlValue* busts = find_value(entries, "busts")) load_busts(*busts, book, spec);
  check_version(root, entries);
}

ExpressionBook build_book(std::vector<Expression> expressions) {
  ExpressionBook book;
  for (const Expression& expression : expressions)
    if (std::ranges::find(book.libraries, expression.library) == book.libraries.end())
      book.libraries.push_back(expression.library);
  append_expressions(book, std::move(expressions));
  return book;
}

}  // namespace

void check_version(const YamlValue& root, const YamlMapping& entries) {
  const YamlValue* version = find_value(entries, "mien");
  if (version == nullptr) {
    // A slip in the word itself was told as an unknown key.
    for (const YamlEntry& entry : load_free_mapping(root, ""))
      if (suggest_name(entry.key, {"mien"}) == "mien") return;
    add_mistake(root, "'mien: 1' is missing; expected it as the first line");
    return;
  }
  const YamlNode& node = find_node(*version);
  const auto number = node.is_quoted ? std::nullopt : parse_number(node.text);
  if (!number)
    add_unexpected(*version, fmt::format("the version of the language, {}", kLanguageVersion));
  else if (*number != kLanguageVersion)
    add_mistake(*version, fmt::format("version {} of the language is not known; expected 'mien: {}'",
                                      show_word(node.text), kLanguageVersion));
}

LanguagePointer load_language(const std::filesystem::path& data_folder) {
  Findings findings;
  auto language = std::make_shared<Language>();
  language->libraries = build_book(load_expression_libraries(data_folder / "configs/expressions"));
  language->libraries.mappings = load_mapping_data(data_folder, language->libraries, findings);
  language->words = load_head_words(data_folder, findings);
  language->speech = load_speech_data(data_folder, findings);
  throw_mistakes(std::move(findings));
  return language;
}

namespace {

// The document as it reads if its clip lasts so long; with its mistakes in `findings`.
Spec read_spec(const std::filesystem::path& file, const std::optional<YamlDocument>& document,
               const Language& language, std::optional<double> runtime_s, RuntimeUse& use,
               ExpressionBook& book, Findings& findings) {
  Spec spec;
  spec.file = file;
  spec.name = build_name(file);
  if (document) {
    YamlValue root = find_root(*document, findings);
    root.constants = build_file_constants(root, runtime_s, &use);
    if (root.constants->words.use != nullptr && mentions_runtime(*document)) use.is_asked = true;
    const YamlMapping entries = load_section(root, find_sections().file);
    append_notations(*document, book);
    if (find_node(root).kind == NodeKind::mapping) load_sections(root, entries, language.words, book, spec);
  }
  spec.files = findings.files;
  return spec;
}

// How long a clip is that follows from its keys is known when it is read: if its formulas ask for that, it is
// read again. Those that change it ask for what they decide themselves.
void check_runtime(const RuntimeUse& use, double before_s, double after_s, Findings& findings) {
  if (compute_ticks(before_s) == compute_ticks(after_s) || !findings.mistakes.empty()) return;
  add_mistake(
      findings, use.place,
      fmt::format("{} asks for 'runtime', which follows from it: the clip lasts {:.7g}s without it and "
                  "{:.7g}s with it; expected a 'length' of the clip",
                  use.subject, before_s, after_s),
      use.line);
}

Spec build_spec(const std::filesystem::path& file, const std::optional<YamlDocument>& document,
                Findings findings, const Language& language) {
  const Findings unread = findings;
  ExpressionBook book = language.libraries;
  const std::size_t library_count = book.expressions.size();
  RuntimeUse use;
  Spec spec = read_spec(file, document, language, {}, use, book, findings);
  if (use.is_asked) {
    const double length_s = spec.clip.length_s;
    RuntimeUse ignored;
    findings = unread;
    book = language.libraries;
    spec = read_spec(file, document, language, length_s, ignored, book, findings);
    check_runtime(use, length_s, spec.clip.length_s, findings);
  }
  throw_mistakes(std::move(findings));

  spec.mappings = book.mappings;
  spec.expressions = std::move(book.expressions);
  auto& all = spec.expressions;
  std::rotate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(library_count), all.end());
  return spec;
}

}  // namespace

Spec load_spec(const std::filesystem::path& file, const Language& language) {
  Findings findings;
  const auto document = load_document(file, findings);
  return build_spec(file, document, std::move(findings), language);
}

Spec load_spec(const std::filesystem::path& file, std::string text, const Language& language) {
  Findings findings;
  findings.files.push_back(file);
  std::optional<YamlDocument> document;
  if (auto source = build_source(file.string(), std::move(text), findings))
    document = scan_document(std::move(*source), findings);
  return build_spec(file, document, std::move(findings), language);
}

namespace {

ExpressionBook build_spec_book(const Spec& spec) {
  ExpressionBook book = build_book(spec.expressions);
  std::erase(book.libraries, "");
  book.library = spec.library;
  book.mappings = spec.mappings;
  return book;
}

// A notation that the file does not have; empty if it is none, or is called as an expression is.
std::optional<Expression> find_noted_expression(const Spec& spec, const std::string& name) {
  std::string fault;
  if (!spec.mappings || find_expression(build_spec_book(spec), name)) return std::nullopt;
  const auto pose = find_notation_pose(*spec.mappings, name, fault);
  if (!pose) return std::nullopt;
  Expression expression{name, "facs", *pose};
  std::ranges::replace(expression.name, '+', '_');  // as files are called
  return expression;
}

}  // namespace

const Expression& find_expression(const Spec& spec, const std::string& name) {
  ExpressionBook book = build_spec_book(spec);
  const auto index = find_expression(book, name);
  if (!index) throw InputError(describe_unknown_expression(book, name));
  return spec.expressions[*index];
}

namespace {

// "{brows: {up: 0.5}}" as an expression of the file.
Expression read_expression(const Spec& spec, const std::string& words) {
  ExpressionBook book = build_spec_book(spec);
  Findings findings;
  auto source = build_source("--express", "expressions: {posed: " + words + "}\n", findings);
  const auto document = source ? scan_document(std::move(*source), findings) : std::nullopt;
  std::vector<ExpressionDraft> drafts;
  if (document) {
    append_notations(*document, book);
    const YamlMapping entries = load_section(find_root(*document, findings), find_sections().file);
    if (const YamlValue* expressions = find_value(entries, "expressions"))
      load_drafts(*expressions, "", book, drafts);
    build_drafts(drafts, book);
  }
  if (!findings.mistakes.empty()) throw InputError("--express: " + findings.mistakes.front().message);
  if (drafts.size() != 1)
    throw InputError(
        fmt::format("--express is '{}'; expected a name or one expression in braces", show_word(words)));
  return book.expressions[drafts.front().expression];
}

}  // namespace

Expression take_expression(const Spec& spec, const std::string& name) {
  if (name.starts_with('{')) return read_expression(spec, name);
  const auto noted = find_noted_expression(spec, name);
  Expression expression = noted ? *noted : find_expression(spec, name);
  HeldPose held = hold_pose({expression.pose, expression.reach, 1, {}, spec.exaggerate});
  expression.pose = held.pose;
  expression.reach = held.reach;
  return expression;
}

std::vector<Expression> load_expression_libraries(const std::filesystem::path& folder) {
  Findings findings;
  ExpressionBook book;
  std::deque<YamlDocument> documents;  // a deque: drafts point into them
  std::vector<ExpressionDraft> drafts;
  for (const std::filesystem::path& file : list_library_files(folder)) {
    book.libraries.push_back(file.stem().string());
    auto document = load_document(file, findings);
    if (!document) continue;
    documents.push_back(std::move(*document));
    load_library(find_root(documents.back(), findings), file.stem().string(), book, drafts);
  }
  build_drafts(drafts, book);
  throw_mistakes(std::move(findings));
  std::stable_sort(book.expressions.begin(), book.expressions.end(),
                   [](const Expression& a, const Expression& b) {
                     return std::tie(a.library, a.name) < std::tie(b.library, b.name);
                   });
  return std::move(book.expressions);
}

std::map<std::string, std::string> load_library_sources(const std::filesystem::path& folder) {
  std::map<std::string, std::string> sources;
  Findings findings;
  for (const std::filesystem::path& file : list_library_files(folder)) {
    std::string& source = sources[file.stem().string()];
    const auto document = load_document(file, findings);
    if (!document) continue;
    const YamlMapping entries = load_free_mapping(find_root(*document, findings), "");
    if (const YamlValue* value = find_value(entries, "source")) load_title(*value, source);
  }
  throw_mistakes(std::move(findings));
  return sources;
}

std::string build_name(const std::filesystem::path& file) {
  std::string name;
  for (const char c : file.stem().string()) {
    if (!is_first_of_character(c)) continue;
    const unsigned char byte = static_cast<unsigned char>(c);
    const bool is_kept = (byte < 0x80 && std::isalnum(byte)) || c == '-' || c == '_';
    name += is_kept ? c : '_';
  }
  if (name.empty()) name.push_back('_');
  if (name[0] == '-') name[0] = '_';
  return name;
}

}  // namespace mien
