#include "commands/hold.hpp"

#include <fmt/format.h>

#include <string>

#include "clip/trace.hpp"
#include "commands/report.hpp"
#include "core/streams.hpp"
#include "render/picture_store.hpp"
#include "render/plan.hpp"
#include "render/work_folder.hpp"

namespace mien {

namespace {

// What commands write straight into a folder of results.
bool is_result_file(const std::string& name) {
  return name == "manifest.json" || name == "poster.png" || name.starts_with("bust_") ||
         name.starts_with("plate_");
}

void report_no_lock(const Options& options, const std::filesystem::path& folder) {
  if (options.is_quiet) return;
  const std::string text = fmt::format(
      "the disk of {} has no locks; nothing keeps a second run from writing there too", folder.string());
  write_stream(stderr, options.is_json
                           ? format_object(nlohmann::ordered_json{{"kind", "note"}, {"message", text}}) + "\n"
                           : fmt::format("note: {}\n", text));
}

}  // namespace

FolderLock hold_folder(const Options& options, const std::filesystem::path& folder) {
  FolderLock lock(folder);
  if (!lock.is_held()) {
    report_no_lock(options, folder);
    return lock;
  }
  remove_left_folders(folder);
  remove_left_parts(folder, is_result_file);
  for (const char* part : {"scenes", "frames"}) {
    remove_left_folders(folder / part);
    remove_left_parts(folder / part, is_clip_file);
  }
  remove_left_folders(folder / kStoreFolder);
  remove_left_parts(folder / kStoreFolder, is_stored_file);
  return lock;
}

}  // namespace mien
