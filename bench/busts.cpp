#include "busts.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

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

// What all children so far have used of cores.
double read_children_s() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return double(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * double(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

// The best of a few: the others tell of the machine's mood.
double time_program(const fs::path& folder, const std::vector<std::string>& command) {
  double best_s = 1e9;
  for (int round = 0; round < 3; ++round) {
    const double before_s = read_children_s();
    const ProcessResult result = run_process(command, folder);
    const std::string complaint = find_openscad_complaint(result.output);
    if (result.exit_code != 0 || !complaint.empty())
      throw RunError(format_failure(command.front() + " failed", quote_command(command), result.output));
    best_s = std::min(best_s, read_children_s() - before_s);
  }
  return best_s;
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
    write_file(folder / (kind.name + ".yaml"),
               fmt::format("mien: 1\nbusts: [{{express: laugh, height: 80mm{}}}]\n", kind.words));
    const fs::path out = folder / kind.name, source = out / "bust_laugh.scad", bare = out / "bare.scad";
    const double own_s =
        time_program(folder, {mien, "bust", kind.name + ".yaml", "-o", out.string(), "--quiet"});
    const double source_s = time_program(out, list_openscad_command(source, out / "made.stl"));
    const Mesh mesh = read_stl(out / "bust_laugh.stl");
    write_file(bare, build_bare_source(mesh));
    const double bare_s = time_program(out, list_openscad_command(bare, out / "bare.stl"));
    print(fmt::format("{} bust by mien", kind.name), fmt::format("{:.2f} s", own_s),
          fmt::format("{} triangles; STL, source and report, {}", mesh.triangles.size(), kind.own_target));
    print(fmt::format("{} bust by OpenSCAD", kind.name), fmt::format("{:.2f} s", source_s),
          fmt::format("STL of the source, {}; {:.2f} s of its bare polyhedron", kind.source_target, bare_s));
  }
}

}  // namespace mien
