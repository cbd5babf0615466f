#include "config/stock.hpp"

#include "core/text.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

Templates load_templates(const fs::path& data_folder) {
  const fs::path folder = data_folder / "templates";
  Templates templates;
  const auto add = [&](const fs::path& path) {
    templates[path.lexically_relative(folder).generic_string()] = {path.string(), read_file(path)};
  };
  for (const char* part : {"povray", "openscad", "blender"})
    for (const auto& entry : fs::directory_iterator(folder / part))
      if (entry.is_regular_file()) add(entry.path());
  return templates;
}

}  // namespace

Stock load_stock(const fs::path& data_folder) {
  Stock stock;
  stock.language = load_language(data_folder);
  stock.library_sources = load_library_sources(data_folder / "configs/expressions");
  stock.head = load_head_data(data_folder, stock.language->words);
  stock.templates = load_templates(data_folder);
  return stock;
}

}  // namespace mien
