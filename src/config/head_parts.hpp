// Parts of the head's data, each read without the others: for who lists words and builds no head.
#pragma once

#include <filesystem>

#include "config/hair_data.hpp"
#include "config/shape_data.hpp"

namespace mien {

// The same as load_head_data has them, in a fraction of its time. Both throw InputError with every mistake of
// the files at its place; what cannot be read, and a broken line of a table, throws RunError.
ShapeData load_shapes_alone(const std::filesystem::path& data_folder);
HairData load_hair_alone(const std::filesystem::path& data_folder);

}  // namespace mien
