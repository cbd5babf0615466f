#include "config/schema.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "config/language.hpp"
#include "config/quantity.hpp"
#include "config/schema_text.hpp"

namespace mien {

namespace {

using Json = nlohmann::ordered_json;

Json build_forms(const Forms& forms, const DataWords& data);

Json build_reference(std::string_view name) { return {{"$ref", fmt::format("#/$defs/{}", name)}}; }

Json build_text(const std::string& pattern) {
  Json text{{"type", "string"}};
  if (!pattern.empty()) text["pattern"] = pattern;
  return text;
}

// A whole number without a point.
Json build_number(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e15) return static_cast<std::int64_t>(value);
  return value;
}

Json build_range(const Form& form, const char* type) {
  Json number{{"type", type}};
  if (std::isfinite(form.low))
    number[form.is_above_low ? "exclusiveMinimum" : "minimum"] = build_number(form.low);
  if (std::isfinite(form.high)) number["maximum"] = build_number(form.high);
  return number;
}

Json build_quantity(const Form& form) {
  const std::vector<Unit> units = find_measure(form.kind).units;
  return {{"anyOf", {build_range(form, "number"), build_text(build_quantity_pattern(units, form.low < 0))}}};
}

Json build_word(std::string_view name, std::string_view meaning) {
  Json word{{"const", name}};
  if (!meaning.empty()) word["description"] = meaning;
  return word;
}

Json build_any(std::vector<Json> forms) {
  if (forms.size() == 1) return forms.front();
  return {{"anyOf", forms}};
}

Json build_one(std::vector<Json> words) {
  if (words.size() == 1) return words.front();
  return {{"oneOf", words}};
}

Json build_words(const Form& form, const DataWords& data) {
  std::vector<Json> words, forms;
  for (const Word& word : form.words)
    words.push_back(build_word(word.name, word.meaning.empty() ? find_meaning(data, form.data, word.name)
                                                               : std::string(word.meaning)));
  if (!words.empty()) forms.push_back(build_one(words));
  // A beard's words are the table's and only their meanings the data's; a place is the one or the other.
  if (!form.data.empty() && (form.words.empty() || !form.pattern.empty()))
    forms.push_back(build_reference(form.data));
  if (!form.pattern.empty()) forms.push_back(build_text(form.pattern));
  return build_any(forms);
}

Json build_map(const Form& form, const DataWords& data) {
  Json map{{"type", "object"}};
  if (form.low > 0) map["minProperties"] = build_number(form.low);
  const Json items = build_forms(form.items, data);
  Json properties = Json::object();
  const auto add = [&](std::string_view name, std::string_view meaning) {
    Json& item = properties[std::string(name)] = items;
    if (!meaning.empty()) item["description"] = meaning;
  };
  for (const Word& word : form.words) add(word.name, word.meaning);
  if (const auto list = data.find(form.data); list != data.end())
    for (const DataWord& word : list->second) add(word.name, word.meaning);
  if (!properties.empty()) map["properties"] = properties;
  const bool is_open = !form.pattern.empty() || properties.empty();
  map["additionalProperties"] = is_open ? items : Json(false);
  if (!form.pattern.empty() && form.data.empty()) map["propertyNames"] = build_text(form.pattern);
  if (!form.pattern.empty() && !form.data.empty())
    map["propertyNames"] = {{"anyOf", {build_reference(form.data), build_text(form.pattern)}}};
  return map;
}

Json build_section_reference(const Form& form) {
  Json reference = build_reference(form.section->name);
  if (form.excluded.empty()) return reference;
  reference["type"] = "object";
  for (const std::string& key : form.excluded) reference["properties"][key] = false;
  return reference;
}

// It, or a formula that does not change with time.
Json build_constant(const Json& number) { return {{"anyOf", {number, build_reference("constant")}}}; }

Json build_curve(const Form& form) {
  Form x;
  x.high = 1;
  const Json along = build_constant(build_range(x, "number")),
             up = build_constant(build_range(form, "number"));
  return {{"type", "array"}, {"prefixItems", {along, up, along, up}}, {"minItems", 4}, {"maxItems", 4}};
}

Json build_list(const Json& items, double low, double high) {
  Json list{{"type", "array"}, {"items", items}};
  if (low > 0) list["minItems"] = build_number(low);
  if (std::isfinite(high)) list["maxItems"] = build_number(high);
  return list;
}

Json build_form(const Form& form, const DataWords& data) {
  switch (form.kind) {
    case FormKind::version:
      return {{"const", kLanguageVersion}};
    case FormKind::word:
      return build_words(form, data);
    case FormKind::yes_no:
      return {{"type", "boolean"}};
    case FormKind::number:
      return build_range(form, "number");
    case FormKind::whole:
      return build_range(form, "integer");
    case FormKind::formula:
      return build_reference("formula");
    case FormKind::time:
      return build_reference("time");
    case FormKind::duration:
    case FormKind::seconds:
    case FormKind::length:
    case FormKind::angle:
      return build_quantity(form);
    case FormKind::lengths:
      return build_list(build_constant(build_quantity(form)), 3, 3);
    case FormKind::two_lengths:
      return build_text(build_two_lengths_pattern() + "|" + build_two_constants_pattern());
    case FormKind::size:
      return build_text(build_size_pattern(static_cast<int>(form.low), static_cast<int>(form.high)) + "|" +
                        build_two_constants_pattern());
    case FormKind::colour:
      return build_reference("colour");
    case FormKind::line: {
      Json line = build_text("^[^\\u0000-\\u001f\\u007f]*$");
      line["maxLength"] = build_number(form.high);
      return {{"anyOf", {line, {{"type", "number"}}}}};  // an unquoted 1988 is a title, too
    }
    case FormKind::tag:
      if (form.data.empty()) return build_text(form.pattern);
      return {{"anyOf", {build_reference(form.data), build_text(form.pattern)}}};
    case FormKind::file:
      return build_text(form.pattern);
    case FormKind::curve:
      return build_curve(form);
    case FormKind::list:
      return build_list(build_forms(form.items, data), form.low, form.high);
    case FormKind::map:
      return build_map(form, data);
    case FormKind::section:
      return build_section_reference(form);
  }
  return Json::object();
}

// Whether a formula that does not change with time may stand in its place; of lengths in that of each.
bool is_numeric(const Form& form) {
  switch (form.kind) {
    case FormKind::number:
    case FormKind::whole:
    case FormKind::time:
    case FormKind::duration:
    case FormKind::seconds:
    case FormKind::length:
    case FormKind::angle:
      return true;
    default:
      return false;
  }
}

Json build_forms(const Forms& forms, const DataWords& data) {
  std::vector<Json> all;
  for (const Form& form : forms) all.push_back(build_form(form, data));
  if (std::ranges::any_of(forms, is_numeric) && find_form(forms, FormKind::formula) == nullptr)
    all.push_back(build_reference("constant"));
  return build_any(all);
}

Json build_key(const Key& key, const DataWords& data) {
  Json built = build_forms(key.forms, data);
  const std::string range = describe_ranges(key.forms);
  built["description"] = range.empty() ? key.help : fmt::format("{} {}", key.help, range);
  if (!key.otherwise.empty()) {
    const Json value = Json::parse(key.otherwise, nullptr, false);
    built["default"] = value.is_discarded() ? Json(key.otherwise) : value;
  }
  return built;
}

// {"clip": {"type": "object", "properties": {"keys": false}}} for "clip.keys".
void forbid(const std::string& name, Json& properties) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) {
    properties[name] = false;
    return;
  }
  Json& owner = properties[name.substr(0, dot)];
  owner["type"] = "object";
  owner["properties"][name.substr(dot + 1)] = false;
}

