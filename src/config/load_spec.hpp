// From a YAML file to a Spec, or to the whole list of its mistakes.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "config/expressions.hpp"
#include "config/head_words.hpp"
#include "config/spec.hpp"
#include "config/speech_data.hpp"

namespace mien {

// Limits that a file may not pass; each message names the limit.
inline constexpr std::size_t kMaxFileBytes = 1 << 20;  // larger files are data, not a director's note
inline constexpr int kMaxDepth = 32;                   // nesting; YAML itself allows a stack overflow
inline constexpr int kMaxAliases = 100;                // "billion laughs" need few aliases, notes need none
inline constexpr int kMaxFrames = 100000;              // over an hour at 24 frames a second
inline constexpr int kMaxSide_px = 8192;               // POV-Ray's memory, ffmpeg's H.264 limit
inline constexpr int kMinSide_px = 16;

// What mien's own data give to every file: the libraries' expressions and the words of heads.
struct Language {
  ExpressionBook libraries;
  HeadWords words;
  SpeechDataPointer speech;
};
using LanguagePointer = std::shared_ptr<const Language>;

// Reads configs/expressions and the words of templates/head. Throws InputError with every mistake at its
// place, RunError for what cannot be read.
LanguagePointer load_language(const std::filesystem::path& data_folder);

// Reads `file`. Throws InputError with every mistake of the file at its place (unknown keys with the nearest
// known one, wrong types, values out of range, duplicate keys, unknown names).
Spec load_spec(const std::filesystem::path& file, const Language& language);

// The same of a text that `file` does not hold yet.
Spec load_spec(const std::filesystem::path& file, std::string text, const Language& language);

// The expression called `name` ("smile" in the file, then in its library; "tezuka/smile" in that one). Throws
// InputError "unknown expression 'smlie'; did you mean 'smile'?".
const Expression& find_expression(const Spec& spec, const std::string& name);

// A copy of it with the file's `exaggerate`: the face that --express asks for. In braces it is what could
// stand under `expressions:` of the file, "{from: smile, brows: {up: 0.5}}", is called "posed", and goes as
// far as it says. Throws InputError "--express: ..." on what could not.
Expression take_expression(const Spec& spec, const std::string& name);

// A bust of this expression that is printed as the file's busts are: as the first that the file lists of it;
// else with each print option that all of the file's have in common, and if each of them bears a label, with
// its own name (or the label that several share). Its strength is its own.
BustSpec build_asked_bust(const Spec& spec, Expression expression);

// Every expression of the libraries in the folder, by library and name.
std::vector<Expression> load_expression_libraries(const std::filesystem::path& folder);

// Where each library of the folder comes from, in the one line that its `source:` says; empty if it says
// none.
std::map<std::string, std::string> load_library_sources(const std::filesystem::path& folder);

// The name of out/<name>/ from a file's: one '_' for each character that is no ASCII letter, digit, '-' or
// '_'.
std::string build_name(const std::filesystem::path& file);

}  // namespace mien
