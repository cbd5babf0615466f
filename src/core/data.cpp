#include "core/data.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace mien {

std::filesystem::path find_data_folder() {
  const auto is_data_folder = [](const std::filesystem::path& folder) {
    std::error_code ignored;
    return std::filesystem::is_directory(folder / "templates/head", ignored) &&
           std::filesystem::is_directory(folder / "configs/expressions", ignored);
  };
  std::error_code ignored;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  const std::filesystem::path beside = program.parent_path().parent_path();
  if (is_data_folder(beside)) return beside;
  if (is_data_folder(MIEN_SOURCE_DIR)) return MIEN_SOURCE_DIR;
  throw RunError(fmt::format("mien's data are missing: neither {} nor {} has templates/ and configs/",
                             beside.string(), MIEN_SOURCE_DIR));
}

}  // namespace mien