void append_rules(const std::vector<KeyRule>& rules, Json& section) {
  for (const KeyRule& rule : rules) {
    const std::string& first = rule.keys.front();
    if (rule.kind == KeyRule::Kind::one_of) {
      for (const std::string& key : rule.keys)
        section["anyOf"].push_back({{"properties", {{key, true}}}, {"required", {key}}});
      continue;
    }
    for (auto other = rule.keys.begin() + 1; other != rule.keys.end(); ++other)
      if (rule.kind == KeyRule::Kind::needs)
        section["dependentRequired"][first].push_back(*other);
      else
        forbid(*other, section["dependentSchemas"][first]["properties"]);
  }
}

Json build_section(const Section& section, const DataWords& data) {
  Json built{{"type", "object"}, {"description", section.help}, {"additionalProperties", false}};
  Json required = Json::array(), properties = Json::object();
  for (const Key& key : section.keys) {
    if (key.is_required) required.push_back(key.name);
    properties[key.name] = build_key(key, data);
  }
  if (!required.empty()) built["required"] = required;
  built["properties"] = properties;
  append_rules(section.rules, built);
  return built;
}

// What a file of expressions has and others lack, and the other way round.
void append_library(const DataWords& data, Json& schema) {
  const Sections& all = find_sections();
  Json& library = schema["dependentSchemas"]["source"];
  library["properties"] = Json::object();
  for (const Key& key : all.library_file.keys) {
    if (find_key(all.file, key.name) == nullptr) schema["properties"][key.name] = build_key(key, data);
    if (!key.is_required) continue;
    library["properties"][key.name] = true;
    library["required"].push_back(key.name);
  }
  for (const Key& key : all.file.keys)
    if (find_key(all.library_file, key.name) == nullptr) forbid(key.name, library["properties"]);
}

