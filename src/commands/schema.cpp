// `mien schema`.
#include <fmt/format.h>

#include "commands/table.hpp"
#include "config/schema.hpp"
#include "core/data.hpp"

namespace mien {

namespace {

void run_schema(const Options& options) {
  static_cast<void>(options);  // none says anything to it
  fmt::print("{}", build_schema(load_data_words(find_data_folder())));
}

}  // namespace

const CommandInfo command_schema{
    "schema",
    "The file",
    "",
    "the JSON Schema of the file, for editors",
    "Prints the JSON Schema of the YAML file. Editors complete and check with it.",
    "",
    "mien schema > mien.schema.json",
    run_schema};

}  // namespace mien
