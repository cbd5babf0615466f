#include "config/speech_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "config/data_table.hpp"
#include "config/language_forms.hpp"
#include "config/load_areas.hpp"

namespace mien {

namespace {

const Names kContacts{"nothing", "each_other", "upper_teeth"};  // in the order of MouthContact

// The value of a data file, read as the language's own.
YamlValue take_as(const YamlValue& value, const Forms& forms) {
  YamlValue taken = value;
  taken.forms = &forms;
  return taken;
}

Viseme read_viseme(const YamlEntry& entry) {
  static const Forms kAreasForms{as_section(find_sections().areas)};
  static const Forms kNumbersForms{as_section(find_sections().dominance)};
  Viseme viseme;
  viseme.name = entry.key;
  const DataTable table(entry.value);
  table.read("meaning", viseme.meaning);
  if (const YamlValue* areas = table.require("areas")) {
    const AreaValues set = load_areas(take_as(*areas, kAreasForms));
    for (std::size_t i = 0; i < kMoveCount; ++i) viseme.pose.values[i] = set.values[i].value_or(0);
  }
  if (const YamlValue* insists = table.require("insists")) {
    const AreaNumbers shares = load_area_numbers(take_as(*insists, kNumbersForms));
    for (std::size_t i = 0; i < kMoveCount; ++i)
      viseme.insists[i] = std::clamp(shares[i].value_or(0), 0.0, 1.0);
  }
  table.read_if("vowel", viseme.is_vowel);
  std::string contact;
  if (const YamlValue* touches = table.find("touches"))
    if (load_name(*touches, "contact", kContacts, contact))
      viseme.contact = static_cast<MouthContact>(std::ranges::find(kContacts, contact) - kContacts.begin());
  return viseme;
}

Names list_viseme_names(const SpeechData& data) {
  Names names;
  for (const Viseme& viseme : data.visemes) names.push_back(viseme.name);
  return names;
}

// "AA IH": one or two names.
VisemeIndices find_visemes(const SpeechData& data, const std::string& words, const YamlValue& place) {
  const Names names = list_viseme_names(data);
  VisemeIndices indices;
  std::istringstream in(words);
  for (std::string word; in >> word;)
    if (check_name(place, word, "viseme", names))
      indices.push_back(static_cast<std::size_t>(std::ranges::find(names, word) - names.begin()));
  if (indices.size() > 2) add_mistake(place, "more than two visemes; expected one or two");
  return indices;
}

void read_names(const DataTable& root, const std::string& key, const SpeechData& data,
                std::map<std::string, VisemeIndices>& into) {
  for (const YamlEntry& entry : root.list(key))
    if (std::string words; load_datum(entry.value, words))
      into[entry.key] = find_visemes(data, words, entry.value);
}

}  // namespace

SpeechDataPointer load_speech_data(const std::filesystem::path& data_folder, Findings& findings) {
  auto data = std::make_shared<SpeechData>();
  const auto document = load_document(data_folder / "templates/speech/visemes.yaml", findings);
  if (!document) return data;
  const DataTable root(find_root(*document, findings));
  for (const YamlEntry& entry : root.list("visemes")) data->visemes.push_back(read_viseme(entry));
  for (const YamlEntry& entry : root.list("phonemes")) {
    const VisemeIndices indices = find_visemes(*data, entry.key, entry.value);
    std::vector<std::string> sounds;
    if (load_datum(entry.value, sounds))
      for (const std::string& sound : sounds) data->phonemes[sound] = indices;
  }
  read_names(root, "rhubarb", *data, data->rhubarb);
  read_names(root, "preston_blair", *data, data->preston_blair);
  read_names(root, "arpabet", *data, data->arpabet);
  return data;
}

}  // namespace mien
