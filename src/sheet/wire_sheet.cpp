#include "sheet/wire_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "clip/outputs.hpp"
#include "core/text.hpp"
#include "render/work_folder.hpp"
#include "sheet/asked_face.hpp"
#include "sheet/camera.hpp"
#include "sheet/layout.hpp"
#include "sheet/wire_head.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr std::pair kView_px{660, 820};
struct WireView {
  const char* caption;
  double angle_deg;
};
constexpr std::array kWireViews{WireView{"front", 0}, WireView{"three-quarter", 35}, WireView{"side", 90}};

SheetPlan plan_wire(const AskedFace& face) {
  SheetPlan plan;
  plan.subject = face.words.empty() ? "Lines" : "Lines: " + face.words;
  plan.cell_px = kView_px;
  SheetBlock& block = plan.blocks.emplace_back();
  for (const WireView& view : kWireViews) {
    SheetCell cell{view.caption};
    cell.angle_deg = view.angle_deg;
    block.cells.push_back(cell);
  }
  return plan;
}

// Level lines behind the head, and their names at the picture's left edge.
void append_levels(const HeadMeasures& measures, const CameraView& view, const WireCamera& camera,
                   const glm::dvec2& corner_px, WireModel& model, Paper& paper) {
  const glm::dvec3 toward(compute_toward_camera(view));
  const double half_mm = camera.size.width_px / camera.px_per_mm / 2;
  for (const auto& [name, y_mm] : measures.guides) {
    const glm::dvec3 middle =
        glm::dvec3(view.look_at.x, y_mm, view.look_at.z) - measures.height_mm() * toward;
    model.lines.push_back(
        {{glm::vec3(middle - half_mm * camera.right), glm::vec3(middle + half_mm * camera.right)},
         Pen::guide});
    PaperWords words{build_caption(name),
                     corner_px + find_paper_place(camera, middle - half_mm * camera.right)};
    words.capital_px = 0.013 * camera.size.height_px;
    words.at_px.y -= 0.4 * words.capital_px;
    words.srgb = get_pen_looks()[static_cast<std::size_t>(Pen::guide)].srgb;
    paper.words.push_back(words);
  }
}

}  // namespace

std::vector<fs::path> list_wire_files(const Options& options, const Spec& spec, const std::string& name) {
  std::vector<OutputFile> files;
  if (options.output)
    files.push_back({"-o", *options.output});
  else
    for (const char* ending : {".svg", ".png"})
      files.push_back({"", fs::path("out") / spec.name / (name + ending)});
  for (const OutputFile& file : files) check_ending(file, "line drawing", {".svg", ".png"});
  check_output_files(files, spec);
  std::vector<fs::path> paths;
  for (const OutputFile& file : files) paths.push_back(file.path);
  return paths;
}

void write_papers(const Paper& paper, const std::vector<fs::path>& paths, const Templates& templates) {
  for (const fs::path& path : paths) {
    remove_left_parts_of(path);
    write_file(path, find_ending(path) == ".svg"
                         ? build_paper_svg(paper)
                         : build_png(build_paper_pixels(paper, find_letters(templates))));
  }
}

SheetFiles write_wire_sheet(const Options& options, const Resources& resources) {
  const Clip clip = open_clip(options, *resources.stock.language);
  const AskedFace face = find_asked_face(options, clip, resources);
  const SheetPlan plan = plan_wire(face);
  SheetFiles files{list_wire_files(options, clip.spec, "sheet_wire"), face.held};
  const std::pair<int, int> cell_px = options.size_px.value_or(plan.cell_px);
  const SheetLayout layout = build_sheet_layout(plan, find_sheet_title(clip.spec), cell_px);
  check_sheet_page(layout);

  const Figure figure = build_figure(resources.heads, face.head);
  const HeadMeasures measures = measure_head(figure);
  WireModel head;
  append_wire_head(figure, {face.pose, {}, glm::dmat4(1)}, options.wire, head);
  Paper paper;
  paper.title = clip.spec.title.empty() ? clip.spec.name : clip.spec.title;
  append_plate(layout.plate, paper);
  for (std::size_t i = 0; i < kWireViews.size(); ++i) {
    const CameraView view = compute_cell_view(plan.blocks.front().cells[i], measures, measures);
    const WireCamera camera = build_wire_camera(view, {cell_px.first, cell_px.second});
    const glm::dvec2 corner(layout.places[i].left_px, layout.places[i].top_px);
    WireModel seen = head;
    if (options.wire.has_guides) append_levels(measures, view, camera, corner, seen, paper);
    draw_wire(seen, camera, get_pen_looks(), corner, count_jobs(options), paper);
  }
  write_papers(paper, files.paths, resources.stock.templates);
  return files;
}

Paper draw_wire_still(const Options& options, const Clip& clip, const Cast& cast, const Still& still,
                      const HeadStock& stock) {
  const Heads heads = build_heads(clip, cast, still.time_s, stock);
  WireModel model;
  for (std::size_t i = 0; i < heads.figures.size(); ++i) {
    Moment moment{};
    if (still.pose)
      moment.pose = *still.pose;
    else
      moment = sample_performance(heads.performances[i], still.time_s);
    if (!moment.is_there) continue;
    append_wire_head(*heads.figures[i], {moment.pose, moment.turn, find_actor_place(heads, i, moment)},
                     options.wire, model);
  }
  Paper paper;
  paper.title = clip.spec.title.empty() ? clip.spec.name : clip.spec.title;
  paper.size = {clip.spec.render.width_px, clip.spec.render.height_px};
  const CameraView view = build_start(clip, cast, still.camera, still.stage).view;
  draw_wire(model, build_wire_camera(view, paper.size), get_pen_looks(), {0, 0}, count_jobs(options), paper);
  return paper;
}

}  // namespace mien
