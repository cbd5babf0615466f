// What every command that builds heads begins with: mien's own data, and the solved adult.
#pragma once

#include "config/stock.hpp"
#include "head/form.hpp"

namespace mien {

// Made once, shared read-only by all threads.
struct Resources {
  Stock stock;
  HeadStock heads;
};

// About 0.2 s. Throws InputError for mistakes in the data, at their places.
Resources load_resources(const std::filesystem::path& data_folder);

}  // namespace mien
