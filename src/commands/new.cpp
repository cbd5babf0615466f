// `mien new`.
#include <fmt/format.h>

#include "commands/report.hpp"
#include "commands/table.hpp"
#include "config/starter.hpp"
#include "core/data.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

void run_new(const Options& options) {
  std::filesystem::path path = options.output.value_or(options.file);
  if (path.extension() != ".yaml" && path.extension() != ".yml") path += ".yaml";
  if (std::filesystem::exists(path))
    throw InputError(fmt::format("{} exists; expected the name of a new file", path.string()));
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
