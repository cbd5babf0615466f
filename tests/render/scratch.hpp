// A folder for one test, and programs that pretend to be povray or ffmpeg.
#pragma once

#include <gtest/gtest.h>
#include <png.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "core/text.hpp"

namespace mien {

// Empty at the start, gone at the end. Its name has what users' folders have: a blank and a letter outside
// ASCII.
struct Scratch {
  Scratch() {
    std::string name = testing::TempDir() + "mien é XXXXXX";
    path = ::mkdtemp(name.data());
  }
  ~Scratch() { std::filesystem::remove_all(path); }
  std::filesystem::path path;
};

// Puts a shell script before the real program on PATH while it lives.
struct FakeProgram {
  FakeProgram(const std::string& name, const std::string& script) {
    write_file(folder.path / name, "#!/bin/sh\n" + script);
    std::filesystem::permissions(folder.path / name, std::filesystem::perms::owner_all);
    ::setenv("PATH", (folder.path.string() + ":" + before).c_str(), 1);
  }
  ~FakeProgram() { ::setenv("PATH", before.c_str(), 1); }
  std::string before = std::getenv("PATH");
  Scratch folder;
};

// The message of the Error that `work` throws; empty if it throws none.
template <typename Error>
std::string find_message(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// How many files there are at and below `folder`, hidden ones too.
inline std::ptrdiff_t count_files(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::recursive_directory_iterator(folder),
                       std::filesystem::recursive_directory_iterator());
}

inline std::string read_or_empty(const std::filesystem::path& path) {
  return std::filesystem::exists(path) ? read_file(path) : "";
}

// True once process `id` is gone or only waits to be collected; waits two seconds at most.
inline bool is_gone(pid_t id) {
  for (int i = 0; i < 200; ++i) {
    if (::kill(id, 0) != 0) return true;
    const std::string facts = read_or_empty("/proc/" + std::to_string(id) + "/stat");
    if (facts.find(") Z") != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

// Until `file` holds `count` lines; five seconds at most.
inline void wait_for_lines(const std::filesystem::path& file, std::ptrdiff_t count) {
  for (int i = 0; i < 500 && std::ranges::count(read_or_empty(file), '\n') < count; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

using Rgb = std::array<unsigned char, 3>;

// A PNG of `width` x `height`: all of one colour but for the last pixel.
inline std::string build_picture(int width, int height, Rgb colour = {10, 10, 10},
                                 Rgb last = {255, 255, 255}) {
  std::vector<png_byte> pixels;
  for (int i = 1; i < width * height; ++i) pixels.insert(pixels.end(), colour.begin(), colour.end());
  pixels.insert(pixels.end(), last.begin(), last.end());
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 100000;
  std::string png(size, '\0');
  png_image_write_to_memory(&image, png.data(), &size, 0, pixels.data(), 0, nullptr);
  png.resize(size);
  return png;
}

}  // namespace mien
