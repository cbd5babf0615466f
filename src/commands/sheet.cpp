// `mien sheet`.
#include <fmt/format.h>

#include "commands/report.hpp"
#include "commands/table.hpp"
#include "core/data.hpp"
#include "sheet/clip_sheets.hpp"
#include "sheet/compare_sheet.hpp"
#include "sheet/proofs_sheet.hpp"
#include "sheet/sheet.hpp"
#include "sheet/wire_sheet.hpp"

namespace mien {

namespace {

void check_sheet_wire(const Options& options) {
  const WireOptions& wire = options.wire;
  for (const auto& [is_given, name] :
       {std::pair(wire.has_cage, "cage"), {wire.has_guides, "guides"}, {wire.has_limits, "limits"}})
    if (is_given && options.kind != kWireSheet)
      throw InputError(fmt::format("--{} says nothing to 'mien sheet {}'; expected it with 'mien sheet {}'",
                                   name, options.kind, kWireSheet));
}

void run_sheet(const Options& options) {
  check_sheet_kind(options.kind);
  if (options.express && !is_of_face(options.kind) && options.kind != "heads")
    throw InputError(fmt::format(
        "--express says nothing to 'mien sheet {}'; expected it with 'mien sheet heads', 'views' or 'wire'",
        options.kind));
  if ((options.at_s || options.at_frames) && !is_of_face(options.kind))
    throw InputError(fmt::format(
        "--at says nothing to 'mien sheet {}'; expected it with 'mien sheet views' or 'wire'", options.kind));
  if (options.seed && options.kind != kPeopleSheet)
    throw InputError(fmt::format("--seed says nothing to 'mien sheet {}'; expected it with 'mien sheet {}'",
                                 options.kind, kPeopleSheet));
  if (options.every && options.kind != "contact")
    throw InputError(fmt::format(
        "--every says nothing to 'mien sheet {}'; expected it with 'mien sheet contact'", options.kind));
  if (options.actor && options.kind == "contact")
    throw InputError("--actor says nothing to 'mien sheet contact', which shows everybody");
  check_sheet_wire(options);
  if (options.kind == kProofsSheet && !options.file.empty())
    throw InputError(fmt::format("'mien sheet {}' has heads of its own; expected no FILE", options.kind));
  const Resources resources = load_resources(find_data_folder());
  if (is_clip_sheet(options.kind))
    return report_result(options, "sheet", write_clip_sheet(options, resources));
  const SheetFiles files = options.kind == kWireSheet      ? write_wire_sheet(options, resources)
                           : options.kind == kCompareSheet ? write_compare_sheet(options, resources)
                           : options.kind == kProofsSheet  ? write_proofs(options, resources)
                                                           : write_sheet(options, resources);
  report_held(options, files.held);
  for (const std::filesystem::path& path : files.paths) report_result(options, "sheet", path);
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
    "which --express names another than its poster's. --size is the size of one picture. views and wire "
    "show\n"
    "the face of --express or --at; wire is lines, as SVG and PNG, hidden ones hidden. compare takes two "
    "FILEs, "
    "each with\n@EXPRESSION or @TIME behind it if it is not to be at rest, and measures how far they are "
    "apart. proofs takes none:\nit is a page of the figures of the thesis's "
    "chapter 6, each with what it shows, measured. Three kinds put\n"
    "the clip itself on paper: contact (its drawings in rows, or one in --every), strip (drawings and the\n"
    "curves of each area, as SVG) and exposure (each frame's drawing and what changed, as CSV).",
    "actor at express every seed cage guides limits",
    "mien sheet views configs/hello.yaml\nmien sheet ages configs/hello.yaml -o ages.png\n"
    "mien sheet expressions tezuka\nmien sheet heads smile\nmien sheet people --seed 13\n"
    "mien sheet wire configs/hello.yaml --express laugh --guides -o laugh.svg\n"
    "mien sheet compare configs/hello.yaml configs/hello.yaml@laugh\n"
    "mien sheet contact configs/hello.yaml --quality sketch",
    run_sheet,
    list_sheet_kinds,
    "people proofs",
    kCompareSheet};

}  // namespace mien
