// Busts to the slicer and back from OpenSCAD.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bust/build_bust.hpp"
#include "core/text.hpp"
#include "end_to_end/program.hpp"
#include "places.hpp"
#include "scene/openscad.hpp"
#include "scene/stl.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

constexpr const char* kBusts = R"(mien: 1
busts:
  - {express: laugh, height: 60mm}
  - {express: surprise, height: 40mm, base: plinth, label: "a \"b\" c", hollow: true, wall: 1.2mm, drain: 3.5mm}
)";

TEST(bust, is_one_closed_part_for_the_slicer) {
  const auto folder = make_folder("bust");
  write_file(folder / "busts.yaml", kBusts);
  const ProgramRun run = run_shell(folder, "mien bust busts.yaml --3mf -o out");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(list_files(folder / "out"),
            (std::vector<std::string>{"bust_laugh.3mf", "bust_laugh.scad", "bust_laugh.stl", "bust_laugh.txt",
                                      "bust_surprise.3mf", "bust_surprise.scad", "bust_surprise.stl",
                                      "bust_surprise.txt"}));
  for (const char* name : {"bust_laugh", "bust_surprise"}) {
    const ProgramRun info = run_shell(folder, fmt::format("prusa-slicer --info out/{}.stl", name));
    EXPECT_THAT(info.out, HasSubstr("manifold = yes")) << name;
    EXPECT_THAT(info.out, HasSubstr("number_of_parts =  1")) << name;
    const ProgramRun admesh = run_shell(folder, fmt::format("admesh out/{}.stl", name));
    EXPECT_THAT(admesh.out, HasSubstr("Total disconnected facets        :     0")) << name;
    EXPECT_THAT(admesh.out, HasSubstr("Facets reversed       :     0")) << name;
    EXPECT_THAT(read_file(folder / fmt::format("out/{}.txt", name)), HasSubstr("open edges      0"));
  }
  // Nothing else in a second run.
  const std::string stl = read_file(folder / "out/bust_laugh.stl"),
                    scad = read_file(folder / "out/bust_laugh.scad"),
                    package = read_file(folder / "out/bust_laugh.3mf");
  ASSERT_EQ(run_shell(folder, "mien bust busts.yaml --3mf -o out").status, 0);
  EXPECT_EQ(read_file(folder / "out/bust_laugh.stl"), stl);
  EXPECT_EQ(read_file(folder / "out/bust_laugh.scad"), scad);
  EXPECT_EQ(read_file(folder / "out/bust_laugh.3mf"), package);
}

TEST(bust, warnings_and_notes_are_json_too) {
  const auto folder = make_folder("bust_json");
  write_file(folder / "a.yaml",
             "mien: 1\nhead: {hair: bob}\nbusts: {all: [smile, anger], height: 30mm, triangles: 8000}\n");
  const ProgramRun run = run_shell(folder, "mien bust a.yaml --json --no-stl -o out");
  ASSERT_EQ(run.status, 0) << run.err;
  std::istringstream lines(run.out);
  std::vector<std::string> told, notes;
  for (std::string line; std::getline(lines, line);) {
    const auto object = nlohmann::json::parse(line);
    if (!object.contains("kind")) continue;
    EXPECT_EQ(object["file"], "a.yaml");
    if (object["kind"] == "note") notes.push_back(object["message"]);
    if (object["kind"] == "warning")
      told.push_back(object["bust"].get<std::string>() + ".txt: " + object["message"].get<std::string>());
  }
  EXPECT_EQ(notes, std::vector<std::string>{"Its hair is not printed: hair is finer than any nozzle."});
  // What the reports warn of, but for the hair.
  std::vector<std::string> meant;
  for (const char* name : {"bust_smile.txt", "bust_anger.txt"}) {
    std::istringstream report(read_file(folder / "out" / name));
    for (std::string line; std::getline(report, line);)
      if (line.starts_with("warning: ") && line.substr(9) != notes[0])
        meant.push_back(fmt::format("{}: {}", name, line.substr(9)));
  }
  EXPECT_EQ(told, meant);
  EXPECT_GE(told.size(), 2U);
  // In words once a run, under the files what each has besides.
  const ProgramRun words = run_shell(folder, "mien bust a.yaml --no-stl -o out");
  EXPECT_THAT(
      words.out,
      testing::StartsWith("a.yaml: note: Its hair is not printed: hair is finer than any nozzle.\nsource "));
  EXPECT_EQ(words.out.find("not printed"), words.out.rfind("not printed"));
  EXPECT_EQ(run_shell(folder, "mien bust a.yaml --quiet --no-stl -o out").out, "");
}

