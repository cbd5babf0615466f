// The fixed words that values of the YAML language may be, each with its meaning in one line. The keys of its
// mappings and the ranges of its numbers are language.hpp's.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/areas.hpp"
#include "core/staging.hpp"

namespace mien {

using Names = std::vector<std::string>;

inline constexpr int kLanguageVersion = 1;  // `mien: 1`

// An empty meaning: the word says it itself, or the data that the word stands for does (data_words.hpp).
struct Word {
  std::string_view name, meaning = {};
};

inline Names list_names(std::span<const Word> words) {
  Names names;
  for (const Word& word : words) names.emplace_back(word.name);
  return names;
}

// Names of enums stand in the enum's order (spec.hpp).
inline constexpr std::array kAgeWords{Word{"infant", "about 1 year"},
                                      Word{"child", "about 6 years"},
                                      Word{"teenager", "about 12 years"},
                                      Word{"young_adult", "about 17 years"},
                                      Word{"adult", "what the other ages are told against"},
                                      Word{"old", "about 70 years"}};
inline constexpr std::array kSkullWords{
    Word{"average", "between all others"}, Word{"square", "a broad jaw with corners"},
    Word{"round", "a round skull and jaw"}, Word{"wide", "broad for its height"},
    Word{"narrow", "high for its breadth"}};
inline constexpr std::array kCharacterWords{Word{"female", "-1"}, Word{"male", "1"}};
inline constexpr std::array kHairWords{Word{"none", "a bald head: the default"},
                                       Word{"buzz"},
                                       Word{"crop"},
                                       Word{"side_part"},
                                       Word{"pixie"},
                                       Word{"bob"},
                                       Word{"long"},
                                       Word{"wavy"},
                                       Word{"curls"},
                                       Word{"ponytail"},
                                       Word{"bun"}};  // cuts of templates/head/hair.yaml
inline constexpr std::array kBeardWords{Word{"none", "no beard"}, Word{"stubble"}, Word{"moustache"},
                                        Word{"short"}};  // beards of hair.yaml
inline constexpr std::array kGuideWords{
    Word{"mouth_line", "where the lips meet"}, Word{"nose_base", "the underside of the nose"},
    Word{"eye_line", "the middle of the eyes"}, Word{"brow_line", "the brows"},
    Word{"hairline", "where the hair begins"}};  // upward
inline constexpr std::array kEarGuideWords{
    Word{"ear_base", "the lower end of the ears"},
    Word{"ear_top", "the upper end of the ears"}};  // beside the face's
inline constexpr std::array kEasingWords{Word{"linear", "straight"},
                                         Word{"in", "sets out slowly"},
                                         Word{"out", "arrives slowly"},
                                         Word{"in_out", "sets out and arrives slowly"},
                                         Word{"hold", "stays, and jumps at the key's time"},
                                         Word{"back", "passes the key and settles"},
                                         Word{"bounce", "rebounds"}};
inline constexpr std::array kBetweenWords{Word{"ease", "each way by itself, as its `ease` says"},
                                          Word{"linear", "straight"},
                                          Word{"smooth", "a curve through all keys that never passes them"},
                                          Word{"spline", "the natural cubic spline, held at the limits"}};
inline constexpr std::array kRuleWords{Word{"over", "this one, over those below"}, Word{"add", "their sum"},
                                       Word{"max", "whoever moves it further from rest"},
                                       Word{"share", "all that say so, by their weights"}};
inline constexpr std::array kLeadWords{Word{"none", "all areas together"},
                                       Word{"natural", "the eyes first, jaw and head last"}};
inline constexpr std::array kBlinkWords{
    Word{"none", "no blinks of their own"},
    Word{"natural", "15 a minute with doubles, half blinks and blinks that go with great moves"}};
inline constexpr std::array kGazeModeWords{Word{"wander", "small fixations about where the poses look"},
                                           Word{"camera", "into the lens"}};
inline constexpr std::array kLookWords{Word{"ahead", "straight out of the head, wherever it turns"},
                                       Word{"camera", "into the lens"},
                                       Word{"left", "to the character's left"},
                                       Word{"right", "to the character's right"},
                                       Word{"up", "upward"},
                                       Word{"down", "downward"}};
inline constexpr std::array kDrawWords{Word{"ones", "a new drawing each frame: smooth"},
                                       Word{"twos", "each drawing for two frames"},
                                       Word{"threes", "each drawing for three frames: choppy"}};
inline constexpr std::array kQualityWords{
    Word{"sketch", "drawn by mien itself, ten times as quick as draft or more"},
    Word{"draft", "POV-Ray at its quickest: to see the timing"},
    Word{"good", "about twice as long as draft: the default"},
    Word{"best", "about 4 times as long as draft: for the last run"}};
inline constexpr std::array kBackgroundWords{Word{"studio", "cool grey, lighter behind the head"},
                                             Word{"light", "a bright wall"},
                                             Word{"dark", "a black room"},
                                             Word{"sun", "a flat warm yellow"},
                                             Word{"sky", "a flat light blue"},
                                             Word{"dots", "a printer's screen of dots"}};
// Behind a clip or a still from beginning to end.
inline constexpr auto kGroundWords = [] {
  std::array<Word, kBackgroundWords.size() + 1> words{};
  std::ranges::copy(kBackgroundWords, words.begin());
  words.back() = {kNoBackground, "nothing: pictures are transparent where nobody is"};
  return words;
}();
inline constexpr std::array kStyleWords{
    Word{"studio", "lit as in a photographer's studio: the default of real heads"},
    Word{"ink", "two tones and lines, as a comic is drawn: the default of drawn heads"},
    Word{"plaster", "a cast of white plaster"}};  // as Style
inline constexpr std::array kLightSetWords{
    Word{"studio", "a portrait studio: a soft key, fill and rim"},
    Word{"side", "one window in a dark room"},
    Word{"low", "a lamp on the floor"},
    Word{"candle", "one candle on the table"},
    Word{"moon", "the moon high behind"},
    Word{"rim", "a silhouette: light from behind on either side"}};  // of templates/povray
inline constexpr std::array kAreasWords{Word{"all", "what people's faces do"},
                                        Word{"nine", "Tezuka's nine, with what he moves in them"}};
inline constexpr std::array kAxisWords{Word{"x", "from ear to ear: as one nods"},
                                       Word{"y", "upright: as one shakes the head"},
                                       Word{"z", "from back to front: as a head tilts"}};
inline constexpr std::array kAreaRuleWords{Word{"house", "as skin moves: the default"},
                                           Word{"thesis", "as the thesis writes them in 5.3"}};
inline constexpr std::array kDoctrineWords{
    Word{"areas", "Tezuka's areas, and what is beyond them"},
    Word{"muscles", "muscles and rings of zones of influence: Waters 1987"},
    Word{"candide", "the animation units of CANDIDE-3: Ahlberg 2001"},
    Word{"parke", "Parke's expression parameters: 1982"}};  // as Doctrine
inline constexpr std::array kAsymmetryWords{Word{"none", "both sides alike"},
                                            Word{"natural", "0.2: as much as is seen in people"}};
inline constexpr std::array kBaseWords{Word{"round", "a disc"}, Word{"square", "a block"},
                                       Word{"plinth", "a moulded pedestal"},
                                       Word{"none", "the chest is cut flat"}};
inline constexpr std::array kTakeWords{Word{"keys"}, Word{"camera"}, Word{"turn"},    Word{"cues"},
                                       Word{"laws"}, Word{"tracks"}, Word{"scripts"}, Word{"inputs"}};
// As LeadPart; those before the head are the face's own.
inline constexpr auto kPartWords = [] {
  std::array<Word, kLeadCount> words{};
  for (std::size_t part = 0; part < kLeadCount; ++part) words[part] = {find_part_key(part)};
  return words;
}();

inline const Names kAges = list_names(kAgeWords);
inline const std::string kAdult = "adult";  // what the other ages are told against
inline const Names kSkulls = list_names(kSkullWords);
inline const Names kHairs = list_names(kHairWords);
inline const Names kBeards = list_names(kBeardWords);
inline const Names kGuides = list_names(kGuideWords);
inline const Names kEarGuides = list_names(kEarGuideWords);
inline const Names kEasings = list_names(kEasingWords);
inline const Names kBetweens = list_names(kBetweenWords);
inline const Names kRules = list_names(kRuleWords);
inline const Names kLooks = list_names(kLookWords);
inline const Names kDraws = list_names(kDrawWords);
inline const Names kQualities = list_names(kQualityWords);
inline const Names kBackgrounds = list_names(kBackgroundWords);
inline const Names kStyles = list_names(kStyleWords);
// Of a word of kStyles.
inline Style find_style(std::string_view word) {
  return static_cast<Style>(std::ranges::find(kStyles, word) - kStyles.begin());
}
inline const Names kDoctrines = list_names(kDoctrineWords);
inline const Names kTakes = list_names(kTakeWords);
inline const Names kLeadKeys = list_names(kPartWords);
inline const Names kReleaseKeys = list_names(std::span(kPartWords).first(kFacePartCount));

// A plain expression name is looked up in the file, in its `library`, and then in these.
inline const Names kEverydayLibraries{"mien", "mouths", "extras"};

}  // namespace mien
