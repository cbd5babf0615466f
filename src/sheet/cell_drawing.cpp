#include "sheet/cell_drawing.hpp"

#include <fmt/format.h>

#include "clip/view.hpp"
#include "core/pool.hpp"
#include "core/text.hpp"
#include "frames/drawn_gaze.hpp"
#include "render/process.hpp"
#include "sketch/overlay.hpp"

namespace mien {

namespace {

// How far the skin goes in a cell with arrows: where it shows a limit, at the limit's place, so that all
// sheets say the same.
double compute_way_mm(const HeadMeasures& measures, const SheetCell& cell, const DrawnMarks& marks) {
  for (const Limit& limit : measures.limits)
    if (cell.pose.values[limit.name->move] == limit.name->sign) return limit.skin_mm;
  return marks.way_mm;
}

}  // namespace

CellDrawing draw_cell(const CellHead& head, SheetCell& cell, CellBuffers& buffers) {
  const HeadMeasures& measures = head.measures.at(cell.head);
  const std::pair size_px(head.render.width_px, head.render.height_px);
  CellDrawing drawn;
  drawn.view = compute_cell_view(cell, measures, head.measures.at(cell.framing.scale_of));
  // Without perspective all is seen from far away: what ink draws behind the head must not grow past it.
  constexpr double kFar = 1000;
  InkView view = compute_ink_view(drawn.view, head.render);
  const glm::dvec3 middle(drawn.view.look_at);
  view.camera_mm = middle + kFar * (view.camera_mm - middle);
  const Pose pose = head.figure.ink
                        ? turn_gaze_to_camera(head.figure, cell.pose, glm::dmat4(1), view.camera_mm)
                        : cell.pose;
  deform_figure(head.figure, pose, {}, buffers.deform, drawn.drawing);
  const PartShape skin = drawn.drawing.parts.front();
  if (head.figure.ink) draw_ink(*head.figure.ink, pose, view, buffers.ink, drawn.drawing);
  if (cell.has_guides)
    drawn.overlays.push_back(build_guides(measures,
                                          {skin.positions, skin.normals, head.figure.head.skin.triangles},
                                          drawn.view, size_px, cell.has_frame));
  const DrawnMarks marks = draw_marks(cell, head.places, drawn.view, size_px);
  drawn.overlays.push_back(marks.overlay);
  if (marks.way_mm > 0)
    cell.caption += fmt::format(", {} mm", format_number(compute_way_mm(measures, cell, marks), 1));
  if (cell.shows_height) cell.caption += fmt::format(", {} mm", format_number(measures.height_mm(), 0));
  return drawn;
}

void sketch_cells(const CellHead& head, std::size_t index, const std::vector<SheetCell*>& cells,
                  const Templates& templates, int jobs, std::vector<Pixels>& pictures) {
  struct Bench {
    CellBuffers buffers;
    SketchDesk desk;
  };
  std::vector<Bench> benches(static_cast<std::size_t>(jobs));
  const Model& model = head.figure.get_drawn_model();
  const std::string include = build_povray_stage("", head.render, templates);
  const Letters letters = find_letters(templates);
  for_each_index(cells.size(), jobs, [&](std::size_t i, int worker) {
    if (cells[i]->head != index) return;
    throw_if_interrupted();
    Bench& bench = benches[static_cast<std::size_t>(worker)];
    const CellDrawing drawn = draw_cell(head, *cells[i], bench.buffers);
    std::string start;
    append_povray_start(start, {{}, {}, {}, drawn.view});
    set_stage(bench.desk, build_sketch_stage(include, start, head.render.width_px, head.render.height_px));
    const SketchLook look = build_sketch_look(model, bench.desk.stage.names);
    std::vector<SketchFigure> figures{{&model, &look, &drawn.drawing}};
    std::vector<SketchOverlay> overlays;
    for (const Overlay& overlay : drawn.overlays)
      overlays.push_back(build_sketch_overlay(overlay, drawn.view, letters));
    for (const SketchOverlay& overlay : overlays) figures.push_back(find_figure(overlay));
    pictures[i] = trace_sketch(bench.desk, figures, {head.render.width_px, head.render.height_px});
  });
}

}  // namespace mien