Json build_shared(const DataWords& data) {
  Json shared;
  shared["time"] = build_quantity({FormKind::time});
  shared["time"]["description"] = "A moment: 1.5s, 36f (frames), 500ms, or a bare number of seconds.";
  shared["formula"] = build_text("^[ !#-~]*$");
  shared["formula"]["maxLength"] = kMaxFormulaLength;
  shared["formula"]["description"] =
      "A formula of the time t in seconds, in quotes: \"0.3*sin(2*pi*t/1.5)\". It may use runtime, fps, pi, "
      "inputs, + - * / ^, comparisons, a ? b : c, and functions such as sin, abs, min, max, clamp and mod.";
  shared["constant"] = build_text(build_constant_pattern());
  shared["constant"]["maxLength"] = kMaxFormulaLength;
  shared["constant"]["description"] =
      "A formula in quotes of what does not change with time: \"runtime/2\". It may use runtime (the clip's "
      "length in seconds), fps, pi, constant inputs and what other formulas use but t, and comes to the "
      "place's own unit.";
  shared["colour"] = build_text("^#[0-9a-fA-F]{6}$");
  shared["colour"]["description"] = "A colour in quotes, as an unquoted '#' begins a comment.";
  for (const char* list : {"looks", "hair_colours", "designs", "places", "libraries", "expressions"}) {
    std::vector<Json> words;
    if (const auto found = data.find(list); found != data.end())
      for (const DataWord& word : found->second) words.push_back(build_word(word.name, word.meaning));
    shared[list] = words.empty() ? Json(false) : build_one(words);
  }
  return shared;
}

}  // namespace

std::string build_schema(const DataWords& data) {
  const Sections& all = find_sections();
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "mien"}};
  schema.update(build_section(all.file, data));
  append_library(data, schema);
  schema["$defs"] = build_shared(data);
  for (const Section* section : list_sections())
    if (section != &all.file && section != &all.library_file)
      schema["$defs"][section->name] = build_section(*section, data);
  return schema.dump(1) + "\n";
}

}  // namespace mien
