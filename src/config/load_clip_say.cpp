#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "config/load_clip.hpp"
#include "config/named_file.hpp"

namespace mien {

namespace {

constexpr std::size_t kMaxLines = 500;

Place find_value_place(const YamlValue& value) { return find_place(value.document->source, value.spot); }

// One line of text with a letter in it.
void load_said(const YamlValue& value, std::string& into) {
  const std::string expected = fmt::format("what is said, in one line of {} bytes at most", kMaxSaidLength);
  std::string text;
  if (!load_text(value, expected, text)) return;
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  const auto is_said = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0;
  };
  if (text.size() <= kMaxSaidLength && std::ranges::none_of(text, is_control) &&
      std::ranges::any_of(text, is_said))
    into = text;
  else
    add_unexpected(value, expected);
}

void load_voice(const YamlValue& value, std::string& into) {
  static const std::regex kVoice("[A-Za-z0-9_+-]{1,40}");
  const std::string expected = "a voice or language of eSpeak NG, such as de or en-gb";
  std::string text;
  if (!load_text(value, expected, text)) return;
  if (std::regex_match(text, kVoice))
    into = text;
  else
    add_unexpected(value, expected);
}

SaySpec load_line(const YamlMapping& entries, const YamlValue& item, const ClipReader& reader) {
  SaySpec line;
  line.place = line.text_place = line.voice_place = line.mouths_place = find_value_place(item);
  if (const YamlValue* at = find_value(entries, "at")) load_time(*at, reader.clock, line.at_s);
  const YamlValue* text = find_value(entries, "text");
  const YamlValue* mouths = find_value(entries, "mouths");
  if (text != nullptr) {
    load_said(*text, line.text);
    line.text_place = find_value_place(*text);
  }
  if (mouths != nullptr) {
    load_file(*mouths, line.mouths);
    line.mouths_place = find_value_place(*mouths);
  }
  if (const YamlValue* sound = find_value(entries, "sound")) load_file(*sound, line.sound);
  if (text == nullptr && mouths == nullptr)
    add_mistake(item, fmt::format("{} says nothing; expected 'text' or 'mouths'", describe_subject(item)));
  if (text != nullptr && mouths != nullptr)
    add_mistake(*mouths, "'mouths' and 'text' stand in one line; expected one of them");
  for (const char* key : {"voice", "pace"})
    if (const YamlValue* value = find_value(entries, key); value != nullptr && text == nullptr)
      add_mistake(*value, fmt::format("'{}' stands without a text; expected 'text' beside it", key));
  if (const YamlValue* voice = find_value(entries, "voice")) {
    load_voice(*voice, line.voice);
    line.voice_place = find_value_place(*voice);
  }
  for (const auto& [key, into] : {std::pair{"pace", &line.pace}, std::pair{"strength", &line.strength},
                                  std::pair{"share", &line.share}, std::pair{"still", &line.still}})
    if (const YamlValue* value = find_value(entries, key)) load_number(*value, *into);
  return line;
}

}  // namespace

void load_say(const YamlMapping& clip, const ClipReader& reader, std::vector<SaySpec>& into) {
  const YamlValue* list = find_value(clip, "say");
  if (list == nullptr) return;
  const std::vector<YamlValue> items =
      load_list(*list, "a list of lines such as [{at: 1s, text: \"I'm fine.\"}]");
  if (items.size() > kMaxLines) {
    add_mistake(*list, fmt::format("{} has {} lines; expected {} at most", describe_subject(*list),
                                   items.size(), kMaxLines));
    return;
  }
  for (const YamlValue& item : items) {
    if (!count_part(item, reader)) break;
    const YamlMapping entries = load_section(item);
    if (find_node(item).kind == NodeKind::mapping) into.push_back(load_line(entries, item, reader));
  }
  std::ranges::stable_sort(into, {}, &SaySpec::at_s);
}

}  // namespace mien
