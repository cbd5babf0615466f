#include "print/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/crossings.hpp"
#include "core/holes.hpp"
#include "core/text.hpp"
#include "print/solid_tree.hpp"
#include "print/thickness.hpp"

namespace mien {

namespace {

constexpr double kPla_g_per_mm3 = 1.24e-3, kResin_g_per_mm3 = 1.15e-3;
constexpr double kReach_mm = 20;     // thicker is thick enough for anything
constexpr double kSpeck_mm2 = 0.3;   // of surface: less is a corner rather than a detail
constexpr double kSamples = 5000;    // of the surface for the wall: a hundredth is still fifty
constexpr double kThinShare = 0.01;  // of the surface may be thinner than the wall
constexpr double kFinest_mm = 0.8;   // two lines of a nozzle of 0.4 mm, and safe in resin
constexpr double kLayer_mm = 0.3;    // what begins in the air for less is closed by the next layer
constexpr double kBed_mm = 0.01f;
constexpr double kSteep = 0.7072;       // the cosine of 45 degrees, and a little
constexpr double kMuchOverhang = 0.01;  // of the whole surface; less hangs by itself
constexpr double kLeastStand = 0.04;    // of the print's breadth and depth; on less it topples

void measure_faces(PrintReport& report, const Mesh& mesh, std::size_t inner_first, std::size_t inner_count) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const glm::dvec3 p(mesh.positions[a]), q(mesh.positions[b]), r(mesh.positions[c]);
    const glm::dvec3 cross = glm::cross(q - p, r - p);
    const double area = glm::length(cross) / 2;
    if (!(area > 0) || cross.z / (2 * area) > -kSteep) continue;
    const bool is_inner = t >= inner_first && t < inner_first + inner_count;
    if (std::max({p.z, q.z, r.z}) < kBed_mm)
      report.bed_mm2 += area;
    else
      (is_inner ? report.inner_overhang_mm2 : report.overhang_mm2) += area;
  }
}

void measure_pieces(PrintReport& report, const Mesh& mesh) {
  for (const Mesh& piece : split_pieces(mesh)) {
    if (compute_volume_mm3(piece) < 0)
      ++report.sealed_cavities;
    else
      ++report.parts;
  }
}

void measure_thickness(PrintReport& report, const Mesh& mesh) {
  const SurfaceTree tree = build_solid_tree(mesh);
  report.fine = list_fine_details(mesh, tree, kFinest_mm, kSpeck_mm2);
  double all = 0, area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    all += glm::length(
               glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a])) /
           2;
  for (const ThicknessSample& sample : list_thicknesses(mesh, tree, kReach_mm, all / kSamples)) {
    area += sample.area_mm2;
    report.least_wall_mm = sample.thickness_mm;
    if (area >= kThinShare * all) break;
  }
}

void measure_crossings(PrintReport& report, const Mesh& mesh) {
  const std::vector<Crossing> crossings = find_crossings(mesh.positions, mesh.triangles);
  report.crossings = crossings.size();
  if (!crossings.empty())
    report.crossing_at = list_crossed_places(mesh.positions, mesh.triangles, crossings).front();
}

std::string format_place(const glm::dvec3& place) {
  return fmt::format("x {}, y {}, z {}", format_number(place.x, 1), format_number(place.y, 1),
                     format_number(place.z, 1));
}

