#include "config/head_parts.hpp"

#include "config/half_head.hpp"
#include "config/point_names.hpp"

namespace mien {

namespace {

PointNames load_point_names(const std::filesystem::path& folder) {
  return list_point_names(load_half_head(folder));
}

}  // namespace

ShapeData load_shapes_alone(const std::filesystem::path& data_folder) {
  const std::filesystem::path folder = data_folder / "templates/head";
  Findings findings;
  ShapeData shapes = load_shape_data(folder, load_point_names(folder), findings);
  throw_mistakes(std::move(findings));
  return shapes;
}

HairData load_hair_alone(const std::filesystem::path& data_folder) {
  const std::filesystem::path folder = data_folder / "templates/head";
  Findings findings;
  HairData hair = load_hair_data(folder / "hair.yaml", load_point_names(folder), findings);
  throw_mistakes(std::move(findings));
  return hair;
}

}  // namespace mien
