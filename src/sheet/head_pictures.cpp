#include "sheet/head_pictures.hpp"

namespace mien {

HeadStage build_head_stage(const PictureSize& size, const Templates& templates) {
  HeadStage stage;
  stage.render.width_px = size.width_px;
  stage.render.height_px = size.height_px;
  stage.render.background = "paper";  // templates/povray/background_paper.inc, as on all sheets
  stage.include = build_povray_stage("", stage.render, templates);
  return stage;
}

Pixels sketch_head(HeadStage& stage, const CameraView& view, const Model& model, const Drawing& drawing,
                   const SketchLook* look) {
  const PictureSize size{stage.render.width_px, stage.render.height_px};
  std::string start;
  append_povray_start(start, {{}, {}, {}, view});
  set_stage(stage.desk, build_sketch_stage(stage.include, start, size.width_px, size.height_px));
  const SketchLook own = look ? *look : build_sketch_look(model, stage.desk.stage.names);
  return trace_sketch(stage.desk, {{&model, &own, &drawing}}, size);
}

Paper draw_head_lines(const WireModel& model, const WireCamera& camera, int jobs) {
  Paper paper;
  paper.size = camera.size;
  draw_wire(model, camera, get_pen_looks(), {0, 0}, jobs, paper);
  return paper;
}

}  // namespace mien
