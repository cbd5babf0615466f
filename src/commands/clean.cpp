// `mien clean`.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "clip/farm.hpp"
#include "clip/trace.hpp"
#include "commands/hold.hpp"
#include "commands/report.hpp"
#include "commands/table.hpp"
#include "config/load_spec.hpp"
#include "core/error.hpp"
#include "render/plan.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> list_folders(const fs::path& folder) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_directory(error) && !entry.is_symlink(error)) folders.push_back(entry.path());
  std::ranges::sort(folders);
  return folders;
}

// The files of mien's own naming in a folder, and the folder if nothing else is in it.
void clean_folder(const fs::path& folder, bool (*is_ours)(const std::string& name), Cleaned& cleaned) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (is_ours(entry.path().filename().string()) && entry.is_regular_file(error))
      files.push_back(entry.path());
  for (const fs::path& file : files) clean_file(file, cleaned);
  fs::remove(folder, error);  // only if it is empty
}

// A clip's folder, and those of its designs within it.
void clean_clip(const Options& options, const fs::path& folder, Cleaned& cleaned) {
  std::vector<fs::path> clips = list_folders(folder);
  clips.push_back(folder);
  for (const fs::path& clip : clips) {
    constexpr std::array kParts{kStoreFolder, "frames", "scenes", kFarmFolder};
    if (std::ranges::none_of(kParts, [&](const char* part) { return fs::is_directory(clip / part); }))
      continue;
    const FolderLock lock = hold_folder(options, clip);
    clean_store({clip / kStoreFolder}, cleaned);
    clean_folder(clip / "frames", is_clip_file, cleaned);
    clean_folder(clip / "scenes", is_clip_file, cleaned);
    clean_folder(clip / kFarmFolder, is_farm_file, cleaned);
  }
}

// What is asked for: -o, else what FILE has, else all that there is.
std::vector<fs::path> find_clips(const Options& options) {
  if (options.output) return {*options.output};
  if (options.file.empty()) return list_folders("out");
  return {fs::path("out") / build_name(options.file)};
}

void run_clean(const Options& options) {
  for (const fs::path& folder : find_clips(options)) {
    if (!fs::is_directory(folder))
      throw InputError(fmt::format("{}: there is no such folder", folder.string()));
    Cleaned cleaned;
    clean_clip(options, folder, cleaned);
    if (options.is_quiet) continue;
    if (options.is_json)
      fmt::print(
          "{}\n",
          format_object({{"cleaned", folder.string()}, {"files", cleaned.files}, {"bytes", cleaned.bytes}}));
    else
      fmt::print("cleaned  {}: {} file{}, {:.1f} MB\n", folder.string(), cleaned.files,
                 cleaned.files == 1 ? "" : "s", static_cast<double>(cleaned.bytes) / 1e6);
  }
}

}  // namespace

const CommandInfo command_clean{
    "clean",
    "Pictures",
    "[FILE]",
    "empties the store of drawings of out/NAME/",
    "Removes what can be made again: the store of drawings, the numbered frames, which are names of the\n"
    "same pictures, scenes, and what a cluster was given. Clips, posters, manifests, busts and all that is\n"
    "not mien's own stay. Without a FILE the folders of all clips in out/ are cleaned.",
    "output",
    "mien clean configs/hello.yaml\nmien clean",
    run_clean};

}  // namespace mien
