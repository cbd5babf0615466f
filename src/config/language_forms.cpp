#include "config/language_forms.hpp"

#include <fmt/format.h>

#include <cctype>

#include "config/facs_notation.hpp"
#include "core/seeded.hpp"

namespace mien {

namespace {

constexpr double kMaxWeight = 1000;  // of a mix; only its proportions count

std::vector<Word> copy_words(std::span<const Word> words) { return {words.begin(), words.end()}; }

Form build_range(FormKind kind, double low, double high) {
  Form form{kind};
  form.low = low;
  form.high = high;
  return form;
}

}  // namespace

Form as_word(std::string noun, std::span<const Word> words) {
  Form form{FormKind::word};
  form.noun = std::move(noun);
  form.words = copy_words(words);
  return form;
}

Form as_data_word(std::string noun, std::string data) {
  Form form{FormKind::word};
  form.noun = std::move(noun);
  form.data = std::move(data);
  return form;
}

Form as_yes_no() {
  static constexpr std::array kYesNo{Word{"true"}, Word{"false"}};
  Form form = as_word("answer", kYesNo);
  form.kind = FormKind::yes_no;
  return form;
}

Form as_number(double low, double high, std::string unit) {
  Form form = build_range(FormKind::number, low, high);
  form.noun = std::move(unit);
  return form;
}

Form as_whole(int low, int high, std::string unit) {
  Form form = build_range(FormKind::whole, low, high);
  form.noun = std::move(unit);
  return form;
}

Form as_formula() { return {FormKind::formula}; }
Form as_duration(double low_s, double high_s) { return build_range(FormKind::duration, low_s, high_s); }
Form as_seconds(double low_s, double high_s) { return build_range(FormKind::seconds, low_s, high_s); }
Form as_length(double low_mm, double high_mm) { return build_range(FormKind::length, low_mm, high_mm); }
Form as_angle(const Bounds& bounds_deg) {
  return build_range(FormKind::angle, bounds_deg.low, bounds_deg.high);
}
Form as_lengths(double most_mm) { return build_range(FormKind::lengths, -most_mm, most_mm); }
Form as_two_lengths(double low_mm, double high_mm) {
  return build_range(FormKind::two_lengths, low_mm, high_mm);
}
Form as_size(int low_px, int high_px) { return build_range(FormKind::size, low_px, high_px); }
Form as_colour() { return {FormKind::colour}; }
Form as_line(std::size_t most_bytes) {
  return build_range(FormKind::line, 0, static_cast<double>(most_bytes));
}
Form as_curve(double low, double high) { return build_range(FormKind::curve, low, high); }

Form as_tag(std::string pattern, std::string data) {
  Form form{FormKind::tag};
  form.pattern = std::move(pattern);
  form.data = std::move(data);
  return form;
}

Form as_file(Names endings) {
  Form form{FormKind::file};
  form.pattern = build_file_pattern(endings);
  form.endings = std::move(endings);
  return form;
}

Form as_list(Forms items, double low, double high) {
  Form form = build_range(FormKind::list, low, high);
  form.items = std::move(items);
  return form;
}

Form as_section(const Section& section) {
  Form form{FormKind::section};
  form.section = &section;
  return form;
}

Form as_map(std::string pattern, Forms items, double low) {
  Form form{FormKind::map};
  form.low = low;
  form.pattern = std::move(pattern);
  form.items = std::move(items);
  return form;
}

Forms as_waiting_time(const Section& wait) { return {{FormKind::time}, as_section(wait)}; }

Forms as_mix(const std::string& noun, std::span<const Word> words) {
  Form weight = as_number(0, kMaxWeight);
  weight.is_above_low = true;
  Form mix = as_map("", {weight}, 1);
  mix.noun = noun;
  mix.words = copy_words(words);
  if (words.empty()) return {mix};
  return {as_word(noun, words), mix};
}

std::string build_key_name_pattern() { return fmt::format("^[A-Za-z0-9_-]{{1,{}}}$", kMaxKeyName); }

std::string build_actor_name_pattern() { return fmt::format("^[a-z][a-z0-9_]{{0,{}}}$", kMaxActorName - 1); }

std::string build_expression_name_pattern() {
  return fmt::format("^[A-Za-z][A-Za-z0-9_-]{{0,{}}}$", kMaxExpressionName - 1);
}

std::string build_asked_expression_pattern() {
  return fmt::format("{}|{}", build_expression_name_pattern(), build_facs_pattern());
}

std::string build_file_pattern(const Names& endings) {
  std::string any;
  for (const std::string& ending : endings) {
    any += any.empty() ? "" : "|";
    for (const char c : ending.substr(1))
      any += fmt::format("[{}{}]", c, static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
  }
  return fmt::format("[^/]\\.({})$", any);
}

std::string begin_great(std::string_view text) {
  std::string sentence(text);
  sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence + ".";
}

std::string say_colour(const glm::vec3& srgb) {
  const auto byte = [](float channel) { return static_cast<int>(channel * 255 + 0.5f); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(srgb.r), byte(srgb.g), byte(srgb.b));
}

std::string say(double value, std::string_view unit) { return fmt::format("{:.7g}{}", value, unit); }

Key build_name_key() {
  return {"name",
          {as_tag(build_key_name_pattern())},
          "A name for it, which others may wait for: `at: {after: NAME, delay: 0.3s}`."};
}

Key build_strength_key(std::string help, bool is_live) {
  Forms forms{as_number(0, 1)};
  if (is_live) forms.push_back(as_formula());
  return {"strength", forms, std::move(help), "1"};
}

Key build_exaggerate_key(std::string help) {
  return {"exaggerate", {as_number(1, kMaxExaggerate)}, std::move(help), "1"};
}

Key build_seed_key() {
  return {"seed", {as_whole(0, kMaxSeed)}, "Another seed, other moments.", say(BlinkSpec{}.seed)};
}

Key build_express_key(bool is_live) {
  Forms weight{as_number(0, 1)};
  if (is_live) weight.push_back(as_formula());
  const std::string pattern = build_asked_expression_pattern();
  Form mix = as_map(pattern, weight, 1);
  mix.data = "expressions";
  return {
      "express",
      {as_tag(pattern, "expressions"), mix},
      "An expression: one of the file's own, a plain name of the library, or `library/name`; action units of "
      "FACS such as `AU6C+AU12D`; or a mix such as `{surprise: 0.6, smile: 0.4}`.",
      "neutral"};
}

Form& find_first_form(Section& section, std::string_view name) {
  return std::ranges::find(section.keys, name, &Key::name)->forms.front();
}

std::vector<Key> copy_keys(const Section& from, const Names& names) {
  std::vector<Key> keys;
  for (const std::string& name : names)
    if (const Key* key = find_key(from, name)) keys.push_back(*key);
  return keys;
}

}  // namespace mien
