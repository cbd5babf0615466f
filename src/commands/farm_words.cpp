#include "commands/farm_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "config/words.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

// A file's name that begins with a dash is no option.
std::string keep_name(const fs::path& file) {
  const std::string name = file.string();
  return name.starts_with("-") ? "./" + name : name;
}

}  // namespace

FarmWords list_farm_words(const Options& options) {
  std::error_code ignored;
  std::vector<std::string> words{fs::read_symlink("/proc/self/exe", ignored).string(), "render",
                                 keep_name(options.file)};
  const auto add = [](std::vector<std::string>& to, const char* name, const std::string& value) {
    to.push_back(fmt::format("--{}={}", name, value));
  };
  for (const fs::path& output : options.outputs) add(words, "output", output.string());
  if (options.frames)
    add(words, "frames", fmt::format("{}-{}", options.frames->first, options.frames->second));
  if (options.size_px)
    add(words, "size", fmt::format("{}x{}", options.size_px->first, options.size_px->second));
  if (options.quality) add(words, "quality", kQualities[static_cast<std::size_t>(*options.quality)]);
  if (!options.beside.empty()) add(words, "beside", fmt::format("{}", fmt::join(options.beside, ",")));
  if (options.nice) add(words, "nice", std::to_string(*options.nice));
  add(words, "jobs", std::to_string(std::max(options.jobs, 1)));
  FarmWords farm{words, words, {}};
  if (options.store_bytes) add(farm.clip, "store", std::to_string(*options.store_bytes));
  if (options.has_scenes) farm.clip.emplace_back("--keep-scenes");
  const VideoOptions& video = options.video;
  if (video.plays > 0)
    add(farm.clip, "loop", std::to_string(video.plays));
  else if (video.rounds > 1)
    farm.clip.emplace_back("--loop");
  if (video.is_boomerang) farm.clip.emplace_back("--boomerang");
  if (video.has_slate) farm.clip.emplace_back("--slate");
  const FarmOptions& how = options.farm;
  farm.asked = fmt::format("{}\n{}\n{}\n{}\n{}", fmt::join(farm.clip, "\n"), how.partition, how.time_limit,
                           how.chunk_s.value_or(0), how.chunk_drawings.value_or(0));
  return farm;
}

std::string name_farm_jobs(const std::string& clip_name, const fs::path& folder) {
  constexpr std::size_t kLongest = 40, kDigits = 8;
  std::string name = "mien_" + clip_name.substr(0, kLongest);
  std::ranges::replace_if(
      name,
      [](char c) {
        return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-');
      },
      '_');
  return name + "_" + hash_hex(folder.lexically_normal().string()).substr(0, kDigits);
}

}  // namespace mien
