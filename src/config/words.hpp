// Every fixed word of the YAML language: the names a value may have, and the keys of each mapping.
#pragma once

#include <string>
#include <vector>

#include "config/areas.hpp"

namespace mien {

using Names = std::vector<std::string>;

// The keys of the first `count` parts of LeadPart.
inline Names list_part_keys(std::size_t count) {
  Names keys;
  for (std::size_t part = 0; part < count; ++part) keys.emplace_back(find_part_key(part));
  return keys;
}

inline constexpr int kLanguageVersion = 1;  // `mien: 1`

// Names. Those of enums stand in the enum's order (spec.hpp).
inline const Names kAges{"infant", "child", "teenager", "young_adult", "adult", "old"};
inline const std::string kAdult = "adult";  // what the other ages are told against
inline const Names kSkulls{"average", "square", "round", "wide", "narrow"};
inline const Names kCharacters{"female", "male"};
inline const Names kHairs{
    "none", "buzz", "crop",  "side_part", "pixie", "bob",
    "long", "wavy", "curls", "ponytail",  "bun"};  // none, and the cuts of templates/head/hair.yaml
inline const Names kBeards{"none", "stubble", "moustache", "short"};  // none, and the beards of hair.yaml
inline const Names kGuides{"mouth_line", "nose_base", "eye_line", "brow_line", "hairline"};  // upward
inline const Names kEarGuides{"ear_base", "ear_top"};  // beside the face's
inline const Names kEasings{"linear", "in", "out", "in_out", "hold", "back", "bounce"};
inline const Names kBetweens{"ease", "linear", "smooth", "spline"};
inline const Names kRules{"over", "add", "max", "share"};
inline const Names kLeads{"none", "natural"};
inline const Names kBlinkStyles{"none", "natural"};
inline const Names kGazeWords{"wander", "camera"};
inline const Names kLooks{"ahead", "camera", "left", "right", "up", "down"};
inline const Names kDraws{"ones", "twos", "threes"};  // held for 1, 2, 3 frames
inline const Names kQualities{"draft", "good", "best"};
inline const Names kBackgrounds{"studio", "light", "dark"};
inline const Names kLightSets{"studio", "side", "low", "candle", "moon", "rim"};  // of templates/povray

// A plain expression name is looked up in the file, in its `library`, and then in these.
inline const Names kEverydayLibraries{"mien", "mouths", "extras"};

// Keys.
inline const Names kFileKeys{"mien",        "title", "head",   "library", "exaggerate",
                             "expressions", "clip",  "render", "busts",   "actors"};
inline const Names kLibraryFileKeys{"mien", "library", "source", "expressions"};
inline const Names kHeadKeys{"age",  "skull", "character", "guides", "features", "look",  "mesh",
                             "scan", "mix",   "sculpt",    "hair",   "limits",   "random"};
inline const Names kGrowthKeys{"age", "skull", "character", "guides", "features", "look"};
inline const Names kSculptKeys{"at", "move", "radius"};
inline const Names kLookKeys{"skin", "lips", "iris", "brow", "hair", "beard", "freckles", "age_spots"};
inline const Names kExpressionKeys{"from",   "strength",  "exaggerate",
                                   "attack", "dominance", "growth"};  // and every area's
inline const Names kClipKeys{"fps",       "draw",    "keys",    "camera",    "turn", "blink",
                             "blinks",    "length",  "between", "lead",      "cues", "laws",
                             "tracks",    "scripts", "inputs",  "include",   "gaze", "drift",
                             "asymmetry", "head",    "light",   "background"};
inline const Names kPoseKeyKeys{"at",   "express", "strength", "exaggerate", "areas",
                                "ease", "between", "name",     "release"};
inline const Names kCameraKeys{"at", "angle", "height", "distance", "look_at", "lens", "ease", "between"};
inline const Names kTurnKeys{"at", "turn", "nod", "tilt", "ease", "between", "name"};
inline const Names kDrawKeys{"at", "on"};
inline const Names kLeadKeys = list_part_keys(kLeadCount);         // as LeadPart
inline const Names kReleaseKeys = list_part_keys(kFacePartCount);  // of the face, as LeadPart
inline const Names kCueKeys{"from", "to",      "express",  "play",       "with",  "repeat", "attack",
                            "hold", "release", "strength", "exaggerate", "areas", "rule",   "name"};
inline const Names kLawKeys{"area", "move", "value", "from", "to", "range", "attack", "release", "rule"};
inline const Names kTrackKeys{"csv", "at", "between", "attack", "release", "rule"};
inline const Names kScriptKeys{"length", "parameters", "keys", "cues", "turn", "laws", "between"};
inline const Names kIncludeKeys{"file", "at", "take"};
inline const Names kTakes{"keys", "camera", "turn", "cues", "laws", "tracks", "scripts", "inputs"};
inline const Names kHeadTrackKeys{"at",       "age",  "skull", "character", "guides",
                                  "features", "look", "ease",  "name"};
inline const Names kLightKeys{"at", "set", "brightness", "angle", "ease"};
inline const Names kBackgroundKeys{"at", "show", "ease"};
inline const Names kSharedClipKeys{"fps", "draw", "length", "camera", "light", "background"};  // with actors
inline const Names kActorKeys{"head", "place", "clip"};
inline const Names kPlaceKeys{"at", "turn"};
inline const Names kWaitKeys{"after", "delay"};  // of a time that counts from another one
inline const Names kBlinkKeys{"per_minute", "seed", "style", "doubles", "partial", "shifts"};
inline const Names kGazeKeys{"keys", "look", "wander", "seed"};
inline const Names kGazeKeyKeys{"at", "look"};
inline const Names kDirectionKeys{"side", "up"};
inline const Names kDriftKeys{"amount", "seed", "stillness", "breath"};
inline const Names kAsymmetryWords{"none", "natural"};
inline const Names kAsymmetryKeys{"amount", "seed"};
inline const Names kRenderKeys{"size", "quality", "background"};
inline const Names kBustKeys{"express", "strength", "exaggerate", "areas", "height", "base",
                             "label",   "hollow",   "wall",       "drain", "magnet", "triangles"};
inline const Names kBustSetKeys{"all",   "plate",  "strength", "exaggerate", "height", "base",
                                "label", "hollow", "wall",     "drain",      "magnet", "triangles"};
inline const Names kBases{"round", "square", "plinth", "none"};
inline const Names kYesNo{"true", "false"};

// Where a key belongs that was written in another place.
struct Section {
  std::string name;  // empty: the top of the file
  Names keys;
};
inline const std::vector<Section> kSections{
    {"", kFileKeys}, {"head", kHeadKeys}, {"clip", kClipKeys}, {"render", kRenderKeys}};

}  // namespace mien
