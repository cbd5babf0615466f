#include "render/picture_store.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/picture.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

struct StoredFile {
  fs::path path;
  std::uintmax_t bytes = 0;
  fs::file_time_type used;
  bool operator<(const StoredFile& other) const {
    return used != other.used ? used < other.used : path < other.path;
  }
};

std::vector<StoredFile> list_stored(const PictureStore& store) {
  std::vector<StoredFile> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(store.folder, error)) {
    if (!is_stored_file(entry.path().filename().string()) || !entry.is_regular_file(error)) continue;
    files.push_back({entry.path(), entry.file_size(error), entry.last_write_time(error)});
  }
  return files;
}

}  // namespace

bool is_stored_file(const std::string& name) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  constexpr std::size_t kKeySize = 16;
  return name.size() == kKeySize + 4 && name.ends_with(".png") && name.find_first_not_of(kDigits) == kKeySize;
}

bool has_picture(const PictureStore& store, const std::string& key) {
  return !key.empty() && read_picture_key(store.picture(key)) == key;
}

void show_picture(const fs::path& stored, const fs::path& shown) {
  std::error_code error;
  // Of one that a frame shows already the time stays: it would be that frame's, too.
  if (fs::hard_link_count(stored, error) == 1)
    fs::last_write_time(stored, fs::file_time_type::clock::now(), error);
  fs::create_directories(shown.parent_path(), error);
  if (error) throw RunError(fmt::format("cannot write {}: {}", shown.string(), error.message()));
  fs::path second = shown;
  second += fmt::format(".{}.part", ::getpid());
  fs::remove(second, error);
  fs::create_hard_link(stored, second, error);
  if (error) return write_file(shown, read_file(stored));
  fs::rename(second, shown, error);
  std::error_code ignored;
  fs::remove(second, ignored);  // rename(2) of two names of one file leaves both
  if (error) throw RunError(fmt::format("cannot write {}: {}", shown.string(), error.message()));
}

void trim_store(const PictureStore& store, const std::set<std::string>& in_use) {
  std::vector<StoredFile> files = list_stored(store);
  std::uintmax_t bytes = 0;
  for (const StoredFile& file : files) bytes += file.bytes;
  std::sort(files.begin(), files.end());
  for (const StoredFile& file : files) {
    if (bytes <= store.most_bytes) return;
    if (in_use.contains(file.path.stem().string())) continue;
    std::error_code error;
    if (fs::remove(file.path, error)) bytes -= file.bytes;
  }
}

void clean_file(const fs::path& file, Cleaned& cleaned) {
  std::error_code error;
  const bool is_last = fs::hard_link_count(file, error) == 1;
  const std::uintmax_t bytes = error ? 0 : fs::file_size(file, error);
  if (!fs::remove(file, error)) return;
  ++cleaned.files;
  if (is_last) cleaned.bytes += bytes;
}

void clean_store(const PictureStore& store, Cleaned& cleaned) {
  for (const StoredFile& file : list_stored(store)) clean_file(file.path, cleaned);
  std::error_code ignored;
  fs::remove(store.folder / kKnownDrawings, ignored);
  fs::remove(store.folder, ignored);  // only if it is empty
}

}  // namespace mien