std::string count_things(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

PrintReport measure_print(const Mesh& mesh, std::size_t inner_first, std::size_t inner_count) {
  PrintReport report;
  const Box box = compute_bounds(mesh.positions);
  report.size_mm = glm::dvec3(box.high) - glm::dvec3(box.low);
  report.volume_mm3 = compute_volume_mm3(mesh);
  report.pla_g = kPla_g_per_mm3 * report.volume_mm3;
  report.resin_g = kResin_g_per_mm3 * report.volume_mm3;
  report.triangles = mesh.triangles.size();
  report.open_edges = count_open_edges(mesh.triangles);
  measure_faces(report, mesh, inner_first, inner_count);
  measure_pieces(report, mesh);
  measure_thickness(report, mesh);
  measure_crossings(report, mesh);
  report.islands = find_islands(mesh, kLayer_mm);
  update_warnings(report);
  return report;
}

void update_warnings(PrintReport& report) {
  std::vector<std::string>& say = report.warnings;
  say.clear();
  if (report.open_edges > 0)
    say.push_back(fmt::format("It is not a solid: its surface has {}.",
                              count_things(report.open_edges, "open edge", "open edges")));
  else if (report.volume_mm3 <= 0)
    say.emplace_back("It is inside out.");
  if (report.crossings > 0)
    say.push_back(fmt::format("Its surface passes through itself at {}, one of them at {}.",
                              count_things(report.crossings, "place", "places"),
                              format_place(report.crossing_at)));
  if (report.parts > 1) say.push_back(fmt::format("It falls into {} parts.", report.parts));
  if (report.bed_mm2 <= 0)
    say.emplace_back("Nothing of it lies on the bed.");
  else if (report.bed_mm2 < kLeastStand * report.size_mm.x * report.size_mm.y)
    say.push_back(fmt::format("It stands on {} mm2 only and may topple.", format_number(report.bed_mm2, 0)));
  if (report.sealed_cavities > 0)
    say.push_back(fmt::format("It has {} without a hole, where resin would stay.",
                              count_things(report.sealed_cavities, "cavity", "cavities")));
  if (report.drain_mm > 0 && report.vent_mm.x <= 0)
    say.emplace_back(
        "Its only hole lies on the bed: on a resin printer the hollow is a cup that sucks at the film. Print "
        "it "
        "tilted on supports, or drill a second hole near the bed.");
  if (report.fine.size() == 1)
    say.push_back(fmt::format("A detail of it is {} mm thick, at {}; below {} mm it may not print.",
                              format_number(report.fine[0].finest_mm, 2), format_place(report.fine[0].place),
                              format_number(kFinest_mm, 1)));
  else if (report.fine.size() > 1)
    say.push_back(
        fmt::format("{} details of it are finer than {} mm and may not print, the finest {} mm thick, at {}.",
                    report.fine.size(), format_number(kFinest_mm, 1),
                    format_number(report.fine[0].finest_mm, 2), format_place(report.fine[0].place)));
  if (report.least_wall_mm < kFinest_mm)
    say.push_back(fmt::format("Its wall is down to {} mm; below {} mm it may break.",
                              format_number(report.least_wall_mm, 2), format_number(kFinest_mm, 1)));
  if (report.islands.size() == 1)
    say.push_back(fmt::format("A part of it begins in the air, at {}, and needs a support.",
                              format_place(report.islands[0].lowest)));
  else if (report.islands.size() > 1)
    say.push_back(fmt::format("{} parts of it begin in the air and need supports, the lowest at {}.",
                              report.islands.size(), format_place(report.islands[0].lowest)));
  const double surface = report.size_mm.x * report.size_mm.y + report.size_mm.x * report.size_mm.z +
                         report.size_mm.y * report.size_mm.z;
  if (report.overhang_mm2 > kMuchOverhang * surface)
    say.push_back(fmt::format("{} mm2 hang over by more than 45 degrees: print them with supports.",
                              format_number(report.overhang_mm2, 0)));
}

bool is_printable(const PrintReport& report) {
  return report.open_edges == 0 && report.parts == 1 && report.volume_mm3 > 0 && report.bed_mm2 > 0 &&
         report.crossings == 0;
}

std::string describe_report(const PrintReport& report) {
  std::string text;
  const auto add = [&](const char* name, const std::string& value) {
    text += fmt::format("{:<16}{}\n", name, value);
  };
  add("size", fmt::format("{} x {} x {} mm", format_number(report.size_mm.x, 1),
                          format_number(report.size_mm.y, 1), format_number(report.size_mm.z, 1)));
  add("volume", format_number(report.volume_mm3 / 1000, 2) + " cm3");
  add("mass", fmt::format("{} g of PLA, {} g of resin", format_number(report.pla_g, 1),
                          format_number(report.resin_g, 1)));
  add("wall", format_number(report.least_wall_mm, 2) + " mm at least");
  add("finest detail", report.fine.empty()
                           ? format_number(kFinest_mm, 1) + " mm or more"
                           : fmt::format("{} mm, at {}", format_number(report.fine[0].finest_mm, 2),
                                         format_place(report.fine[0].place)));
  if (report.drain_mm > 0) add("drain", format_number(report.drain_mm, 1) + " mm, in the underside");
  if (report.vent_mm.x > 0)
    add("vent", fmt::format("{} x {} mm, from the drain to the base's back",
                            format_number(report.vent_mm.x, 1), format_number(report.vent_mm.y, 1)));
  std::string overhang = format_number(report.overhang_mm2, 0) + " mm2 past 45 degrees";
  if (report.inner_overhang_mm2 > 0)
    overhang += fmt::format(", {} mm2 inside", format_number(report.inner_overhang_mm2, 0));
  add("overhang", overhang);
  add("on the bed", format_number(report.bed_mm2, 0) + " mm2");
  add("islands", fmt::format("{}", report.islands.size()));
  add("sealed cavities", fmt::format("{}", report.sealed_cavities));
  add("parts", fmt::format("{}", report.parts));
  add("triangles", fmt::format("{}", report.triangles));
  add("open edges", fmt::format("{}", report.open_edges));
  add("crossings", fmt::format("{}", report.crossings));
  for (const std::string& warning : report.warnings) text += fmt::format("warning: {}\n", warning);
  return text;
}

}  // namespace mien
