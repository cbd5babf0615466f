#include "frames/resources.hpp"

namespace mien {

Resources load_resources(const std::filesystem::path& data_folder) {
  Resources resources;
  resources.stock = load_stock(data_folder);
  resources.heads = build_head_stock(resources.stock.head);
  return resources;
}

}  // namespace mien
