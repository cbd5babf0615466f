#include "config/data_table.hpp"
#include "config/landmark_data.hpp"

namespace mien {

namespace {

const Names kRules{"highest", "lowest", "rearmost", "widest"};

LandmarkRule read_rule(const YamlValue& value, const PointNames& points, bool is_sided) {
  LandmarkRule rule;
  const YamlNode& node = find_node(value);
  if (node.kind == NodeKind::mapping) {
    rule.kind = LandmarkRule::Kind::extreme;
    const YamlMapping entries = load_free_mapping(value, "a rule such as {highest: er*}");
    if (entries.size() != 1) add_mistake(value, describe_subject(value) + " has several rules; expected one");
    for (const YamlEntry& entry : entries)
      if (check_name(entry, "rule", kRules)) {
        rule.rule = entry.key;
        load_datum(entry.value, rule.pattern);
      }
  } else if (node.kind == NodeKind::list) {
    for (const YamlValue& item : load_list(value, "a list of points"))
      if (load_datum(item, rule.points.emplace_back())) check_point(item, rule.points.back(), points);
  } else if (node.text == (is_sided ? "pupil" : "hairline")) {
    rule.kind = is_sided ? LandmarkRule::Kind::pupil : LandmarkRule::Kind::hairline;
  } else if (!is_sided && node.text == "tongue") {
    rule.kind = LandmarkRule::Kind::tongue;
  } else if (std::string point; load_datum(value, point)) {
    check_point(value, point, points);
    rule.points = {point};
  }
  return rule;
}

void read_everyday(const DataTable& root, const char* key, const LandmarkData& data, const PointNames& points,
                   std::vector<std::pair<std::string, std::string>>& into) {
  for (const YamlEntry& entry : root.list(key))
    if (std::string word; load_datum(entry.value, word)) {
      if (find_landmark_rule(data, word) == nullptr) check_point(entry.value, word, points);
      into.emplace_back(entry.key, word);
    }
}

}  // namespace

const LandmarkRule* find_landmark_rule(const LandmarkData& data, const std::string& code) {
  for (const auto* rules : {&data.middle, &data.sided})
    for (const auto& [name, rule] : *rules)
      if (name == code) return &rule;
  return nullptr;
}

LandmarkData load_landmark_data(const std::filesystem::path& file, const PointNames& points,
                                Findings& findings) {
  LandmarkData data;
  const auto document = load_document(file, findings);
  if (!document) return data;
  const DataTable root(find_root(*document, findings));
  for (const YamlEntry& entry : root.list("middle"))
    data.middle.emplace_back(entry.key, read_rule(entry.value, points, false));
  for (const YamlEntry& entry : root.list("sided"))
    data.sided.emplace_back(entry.key, read_rule(entry.value, points, true));
  read_everyday(root, "everyday_middle", data, points, data.everyday_middle);
  read_everyday(root, "everyday_sided", data, points, data.everyday_sided);
  if (const YamlValue* needed = root.require("needed"))
    for (const YamlValue& item : load_list(*needed, "a list of codes"))
      if (std::string code; load_datum(item, code)) {
        if (find_landmark_rule(data, code) == nullptr)
          add_mistake(item, "'" + show_word(code) + "' is no code of 'middle' or 'sided'; expected one");
        data.needed.push_back(code);
      }
  return data;
}

}  // namespace mien
