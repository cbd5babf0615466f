// `mien import`.
#include <fmt/format.h>

#include "commands/import_pose.hpp"
#include "commands/import_take.hpp"
#include "commands/report.hpp"
#include "commands/table.hpp"
#include "config/load_spec.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "import/mouth_track.hpp"
#include "import/take.hpp"
#include "import/unit_pose.hpp"
#include "render/work_folder.hpp"
#include "voice/cues_text.hpp"

namespace mien {

namespace {

constexpr double kFrameRate =
    24;  // of switch data that does not tell its own: what Rhubarb and Papagayo write

void import_mouths(const Options& options) {
  const MouthTrack track = load_mouth_track(options.file, options.take.fps.value_or(kFrameRate));
  if (track.names == MouthNames::words)
    throw InputError(fmt::format(
        "{} has words and no mouths; expected phonemes or shapes (say: [{{mouths: {}}}] speaks words)",
        options.file.string(), options.file.filename().string()));
  const std::filesystem::path output = find_import_output(options);
  remove_left_parts_of(output);
  const LanguagePointer language = load_language(find_data_folder());
  write_file(output,
             build_cues_text(track, *language->speech, build_name(output), options.file.filename().string()));
  report_result(options, "file", output);
}

void run_import(const Options& options) {
  if (is_unit_pose(options.file)) return import_pose(options);
  if (find_ending(options.file) == ".vrm") return import_avatar(options);
  switch (guess_take_kind(options.file)) {
    case TakeGuess::live_link:
      return import_take(options, TakeKind::live_link);
    case TakeGuess::arkit:
      return import_take(options, TakeKind::arkit);
    case TakeGuess::openface:
      return import_take(options, TakeKind::openface);
    case TakeGuess::tracks:
      return import_take(options, TakeKind::tracks);
    case TakeGuess::vrma:
      return import_take(options, TakeKind::vrma);
    case TakeGuess::gltf:
      return import_take(options, TakeKind::gltf);
    case TakeGuess::none:
      return import_mouths(options);
  }
}

}  // namespace

const CommandInfo command_import{
    "import",
    "The file",
    "FILE",
    "what other programs recorded of a face, as keys and cues",
    "Writes a YAML file that does what FILE says. Takes of a face become keys: of Live Link Face (.csv),\n"
    "MediaPipe and recorders of ARKit (.json), OpenFace 2 (.csv), OpenFaceFX (.json), VRM animation\n"
    "(.vrma), and heads that glTF animates (.glb, .gltf); what of a take our areas cannot do is told. An\n"
    "expression of MPFB (.json) or MakeHuman (.mhpose) becomes one of ours, and those of an avatar of VRM\n"
    "(.vrm) do by their names. What FILE says of a mouth becomes a script: the cues of Rhubarb Lip Sync\n"
    "(.tsv, .xml, .json, .dat), of Papagayo and Moho (.dat, .pgo), of the Montreal Forced Aligner\n"
    "(.TextGrid), or a table of phonemes (.csv). `tracks:` and `say:` follow the files themselves, without\n"
    "this.",
    "keys strict smooth fps",
    "mien import take.csv -o take.yaml\n"
    "mien import take.csv --keys 1mm --strict 20 -o take.yaml\n"
    "mien import line.tsv -o line.yaml",
    run_import};

}  // namespace mien
