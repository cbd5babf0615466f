#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "config/data_table.hpp"
#include "config/design_data.hpp"
#include "config/words.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

// The dials that stand in a mapping; the others keep what they have.
void read_dials(const DataTable& table, DesignNumbers& numbers) {
  std::set<std::string_view> sections;
  for (const DesignDial& dial : kDesignDials) sections.insert(dial.section);
  for (const std::string_view section : sections) {
    const YamlValue* value = table.find(std::string(section));
    if (value == nullptr) continue;
    const DataTable dials(*value);
    for (const DesignDial& dial : kDesignDials) {
      if (dial.section != section) continue;
      if (const YamlValue* number = dials.find(std::string(dial.name)))
        load_number(*number, dial.low, dial.high, numbers.*dial.number);
    }
  }
}

Design read_design(const YamlValue& root, std::string name) {
  Design design{std::move(name), {}, Style::studio, {}};
  std::string word;
  const DataTable table(root);
  table.read("meaning", design.meaning);
  if (const YamlValue* style = table.require("style"))
    if (load_name(*style, "style", kStyles, word)) design.style = find_style(word);
  DesignNumbers numbers;
  read_dials(table, numbers);
  design.ages[""] = numbers;
  const YamlValue* ages = table.find("ages");
  if (ages == nullptr) return design;
  for (const YamlEntry& age : load_free_mapping(*ages, "ages with their own dials")) {
    if (!check_name(age, "age", kAges)) continue;
    DesignNumbers& own = design.ages[age.key] = numbers;
    read_dials(DataTable(age.value), own);
  }
  return design;
}

void add_numbers(const DesignNumbers& from, double weight, DesignNumbers& sum) {
  for (const DesignDial& dial : kDesignDials) sum.*dial.number += weight * from.*dial.number;
}

}  // namespace

std::vector<Design> load_designs(const fs::path& folder, Findings& findings) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<Design> designs;
  for (const fs::path& file : files)
    if (const auto document = load_document(file, findings))
      designs.push_back(read_design(find_root(*document, findings), file.stem().string()));
  return designs;
}

DesignNumbers mix_designs(const std::vector<Design>& designs, const Mix& mix, const Mix& ages) {
  DesignNumbers sum;
  for (const DesignDial& dial : kDesignDials) sum.*dial.number = 0;
  const Mix adult{{kAdult, 1.0}};
  for (const auto& [name, weight] : mix) {
    if (name == kReal) {
      add_numbers({}, weight, sum);
      continue;
    }
    const auto design = std::ranges::find(designs, name, &Design::name);
    if (design == designs.end()) throw RunError(fmt::format("there is no design '{}'", name));
    for (const auto& [age, share] : ages.empty() ? adult : ages) {
      const auto own = design->ages.find(age);
      add_numbers(own == design->ages.end() ? design->ages.at("") : own->second, weight * share, sum);
    }
  }
  return sum;
}

}  // namespace mien