TEST(bust, one_that_passes_through_itself_is_not_printable) {
  const auto folder = make_folder("bust_crossed");
  write_file(folder / "a.yaml",
             "mien: 1\nhead: {sculpt: [{at: nose_tip, move: [0, -20mm, -20mm], radius: 8mm}]}\n"
             "busts: [{express: laugh, height: 60mm, triangles: 8000}]\n");
  const ProgramRun run = run_shell(folder, "mien bust a.yaml -o out");
  EXPECT_EQ(run.status, 1);
  // A slow machine tells how far it is before.
  EXPECT_THAT(run.err, EndsWith("error: not every bust is printable; the reports say why\n"));
  EXPECT_THAT(run.out, HasSubstr("        Its surface passes through itself at "));
  EXPECT_EQ(list_files(folder / "out"),
            (std::vector<std::string>{"bust_laugh.scad", "bust_laugh.stl", "bust_laugh.txt"}));
}

TEST(bust, an_asked_one_is_printed_as_the_file_says) {
  const auto folder = make_folder("bust_asked");
  write_file(folder / "a.yaml",
             "mien: 1\nclip: {length: 1s}\n"
             "busts: {all: [smile, anger], height: 40mm, base: plinth, triangles: 8000}\n");
  const auto find_size = [&](const std::string& asked, const std::string& stem) {
    const ProgramRun run = run_shell(folder, "mien bust a.yaml --no-stl -o out " + asked);
    EXPECT_EQ(run.status, 0) << run.err;
    const std::string source = read_file(folder / "out" / (stem + ".scad"));
    const auto line = [&](const std::string& start) {
      const std::size_t at = source.find("\n" + start) + 1;
      return source.substr(at, source.find(';', at) - at);
    };
    return line("height_mm = ") + ", " + line("base = ") + ", " + line("label = ");
  };
  EXPECT_EQ(find_size("--express laugh", "bust_laugh"),
            "height_mm = 40, base = \"plinth\", label = \"laugh\"");
  EXPECT_EQ(find_size("--express smile --height 30mm", "bust_smile"),
            "height_mm = 30, base = \"plinth\", label = \"smile\"");
  EXPECT_EQ(find_size("--at 0.5s", "bust_0.5s"), "height_mm = 40, base = \"plinth\", label = \"0.5s\"");
}

TEST(bust, says_that_hair_and_beard_are_not_printed) {
  const std::pair<const char*, const char*> heads[] = {
      {"{hair: bob}", "warning: Its hair is not printed: hair is finer than any nozzle.\n"},
      {"{look: {beard: short}}", "warning: Its beard is not printed: hair is finer than any nozzle.\n"},
      {"{hair: crop, look: {beard: stubble}}",
       "warning: Its hair and beard are not printed: hair is finer than any nozzle.\n"},
      {"{hair: buzz, design: comic}", "warning: Its hair is not printed: hair is finer than any nozzle.\n"},
      {"{hair: bob, design: comic, look: {beard: short}}",
       "warning: Its beard is not printed: hair is finer than any nozzle.\n"},
      {"{hair: bob, design: comic}", ""},
      {"{age: child}", ""}};
  for (const auto& [head, warning] : heads) {
    const auto folder = make_folder("bust_hair");
    write_file(folder / "hair.yaml", fmt::format("mien: 1\nhead: {}\n", head));
    const ProgramRun run = run_shell(folder, "mien bust hair.yaml --express neutral --height 30mm -o out");
    ASSERT_EQ(run.status, 0) << run.err;
    const std::string report = read_file(folder / "out/bust_neutral.txt");
    EXPECT_THAT(report, HasSubstr(warning)) << head;
    EXPECT_EQ(report.find("not printed") != report.npos, *warning != 0) << head;
  }
}

