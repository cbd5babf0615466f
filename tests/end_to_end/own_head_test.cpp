// Heads from files of the user's own, as a person would make them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "end_to_end/program.hpp"
#include "import/polygons.hpp"

namespace mien {
namespace {

const std::string kClip = "clip: {keys: [{at: 0s, express: smile}]}\nrender: {size: 16x20, quality: draft}\n";

// The text with the point on line `line` (from 1) 5 mm further out.
std::string move_point(std::string text, int line) {
  std::size_t at = 0;
  for (int i = 1; i < line; ++i) at = text.find('\n', at) + 1;
  const std::size_t end = text.find('\n', at), space = text.rfind(' ', end);
  const double z = std::stod(text.substr(space + 1, end - space - 1));
  return text.replace(space + 1, end - space - 1, format_number(z + 5, 4));
}

// The keys of the clip's pictures: what their pixels depend on.
std::string find_keys(const std::filesystem::path& folder, const std::string& name) {
  const ProgramRun run = run_shell(folder, "mien render " + name + ".yaml --quiet");
  EXPECT_EQ(run.status, 0) << run.err;
  return nlohmann::json::parse(read_file(folder / "out" / name / "manifest.json")).at("drawings").dump();
}

TEST(own_head, a_half_goes_out_and_comes_back_as_it_was) {
  const auto folder = make_folder("own_head");
  write_file(folder / "adult.yaml", "mien: 1\n");
  write_file(folder / "mine.yaml", "mien: 1\nhead: {mesh: parts/half.obj}\n" + kClip);
  ProgramRun run = run_shell(folder, "mien mesh adult.yaml --half -o parts/half.obj");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "half    parts/half.obj\n");
  run = run_shell(folder, "mien mesh mine.yaml --half -o again.obj && cmp parts/half.obj again.obj");
  EXPECT_EQ(run.status, 0) << run.out << run.err;

  const std::string before = find_keys(folder, "mine");
  write_file(folder / "parts/half.obj", move_point(read_file(folder / "parts/half.obj"), 100));
  EXPECT_NE(find_keys(folder, "mine"), before) << "another half is another picture";
}

// A scan with one point far off: what it is worth is said by every command that makes a head of it.
TEST(own_head, a_scan_that_is_to_be_doubted_is_warned_of) {
  const auto folder = make_folder("own_head_doubted");
  const std::filesystem::path model = std::filesystem::path(source_folder()) / "configs/scans/model.ply";
  const Polygons mesh = load_polygons(model);
  std::string obj;
  for (const glm::dvec3& p : mesh.positions) obj += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    obj += "f";
    for (std::uint32_t i = mesh.first[f]; i < mesh.first[f + 1]; ++i)
      obj += fmt::format(" {}", mesh.corners[i] + 1);
    obj += "\n";
  }
  write_file(folder / "face.obj", obj + "v 5000 0 0\n");
  write_file(folder / "face.yaml", read_file(std::filesystem::path(model).replace_extension(".yaml")));
  write_file(folder / "mine.yml", "mien: 1\nhead: {scan: face.obj}\n");
  const std::string told =
      "1 of 3898 points is astray, up to 5000 from the middle of the others, which lie within ";
  for (const char* command : {"check", "mesh -o a.obj", "mesh --half -o b.obj"}) {
    const ProgramRun run = run_shell(folder, fmt::format("mien {} mine.yml", command));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("face.obj: warning: " + told), std::string::npos) << command << "\n" << run.out;
  }
  const ProgramRun json = run_shell(folder, "mien mesh mine.yml --half --json -o b.obj | head -n 1");
  const auto object = nlohmann::json::parse(json.out);
  EXPECT_EQ(object.at("kind"), "warning");
  EXPECT_EQ(object.at("file"), "face.obj");
  EXPECT_FALSE(object.contains("line")) << "the file as a whole";
  EXPECT_EQ(object.at("message").get<std::string>().substr(0, told.size()), told);
  const ProgramRun quiet = run_shell(folder, "mien mesh mine.yml --half --quiet -o b.obj");
  EXPECT_EQ(quiet.out, "");
}

