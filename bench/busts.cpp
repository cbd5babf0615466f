#include "busts.hpp"

#include <fmt/format.h>
#include <chrono>

#include "children.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "render/failure.hpp"
#include "render/process.hpp"
#include "scene/openscad_check.hpp"
#include "scene/openscad_lists.hpp"
#include "scene/stl.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

// On the clock, and summed over all cores.
struct Spent {
  double clock_s = 1e9, cores_s = 1e9;
};

// The best of a few: the others tell of the machine's mood.
Spent time_program(const fs::path& folder, const std::vector<std::string>& command) {
  Spent best;
  for (int round = 0; round < 3; ++round) {
    const double before_s = read_children_s();
    const auto start = std::chrono::steady_clock::now();
    const ProcessResult result = run_process(command, folder);
    const std::string complaint = find_openscad_complaint(result.output);
    if (result.exit_code != 0 || !complaint.empty())
      throw RunError(format_failure(command.front() + " failed", quote_command(command), result.output));
    best.clock_s = std::min(best.clock_s,
                            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    best.cores_s = std::min(best.cores_s, read_children_s() - before_s);
  }
  return best;
}

// The polyhedron alone: what OpenSCAD needs for reading it and writing it again.
std::string build_bare_source(const Mesh& mesh) {
  const auto points = list_rows(mesh.positions.size(), 8, [&](std::string& text, std::size_t i) {
    append_scad_vector(text, mesh.positions[i]);
  });
  return fmt::format("polyhedron(points = [{}],\n  faces = [{}]);\n", points,
                     list_scad_triangles(mesh.triangles));
}

}  // namespace

void measure_busts(const fs::path& folder, const std::string& mien, const PrintRow& print) {
  struct Kind {
    std::string name, words, own_target, source_target;
  };
  const Kind kinds[] = {
      {"solid", "", "target 1 s", "target 5 s"},
      {"hollow", ", hollow: true, label: \"Laugh\", magnet: 6x2mm", "with label and magnet", "target 12 s"}};
  for (const Kind& kind : kinds) {
    write_file(
        folder / (kind.name + ".yaml"),
        fmt::format("mien: 1\nbusts: [{{express: laugh, height: 80mm, triangles: 15000{}}}]\n", kind.words));
    const fs::path out = folder / kind.name, source = out / "bust_laugh.scad", bare = out / "bare.scad";
    const Spent own =
        time_program(folder, {mien, "bust", kind.name + ".yaml", "-o", out.string(), "--quiet"});
    const double source_s = time_program(out, list_openscad_command(source, out / "made.stl")).cores_s;
    const Mesh mesh = read_stl(out / "bust_laugh.stl");
    write_file(bare, build_bare_source(mesh));
    const double bare_s = time_program(out, list_openscad_command(bare, out / "bare.stl")).cores_s;
    print(fmt::format("{} bust by mien", kind.name), fmt::format("{:.2f} s", own.clock_s),
          fmt::format("{} triangles; STL, source and report, {}; {:.2f} s of cores", mesh.triangles.size(),
                      kind.own_target, own.cores_s));
    print(fmt::format("{} bust by OpenSCAD", kind.name), fmt::format("{:.2f} s", source_s),
          fmt::format("STL of the source, {}; {:.2f} s of its bare polyhedron", kind.source_target, bare_s));
  }
}

}  // namespace mien
