#include <fmt/format.h>
#include <algorithm>

#include "config/constants.hpp"
#include "config/load_clip.hpp"

namespace mien {

namespace {

constexpr std::size_t kMaxDepth = 8;      // of scripts that play scripts
constexpr std::size_t kMaxPlayed = 2000;  // different sets of parameters in one clip

// In a script `runtime` is its own length.
void settle_runtime(const YamlMapping& entries, const Inputs& given, ClipReader& reader) {
  FormulaReader own = reader.formulas;  // whose mistakes nobody hears
  Findings silent;
  const auto silence = [&](const YamlValue* value) {
    YamlValue heard = *value;
    heard.findings = &silent;
    return heard;
  };
  own.found = nullptr;
  own.count = nullptr;
  own.words.runtime_s = {};
  own.words.use = nullptr;
  if (const YamlValue* parameters = find_value(entries, "parameters"))
    load_inputs(silence(parameters), given, reader.clock, own);
  reader.formulas.words.use = nullptr;
  reader.formulas.words.runtime_s = {};
  reader.formulas.words.missing = "is not known in a script without 'length'; expected one";
  const YamlValue* length = find_value(entries, "length");
  double length_s = 0;
  if (length == nullptr) return;
  YamlValue heard = silence(length);
  heard.constants = build_constants(own);
  if (load_duration(heard, reader.clock, length_s)) reader.formulas.words.runtime_s = length_s;
}

std::shared_ptr<const ClipSpec> load_script(const ScriptText& text, const std::string& name,
                                            const Inputs& given, const ClipReader& outer) {
  ClipReader reader = outer;
  reader.clock = text.clock;
  reader.clock.start_s = 0;
  reader.book = text.book;
  reader.formulas.inputs = text.inputs;
  reader.formulas.words = text.words;
  reader.formulas.start_s = 0;
  reader.formulas.fps = 0;
  reader.scripts.push_back(name);
  YamlMapping entries = load_section(text.body);
  load_between(entries, reader.between);
  settle_runtime(entries, given, reader);
  if (const YamlValue* parameters = find_value(entries, "parameters"))
    load_inputs(*parameters, given, reader.clock, reader.formulas);
  set_constants(build_constants(reader.formulas), entries);
  auto clip = std::make_shared<ClipSpec>();
  load_layers(entries, reader, *clip);
  // Without keys it begins and ends at rest.
  if (clip->keys.empty()) clip->keys.emplace_back();
  if (clip->turn.empty()) clip->turn.emplace_back();
  if (clip->camera.empty()) clip->camera.emplace_back();
  return clip;
}

// The numbers that a cue plays the script with; each has to be one of its parameters.
Inputs load_given(const YamlValue& value, const ScriptText& text) {
  Names known;
  Findings silent;  // the script's own mistakes are told when it is read
  YamlValue body = text.body;
  body.findings = &silent;
  const YamlMapping entries = load_free_mapping(body, "");
  if (const YamlValue* parameters = find_value(entries, "parameters"))
    for (const YamlEntry& entry : load_free_mapping(*parameters, "")) known.push_back(entry.key);
  Inputs given;
  for (const YamlEntry& entry : load_mapping(value, known, "numbers such as {times: 3}", "parameter")) {
    Input input{entry.key, 0, {}};
    if (load_number(entry.value, input.value)) given.push_back(input);
  }
  return given;
}

}  // namespace

void load_scripts(const YamlMapping& clip, const ClipReader& reader) {
  const YamlValue* value = find_value(clip, "scripts");
  if (value == nullptr) return;
  for (const YamlEntry& entry :
       load_free_mapping(*value, "scripts by name such as {nod: {length: 1s, keys: [...]}}"))
    reader.library->scripts[entry.key] = {entry.value, reader.book, reader.clock, reader.formulas.inputs,
                                          reader.formulas.words};
}

std::shared_ptr<const ClipSpec> play_script(const YamlValue& name, const YamlValue* parameters,
                                            const ClipReader& reader) {
  ClipLibrary& library = *reader.library;
  std::string word;
  if (!load_text(name, "a script's name", word)) return {};
  if (library.scripts.empty()) {
    add_mistake(
        name, fmt::format("unknown script '{}'; expected one of 'scripts', which has none", show_word(word)));
    return {};
  }
  if (!library.scripts.contains(word)) {
    Names known;
    for (const auto& [script, text] : library.scripts) known.push_back(script);
    add_mistake(name, describe_unknown("script", word, known));
    return {};
  }
  const auto again = std::ranges::find(reader.scripts, word);
  if (again != reader.scripts.end() || reader.scripts.size() >= kMaxDepth) {
    add_mistake(name, again != reader.scripts.end()
                          ? fmt::format("script '{}' plays itself; expected another one", word)
                          : fmt::format("scripts play scripts more than {} deep; expected fewer", kMaxDepth));
    return {};
  }
  const ScriptText& text = library.scripts.at(word);
  const Inputs given = parameters != nullptr ? load_given(*parameters, text) : Inputs{};
  library.played_names.insert(word);
  std::string key = word;
  for (const Input& input : given) key += fmt::format(" {}={}", input.name, input.value);
  if (const auto played = library.played.find(key); played != library.played.end()) return played->second;
  if (library.played.size() >= kMaxPlayed) {
    add_mistake(name, fmt::format("scripts are played with more than {} sets of parameters; expected fewer",
                                  kMaxPlayed));
    return {};
  }
  return library.played[key] = load_script(text, word, given, reader);
}

void check_scripts(const ClipReader& reader) {
  for (const auto& [name, text] : reader.library->scripts)
    if (!reader.library->played_names.contains(name)) load_script(text, name, {}, reader);
}

}  // namespace mien