TEST(own_head, check_tells_broken_files_and_nothing_is_written) {
  const auto folder = make_folder("own_head_broken");
  write_file(folder / "mine.yaml", "mien: 1\nhead: {mesh: half.obj}\n");
  write_file(folder / "half.obj", "v 0 0 0\nv 0 1\n");
  for (const char* command : {"check", "render", "mesh", "frames"}) {
    const ProgramRun run = run_shell(folder, std::string("mien ") + command + " mine.yaml");
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err, "half.obj:2: error: a point of 2 numbers; expected v X Y Z\n");
  }
  EXPECT_EQ(list_files(folder), (std::vector<std::string>{"half.obj", "mine.yaml"}));
  const ProgramRun run = run_shell(folder, "mien check mine.yaml --json");
  EXPECT_EQ(run.err,
            "{\"kind\":\"error\",\"file\":\"half.obj\",\"line\":2,\"message\":\"a point of 2 numbers; "
            "expected v X Y "
            "Z\"}\n");
}

TEST(own_head, half_is_the_neutral_heads_alone) {
  const auto folder = make_folder("own_head_half");
  write_file(folder / "adult.yaml", "mien: 1\n");
  const ProgramRun run = run_shell(folder, "mien mesh adult.yaml --half --express smile -o half.obj");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "error: --half is the neutral head's half alone; give it without --express\n");
}

TEST(own_head, check_takes_surfaces_clouds_and_slices) {
  const auto folder = make_folder("own_head_kinds");
  const std::string net =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\ncstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\n"
      "parm v 0 1\n";
  std::string cloud, slices;
  for (int i = 0; i < 100; ++i) cloud += fmt::format("{} {} {}\n", i, i * i % 7, i * i % 11);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 100; ++j)
      slices += fmt::format("{}{} {} {}\n", j == 0 ? "slice\n" : "", j, j * j / 100.0, 5 * i);
  write_file(folder / "flat.obj", net + "end\n");
  write_file(folder / "cut.obj", net + "trim 0 1 1\nend\n");
  write_file(folder / "cloud.csv", cloud);
  write_file(folder / "few.pts", "1 2 3\n");
  write_file(folder / "slices.asc", slices);
  EXPECT_EQ(run_shell(folder, "mien check flat.obj").out,
            "flat.obj: good; 4 points, 1 polygon, 1 open rim of 4 edges; of 1 surface\n");
  EXPECT_EQ(
      run_shell(folder, "mien check cut.obj").out,
      "cut.obj:10: warning: 1 of 1 surfaces has 'trim' or 'hole': taken whole, with what these cut away\n"
      "cut.obj: good; 4 points, 1 polygon, 1 open rim of 4 edges; of 1 surface\n");
  EXPECT_EQ(run_shell(folder, "mien check cloud.csv").out, "cloud.csv: good; a cloud of 100 points\n");
  const std::string told = run_shell(folder, "mien check slices.asc").out;
  EXPECT_TRUE(told.starts_with("slices.asc: good; a cloud of ") && told.ends_with(" points; of 5 slices\n"))
      << told;
  const ProgramRun few = run_shell(folder, "mien check few.pts");
  EXPECT_EQ(few.status, 2);
  EXPECT_EQ(
      few.err,
      "few.pts: error: has 1 points and no faces; expected a surface, or a cloud of 100 points at least\n");
  EXPECT_EQ(run_shell(folder, "mien check cloud.csv --faults a.ply").err,
            "cloud.csv: error: has no faces; expected a surface of triangles or quads\n");
  EXPECT_EQ(list_files(folder).size(), 5u);
}

// One table says which files are read; what is written by hand follows it.
TEST(own_head, help_and_docs_name_every_kind_of_file) {
  const auto folder = make_folder("own_head_endings");
  const std::string help = run_shell(folder, "mien check --help").out,
                    docs = read_file(std::filesystem::path(source_folder()) / "docs/scans.md");
  for (const std::string& ending : list_geometry_endings()) {
    EXPECT_NE(help.find(ending), std::string::npos) << ending;
    EXPECT_NE(docs.find("`" + ending + "`"), std::string::npos) << ending;
  }
}

}  // namespace
}  // namespace mien
