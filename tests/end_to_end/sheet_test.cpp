// Sheets as a person makes them, read back pixel by pixel.
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "end_to_end/program.hpp"
#include "render/picture.hpp"
#include "sheet/camera.hpp"
#include "sheet/layout.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

constexpr const char* kChild =
    "mien: 1\ntitle: A \"child\" \\ é\nhead: {age: child}\nrender: {quality: draft}\n";

// How much redder than green and blue together: high on the red pencil's lines alone.
int find_redness(const Pixels& page, int x, int y) {
  const std::uint8_t* p = &page.rgb[3 * (static_cast<std::size_t>(y) * page.size.width_px + x)];
  return p[0] - (p[1] + p[2]) / 2;
}

TEST(sheet, is_the_same_bytes_each_time_with_any_number_of_jobs) {
  const auto folder = make_folder("sheet_same");
  write_file(folder / "child.yaml", kChild);
  ProgramRun run = run_shell(folder, "mien sheet skulls child.yaml --size 60x75 --jobs 1");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "sheet   out/child/sheet_skulls.png\n");
  run = run_shell(folder, "mien sheet skulls child.yaml --size 60x75 --jobs 2 --json -o again.png");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "{\"sheet\":\"again.png\"}\n");
  EXPECT_EQ(read_file(folder / "again.png"), read_file(folder / "out/child/sheet_skulls.png"));
  EXPECT_EQ(list_files(folder),
            (std::vector<std::string>{"again.png", "child.yaml", "out/child/sheet_skulls.png"}));
}

TEST(sheet, draws_each_guide_line_at_its_height_in_every_view) {
  constexpr std::pair kCell{150, 144};
  const auto folder = make_folder("sheet_guides");
  write_file(folder / "child.yaml", kChild);
  const ProgramRun run = run_shell(folder, "mien sheet views child.yaml --size 150x144 --quiet -o views.png");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out + run.err, "");
  const Pixels page = read_pixels(folder / "views.png");

  SheetSubject subject;
  subject.spec.head.age = {{"child", 1.0}};
  const SheetPlan plan = build_sheet_plan("views", subject, *shipped_stock().head);
  const SheetLayout layout = build_sheet_layout(plan, "", kCell);
  ASSERT_EQ(page.size.width_px, layout.plate.width_px);
  ASSERT_EQ(page.size.height_px, layout.plate.height_px);
  const HeadMeasures head = measure_head(build_figure(shipped().heads, subject.spec.head));
  ASSERT_EQ(head.guides.size(), 7u);
  for (std::size_t i = 0; i < 4; ++i) {
    const SheetCell& cell = plan.blocks[1].cells[i];
    const CameraView view = compute_cell_view(cell, head, head);
    const double tall_mm = std::max(view.frame_height_mm, view.frame_width_mm * kCell.second / kCell.first);
    const auto [left, top] = layout.places[4 + i];
    const int x = left + kCell.first - 3;  // beside the head
    for (const auto& [name, y_mm] : head.guides) {
      const double row = top + (view.look_at.y + tall_mm / 2 - y_mm) / tall_mm * kCell.second - 0.5;
      int reddest = 0;
      for (int y = static_cast<int>(row) - 4; y <= row + 5; ++y)
        if (reddest == 0 || find_redness(page, x, y) > find_redness(page, x, reddest)) reddest = y;
      EXPECT_GT(find_redness(page, x, reddest), 40) << cell.caption << " " << name;
      EXPECT_NEAR(reddest, row, 1) << cell.caption << " " << name;
    }
  }
}

TEST(sheet, cells_hold_high_hair_and_a_head_that_stretches) {
  HeadSpec spec;
  const HeadMeasures bald = measure_head(build_figure(shipped().heads, spec));
  EXPECT_EQ(bald.above_mm, 0);
  spec.hair = "bob";
  spec.design = {{"comic", 1.0}};
  const HeadMeasures drawn = measure_head(build_figure(shipped().heads, spec, FigureUse::ink));
  EXPECT_GT(drawn.above_mm, 25);
  for (const HeadMeasures& scale : {bald, drawn}) {
    const CameraView view = compute_cell_view({}, drawn, scale);
    EXPECT_GT(view.look_at.y + view.frame_height_mm / 2, drawn.guides.back().second + drawn.above_mm);
  }
}