TEST(bust, higher_ones_are_finer) {
  const auto folder = make_folder("bust_fine");
  std::size_t last = 0;
  for (const char* height : {"40mm", "90mm"}) {
    ASSERT_EQ(run_shell(folder, fmt::format("mien bust '{}/configs/hello.yaml' --express neutral --height {} "
                                            "--quiet -o out",
                                            source_folder(), height))
                  .status,
              0);
    const std::size_t triangles = read_stl(folder / "out/bust_neutral.stl").triangles.size();
    EXPECT_GE(triangles, last + 15000);
    last = triangles;
  }
}

TEST(bust, lips_of_a_wide_open_mouth_are_thick_enough) {
  const auto folder = make_folder("bust_lips");
  const ProgramRun run = run_shell(
      folder,
      fmt::format("mien bust '{}/configs/hello.yaml' --express tezuka/shout --height 80mm --quiet -o out",
                  source_folder()));
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(read_file(folder / "out/bust_shout.txt"), HasSubstr("finest detail   0.8 mm or more"));
}

// Height with the base, and what of it was asked for and had no room.
TEST(bust, reports_what_it_came_to) {
  const auto folder = make_folder("bust_came_to");
  write_file(folder / "a.yaml",
             "mien: 1\nbusts:\n"
             "  - {express: smile, height: 40mm, base: plinth, label: A name too long for so low a plinth, "
             "triangles: 8000}\n"
             "  - {express: anger, height: 40mm, base: round, hollow: true, drain: 10mm, triangles: 8000}\n");
  const ProgramRun run = run_shell(folder, "mien bust a.yaml --no-stl -o out");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("        Its label has room for 'A n"));
  EXPECT_THAT(run.out, HasSubstr(" mm wide instead of 10 mm: the base leaves no room for more."));
  for (const char* name : {"smile", "anger"}) {
    const std::string report = read_file(folder / "out" / fmt::format("bust_{}.txt", name));
    EXPECT_THAT(report.substr(0, report.find('\n')), EndsWith(" x 40 mm")) << name;
    // The menu has the file's library alone.
    const std::string source = read_file(folder / "out" / fmt::format("bust_{}.scad", name));
    const std::size_t menu = source.find("\nexpression = ") + 1;
    ASSERT_NE(menu, 0U);
    const std::string words = source.substr(menu, source.find('\n', menu) - menu);
    EXPECT_EQ(std::ranges::count_if(shipped_stock().language->libraries.expressions,
                                    [](const Expression& e) { return e.library == "mien"; }),
              std::ranges::count(words, ',') + 1)
        << words;
  }
}

