#include "exchange/exports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>

#include "core/error.hpp"
#include "core/text.hpp"
#include "exchange/export_arkit.hpp"
#include "exchange/export_points.hpp"
#include "exchange/export_rig.hpp"
#include "exchange/export_sequence.hpp"
#include "exchange/export_table.hpp"

namespace mien {

namespace {

struct ExportFormat {
  std::string_view ending;
  bool is_sequence;
  ExportNotes (*write)(const ExportWork& work, const std::filesystem::path& path);
};

constexpr std::array kExportFormats{
    ExportFormat{".glb", false, export_gltf},        ExportFormat{".gltf", false, export_gltf},
    ExportFormat{".vrm", false, export_vrm},         ExportFormat{".usda", false, export_usd},
    ExportFormat{".py", false, export_script},       ExportFormat{".csv", false, export_table},
    ExportFormat{".json", false, export_face_units}, ExportFormat{".pc2", false, export_points},
    ExportFormat{".mdd", false, export_points},      ExportFormat{".obj", true, export_sequence},
    ExportFormat{".ply", true, export_sequence},     ExportFormat{".stl", true, export_sequence},
};

const ExportFormat& find_format(const std::string& ending) {
  const auto found = std::ranges::find(kExportFormats, ending, &ExportFormat::ending);
  if (found == kExportFormats.end())
    throw RunError(fmt::format("internal: nothing is exported as '{}'", ending));
  return *found;
}

}  // namespace

std::vector<std::string> list_export_endings() {
  std::vector<std::string> endings;
  for (const ExportFormat& format : kExportFormats) endings.emplace_back(format.ending);
  return endings;
}

bool is_sequence(const std::string& ending) { return find_format(ending).is_sequence; }

std::filesystem::path name_frame_file(const std::filesystem::path& pattern, int frame) {
  static const std::regex kPlace("%(0([1-9]))?d");
  const std::string name = pattern.filename().string();
  const std::string wrong = fmt::format(
      "-o {}: each frame is a file of its own; expected a name with a place for its number, such as {}",
      pattern.string(), pattern.stem().string() + "_%04d" + pattern.extension().string());
  std::smatch found;
  if (!std::regex_search(name, found, kPlace)) throw InputError(wrong);
  const int width = found[2].matched ? std::stoi(found[2]) : 1;
  const std::string rest = found.suffix();
  if (rest.find('%') != std::string::npos) throw InputError(wrong);
  return pattern.parent_path() / fmt::format("{}{:0{}}{}", found.prefix().str(), frame, width, rest);
}

void check_export_options(const std::string& ending, const Options& options) {
  const std::vector<std::string> rigs{".glb", ".gltf", ".usda", ".py"};
  const bool is_rig = std::ranges::find(rigs, ending) != rigs.end();
  if (options.is_exact && !is_rig)
    throw InputError(fmt::format("--exact is not for {}; expected a name that ends in one of: {}", ending,
                                 join_names(rigs)));
  if (options.targets == "moves") return;
  if (options.is_exact) throw InputError("--targets and --exact are two kinds of targets; give one of them");
  if (is_rig || (ending == ".csv" && options.targets == "arkit") ||
      (ending == ".vrm" && options.targets == "vrm"))
    return;
  throw InputError(fmt::format("--targets {} is not for {}; expected a name that ends in one of: {}",
                               options.targets, ending, join_names(rigs)));
}

std::filesystem::path find_companion(const std::filesystem::path& path) {
  if (find_ending(path) != ".py") return {};
  return std::filesystem::path(path).replace_extension(".glb");
}

ExportNotes write_export(const ExportWork& work, const std::filesystem::path& path) {
  return find_format(find_ending(path)).write(work, path);
}

}  // namespace mien