// In the picture of the chin, beside the neck: the levels of the limits in red.
TEST(sheet, draws_the_limits_on_the_face) {
  constexpr std::pair kCell{96, 72};
  const auto folder = make_folder("sheet_limits");
  write_file(folder / "child.yaml", kChild);
  const ProgramRun run = run_shell(folder, "mien sheet limits child.yaml --size 96x72 --quiet -o limits.png");
  ASSERT_EQ(run.status, 0) << run.err;
  const Pixels page = read_pixels(folder / "limits.png");
  const SheetLayout layout =
      build_sheet_layout(build_sheet_plan("limits", {}, *shipped_stock().head), "", kCell);
  ASSERT_EQ(page.size.width_px, layout.plate.width_px);
  ASSERT_EQ(page.size.height_px, layout.plate.height_px);
  const auto [left, top] = layout.places.at(5);
  int lines = 0;
  for (int y = top + 2, above = find_redness(page, left + 1, top + 1); y < top + kCell.second; ++y) {
    const int redness = find_redness(page, left + 1, y);
    if (redness > 40 && above <= 40) ++lines;
    above = redness;
  }
  EXPECT_EQ(lines, 2) << "up and down";
}

TEST(sheet, writes_nothing_if_its_words_are_wrong) {
  const auto folder = make_folder("sheet_wrong");
  write_file(folder / "child.yaml", kChild);
  write_file(folder / "crossed.yaml", "mien: 1\nhead: {guides: {eye_line: 0.25}}\n");
  const auto find_mistake = [&](const std::string& words) {
    const ProgramRun run = run_shell(folder, "mien sheet " + words);
    EXPECT_EQ(run.status, 2) << words;
    return run.err;
  };
  EXPECT_EQ(find_mistake("vews child.yaml"), "error: unknown kind 'vews'; did you mean 'views'?\n");
  EXPECT_EQ(find_mistake("poster child.yaml"),
            "error: unknown kind 'poster'; expected views, details, ages, skulls, features, expressions, "
            "libraries, designs, doctrines, heads, people, mouths, areas, limits, wire, compare, proofs, "
            "strip, exposure or "
            "contact\n");
  EXPECT_EQ(find_mistake("views child.yaml -o a.jpg"),
            "error: -o a.jpg: unknown kind of picture '.jpg'; expected a name that ends in .png\n");
  EXPECT_EQ(
      find_mistake("views child.yaml --size 8000x8000"),
      "error: --size: the sheet would have 34976x22416 pixels; expected cells so small that no side has "
      "more than 20000\n");
  EXPECT_EQ(find_mistake("expressions tezka"),
            "error: 'tezka' is no FILE and no library; did you mean 'tezuka'?\n");
  EXPECT_EQ(find_mistake("heads smlie"),
            "error: 'smlie' is no FILE; unknown expression 'smlie'; did you mean 'smile'?\n");
  EXPECT_NE(find_mistake("skulls crossed.yaml").find("guide line"), std::string::npos);
  EXPECT_EQ(list_files(folder), (std::vector<std::string>{"child.yaml", "crossed.yaml"}));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(sheet, wire_writes_lines_as_svg_and_as_png) {
  const auto folder = make_folder("sheet_wire");
  write_file(folder / "child.yaml", kChild);
  ProgramRun run = run_shell(folder, "mien sheet wire child.yaml --size 200x240 --guides");
  EXPECT_EQ(run.status, 0) << run.err;
  const std::string svg = read_file(folder / "out/child/sheet_wire.svg");
  EXPECT_NE(svg.find("<path fill=\"none\""), svg.npos);
  EXPECT_NE(svg.find(">brow line</text>"), svg.npos);
  const Pixels page = read_pixels(folder / "out/child/sheet_wire.png");
  EXPECT_GT(page.size.width_px, 600);
  // The same bytes again, whatever the threads.
  run = run_shell(folder, "mien sheet wire child.yaml --size 200x240 --guides --jobs 5 -o again.svg");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(read_file(folder / "again.svg"), svg);
  run = run_shell(folder, "mien sheet wire child.yaml --size 200x240 --express laugh -o laugh.svg");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(read_file(folder / "laugh.svg").find("Lines: laugh"), std::string::npos);
  run = run_shell(folder, "mien still child.yaml --wire --cage --limits --size 200x240 -o cage.png");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(read_picture_size(folder / "cage.png").width_px, 200);
  run = run_shell(folder, "mien still child.yaml --wire -o face.jpg");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(
      run.err,
      "error: -o face.jpg: unknown kind of line drawing '.jpg'; expected a name that ends in .svg or .png\n");
}

TEST(sheet, compare_tells_how_far_two_faces_are_apart) {
  const auto folder = make_folder("sheet_compare");
  write_file(folder / "child.yaml", kChild);
  ProgramRun run =
      run_shell(folder, "mien sheet compare child.yaml child.yaml@tezuka/laugh --size 120x140 -o two.png");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_GT(read_picture_size(folder / "two.png").width_px, 480);
  run = run_shell(folder, "mien sheet compare child.yaml child.yaml@smlie -o three.png");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "error: child.yaml@smlie: unknown expression 'smlie'; did you mean 'smile'?\n");
  run = run_shell(folder, "mien sheet compare child.yaml nobody.yaml@2s -o three.png");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("nobody.yaml"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "three.png"));
}

}  // namespace
}  // namespace mien
