// One cell of a sheet as it is drawn, whoever makes the picture of it.
#pragma once

#include <vector>

#include "frames/drawn_figure.hpp"
#include "render/picture.hpp"
#include "sheet/camera.hpp"
#include "sheet/marks.hpp"

namespace mien {

struct CellBuffers {
  DeformBuffers deform;
  InkBuffers ink;
};

struct CellDrawing {
  CameraView view;
  Drawing drawing;
  std::vector<Overlay> overlays;
};

// A head that cells show: its figure, where its landmarks go, and the measures of all heads up to it.
struct CellHead {
  const DrawnFigure& figure;
  const FigurePlaces& places;
  const std::vector<HeadMeasures>& measures;
  RenderSpec render;
};

// Draws the cell, and puts what is measured there behind its caption.
CellDrawing draw_cell(const CellHead& head, SheetCell& cell, CellBuffers& buffers);

// The pictures of all `cells` that show head number `index`, each into its place of `pictures`, by sketch/.
void sketch_cells(const CellHead& head, std::size_t index, const std::vector<SheetCell*>& cells,
                  const Templates& templates, int jobs, std::vector<Pixels>& pictures);

}  // namespace mien
