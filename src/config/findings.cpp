#include "config/findings.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <tuple>

#include "config/common_words.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"

namespace mien {

namespace {

constexpr std::size_t kMaxLineShown = 200;  // bytes; a longer line would hide its message
constexpr std::size_t kMaxWordShown = 40;   // characters
constexpr std::size_t kMaxNamesShown = 40;
constexpr std::size_t kMaxWordCompared = 64;  // bytes; a longer one is no slip
constexpr std::size_t kMaxCandidates = 1000;  // names compared for a suggestion

std::string fold_word(std::string_view word) {
  std::string folded(word);
  for (char& letter : folded)
    letter = letter == '-' || letter == ' '   ? '_'
             : letter >= 'A' && letter <= 'Z' ? char(letter + 32)
                                              : letter;
  return folded;
}

bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    if (words.substr(at, end - at) == word) return true;
    at = end + 1;
  }
  return false;
}

// The first row for the word that leads to one of the names; nullptr if there is none, or if the word is one
// of them but for its letters' size.
const CommonWord* find_common_word(std::string_view word, const std::vector<std::string>& names) {
  const std::string folded = fold_word(word);
  const auto is_known = [&](std::string_view name) { return std::ranges::find(names, name) != names.end(); };
  if (folded.empty() || folded.size() > kMaxWordCompared || is_known(folded)) return nullptr;
  for (const CommonWord& row : kCommonWords)
    if (has_word(row.words, folded) && is_known(row.name)) return &row;
  return nullptr;
}

}  // namespace

bool is_full(const Findings& findings) { return findings.mistakes.size() >= kMaxMistakes; }

void add_mistake(Findings& findings, Place place, std::string message, std::string_view source_line) {
  if (is_full(findings)) {
    ++findings.untold;
    return;
  }
  if (source_line.size() > kMaxLineShown) source_line = {};
  findings.mistakes.push_back({std::move(place), std::move(message), std::string(source_line), false});
}

void throw_mistakes(Findings findings) {
  auto& mistakes = findings.mistakes;
  if (mistakes.empty()) return;
  const auto key = [](const Diagnostic& d) { return std::tie(d.place.file, d.place.line, d.place.column); };
  std::stable_sort(mistakes.begin(), mistakes.end(),
                   [&](const auto& a, const auto& b) { return key(a) < key(b); });
  // An alias repeats its text, and so its mistakes.
  const auto is_same = [&](const auto& a, const auto& b) {
    return key(a) == key(b) && a.message == b.message;
  };
  mistakes.erase(std::unique(mistakes.begin(), mistakes.end(), is_same), mistakes.end());
  if (findings.untold > 0) {
    Diagnostic more;
    more.place.file = mistakes.back().place.file;
    more.message = fmt::format("{} more mistakes are not shown", findings.untold);
    mistakes.push_back(more);
  }
  throw InputError(std::move(mistakes));
}

std::string show_word(std::string_view word) {
  std::string shown;
  std::size_t characters = 0;
  for (const char byte : word) {
    if (is_first_of_character(byte) && ++characters > kMaxWordShown) return shown + "...";
    if (static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F)
      shown += fmt::format("\\x{:02x}", static_cast<unsigned>(byte));
    else
      shown += byte;
  }
  return shown;
}

std::string join_names(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += ", ";
    if (i == kMaxNamesShown) return text + "...";
    text += show_word(names[i]);
  }
  return text;
}

std::string suggest_name(std::string_view word, const std::vector<std::string>& names) {
  const std::size_t slack = std::max<std::size_t>(1, word.size() / 3);
  if (word.size() > kMaxWordCompared) return {};
  if (const CommonWord* common = find_common_word(word, names)) return std::string(common->name);
  std::vector<std::string> candidates;
  for (const std::string& name : names)
    if (candidates.size() < kMaxCandidates && name.size() <= word.size() + slack &&
        word.size() <= name.size() + slack)
      candidates.push_back(name);

  std::string lower(word);
  for (char& letter : lower)
    letter = letter == '-' ? '_' : letter >= 'A' && letter <= 'Z' ? char(letter + 32) : letter;
  const std::string nearest = find_nearest(word, candidates);
  return nearest.empty() && lower != word ? find_nearest(lower, candidates) : nearest;
}

std::string describe_suggestion(std::string_view word, const std::vector<std::string>& names) {
  const std::string name = suggest_name(word, names);
  if (name.empty()) return {};
  const CommonWord* common = find_common_word(word, names);
  const bool has_note = common != nullptr && !common->note.empty();
  return fmt::format("did you mean '{}'{}?", name, has_note ? fmt::format(" ({})", common->note) : "");
}

std::string describe_unknown(std::string_view kind, std::string_view word,
                             const std::vector<std::string>& names) {
  std::string text = fmt::format("unknown {} '{}'; ", kind, show_word(word));
  const std::string suggestion = describe_suggestion(word, names);
  if (!suggestion.empty()) return text + suggestion;
  return text + (names.empty() ? std::string("none is known here") : "known: " + join_names(names));
}

}  // namespace mien
