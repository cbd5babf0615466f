// Texts as files, for the tests of the YAML language.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "config/load_spec.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "places.hpp"

namespace mien {

inline const std::filesystem::path kData = source_folder();

// The libraries and words of `data`; ours are read once for all tests.
inline LanguagePointer find_language(const std::filesystem::path& data = kData) {
  static const LanguagePointer ours = load_language(kData);
  return data == kData ? ours : load_language(data);
}

// An empty folder of the running test's own.
inline std::filesystem::path make_test_folder(const std::string& ending = "") {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) / "mien_config" / (test->name() + ending);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

// The Spec of a text, in a file "test.yaml".
inline Spec load_text(const std::string& text, const std::filesystem::path& data = kData) {
  const auto file = make_test_folder() / "test.yaml";
  write_file(file, text);
  return load_spec(file, *find_language(data));
}

// All of an error's lines, with files by their bare names.
inline std::string format_error(const InputError& error) {
  std::string text;
  for (Diagnostic diagnostic : error.diagnostics) {
    diagnostic.place.file = std::filesystem::path(diagnostic.place.file).filename();
    if (!text.empty()) text.push_back('\n');
    text += format_diagnostic(diagnostic);
  }
  return text;
}

// What is wrong with the file; empty if nothing is.
inline std::string find_mistakes(const std::filesystem::path& file,
                                 const std::filesystem::path& data = kData) {
  try {
    load_spec(file, *find_language(data));
  } catch (const InputError& error) {
    return format_error(error);
  }
  return "";
}

inline std::string find_text_mistakes(const std::string& text, const std::filesystem::path& data = kData) {
  const auto file = make_test_folder() / "test.yaml";
  write_file(file, text);
  return find_mistakes(file, data);
}

// The value of a move in a pose, by the words of the language.
inline double find_value(const Pose& pose, std::string_view area, Side side, std::string_view move) {
  return pose.values.at(find_move(area, side, move).value());
}

}  // namespace mien
