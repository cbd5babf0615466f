// `mien watch`.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "clip/outputs.hpp"
#include "clip/pictures.hpp"
#include "clip/sound.hpp"
#include "commands/hold.hpp"
#include "commands/sketch_clip.hpp"
#include "commands/table.hpp"
#include "core/data.hpp"
#include "core/diagnostics.hpp"
#include "core/error.hpp"
#include "core/streams.hpp"
#include "render/file_watch.hpp"
#include "render/process.hpp"

namespace mien {

namespace {

// One save: the file is read and judged, what changed is sketched. Mistakes are told, and the last clip
// stays. Returns the files that the next save may be of.
std::vector<std::filesystem::path> follow_save(const Options& options, const Resources& resources,
                                               std::vector<std::filesystem::path> files, SketchStore& store,
                                               FigureStore& figures) {
  try {
    const ClipParts planned = plan_parts(options, resources);
    files = planned.clip.spec.files;
    check_sketch_folder(options, planned.clip);
    check_sound(planned.clip);
    const std::vector<Cast> casts = build_casts(planned, resources.heads, &figures);
    const FolderLock lock = hold_folder(options, planned.clip.files.folder);
    sketch_clip(options, planned, casts, resources, &store);
  } catch (const InputError& error) {
    write_diagnostics(error.diagnostics, options.is_json);
  } catch (const RunError& error) {
    write_diagnostics(InputError(error.what()).diagnostics, options.is_json);
  }
  std::fflush(stdout);  // whoever follows a pipe learns it now
  if (std::ranges::find(files, options.file) == files.end()) files.push_back(options.file);
  return files;
}

void run_watch(const Options& asked) {
  const Resources resources = load_resources(find_data_folder());
  require_programs({{"ffmpeg", "ffmpeg"}, {"ffprobe", "ffmpeg"}});
  Options options = asked;
  options.quality = Quality::sketch;
  if (!std::filesystem::exists(options.file)) load_request(options, *resources.stock.language);  // says so
  FileWatch watch;
  SketchStore store;
  FigureStore figures;
  std::vector<std::filesystem::path> files{options.file};
  try {
    while (true) {
      set_watched_files(watch, files);  // before they are read: no save is missed
      files = follow_save(options, resources, std::move(files), store, figures);
      set_watched_files(watch, files);
      if (!options.is_quiet && !options.is_json)
        write_stream(stderr, fmt::format("watching {}; Ctrl-C ends\n", options.file.string()));
      wait_for_save(watch);
    }
  } catch (const Interrupted&) {  // which is how it ends
  }
}

}  // namespace

const CommandInfo command_watch{"watch",
                                "Pictures",
                                "FILE",
                                "a sketched clip that follows the file as you save it",
                                "Sketches the clip, waits, and whenever the file (or one that it includes) "
                                "is saved, sketches the drawings\n"
                                "that changed into the same clip, out/NAME/NAME_sketch.mp4: a player that "
                                "loops shows the newest. Mistakes\n"
                                "are told and the last good clip stays. Ctrl-C ends.",
                                "beside",
                                "mien watch configs/hello.yaml\nmien watch face.yaml --size 240x300",
                                run_watch};

}  // namespace mien