TEST(bust, a_set_stands_on_plates) {
  const auto folder = make_folder("bust_set");
  write_file(folder / "set.yaml",
             "mien: 1\nbusts: {all: tezuka, height: 40mm, plate: 90x90mm, triangles: 8000}\n");
  const ProgramRun run = run_shell(folder, "mien bust set.yaml --quiet -o out");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(std::filesystem::exists(folder / "out/plate_1.stl"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/plate_2.stl"));
  const StlFacts plate = check_stl(folder / "out/plate_1.stl");
  EXPECT_GT(plate.parts, 1U);
  EXPECT_EQ(plate.open_edges, 0U);
  EXPECT_GE(plate.box.low.x, 0);
  EXPECT_LE(plate.box.high.x, 90);
}

TEST(bust, says_what_cannot_be_printed) {
  const auto folder = make_folder("bust_wrong");
  write_file(folder / "a.yaml", "mien: 1\nbusts: [{height: 30mm, hollow: true, wall: 15mm}]\n");
  const ProgramRun run = run_shell(folder, "mien bust a.yaml -o out");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("error: a wall of 15 mm leaves nothing to hollow"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/bust_neutral.stl"));
  const ProgramRun low = run_shell(folder, "mien bust a.yaml --height 0 -o out");
  EXPECT_EQ(low.status, 2);
  EXPECT_EQ(low.err, "error: --height: '0' is outside 20mm..400mm\n");
}

TEST(bust, an_openscad_that_fails_is_told) {
  const auto folder = make_folder("bust_openscad");
  write_file(folder / "a.yaml", "mien: 1\nbusts: [{express: laugh, triangles: 8000}]\n");
  struct Case {
    std::string script, message;
  };
  for (const auto& [script, message] : {Case{"echo hm; exit 1", "openscad failed (exit status 1)"},
                                        Case{"echo 'ERROR: The given mesh is not closed!'; exit 0",
                                             "openscad complains: ERROR: The given mesh is not closed!"},
                                        Case{"for word; do case $word in *.stl) : >$word;; esac; done; "
                                             "echo 'WARNING: undefined operation'",
                                             "openscad complains: WARNING: undefined operation"},
                                        Case{"kill -9 $$", "openscad was ended by signal 9 (Killed)"},
                                        Case{"exit 0", "openscad has written nothing"}}) {
    std::filesystem::remove_all(folder / "out");
    const std::string path = make_program(folder, "openscad", script);
    const ProgramRun run = run_shell(folder, path + "mien bust a.yaml --openscad -o out");
    EXPECT_EQ(run.status, 1) << script;
    EXPECT_THAT(run.err, HasSubstr("error: out/bust_laugh.scad: " + message)) << script;
    EXPECT_THAT(run.err, HasSubstr("\n  command: openscad --hardwarnings")) << script;
    EXPECT_EQ(list_files(folder / "out"),
              (std::vector<std::string>{"bust_laugh.scad", "bust_laugh.stl", "bust_laugh.txt"}))
        << script;
  }
  std::filesystem::remove_all(folder / "out");
  const ProgramRun none = run_shell(folder, "PATH=/nowhere mien bust a.yaml --openscad -o out");
  EXPECT_EQ(none.status, 1);
  EXPECT_EQ(none.err, "error: openscad is not installed; install it with: apt-get install openscad\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  // Nobody waits for an OpenSCAD that hangs.
  const std::string path = make_program(folder, "openscad", "echo $$ >pid; exec sleep 60");
  const ProgramRun run =
      run_shell(folder, path + "timeout -s INT 20 sh -c '" + program_path() +
                            " bust a.yaml --openscad -o out & wait_for=$!; "
                            "while ! ls out/.mien-work-*/pid 2>/dev/null; do sleep 0.1; done; "
                            "kill -INT $wait_for; wait $wait_for'");
  EXPECT_EQ(run.status, 130) << run.err;
  EXPECT_EQ(list_files(folder / "out"),
            (std::vector<std::string>{"bust_laugh.scad", "bust_laugh.stl", "bust_laugh.txt"}));
}

TEST(bust, a_disk_that_takes_nothing_is_told) {
  const auto folder = make_folder("bust_disk");
  write_file(folder / "a.yaml", "mien: 1\nbusts: [{express: laugh, triangles: 8000}]\n");
  // No file may be larger than 200 kB: as a full disk.
  const ProgramRun full = run_shell(folder, "(ulimit -f 200; trap '' XFSZ; mien bust a.yaml -o out)");
  EXPECT_EQ(full.status, 1);
  EXPECT_THAT(full.err, testing::StartsWith("error: cannot write out/bust_laugh.scad: "));
  EXPECT_EQ(list_files(folder / "out"), std::vector<std::string>{});
  write_file(folder / "taken", "a file");
  const ProgramRun wrong = run_shell(folder, "mien bust a.yaml -o taken");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(wrong.err, "error: -o taken: it is a file; expected a folder\n");
}

TEST(bust, a_wrong_height_or_label_is_told_before_anything_is_done) {
  const auto folder = make_folder("bust_input");
  write_file(folder / "a.yaml", "mien: 1\n");
  for (const char* height : {"0", "-80mm", "10000"})
    EXPECT_EQ(run_shell(folder, fmt::format("mien bust a.yaml --height={} -o out", height)).err,
              fmt::format("error: --height: '{}' is outside 20mm..400mm\n", height));
  for (const char* height : {"nan", "inf", "tall", "80in"}) {
    const ProgramRun run = run_shell(folder, fmt::format("mien bust a.yaml --height {} -o out", height));
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err, fmt::format("error: --height: '{}' is not a length such as 80mm or 8cm\n", height));
  }
  write_file(folder / "long.yaml", "mien: 1\nbusts: [{label: \"" + std::string(10000, 'x') + "\"}]\n");
  const ProgramRun run = run_shell(folder, "mien bust long.yaml -o out");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("expected one line of 200 bytes at most"));
  EXPECT_LT(run.err.size(), 1000u);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(bust, text_of_authors_is_never_code) {
  const auto folder = make_folder("bust_label");
  write_file(folder / "a.yaml",
             "mien: 1\ntitle: \"*/ cube(99); /*\"\nbusts:\n  - {express: laugh, triangles: 8000, "
             "label: \"\\\"];cube(99);[\\\\ \U0001F600 {{foot}}\"}\n");
  const ProgramRun run = run_shell(folder, "mien bust a.yaml --openscad --no-stl -o out");
  ASSERT_EQ(run.status, 0) << run.err;  // compared with what was meant
  EXPECT_THAT(read_file(folder / "out/bust_laugh.scad"),
              HasSubstr("\nlabel = \"\\\"];cube(99);[\\\\ \xF0\x9F\x98\x80 {{foot}}\";\n"));
  EXPECT_EQ(list_files(folder / "out"),
            (std::vector<std::string>{"bust_laugh.scad", "bust_laugh.txt", "bust_laugh_openscad.stl"}));
}

TEST(bust, equal_names_are_told_apart_in_the_menu) {
  const auto folder = make_folder("bust_names");
  write_file(folder / "a.yaml",
             "mien: 1\nbusts:\n  - {express: tezuka/anger, triangles: 8000}\n"
             "  - {express: emfacs/anger, triangles: 8000}\n"
             "  - {express: tezuka/anger, height: 60mm, triangles: 8000}\n");
  ASSERT_EQ(run_shell(folder, "mien bust a.yaml --no-stl -o out").status, 0);
  const auto find_menu = [&](const char* name) {
    const std::string text = read_file(folder / "out" / name);
    const std::size_t at = text.find("\nexpression = ");
    return text.substr(at + 1, text.find('\n', at + 1) - at - 1);
  };
  EXPECT_THAT(find_menu("bust_anger.scad"),
              testing::StartsWith("expression = \"anger\"; // [anger, anger_2, "));
  EXPECT_THAT(find_menu("bust_anger.scad"), HasSubstr(", mien/anger"));
  EXPECT_THAT(find_menu("bust_anger_2.scad"),
              testing::StartsWith("expression = \"anger_2\"; // [anger, anger_2, "));
  EXPECT_THAT(find_menu("bust_anger_3.scad"),
              testing::StartsWith("expression = \"anger\"; // [anger, anger_2, "));
}

// Each vertex's distance from the nearest of the other mesh; both ways.
float find_furthest_mm(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  float furthest = 0;
  for (const auto& [from, to] : {std::pair{&a, &b}, std::pair{&b, &a}})
    for (const glm::vec3& p : *from) {
      float nearest = 1e9f;
      for (const glm::vec3& q : *to) nearest = std::min(nearest, glm::dot(p - q, p - q));
      furthest = std::max(furthest, std::sqrt(nearest));
    }
  return furthest;
}

// What the Customizer of a bust's source makes: bytes of an STL, or OpenSCAD's complaint.
ProgramRun pose_in_openscad(const std::filesystem::path& folder, const std::string& set) {
  write_file(folder / "sets.json",
             fmt::format("{{\"fileFormatVersion\": \"1\", \"parameterSets\": {{\"a\": {{{}}}}}}}", set));
  return run_shell(
      folder, "openscad --hardwarnings -p sets.json -P a --export-format binstl -o a.stl bust.scad 2>&1");
}

// Each colour but the skin's is where its part is and no further.
TEST(bust, colours_end_where_their_parts_end) {
  const Figure figure = build_figure(shipped().heads, HeadSpec{});
  BustCache cache{figure, {{"neutral", Pose{}}}, "A test", {}};
  BustSpec spec;
  spec.expression.name = "neutral";
  const MadeBust made = make_bust(cache, spec);
  const Box whole = compute_bounds(made.mesh.positions);
  ASSERT_GT(made.colours.size(), 3u);
  for (const ColourRange& range : made.colours) {
    if (range.name == "skin") continue;
    std::vector<glm::vec3> corners;
    for (std::size_t t = range.first; t < range.first + range.count; ++t)
      for (const std::uint32_t v : made.mesh.triangles[t]) corners.push_back(made.mesh.positions[v]);
    ASSERT_FALSE(corners.empty()) << range.name;
    const Box part = compute_bounds(corners);
    EXPECT_LT(part.high.z - part.low.z, 0.25f * (whole.high.z - whole.low.z)) << range.name;
    EXPECT_LT(part.high.y - part.low.y, 0.5f * (whole.high.y - whole.low.y)) << range.name;
  }
}

void expect_posed_alike(const Figure& figure, const std::filesystem::path& folder) {
  Pose laugh;
  for (const auto& [area, move, value] :
       {std::tuple{"chin", "down", 0.6}, std::tuple{"corner", "up", 0.9}, std::tuple{"lid", "lower", 0.6}})
    for (std::size_t i = 0; i < kMoveCount; ++i)
      if (kMoves[i].area == area && kMoves[i].move == move) laugh.values[i] = value;
  BustCache cache{figure, {{"neutral", Pose{}}, {"laugh", laugh}}, "A test", {}};
  BustSpec spec;
  spec.expression.name = "neutral";
  write_file(folder / "bust.scad",
             build_openscad_bust(make_bust(cache, spec).source, shipped_stock().templates));

  struct Case {
    std::string set;  // of the Customizer
    Pose pose;
    float bound_mm;
  };
  std::vector<Case> cases{{"\"expression\": \"laugh\"", laugh, 0.3f}};
  for (const auto& [area, side, move, value] :
       {std::tuple{"chin", Side::none, "down", 0.37}, std::tuple{"lid", Side::left, "upper", -1.0},
        std::tuple{"eye", Side::right, "side", 0.6}, std::tuple{"corner", Side::left, "up", -0.7}}) {
    Pose pose;
    pose.values[find_move(area, side, move).value()] = value;
    const std::string name = fmt::format("{}{}_{}", area,
                                         side == Side::none   ? ""
                                         : side == Side::left ? "_left"
                                                              : "_right",
                                         move);
    cases.push_back({fmt::format("\"{}\": \"{}\"", name, value), pose, 0.05f});
  }
  for (const Case& c : cases) {
    const ProgramRun run = pose_in_openscad(folder, c.set);
    ASSERT_EQ(run.status, 0) << run.out;
    spec.expression.pose = c.pose;
    EXPECT_LT(find_furthest_mm(read_stl(folder / "a.stl").positions, make_bust(cache, spec).mesh.positions),
              c.bound_mm)
        << c.set;
  }
}

TEST(bust, openscad_poses_the_face_as_mien_does) {
  expect_posed_alike(build_figure(shipped().heads, HeadSpec{}), make_folder("bust_pose"));
}

// Its lens too, with the gaze carved before it, and its hair.
TEST(bust, openscad_poses_a_drawn_face_as_mien_does) {
  HeadSpec spec;
  spec.design = {{"comic", 1.0}};
  spec.hair = "bob";
  expect_posed_alike(build_figure(shipped().heads, spec, FigureUse::print), make_folder("bust_drawn"));
}

TEST(bust, openscad_hollows_it_and_labels_it_as_mien_does) {
  const auto folder = make_folder("bust_hollow");
  const Figure figure = build_figure(shipped().heads, HeadSpec{});
  Pose open;
  open.values[find_move(Area::chin, Side::none, "down").value()] = 0.8;
  BustCache cache{figure,
                  {{"neutral", Pose{}}, {"open", open}},
                  "A test",
                  build_letters(find_template(shipped().stock.templates, "openscad/letters.csv"))};
  BustSpec spec;
  spec.expression.name = "neutral";
  spec.triangles = 8000;
  write_file(folder / "bust.scad",
             build_openscad_bust(make_bust(cache, spec).source, shipped_stock().templates));
  const auto compare = [&](const BustSpec& asked, const std::string& set) {
    const ProgramRun run = pose_in_openscad(folder, set);
    ASSERT_EQ(run.status, 0) << run.out;
    const Mesh meant = make_bust(cache, asked).mesh;
    const StlFacts facts = check_stl(folder / "a.stl");
    EXPECT_EQ(facts.open_edges, 0u) << set;
    EXPECT_EQ(facts.parts, asked.drain_mm > 0 ? 1u : 2u) << set;
    EXPECT_NEAR(facts.volume_mm3, compute_volume_mm3(meant), 0.002 * compute_volume_mm3(meant)) << set;
    const Box box = compute_bounds(meant.positions);
    EXPECT_LT(glm::distance(facts.box.low, box.low), 0.02) << set;
    EXPECT_LT(glm::distance(facts.box.high, box.high), 0.02) << set;
    // Every vertex of the base's back, and of the vent's mouth there, in either one.
    const auto list_back = [](const Mesh& mesh) {
      std::vector<glm::vec3> back;
      for (const glm::vec3& p : mesh.positions)
        if (p.y > 0 && p.z < 7.5f) back.push_back(p);
      return back;
    };
    EXPECT_LT(find_furthest_mm(list_back(read_stl(folder / "a.stl")), list_back(meant)), 0.02f) << set;
  };
  spec.is_hollow = true;
  compare(spec, R"("hollow": "true")");
  spec.drain_mm = 0;
  compare(spec, R"("hollow": "true", "drain_mm": "0")");
  spec.drain_mm = 4;
  spec.wall_mm = 1;  // one of those that the plan holds besides
  spec.expression = {"open", "", open, 1, {}};
  spec.magnet_mm = {6, 2};
  spec.label = "Oh, \"no\"! \\ \u00e9";
  compare(spec, R"("hollow": "true", "wall_mm": "1", "expression": "open", "magnet_diameter_mm": "6",)"
                R"("magnet_depth_mm": "2", "label": "Oh, \"no\"! \\ \u00e9")");
  const ProgramRun unknown = pose_in_openscad(folder, R"("expression": "grin")");
  EXPECT_EQ(unknown.status, 1);
  EXPECT_THAT(unknown.out, HasSubstr("there is no expression \"grin\"; known: neutral, open"));
  EXPECT_LT(unknown.out.size(), 2000u);
  const ProgramRun thick = pose_in_openscad(folder, R"("hollow": "true", "wall_mm": "6")");
  EXPECT_EQ(thick.status, 1);
  EXPECT_THAT(thick.out, HasSubstr("wall_mm can be 3.6 at most in a bust of this height"));
}

TEST(bust, no_expression_makes_the_wall_thinner) {
  const auto folder = make_folder("bust_wall");
  write_file(folder / "a.yaml",
             "mien: 1\nbusts: {all: tezuka, hollow: true, wall: 2.2mm, triangles: 8000}\n");
  ASSERT_EQ(run_shell(folder, "mien bust a.yaml --quiet -o out").status, 0);
  int reports = 0;
  for (const std::string& name : list_files(folder / "out")) {
    if (!name.ends_with(".txt")) continue;
    const std::string report = read_file(folder / "out" / name);
    const std::size_t at = report.find("\nwall ");
    EXPECT_GE(std::stod(report.substr(at + 6)), 0.97 * 2.2) << name;
    ++reports;
  }
  EXPECT_EQ(reports, 10);
}

}  // namespace
}  // namespace mien
