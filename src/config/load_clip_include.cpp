#include <fmt/format.h>
#include <algorithm>

#include "config/constants.hpp"
#include "config/facs_notation.hpp"
#include "config/load_clip.hpp"
#include "config/load_spec.hpp"
#include "config/named_file.hpp"
#include "config/sections.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxDepth = 8;
constexpr int kMaxFiles = 100;

// One entry of `include:`.
struct Include {
  std::optional<FileReference> file;
  YamlValue place;  // for messages
  double at_s = 0;
  Names take = kTakes;
};

bool load_entry(const YamlValue& value, const ClipReader& reader, Include& include) {
  include.place = value;
  if (find_node(value).kind != NodeKind::mapping) return load_file(value, include.file);
  const YamlMapping entries = load_section(value);
  if (const YamlValue* at = find_value(entries, "at")) load_time(*at, reader.clock, include.at_s);
  if (const YamlValue* take = find_value(entries, "take")) {
    include.take.clear();
    for (const YamlValue& item : load_list(*take, "parts such as [keys, cues, scripts]"))
      if (std::string part; load_name(item, part)) include.take.push_back(part);
  }
  const YamlValue* file = find_required(entries, "file", value, "a file such as nods.yaml");
  return file != nullptr && load_file(*file, include.file);
}

// The names that the other file's clip may use: its own expressions and the libraries.
std::shared_ptr<const ExpressionBook> build_other_book(const YamlDocument& document,
                                                       const YamlMapping& entries,
                                                       const ExpressionBook& outer) {
  auto book = std::make_shared<ExpressionBook>(outer);
  std::erase_if(book->index, [](const auto& entry) { return entry.first.starts_with('/'); });
  book->library = ExpressionBook{}.library;
  append_notations(document, *book);
  book->exaggerate = 1;
  if (const YamlValue* library = find_value(entries, "library"))
    load_name(*library, "library", book->libraries, book->library);
  else if (const YamlValue* doctrine = find_value(entries, "doctrine"))
    if (std::string word; load_name(*doctrine, "doctrine", kDoctrines, word) && word != kDoctrines.front())
      book->library = word;
  load_exaggerate(entries, book->exaggerate);
  if (const YamlValue* expressions = find_value(entries, "expressions")) {
    std::vector<ExpressionDraft> drafts;
    load_drafts(*expressions, "", *book, drafts);
    build_drafts(drafts, *book);
  }
  return book;
}

// A file that is included again brings its inputs again, which count from its own beginning.
void load_own_inputs(const YamlValue& value, const fs::path& path, ClipReader& reader) {
  Inputs& inputs = reader.formulas.inputs;
  Names& own = reader.library->inputs[path];
  // They lose their names and not their places: others that use them were read with both.
  for (Input& input : inputs)
    if (std::ranges::find(own, input.name) != own.end()) input.name.clear();
  const std::size_t before = inputs.size();
  load_inputs(value, {}, reader.clock, reader.formulas);
  own.clear();
  for (std::size_t i = before; i < inputs.size(); ++i) own.push_back(inputs[i].name);
}

void load_other(YamlValue value, const Include& include, const YamlMapping& file, ClipReader& outer,
                const fs::path& path, ClipSpec& into) {
  ClipReader reader = outer;
  value.constants = build_constants(reader.formulas);
  YamlMapping entries = load_section(value);
  int fps = ClipSpec{}.fps;
  load_fps(entries, fps);
  reader.formulas.words.fps = fps;
  reader.clock = {build_time_measure(fps), outer.clock.end_s, include.at_s};
  reader.clock.measure.note = outer.clock.measure.note;
  reader.formulas.start_s = include.at_s;
  reader.between = Between::ease;
  reader.files.push_back(path);
  reader.book = build_other_book(*value.document, file, *outer.book);
  load_between(entries, reader.between);
  std::erase_if(entries, [&](const YamlEntry& entry) {
    return entry.key != "include" && std::ranges::find(include.take, entry.key) == include.take.end();
  });
  load_includes(entries, reader, into);
  if (const YamlValue* inputs = find_value(entries, "inputs")) load_own_inputs(*inputs, path, reader);
  set_constants(build_constants(reader.formulas), entries);
  load_scripts(entries, reader);
  load_layers(entries, reader, into);
  outer.formulas.inputs = reader.formulas.inputs;
}

// A file that is included again is read once.
const std::optional<YamlDocument>& find_document(const Include& include, const ClipReader& reader) {
  Findings& findings = *include.place.findings;
  const auto [known, is_new] = reader.library->documents.try_emplace(include.file->path.string());
  if (!is_new || !has_room(include.place, include.file->path)) return known->second;
  auto text = load_named_source(include.file->path, kMienFile, findings);
  if (text) known->second = scan_document(std::move(*text), findings);
  return known->second;
}

void load_include(const Include& include, ClipReader& reader, ClipSpec& into) {
  const fs::path path = find_canonical(include.file->path);
  if (std::ranges::find(reader.files, path) != reader.files.end())
    return add_mistake(include.place, fmt::format("'{}' includes itself; expected another file",
                                                  show_word(path.filename().string())));
  if (reader.files.size() > kMaxDepth)
    return add_mistake(include.place,
                       fmt::format("files include files more than {} deep; expected fewer", kMaxDepth));
  if (++reader.library->include_count > kMaxFiles)
    return add_mistake(include.place,
                       fmt::format("more than {} files are included; expected fewer", kMaxFiles));
  Findings& findings = *include.place.findings;
  const std::optional<YamlDocument>& document = find_document(include, reader);
  if (!document) return;
  YamlValue root = find_root(*document, findings);
  root.constants = build_file_constants(root, reader.formulas.words.runtime_s);
  if (RuntimeUse* use = reader.formulas.words.use; use != nullptr && mentions_runtime(*document))
    use->is_asked = true;
  const YamlMapping entries = load_section(root, find_sections().file);
  if (find_node(root).kind != NodeKind::mapping) return;
  check_version(root, entries);
  if (const YamlValue* clip = find_required(entries, "clip", root, "a clip to include"))
    load_other(*clip, include, entries, reader, path, into);
}

}  // namespace

void load_includes(const YamlMapping& clip, ClipReader& reader, ClipSpec& into) {
  const YamlValue* value = find_value(clip, "include");
  if (value == nullptr) return;
  std::vector<YamlValue> items{*value};
  if (find_node(*value).kind == NodeKind::list) items = load_list(*value, "");
  for (const YamlValue& item : items)
    if (Include include; load_entry(item, reader, include)) load_include(include, reader, into);
}

}  // namespace mien
