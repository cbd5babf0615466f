#include "config/named_file.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>

namespace mien {

namespace {

namespace fs = std::filesystem;

Place find_place(const YamlValue& value) {
  return {value.document->source.file, value.spot.line, value.spot.byte + 1};
}

bool has_ending(const fs::path& file, const Names& endings) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::find(endings, ending) != endings.end();
}

bool is_plain_name(const std::string& name) {
  constexpr std::size_t kMaxName = 1000;  // bytes; systems allow some 4000
  return !name.empty() && name.size() <= kMaxName &&
         std::ranges::none_of(name, [](unsigned char c) { return c < 0x20 || c == 0x7F; });
}

}  // namespace

fs::path find_folder(const YamlValue& value) { return fs::path(value.document->source.file).parent_path(); }

fs::path find_canonical(const fs::path& file) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(file, error);
  return error ? file : canonical;
}

std::string find_file_fault(const std::string& name, const fs::path& folder, const Names& endings,
                            fs::path& path) {
  const std::string expected = "expected a file that ends in " + join_names(endings);
  if (!is_plain_name(name) || !has_ending(name, endings))
    return fmt::format("'{}' is no such file's name; {}", show_word(name), expected);
  path = folder / fs::path(name);
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return fmt::format("there is no file '{}'; {}", show_word(name), expected);
  if (!fs::is_regular_file(status))
    return fmt::format("'{}' is no plain file; {}", show_word(name), expected);
  return {};
}

bool has_room(const YamlValue& value, const fs::path& file) { return has_room(value, value.spot, file); }

bool has_room(const YamlValue& value, Spot spot, const fs::path& file) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) return true;  // whoever reads it tells why it cannot
  std::uintmax_t& all = value.findings->named_bytes;
  all += size;
  if (all <= kMaxNamedBytes) return true;
  add_mistake(*value.findings, value.document->source, spot,
              fmt::format("'{}' makes the texts that are named here {} bytes long; expected {} at most, all "
                          "together",
                          show_word(file.filename().string()), all, kMaxNamedBytes));
  return false;
}

bool load_file(const YamlValue& value, std::optional<FileReference>& into) {
  const Names& endings = find_form(value, FormKind::file).endings;
  std::string name;
  if (!load_text(value, "a file that ends in " + join_names(endings), name)) return false;
  fs::path path;
  const std::string fault = find_file_fault(name, find_folder(value), endings, path);
  if (!fault.empty()) {
    add_mistake(value, fault);
    return false;
  }
  value.findings->files.push_back(path);
  into = FileReference{path, find_place(value)};
  return true;
}

}  // namespace mien
