// The mouths of speech: what each does, and which sounds look like it (templates/speech/visemes.yaml).
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "config/areas.hpp"
#include "config/findings.hpp"

namespace mien {

// What has to meet, whatever is said before and after.
enum class MouthContact { none, lips, teeth };

struct Viseme {
  std::string name;                          // "PP"
  std::string meaning;                       // "lips shut, as in pay - bay - may"
  Pose pose;                                 // of lips, corners, chin and tongue alone
  std::array<double, kMoveCount> insists{};  // how firmly each move stands among its neighbours, 0..1
  MouthContact contact = MouthContact::none;
  bool is_vowel = false;  // opens more where it is stressed
};

// A mouth, or two of which the first takes three fifths of the time.
using VisemeIndices = std::vector<std::size_t>;

struct SpeechData {
  std::vector<Viseme> visemes;
  std::map<std::string, VisemeIndices> phonemes;  // IPA
  std::map<std::string, VisemeIndices> rhubarb, preston_blair, arpabet;
};
using SpeechDataPointer = std::shared_ptr<const SpeechData>;

// Tells mistakes as findings at their places.
SpeechDataPointer load_speech_data(const std::filesystem::path& data_folder, Findings& findings);

}  // namespace mien
