// Samples of takes, whole and broken, and what is read of them.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"
#include "import/take.hpp"
#include "places.hpp"

namespace mien {

inline std::filesystem::path find_take_sample(const std::string& name) {
  return std::filesystem::path(source_folder()) / "tests/import/takes" / name;
}

inline std::string read_take_sample(const std::string& name) { return read_file(find_take_sample(name)); }

inline std::filesystem::path write_take_file(const std::string& name, const std::string& bytes) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "mien_takes" / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

// What is said of the bytes, with the file's bare name and without the line shown; empty if they are read.
inline std::string find_take_fault(const std::string& name, const std::string& bytes, TakeKind kind) {
  try {
    load_take(write_take_file(name, bytes), kind);
  } catch (const InputError& e) {
    Diagnostic diagnostic = e.diagnostics.at(0);
    diagnostic.place.file = std::filesystem::path(diagnostic.place.file).filename();
    diagnostic.source_line.clear();
    return format_diagnostic(diagnostic);
  }
  return "";
}

// The same of a sample with the first `from` of it as `to`.
inline std::string find_broken_take_fault(const std::string& name, TakeKind kind, const std::string& from,
                                          const std::string& to) {
  std::string text = read_take_sample(name);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << name << " has no '" << from << "'";
  return at == text.npos ? text : find_take_fault(name, text.replace(at, from.size(), to), kind);
}

// A channel's value in a row.
inline double find_take_value(const Take& take, std::size_t row, std::string_view name) {
  for (std::size_t i = 0; i < take.channels.size(); ++i)
    if (take.channels[i].name == name)
      return static_cast<double>(take.values.at(row * take.channels.size() + i));
  ADD_FAILURE() << "no channel " << name;
  return 0;
}

}  // namespace mien
