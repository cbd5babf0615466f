// `mien sheet KIND FILE`: a plan of plans.cpp as one picture. POV-Ray renders each cell and the page
// with its words; the cells are laid on the page.
#include "sheet/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "clip/outputs.hpp"
#include "clip/pictures.hpp"
#include "clip/scenes.hpp"
#include "clip/view.hpp"
#include "core/error.hpp"
#include "core/pool.hpp"
#include "core/text.hpp"
#include "render/driver.hpp"
#include "render/picture.hpp"
#include "render/process.hpp"
#include "render/progress.hpp"
#include "render/work_folder.hpp"
#include "sheet/asked_face.hpp"
#include "sheet/cell_drawing.hpp"
#include "sheet/layout.hpp"
#include "sheet/motion_table.hpp"
#include "sheet/plans.hpp"
#include "sheet/subject.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr double kLargeTitle_px = 50;     // the captions' letters are half as large
constexpr const char* kGround = "paper";  // templates/povray/background_paper.inc

fs::path find_sheet_path(const std::string& kind, const Options& options, const Spec& spec) {
  const OutputFile file = find_output_file(
      options, fs::path("out") / spec.name /
                   fmt::format("sheet_{}{}.png", kind, is_sketch(spec.render) ? "_sketch" : ""));
  check_ending(file, "picture", {".png"});
  check_output_files({file}, spec);
  return file.path;
}

std::vector<SheetCell*> list_cells(SheetPlan& plan) {
  std::vector<SheetCell*> cells;
  for (SheetBlock& block : plan.blocks)
    for (SheetCell& cell : block.cells) cells.push_back(&cell);
  return cells;
}

// What is wrong with a head, such as guide lines that cross, is known when it is built: each is, once, before
// anything is written.
void check_heads(const SheetPlan& plan, const Options& options, const HeadStock& stock) {
  for_each_index(plan.heads.size(), count_jobs(options), [&](std::size_t i, int) {
    throw_if_interrupted();
    build_neutral_head(stock, plan.heads[i]);
  });
}

// The scenes of all cells that show head number `index`, in a folder of their own.
void write_cell_scenes(const CellHead& head, std::size_t index, const std::vector<SheetCell*>& cells,
                       const fs::path& work, const Templates& templates) {
  const fs::path folder = work / fmt::format("head{}", index);
  const Model& model = head.figure.get_drawn_model();
  write_file(folder / "head.inc", build_povray_include(model, head.render, templates));
  write_part_pictures(model, folder);
  CellBuffers buffers;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i]->head != index) continue;
    throw_if_interrupted();
    const CellDrawing drawn = draw_cell(head, *cells[i], buffers);
    std::string scene;
    append_povray_frame(scene, model, drawn.drawing, drawn.view);
    for (const Overlay& overlay : drawn.overlays) append_povray_overlay(scene, overlay, drawn.view);
    write_file(folder / fmt::format("cell{}.pov", i), scene);
  }
}

// The values of this head's limits in the tables that tell them.
void fill_limits(const std::vector<Limit>& limits, SheetPlan& plan) {
  for (SheetBlock& block : plan.blocks) {
    if (!block.table.shows_limits) continue;
    for (std::vector<SheetField>& row : block.table.rows)
      for (const Limit& limit : limits)
        if (limit.name->name == row.front().words) {
          row.end()[-2].words = limit.unit == "deg"
                                    ? fmt::format("{:.1f} deg", limit.value)
                                    : fmt::format("{:.3f} {}", limit.value, build_caption(limit.unit));
          row.end()[-1].words = fmt::format("{:.1f}", limit.skin_mm);
        }
  }
}

// Builds the heads one after the other: none is kept but its measures. Cells become scenes in `work`, or, of
// a sketch, `pictures`.
void draw_all_cells(SheetPlan& plan, const RenderSpec& render, const fs::path& work,
                    const Resources& resources, int jobs, Progress& progress, std::vector<Pixels>& pictures) {
  const std::vector<SheetCell*> cells = list_cells(plan);
  if (is_sketch(render)) pictures.resize(cells.size());
  std::vector<HeadMeasures> measures;
  for (std::size_t i = 0; i < plan.heads.size(); ++i) {
    throw_if_interrupted();
    RenderSpec own = render;
    if (!plan.styles.empty()) own.style = plan.styles[i];
    const DrawnFigure figure = build_drawn_figure(resources.heads, plan.heads[i], own);
    measures.push_back(measure_head(figure));
    if (i == 0) fill_motions(figure, plan);
    const FigurePlaces places = build_places(figure);
    const CellHead head{figure, places, measures, own};
    if (is_sketch(render))
      sketch_cells(head, i, cells, resources.stock.templates, jobs, pictures);
    else
      write_cell_scenes(head, i, cells, work, resources.stock.templates);
    progress.advance(false, static_cast<int>(i) + 1);
  }
  progress.finish();
  fill_limits(measures.front().limits, plan);
}

