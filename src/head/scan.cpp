#include "head/scan.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/head_files.hpp"
#include "config/named_file.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "head/cloud.hpp"
#include "head/landmarks.hpp"
#include "head/nearest.hpp"
#include "head/scan_strays.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr double kExtremeWeight = 0.05;  // nobody finds the highest point of a skull to the millimetre
constexpr double kMostOff = 0.03;        // of the mesh's size: a landmark further off it is a slip

const Names kScanKeys{"landmarks", "unit"};
const Names kUnits{"mm", "cm", "m", "in"};
constexpr std::array kUnits_mm{1.0, 10.0, 1000.0, 25.4};

double compute_size(const Polygons& mesh) {
  glm::dvec3 low(1e300), high(-1e300);
  for (const glm::dvec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
  return glm::distance(low, high);
}

SaidAt find_said(const YamlValue& value) {
  const SourceText& source = value.document->source;
  return {find_place(source, value.spot), std::string(find_line(source, value.spot.line))};
}

// The place of one landmark: three coordinates, or the number of one of the mesh's points as its file counts.
bool load_mark(const YamlValue& value, const Polygons& mesh, glm::dvec3& at) {
  const std::string ending = find_ending(mesh.file);
  const bool is_obj = ending == ".obj";
  if (find_node(value).kind != NodeKind::list && (is_obj || ending == ".ply") && !mesh.is_made) {
    const int first = is_obj ? 1 : 0, last = static_cast<int>(mesh.positions.size()) - 1 + first;
    int number = 0;
    if (!load_whole(value, first, last, number, "(a point of the mesh), or a place such as [0, -30.5, 112]"))
      return false;
    at = mesh.positions[static_cast<std::size_t>(number - first)];
    return true;
  }
  const std::vector<YamlValue> items = load_list(value, "a place such as [0, -30.5, 112]");
  if (find_node(value).kind != NodeKind::list) return false;
  if (items.size() != 3) {
    add_mistake(value, fmt::format("{} has {} number{}; expected three, x y z", describe_subject(value),
                                   items.size(), items.size() == 1 ? "" : "s"));
    return false;
  }
  bool is_right = true;
  for (int axis = 0; axis < 3; ++axis)
    is_right &= load_number(items[axis], -kMaxCoordinate, kMaxCoordinate, at[axis]);
  return is_right;
}

// Makes a half whole: mirrored triangles beside it, points of the middle shared.
void complete_half(Scan& scan) {
  Polygons& mesh = scan.mesh;
  const double near = 1e-4 * compute_size(mesh);
  std::vector<std::uint32_t> image(mesh.positions.size());
  const std::size_t count = mesh.positions.size(), faces = mesh.face_count();
  for (std::size_t i = 0; i < count; ++i) {
    glm::dvec3 p = mesh.positions[i];
    if (std::abs(p.x) < near) {
      image[i] = static_cast<std::uint32_t>(i);
      continue;
    }
    image[i] = static_cast<std::uint32_t>(mesh.positions.size());
    p.x = -p.x;
    mesh.positions.push_back(p);
    if (!scan.rims.empty()) scan.rims.push_back(scan.rims[i]);
  }
  for (std::size_t f = 0; f < faces; ++f) {
    for (std::uint32_t i = mesh.first[f + 1]; i-- > mesh.first[f];)
      mesh.corners.push_back(image[mesh.corners[i]]);
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
}

void check_half(const Polygons& mesh) {
  const double near = 0.01 * compute_size(mesh);
  const auto [low, high] = std::ranges::minmax_element(mesh.positions, {}, &glm::dvec3::x);
  if (low->x >= -near || high->x <= near) return;
  throw InputError(std::vector<Diagnostic>{
      {{mesh.file, 0, 0},
       fmt::format(
           "not a half: points lie from x = {:.4g} to x = {:.4g}; expected all on one side of x = 0 (a whole "
           "head is named by head.scan)",
           low->x, high->x),
       "",
       false}});
}

[[noreturn]] void fail_mesh(const Polygons& mesh, const std::string& message) {
  throw InputError(std::vector<Diagnostic>{{{mesh.file, 0, 0}, message, "", false}});
}

// What is no part of the surface is taken out of it. Throws InputError if there is no surface then.
void clean_mesh(Scan& scan) {
  Polygons& mesh = scan.mesh;
  const bool is_cloud = mesh.face_count() == 0;
  check_cloud_size(mesh);
  const std::size_t count = mesh.positions.size();
  const Strays strays = leave_out_strays(mesh);
  if (strays.count > 0)
    scan.warnings.push_back(
        {{mesh.file, 0, 0},
         fmt::format(
             "{} of {} points {} astray, up to {:.4g} from the middle of the others, which lie within "
             "{:.4g}: left out, with their faces",
             strays.count, count, strays.count == 1 ? "is" : "are", strays.furthest, strays.most_within),
         "",
         true});
  if (!is_cloud) return;
  leave_out_doubles(mesh);  // a thousand in one place would be each other's neighbours
  check_cloud_size(mesh, "different points");
}

SurfaceTree build_tree(const Polygons& mesh) {
  SurfaceTree tree = build_surface_tree(mesh);
  if (tree.triangles.empty())
    fail_mesh(mesh, fmt::format("none of its {} faces has an area; expected a surface", mesh.face_count()));
  return tree;
}

struct MarkReader {
  const HeadStock& stock;
  const HeadWords& words;
  NeutralHead adult;
  bool is_half = false;
  Polygons file;  // the points as the file counts them
  Scan& scan;
};

void add_mark(MarkReader& reader, const std::string& name, const std::string& bare, bool is_right,
              const glm::dvec3& at, const SaidAt& said) {
  const SkinSpot spot = find_place(reader.adult, bare);
  LinearRow place = compute_mean_row(*reader.stock.surface, spot.vertices, spot.shares);
  if (is_right)
    for (auto& entry : place) entry.first = reader.stock.adult.mirror[entry.first];
  reader.scan.marks.push_back({name, at, std::move(place), spot.is_extreme ? kExtremeWeight : 1, said});
}

void load_marks(MarkReader& reader, const YamlMapping& entries, const SurfaceTree& tree) {
  Scan& scan = reader.scan;
  const double size = compute_size(scan.mesh);
  for (const YamlEntry& entry : entries) {
    const bool is_sided = entry.key.ends_with("_l") || entry.key.ends_with("_r");
    const std::string bare = is_sided ? entry.key.substr(0, entry.key.size() - 2) : entry.key;
    glm::dvec3 at{0};
    if (!load_mark(entry.value, reader.file, at) || bare == "pupil" || bare == "tongue") continue;  // no skin
    const double off = find_nearest(tree, at, size * 10).distance;
    if (off > kMostOff * size) {
      add_mistake(entry.value,
                  fmt::format("landmark '{}' lies {:.3g} off the mesh, which is {:.3g} large; expected it "
                              "on the mesh",
                              entry.key, off, size));
      continue;
    }
    if (!reader.is_half || !is_sided) {
      if (reader.is_half) at.x = 0;
      add_mark(reader, entry.key, bare, entry.key.ends_with("_r"), at, find_said(entry.value));
      continue;
    }
    // Of a half one side is told: the other one is its mirror image. Ours is the side with x > 0.
    at.x = std::abs(at.x);
    add_mark(reader, bare + "_l", bare, false, at, find_said(entry.value));
    add_mark(reader, bare + "_r", bare, true, at * glm::dvec3(-1, 1, 1), find_said(entry.value));
  }
}

// Landmarks without which no head can be laid on the scan.
void check_needed(const MarkReader& reader, const YamlValue& root) {
  const auto has = [&](const std::string& name) {
    return std::ranges::find(reader.scan.marks, name, &ScanMark::name) != reader.scan.marks.end();
  };
  Names missing;
  for (const std::string& name : reader.stock.data->landmarks.needed) {
    const bool is_sided = std::ranges::find(reader.words.sided, name) != reader.words.sided.end();
    for (const std::string& each : is_sided ? Names{name + "_l", name + "_r"} : Names{name})
      if (!has(each)) missing.push_back(each);
  }
  if (!missing.empty())
    add_mistake(root, fmt::format("landmarks are missing: {}; expected all of these, more are welcome",
                                  join_names(missing)));
}

}  // namespace

Scan load_scan_files(const HeadStock& stock, const fs::path& file, bool is_half) {
  Scan scan;
  scan.mesh = load_polygons(file, Faces::optional);
  Polygons counted;
  counted.file = scan.mesh.file;
  counted.positions = scan.mesh.positions;
  counted.is_made = scan.mesh.is_made;
  scan.warnings = scan.mesh.warnings;
  clean_mesh(scan);
  if (is_half) check_half(scan.mesh);
  const auto beside = find_landmark_file(file);
  if (!beside)
    throw InputError(std::vector<Diagnostic>{
        {{file.string(), 0, 0},
         fmt::format(
             "has no landmarks beside it; expected a file '{}' such as landmarks: {{prn: [x, y, z], ...}}",
             fs::path(file).replace_extension(".yaml").filename().string()),
         "",
         false}});

  CloudSurface cloud;
  const bool is_cloud = scan.mesh.face_count() == 0;
  if (is_cloud) cloud = build_cloud_surface(scan.mesh);

  Findings findings;
  const HeadWords& words = stock.data->words;
  Names names = words.middle;
  for (const std::string& name : words.sided)
    for (const char* side : {"_l", "_r"}) names.push_back(name + side);
  for (const char* other : {"pupil_l", "pupil_r", "tongue"}) names.push_back(other);
  auto source = load_named_source(*beside, kLandmarkFile, findings);
  if (const auto document = source ? scan_document(std::move(*source), findings) : std::nullopt) {
    MarkReader reader{stock, words, build_bare_head(stock, stock.adult.points), is_half, std::move(counted),
                      scan};
    const YamlValue root = find_root(*document, findings);
    const YamlMapping entries =
        load_mapping(root, kScanKeys, "a mapping such as landmarks: {prn: [x, y, z], ...}");
    if (const YamlValue* unit = find_value(entries, "unit")) {
      std::string name;
      scan.unit_said = find_said(*unit);
      if (load_name(*unit, "unit", kUnits, name))
        scan.unit_mm = kUnits_mm[static_cast<std::size_t>(std::ranges::find(kUnits, name) - kUnits.begin())];
    }
    if (const YamlValue* marks = find_required(entries, "landmarks", root, "names and places")) {
      scan.marks_said = find_said(*marks);
      load_marks(reader, load_mapping(*marks, names, "names and places such as {prn: [x, y, z]}", "landmark"),
                 build_tree(is_cloud ? cloud.mesh : scan.mesh));
    }
    if (findings.mistakes.empty()) check_needed(reader, root);
  }
  throw_mistakes(std::move(findings));
  if (is_cloud) {
    scan.mesh = std::move(cloud.mesh);
    scan.rims = std::move(cloud.rims);
  }
  if (is_half) complete_half(scan);
  return scan;
}

}  // namespace mien
