#include "core/data.hpp"

#include <fmt/format.h>

#include <array>

#include "core/error.hpp"

namespace mien {

namespace {

bool is_data_folder(const std::filesystem::path& folder) {
  std::error_code ignored;
  return std::filesystem::is_directory(folder / "templates/head", ignored) &&
         std::filesystem::is_directory(folder / "configs/expressions", ignored);
}

}  // namespace

std::filesystem::path find_data_folder() {
  std::error_code ignored;
  return find_data_folder(std::filesystem::read_symlink("/proc/self/exe", ignored));
}

std::filesystem::path find_data_folder(const std::filesystem::path& program) {
  const std::filesystem::path own = program.parent_path();
  const std::array<std::filesystem::path, 3> places{
      own.parent_path(), (own / MIEN_DATA_FROM_PROGRAM).lexically_normal(), MIEN_SOURCE_DIR};
  for (const std::filesystem::path& place : places)
    if (is_data_folder(place)) return place;
  throw RunError(fmt::format("mien's data are missing: none of {}, {} and {} has templates/ and configs/",
                             places[0].string(), places[1].string(), places[2].string()));
}

}  // namespace mien
