// The names that programs have for mouths and phonemes.
//   Rhubarb        DanielSWolf/rhubarb-lip-sync README, "Mouth shapes"
//   Preston Blair  the ten mouths of P. Blair, Cartoon Animation, as Moho and Papagayo call them
//   ARPAbet        the 39 phonemes of CMUdict; a vowel may end with its stress, 0 to 2
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "core/utf8.hpp"
#include "import/mouth_reading.hpp"

namespace mien {

namespace {

constexpr std::array<std::string_view, 9> kRhubarbShapes{"A", "B", "C", "D", "E", "F", "G", "H", "X"};
constexpr std::array<std::string_view, 10> kPrestonBlairMouths{"AI", "E",  "O",   "U",  "etc",
                                                               "L",  "WQ", "MBP", "FV", "rest"};
constexpr std::array<std::string_view, 15> kArpabetVowels{"AA", "AE", "AH", "AO", "AW", "AY", "EH", "ER",
                                                          "EY", "IH", "IY", "OW", "OY", "UH", "UW"};
constexpr std::array<std::string_view, 24> kArpabetConsonants{"B",  "CH", "D",  "DH", "F",  "G", "HH", "JH",
                                                              "K",  "L",  "M",  "N",  "NG", "P", "R",  "S",
                                                              "SH", "T",  "TH", "V",  "W",  "Y", "Z",  "ZH"};
// MFA's own, the Penn aligner's, MAUS's and Festival's; of what was not understood nobody knows the mouth.
constexpr std::array<std::string_view, 8> kSilences{"", "sil", "sp", "spn", "pau", "<eps>", "<p:>", "<unk>"};

constexpr std::size_t kLongestIpa = 16;  // characters: a diphthong with marks has some eight

bool is_among(std::span<const std::string_view> names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

bool is_arpabet(std::string_view name) {
  if (is_among(kArpabetVowels, name) || is_among(kArpabetConsonants, name)) return true;
  const bool has_stress = !name.empty() && name.back() >= '0' && name.back() <= '2';
  return has_stress && is_among(kArpabetVowels, name.substr(0, name.size() - 1));
}

// Of ASCII, IPA has small letters and a few signs; people write ' for an ejective and : for what is long.
bool is_ipa(std::string_view name) {
  constexpr std::string_view kSigns = ".:|!'";
  const bool is_right = std::ranges::all_of(name, [&](char c) {
    return static_cast<unsigned char>(c) >= 0x80 || (c >= 'a' && c <= 'z') || kSigns.find(c) != kSigns.npos;
  });
  return is_right && !name.empty() && count_characters(name) <= kLongestIpa;
}

std::string list_names(std::span<const std::string_view> names) {
  std::string list(names.front());
  for (const std::string_view name : names.subspan(1))
    list += (name == names.back() ? " or " : ", ") + std::string(name);
  return list;
}

std::string describe_names(MouthNames names) {
  switch (names) {
    case MouthNames::rhubarb:
      return list_names(kRhubarbShapes);
    case MouthNames::preston_blair:
      return list_names(kPrestonBlairMouths);
    case MouthNames::arpabet: {
      std::vector<std::string_view> all(kArpabetVowels.begin(), kArpabetVowels.end());
      all.insert(all.end(), kArpabetConsonants.begin(), kArpabetConsonants.end());
      std::ranges::sort(all);
      return list_names(all) + ", vowels with a stress from 0 to 2 or without";
    }
    case MouthNames::ipa:
      return "one in IPA, such as a, tʃ or iː";
    case MouthNames::words:
      break;
  }
  return "a word";
}

}  // namespace

bool is_mouth_name(MouthNames names, std::string_view name) {
  switch (names) {
    case MouthNames::rhubarb:
      return is_among(kRhubarbShapes, name);
    case MouthNames::preston_blair:
      return is_among(kPrestonBlairMouths, name);
    case MouthNames::arpabet:
      return is_arpabet(name);
    case MouthNames::ipa:
      return is_ipa(name);
    case MouthNames::words:
      break;
  }
  return !name.empty();
}

void check_mouth_name(const MouthText& text, MouthNames names, MouthWord name) {
  if (is_mouth_name(names, name.word)) return;
  const bool is_mouth = names == MouthNames::rhubarb || names == MouthNames::preston_blair;
  fail_at(text, name.at,
          fmt::format("unknown {} '{}'; expected {}", is_mouth ? "mouth" : "phoneme", show_words(name.word),
                      describe_names(names)));
}

MouthNames find_mouth_names(const MouthText& text, const std::vector<MouthWord>& names,
                            std::initializer_list<MouthNames> kinds) {
  MouthNames best = *kinds.begin();
  std::size_t most = 0;
  for (const MouthNames kind : kinds) {
    const auto count = static_cast<std::size_t>(
        std::ranges::count_if(names, [&](const MouthWord& name) { return is_mouth_name(kind, name.word); }));
    if (count <= most) continue;
    best = kind;
    most = count;
  }
  for (const MouthWord& name : names) check_mouth_name(text, best, name);
  return best;
}

bool is_silence(std::string_view name) {
  std::string small(name);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return is_among(kSilences, small);
}

std::string_view strip_punctuation(std::string_view word) {
  static constexpr std::string_view kSigns[] = {"“", "”", "„", "«", "»", "…",     "—",
                                                "–", "♪", "♫", "¿", "¡", "\u00A0"};
  const auto is_sign = [](char c) {
    return std::ispunct(static_cast<unsigned char>(c)) && c != '\'' && static_cast<unsigned char>(c) < 0x80;
  };
  for (bool is_changed = true; is_changed && !word.empty();) {
    const std::size_t before = word.size();
    while (!word.empty() && is_sign(word.front())) word.remove_prefix(1);
    while (!word.empty() && is_sign(word.back())) word.remove_suffix(1);
    for (const std::string_view sign : kSigns) {
      if (word.starts_with(sign)) word.remove_prefix(sign.size());
      if (word.ends_with(sign)) word.remove_suffix(sign.size());
    }
    is_changed = word.size() != before;
  }
  return word;
}

}  // namespace mien
