// `mien sheet`.
#include <fmt/format.h>

#include "commands/report.hpp"
#include "commands/table.hpp"
#include "core/data.hpp"
#include "sheet/clip_sheets.hpp"
#include "sheet/sheet.hpp"

namespace mien {

namespace {

void run_sheet(const Options& options) {
  if (options.express && options.kind != "heads")
    throw InputError(fmt::format(
        "--express says nothing to 'mien sheet {}'; expected it with 'mien sheet heads'", options.kind));
  if (options.seed && options.kind != command_sheet.kind_without_file)
    throw InputError(fmt::format("--seed says nothing to 'mien sheet {}'; expected it with 'mien sheet {}'",
                                 options.kind, command_sheet.kind_without_file));
  if (options.every && options.kind != "contact")
    throw InputError(fmt::format(
        "--every says nothing to 'mien sheet {}'; expected it with 'mien sheet contact'", options.kind));
  if (options.actor && options.kind == "contact")
    throw InputError("--actor says nothing to 'mien sheet contact', which shows everybody");
  if (!is_clip_sheet(options.kind)) check_sheet_kind(options.kind);
  const Resources resources = load_resources(find_data_folder());
  report_result(
      options, "sheet",
      is_clip_sheet(options.kind) ? write_clip_sheet(options, resources) : write_sheet(options, resources));
}

}  // namespace

const CommandInfo command_sheet{
    "sheet",
    "Pictures",
    "KIND FILE",
    "many heads on one page, to compare them",
    "Renders a page of pictures without perspective, each named: views (from all sides, with Loomis'\n"
    "guide lines), details (eye, mouth, nose and ear close by), ages, skulls, features (each at -1, 0\n"
    "and 1), areas (each move with its arrows), limits (of each area, drawn on the face), expressions,\n"
    "libraries (what each means by six feelings), designs (five faces on each), heads (one expression at six "
    "ages of four skulls),\n"
    "mouths (each mouth of speech, front and side) or people (twelve random heads, each with the seed that\n"
    "makes it; FILE, which may be left out, says what they have in common). FILE may be a library's name "
    "after expressions and an expression's after "
    "heads, for a FILE of\n"
    "which --express names another than its poster's. --size is the size of one picture. Three kinds put\n"
    "the clip itself on paper: contact (its drawings in rows, or one in --every), strip (drawings and the\n"
    "curves of each area, as SVG) and exposure (each frame's drawing and what changed, as CSV).",
    "actor express every seed",
    "mien sheet views configs/hello.yaml\nmien sheet ages configs/hello.yaml -o ages.png\n"
    "mien sheet expressions tezuka\nmien sheet heads smile\nmien sheet people --seed 13\n"
    "mien sheet contact configs/hello.yaml --quality sketch",
    run_sheet,
    list_sheet_kinds,
    kPeopleSheet};

}  // namespace mien
