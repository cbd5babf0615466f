#include "config/head_words.hpp"

#include "config/data_table.hpp"
#include "config/design_data.hpp"

namespace mien {

namespace {

// Nothing if there is no such file.
std::optional<YamlDocument> load_if(const std::filesystem::path& file, Findings& findings) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return std::nullopt;
  return load_document(file, findings);
}

// The keys of one mapping of the file, behind `names`.
void append_keys(const YamlMapping& entries, std::string_view key, Names& names) {
  if (const YamlValue* mapping = find_value(entries, key))
    for (const YamlEntry& entry : load_free_mapping(*mapping, "a mapping"))
      if (entry.key != "pupil" && entry.key != "tongue") names.push_back(entry.key);
}

const Names kLookKeys{"meaning", "skin", "lips", "brow", "hair", "iris", "freckles", "age_spots"};

// Each with its meaning and the text of the colour that it is known by.
void read_looks(const DataTable& root, const std::string& key, const std::string& colour,
                std::vector<std::pair<std::string, Look>>& looks, std::vector<LookWord>& meanings) {
  for (const YamlEntry& entry : root.list(key)) {
    Look look;
    load_look_words(load_mapping(entry.value, kLookKeys, "colours"), look);
    looks.emplace_back(entry.key, look);
    LookWord& word = meanings.emplace_back(LookWord{entry.key, "", ""});
    const YamlMapping entries = load_free_mapping(entry.value, "colours");
    if (const YamlValue* value = find_required(entries, colour, entry.value, "a colour"))
      load_text(*value, "a colour", word.value);
    if (const YamlValue* value = find_required(entries, "meaning", entry.value, "a few words"))
      load_text(*value, "a few words", word.meaning);
  }
}

void load_greying(const YamlValue& value, Greying& greying) {
  const YamlMapping entries =
      load_mapping(value, {"hair", "brow", "hair_share", "brow_share", "age_spots"}, "colours and shares");
  for (const auto& [key, into] : {std::pair{"hair", &greying.hair}, std::pair{"brow", &greying.brow}})
    if (const YamlValue* colour = find_required(entries, key, value, "a colour")) load_colour(*colour, *into);
  for (const auto& [key, into] :
       {std::pair{"hair_share", &greying.hair_share}, std::pair{"brow_share", &greying.brow_share},
        std::pair{"age_spots", &greying.age_spots}})
    if (const YamlValue* share = find_required(entries, key, value, "a number"))
      load_number(*share, 0, 1, *into);
}

}  // namespace

void set_greying(const Greying& greying, Look& look) {
  const auto grow_grey = [](const glm::vec3& colour, const glm::vec3& grey, double share) {
    return glm::mix(colour, grey, static_cast<float>(share));
  };
  look.hair_old = look.is_hair_given ? look.hair : grow_grey(look.hair, greying.hair, greying.hair_share);
  look.brow_old = look.is_brow_given ? look.brow : grow_grey(look.brow, greying.brow, greying.brow_share);
  look.age_spots_old =
      look.are_age_spots_given ? look.age_spots : std::max(look.age_spots, greying.age_spots);
}

void load_look_words(const YamlMapping& entries, Look& look) {
  const auto load = [&](const char* key, glm::vec3& into) {
    const YamlValue* value = find_value(entries, key);
    return value != nullptr && load_colour(*value, into);
  };
  load("skin", look.skin);
  load("iris", look.iris);
  load("brow", look.brow);
  load("hair", look.hair);
  glm::vec3 lips{0};
  if (load("lips", lips)) look.lips = lips;
  const auto load_dial = [&](const char* key, double& into) {
    const Form& range = *find_form(find_key(find_sections().look, key)->forms, FormKind::number);
    if (const YamlValue* value = find_value(entries, key)) load_number(*value, range.low, range.high, into);
  };
  load_dial("freckles", look.freckles);
  load_dial("age_spots", look.age_spots);
  look.are_age_spots_given = look.are_age_spots_given || find_value(entries, "age_spots") != nullptr;
}

HeadWords load_head_words(const std::filesystem::path& data_folder, Findings& findings) {
  HeadWords words;
  if (const auto document = load_if(data_folder / "templates/head/features.yaml", findings))
    append_keys(load_free_mapping(find_root(*document, findings), "a mapping"), "features", words.features);
  if (const auto document = load_if(data_folder / "templates/head/landmarks.yaml", findings)) {
    const YamlMapping entries = load_free_mapping(find_root(*document, findings), "a mapping");
    append_keys(entries, "middle", words.middle);
    append_keys(entries, "everyday_middle", words.middle);
    append_keys(entries, "sided", words.sided);
    append_keys(entries, "everyday_sided", words.sided);
  }
  if (const auto document = load_if(data_folder / "templates/head/looks.yaml", findings)) {
    const DataTable root(find_root(*document, findings));
    read_looks(root, "looks", "skin", words.looks, words.look_words);
    read_looks(root, "hair_colours", "hair", words.hair_colours, words.hair_colour_words);
    if (const YamlValue* greying = root.require("greying")) load_greying(*greying, words.greying);
    for (const YamlEntry& dial : root.list("dials"))
      load_text(dial.value, "a few words", words.dial_words.emplace_back(LookWord{dial.key, "", ""}).meaning);
  }
  words.designs = {{kReal, "", "as it is"}};
  for (const Design& design : load_designs(data_folder / "templates/head/designs", findings)) {
    words.designs.push_back({design.name, "", design.meaning});
    if (design.style == Style::ink) words.inked.push_back(design.name);
  }
  words.people =
      load_people(data_folder / "templates/head/people.yaml", {words.features, words.looks}, findings);
  return words;
}

Names list_places(const HeadWords& words) {
  Names names = words.middle;
  for (const std::string& name : words.sided)
    for (const char* side : {"", "_l", "_r"}) names.push_back(name + side);
  return names;
}

}  // namespace mien
