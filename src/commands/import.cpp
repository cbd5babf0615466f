// `mien import`.
#include <fmt/format.h>

#include "clip/outputs.hpp"
#include "commands/report.hpp"
#include "commands/table.hpp"
#include "config/load_spec.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "import/mouth_track.hpp"
#include "render/work_folder.hpp"
#include "voice/cues_text.hpp"

namespace mien {

namespace {

constexpr double kFrameRate =
    24;  // of switch data that does not tell its own: what Rhubarb and Papagayo write

void run_import(const Options& options) {
  const MouthTrack track = load_mouth_track(options.file, kFrameRate);
  if (track.names == MouthNames::words)
    throw InputError(fmt::format(
        "{} has words and no mouths; expected phonemes or shapes (say: [{{mouths: {}}}] speaks words)",
        options.file.string(), options.file.filename().string()));
  const std::string name = build_name(options.file);
  const OutputFile output = find_output_file(options, name + ".yaml");
  check_ending(output, "file", {".yaml", ".yml"});
  std::error_code ignored;
  if (std::filesystem::exists(std::filesystem::symlink_status(output.path, ignored)))
    throw InputError(fmt::format("{} exists; expected the name of a new file", output.path.string()));
  check_output_files({output}, {});
  remove_left_parts_of(output.path);
  const LanguagePointer language = load_language(find_data_folder());
  write_file(output.path, build_cues_text(track, *language->speech, build_name(output.path),
                                          options.file.filename().string()));
  report_result(options, "file", output.path);
}

}  // namespace

const CommandInfo command_import{
    "import",
    "The file",
    "FILE",
    "the mouths of another program as cues",
    "Writes a YAML file whose script does what FILE says of a mouth: the cues of Rhubarb Lip Sync (.tsv,\n"
    ".xml, .json, .dat), of Papagayo and Moho (.dat, .pgo), of the Montreal Forced Aligner (.TextGrid), or "
    "a\n"
    "table of phonemes (.csv). `say: [{mouths: FILE}]` follows the file itself, without this.",
    "",
    "mien import line.tsv -o line.yaml",
    run_import};

}  // namespace mien
