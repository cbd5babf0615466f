#include "config/head_data.hpp"

namespace mien {

HeadDataPointer load_head_data(const std::filesystem::path& data_folder, const HeadWords& words) {
  const std::filesystem::path folder = data_folder / "templates/head";
  Findings findings;
  auto data = std::make_shared<HeadData>();
  data->half = load_half_head(folder);
  const PointNames points = list_point_names(data->half);
  data->shapes = load_shape_data(folder, points, findings);
  data->designs = load_designs(folder / "designs", findings);
  data->parts = load_part_numbers(folder / "parts.yaml", findings);
  data->hair = load_hair_data(folder / "hair.yaml", points, findings);
  data->landmarks = load_landmark_data(folder / "landmarks.yaml", points, findings);
  data->areas = load_area_data(folder / "areas.yaml", points, findings);
  data->doctrines = load_doctrine_data(folder, points, findings);
  data->folds = load_fold_data(folder / "folds.yaml", points, findings);
  data->words = words;
  throw_mistakes(std::move(findings));
  return data;
}

}  // namespace mien
