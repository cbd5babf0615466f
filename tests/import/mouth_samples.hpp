// Samples of mouth tracks, whole and broken, and what is read of them.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"
#include "import/mouth_track.hpp"
#include "places.hpp"

namespace mien {

inline std::string read_mouth_sample(const std::string& name) {
  return read_file(std::filesystem::path(source_folder()) / "tests/import/mouths" / name);
}

inline std::filesystem::path write_mouth_file(const std::string& name, const std::string& bytes) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "mien_mouths" / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

// What is said of the file, with its bare name and without the line shown; empty if it is read.
inline std::string find_mouth_fault(const std::filesystem::path& file, double fps = 24) {
  try {
    load_mouth_track(file, fps);
  } catch (const InputError& e) {
    Diagnostic diagnostic = e.diagnostics.at(0);
    diagnostic.place.file = std::filesystem::path(diagnostic.place.file).filename();
    diagnostic.source_line.clear();
    return format_diagnostic(diagnostic);
  }
  return "";
}

inline std::string find_mouth_fault(const std::string& name, const std::string& bytes, double fps = 24) {
  return find_mouth_fault(write_mouth_file(name, bytes), fps);
}

inline std::string describe_mouth_cues(const std::vector<MouthCue>& cues) {
  std::string text;
  for (const MouthCue& cue : cues)
    text += fmt::format("{:.6g} {:.6g} {} :{}\n", cue.from_s, cue.to_s, cue.name, cue.line);
  return text;
}

inline MouthTrack load_mouth_bytes(const std::string& name, const std::string& bytes, double fps = 24) {
  return load_mouth_track(write_mouth_file(name, bytes), fps);
}

inline MouthTrack load_mouth_sample(const std::string& name, double fps = 24) {
  return load_mouth_bytes(name, read_mouth_sample(name), fps);
}

// The sample with the first `from` of it as `to`.
inline std::string break_sample(const std::string& name, const std::string& from, const std::string& to) {
  std::string text = read_mouth_sample(name);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << name << " has no '" << from << "'";
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

// One mistake: what of the sample becomes what, and what is said then, behind the file's name.
struct BrokenMouth {
  std::string from, to, fault;
};

inline void expect_mouth_faults(const std::string& name, std::initializer_list<BrokenMouth> mistakes) {
  for (const BrokenMouth& mistake : mistakes)
    EXPECT_EQ(find_mouth_fault(name, break_sample(name, mistake.from, mistake.to)), name + mistake.fault)
        << "'" << mistake.from << "' as '" << mistake.to << "'";
}

}  // namespace mien
