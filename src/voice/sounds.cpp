#include "voice/sounds.hpp"

#include <algorithm>

namespace mien {

namespace {

constexpr double kFirstShare = 0.6;

// Where the letter at `at` of UTF-8 ends.
std::size_t find_letter_end(std::string_view text, std::size_t at) {
  ++at;
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) ++at;
  return at;
}

}  // namespace

VisemeIndices find_ipa_visemes(const SpeechData& data, std::string_view ipa) {
  constexpr std::size_t kMostLetters = 2;  // of a name
  VisemeIndices visemes;
  for (std::size_t at = 0; at < ipa.size();) {
    std::size_t end = at, next = find_letter_end(ipa, at);
    const VisemeIndices* found = nullptr;
    for (std::size_t letters = 0; letters < kMostLetters && end < ipa.size(); ++letters) {
      end = find_letter_end(ipa, end);
      const auto known = data.phonemes.find(std::string(ipa.substr(at, end - at)));
      if (known == data.phonemes.end()) continue;
      found = &known->second;
      next = end;
    }
    if (found != nullptr) visemes.insert(visemes.end(), found->begin(), found->end());
    at = next;
  }
  return visemes;
}

void append_segments(const VisemeIndices& visemes, double from_s, double to_s, int stress,
                     std::vector<MouthSegment>& into) {
  const std::size_t count = visemes.size();
  const double first = count == 2 ? kFirstShare : count == 0 ? 0 : 1.0 / static_cast<double>(count);
  double begin_s = from_s;
  for (std::size_t i = 0; i < count; ++i) {
    const double way =
        i == 0 ? first : first + (1 - first) * static_cast<double>(i) / static_cast<double>(count - 1);
    const double end_s = i + 1 == count ? to_s : from_s + way * (to_s - from_s);
    into.push_back({begin_s, end_s, visemes[i], stress});
    begin_s = end_s;
  }
}

std::vector<MouthSegment> list_segments(const SpeechData& data, const std::vector<SpeechSound>& sounds) {
  std::vector<MouthSegment> segments;
  for (const SpeechSound& sound : sounds)
    append_segments(find_ipa_visemes(data, sound.ipa), sound.from_s, sound.to_s, sound.stress, segments);
  return segments;
}

}  // namespace mien
