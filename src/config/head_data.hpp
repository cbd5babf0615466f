// What heads are made from: the files of templates/head, read and checked once.
#pragma once

#include <filesystem>
#include <memory>

#include "config/area_data.hpp"
#include "config/design_data.hpp"
#include "config/doctrine_data.hpp"
#include "config/fold_data.hpp"
#include "config/hair_data.hpp"
#include "config/half_head.hpp"
#include "config/head_words.hpp"
#include "config/landmark_data.hpp"
#include "config/part_numbers.hpp"
#include "config/shape_data.hpp"

namespace mien {

struct HeadData {
  HalfHead half;
  ShapeData shapes;
  std::vector<Design> designs;
  PartNumbers parts;
  HairData hair;
  LandmarkData landmarks;
  AreaData areas;
  DoctrineData doctrines;
  FoldData folds;
  HeadWords words;  // those of the language, which scans and looks need too
};

// Whoever builds a head shares its data.
using HeadDataPointer = std::shared_ptr<const HeadData>;

// Throws InputError with every mistake of the files at its place; what cannot be read, and a broken line of a
// table, throws RunError.
HeadDataPointer load_head_data(const std::filesystem::path& data_folder, const HeadWords& words);

}  // namespace mien
