// `mien clean`.
#include <fmt/format.h>

#include <cstdio>

#include "clip/clip.hpp"
#include "clip/trace.hpp"
#include "commands/hold.hpp"
#include "commands/report.hpp"
#include "commands/table.hpp"
#include "config/design_data.hpp"
#include "core/data.hpp"
#include "core/streams.hpp"
#include "render/plan.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

// The files of mien's own naming in a folder, and the folder if nothing else is in it.
void clean_folder(const fs::path& folder, Cleaned& cleaned) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (is_clip_file(entry.path().filename().string()) && entry.is_regular_file(error))
      files.push_back(entry.path());
  for (const fs::path& file : files) clean_file(file, cleaned);
  fs::remove(folder, error);  // only if it is empty
}

void clean_clip(const Options& options, const fs::path& folder, Cleaned& cleaned) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) return;
  const FolderLock lock = hold_folder(options, folder);
  clean_store({folder / kStoreFolder}, cleaned);
  for (const char* part : {"frames", "scenes"}) clean_folder(folder / part, cleaned);
}

void run_clean(const Options& options) {
  const auto language = load_language(find_data_folder());
  const Spec spec = load_request(options, *language);
  const fs::path folder = find_output(options, spec);
  Cleaned cleaned;
  clean_clip(options, folder, cleaned);
  clean_clip(options, folder / kReal, cleaned);
  for (const LookWord& design : language->words.designs) clean_clip(options, folder / design.name, cleaned);
  if (options.is_quiet) return;
  if (options.is_json)
    fmt::print("{}\n",
               format_object(nlohmann::ordered_json{
                   {"cleaned", folder.string()}, {"files", cleaned.files}, {"bytes", cleaned.bytes}}));
  else
    fmt::print("cleaned  {}: {} file{}, {:.1f} MB\n", folder.string(), cleaned.files,
               cleaned.files == 1 ? "" : "s", static_cast<double>(cleaned.bytes) / 1e6);
}

}  // namespace

const CommandInfo command_clean{
    "clean",
    "Pictures",
    "FILE",
    "empties the store of drawings of out/NAME/",
    "Removes what can be made again: the store of drawings, the numbered frames, which are names of the "
    "same\n"
    "pictures, and scenes. Clips, posters, manifests, busts and all that is not mien's own stay.",
    "",
    "mien clean configs/hello.yaml",
    run_clean};

}  // namespace mien
