// `mien new`.
#include <fmt/format.h>

#include "clip/outputs.hpp"
#include "commands/report.hpp"
#include "commands/table.hpp"
#include "config/starter.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "render/work_folder.hpp"

namespace mien {

namespace {

// NAME or what -o names, with the ending of a file of ours if it has none.
OutputFile find_new_file(const Options& options) {
  OutputFile file = find_output_file(options, options.file);
  if (has_file_ending(file.path))
    check_ending(file, "file", {".yaml", ".yml"});
  else
    file.path += ".yaml";
  return file;
}

void run_new(const Options& options) {
  const OutputFile output = find_new_file(options);
  const std::filesystem::path& path = output.path;
  std::error_code ignored;
  if (std::filesystem::exists(std::filesystem::symlink_status(path, ignored)))
    throw InputError(fmt::format("{} exists; expected the name of a new file", path.string()));
  check_output_files({output}, {});
  remove_left_parts_of(path);
  write_file(path, load_starter(find_data_folder(), build_name(path), options.random_head));
  report_result(options, "file", path);
}

}  // namespace

const CommandInfo command_new{
    "new",
    "The file",
    "NAME",
    "a commented file to begin with",
    "Writes NAME.yaml with a short performance and a comment on every part of the language. With\n"
    "--random-head its head is one of a crowd, the same as `head: {random: SEED}` gives, with its\n"
    "skull, character, features, look and hair in words to go on from.",
    "random-head",
    "mien new my_face && mien render my_face.yaml\nmien new otto --random-head 7",
    run_new};

}  // namespace mien