void render_scenes(const std::vector<FrameJob>& jobs, const RenderSettings& settings, const Options& options,
                   const char* label) {
  Progress progress(stderr, compute_progress_style(stderr, options.is_quiet, options.is_json), label,
                    static_cast<int>(jobs.size()));
  render_frames(jobs, settings, {[&](int number, bool was_kept) { progress.advance(was_kept, number); }});
  progress.finish();
}

fs::path find_cell_picture(const fs::path& work, std::size_t cell) {
  return work / fmt::format("cell{}.png", cell);
}

void render_cells(const std::vector<SheetCell*>& cells, const RenderSpec& render, const fs::path& work,
                  const Options& options) {
  std::vector<FrameJob> jobs;
  for (std::size_t i = 0; i < cells.size(); ++i)
    jobs.push_back({static_cast<int>(i) + 1,
                    work / fmt::format("head{}", cells[i]->head) / fmt::format("cell{}.pov", i),
                    find_cell_picture(work, i), ""});
  render_scenes(jobs, list_settings(render, {}, count_jobs(options)), options, "cells");
}

// The page without its cells. Many rays for the words, whatever the cells' quality; where letters are so
// small that a stroke may pass between two pixels' middles, for every pixel.
Pixels render_page(const SheetLayout& layout, const fs::path& work, const Templates& templates) {
  write_file(work / "plate.pov", build_plate_scene(layout.plate, templates));
  RenderSettings settings;
  settings.width_px = layout.plate.width_px;
  settings.height_px = layout.plate.height_px;
  const bool is_small = layout.plate.words.front().size_px < kLargeTitle_px;
  settings.povray_options = {"+AM1", is_small ? "+A0.0" : "+A0.02", is_small ? "+R3" : "+R4", "-J"};
  render_frames({{1, work / "plate.pov", work / "plate.png", ""}}, settings, {[](int, bool) {}});
  return read_pixels(work / "plate.png");
}

}  // namespace

SheetFiles write_sheet(const Options& options, const Resources& resources) {
  SheetSubject subject = load_sheet_subject(options, resources.stock);
  SheetFiles files;
  if (is_of_face(options.kind) && (options.express || options.at_s || options.at_frames)) {
    const AskedFace face = find_asked_face(options, open_clip(options, *resources.stock.language), resources);
    subject.spec.head = face.head;
    subject.pose = face.pose;
    subject.words = face.words;
    files.held = face.held;
  }
  const Spec& spec = subject.spec;
  const fs::path path = find_sheet_path(options.kind, options, spec);
  SheetPlan plan = build_sheet_plan(options.kind, subject, *resources.stock.head);
  RenderSpec render = spec.render;
  render.background = kGround;
  const std::pair<int, int> cell_px = options.size_px.value_or(plan.cell_px);
  std::tie(render.width_px, render.height_px) = cell_px;
  const std::string title = find_sheet_title(spec);
  check_sheet_page(build_sheet_layout(plan, title, cell_px));
  require_programs({{"povray", "povray"}});
  check_heads(plan, options, resources.heads);

  remove_left_parts_of(path);
  const WorkFolder work(path.has_parent_path() ? path.parent_path() : ".");
  Progress progress(stderr, compute_progress_style(stderr, options.is_quiet, options.is_json), "heads",
                    static_cast<int>(plan.heads.size()));
  std::vector<Pixels> pictures;
  draw_all_cells(plan, render, work.path, resources, count_jobs(options), progress, pictures);
  const std::vector<SheetCell*> cells = list_cells(plan);
  if (!is_sketch(render)) render_cells(cells, render, work.path, options);
  const SheetLayout layout = build_sheet_layout(plan, title, cell_px);
  Pixels page = render_page(layout, work.path, resources.stock.templates);
  for (std::size_t i = 0; i < cells.size(); ++i)
    paste_pixels(page, is_sketch(render) ? pictures[i] : read_pixels(find_cell_picture(work.path, i)),
                 layout.places[i].left_px, layout.places[i].top_px);
  write_file(path, build_png(page));
  files.paths = {path};
  return files;
}

}  // namespace mien
