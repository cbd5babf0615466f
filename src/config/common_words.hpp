// Words that people use for ours, so that a hint finds what no slip of the pen leads to: "sad" is 'sadness'.
// A row counts only where its name is known, so that one word may lead to several names, each at its place;
// where two are known the first one counts.
#pragma once

#include <array>
#include <string_view>

#include "config/areas.hpp"

namespace mien {

struct CommonWord {
  std::string_view words;      // apart by blanks, in small letters, '_' within a word
  std::string_view name;       // of ours
  std::string_view note = {};  // in a few words, where the name alone would be put to the wrong use
};

inline constexpr const AreaInfo &kBrowArea = find_area(Area::brow), &kLidArea = find_area(Area::lid),
                                &kEyeArea = find_area(Area::eye), &kLipsArea = find_area(Area::lips),
                                &kCornerArea = find_area(Area::corner);

// The table is read across.
// clang-format off
inline constexpr std::array kCommonWords{
    // Expressions
    CommonWord{"happy glad joyful cheerful pleased amused happiness smiling friendly grin grinning", "smile"},
    CommonWord{"happy glad joyful cheerful pleased happiness smile smiling", "joy"},
    CommonWord{"laughing laughter lol", "laugh"},
    CommonWord{"grinning", "grin"},
    CommonWord{"sad unhappy sorrow sorrowful miserable depressed grief gloomy", "sadness"},
    CommonWord{"angry mad furious rage annoyed irritated frown frowning", "anger"},
    CommonWord{"scared afraid fearful frightened terrified terror horror panic", "fear"},
    CommonWord{"surprised astonished amazed shocked shock startled astonishment amazement", "surprise"},
    CommonWord{"disgusted revolted repulsed nausea", "disgust"},
    CommonWord{"contemptuous scorn scornful disdain", "contempt"},
    CommonWord{"doubtful doubting sceptical skeptical unsure puzzled confused confusion", "doubt"},
    CommonWord{"shouting scream screaming yell yelling", "shout"},
    CommonWord{"cry weep weeping tears tearful", "crying"},
    CommonWord{"tired drowsy asleep sleep sleeping exhausted", "sleepy"},
    CommonWord{"boring boredom", "bored"},
    CommonWord{"yawning", "yawn"},
    CommonWord{"winking", "wink"},
    CommonWord{"kissing", "kiss"},
    CommonWord{"pouting sulk sulking", "pout"},
    CommonWord{"smirk smirking", "smug"},
    CommonWord{"suspicion distrust", "suspicious"},
    CommonWord{"normal default calm relaxed rest none plain", "neutral"},
    // Areas
    CommonWord{"eyebrow eyebrows", kBrowArea.plural},
    CommonWord{"eyelid eyelids", kLidArea.plural},
    CommonWord{"eyeball eyeballs gaze pupil pupils iris", kEyeArea.plural},
    CommonWord{"lip", kLipsArea.name},
    CommonWord{"mouth_corner mouth_corners", kCornerArea.plural},
    CommonWord{"eyebrow.left eyebrow_left left_eyebrow left_brow", kBrowArea.left_key},
    CommonWord{"eyebrow.right eyebrow_right right_eyebrow right_brow", kBrowArea.right_key},
    CommonWord{"eyelid.left eyelid_left left_eyelid left_lid", kLidArea.left_key},
    CommonWord{"eyelid.right eyelid_right right_eyelid right_lid", kLidArea.right_key},
    CommonWord{"eyeball.left eyeball_left left_eyeball left_eye", kEyeArea.left_key},
    CommonWord{"eyeball.right eyeball_right right_eyeball right_eye", kEyeArea.right_key},
    CommonWord{"left_corner", kCornerArea.left_key},
    CommonWord{"right_corner", kCornerArea.right_key},
    // Moves
    CommonWord{"open opened", "upper"},
    CommonWord{"open opened drop", "down"},
    CommonWord{"closed close shut pressed tight", "press"},
    CommonWord{"closed close shut", "upper", "below 0 closes it"},
    CommonWord{"raise raised lift lifted vertical", "up"},
    CommonWord{"raise raised lift lifted", "upper"},
    CommonWord{"lower lowered", "down"},
    CommonWord{"down lower lowered", "up", "below 0 is down"},
    CommonWord{"outer outward outwards wide stretch", "out"},
    CommonWord{"in inner inward inwards pucker pursed", "out", "below 0 is inward"},
    CommonWord{"rotate rotation tilt slant", "turn"},
    CommonWord{"horizontal sideways", "side"},
    CommonWord{"left", "side", "above 0 is the character's left"},
    CommonWord{"right", "side", "below 0 is the character's right"},
    // Ages and characters
    CommonWord{"baby newborn toddler", "infant"},
    CommonWord{"kid boy girl", "child"},
    CommonWord{"teen adolescent", "teenager"},
    CommonWord{"young youth", "young_adult"},
    CommonWord{"grown grown_up middle_aged mature man woman", "adult"},
    CommonWord{"elderly aged senior elder ancient", "old"},
    CommonWord{"man boy masculine", "male"},
    CommonWord{"woman girl feminine", "female"},
    // Skulls
    CommonWord{"oval normal medium", "average"},
    CommonWord{"long thin slim", "narrow"},
    CommonWord{"broad", "wide"},
    CommonWord{"boxy angular", "square"},
    // Hair and beards
    CommonWord{"shaved buzzcut buzz_cut crewcut crew_cut", "buzz"},
    CommonWord{"bald shaved clean_shaven", "none"},
    CommonWord{"short", "crop"},
    CommonWord{"medium shoulder_length", "bob"},
    CommonWord{"straight long_hair very_long", "long"},
    CommonWord{"curly curled afro", "curls"},
    CommonWord{"waves", "wavy"},
    CommonWord{"pony_tail pony", "ponytail"},
    CommonWord{"updo topknot chignon", "bun"},
    CommonWord{"parted parting", "side_part"},
    CommonWord{"full full_beard beard", "short"},
    // Skins, then colours of hair: both know "brown"
    CommonWord{"pale white", "porcelain"},
    CommonWord{"light", "fair"},
    CommonWord{"medium tan tanned", "olive"},
    CommonWord{"dark black", "deep"},
    CommonWord{"blonde golden yellow platinum light fair", "blond"},
    CommonWord{"brunette brunet dark dark_brown light_brown", "brown"},
    CommonWord{"auburn", "chestnut"},
    CommonWord{"ginger redhead orange", "red"},
    CommonWord{"gray silver", "grey"},
    CommonWord{"raven", "black"},
    // Answers
    CommonWord{"yes on", "true"},
    CommonWord{"no off", "false"},
    CommonWord{"no off false nothing", "none"}};
// clang-format on

}  // namespace mien
