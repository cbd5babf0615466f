#include "config/named_file.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "config/load_spec.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

Place find_place(const YamlValue& value) {
  return {value.document->source.file, value.spot.line, value.spot.byte + 1};
}

bool has_ending(const fs::path& file, const Names& endings) {
  return std::ranges::find(endings, find_ending(file)) != endings.end();
}

bool is_plain_name(const std::string& name) {
  constexpr std::size_t kMaxName = 1000;  // bytes; systems allow some 4000
  return !name.empty() && name.size() <= kMaxName &&
         std::ranges::none_of(name, [](unsigned char c) { return c < 0x20 || c == 0x7F; });
}

// Whether the key stands somewhere in the text, in quotes or not.
bool has_key(std::string_view text, std::string_view key) {
  for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at + 1)) {
    constexpr std::string_view kBefore = "\n\r\t {,\"'", kQuotes = "\"'";
    if (at > 0 && kBefore.find(text[at - 1]) == kBefore.npos) continue;
    std::size_t end = at + key.size();
    if (end < text.size() && kQuotes.find(text[end]) != kQuotes.npos) ++end;
    end = text.find_first_not_of(" \t", end);
    if (end != text.npos && text[end] == ':') return true;
  }
  return false;
}

NamedKind build_kind(const Names& keys, const std::string& wrong, const std::string& expected) {
  const auto is_right = [keys](std::string_view text) {
    return std::ranges::any_of(keys, [&](const std::string& key) { return has_key(text, key); });
  };
  return {is_right,
          fmt::format("{}: it has none of the keys {}; expected {}", wrong, join_names(keys), expected),
          "the file is empty; expected " + expected};
}

bool has_words(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    const std::size_t first = line.find_first_not_of(" \t");
    if (first != line.npos && line[first] != '#') return true;
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  return false;
}

}  // namespace

const NamedKind kMienFile = build_kind({"mien", "head", "clip", "expressions"}, "is no file for mien",
                                       "a file that begins with 'mien: 1'");
const NamedKind kLandmarkFile =
    build_kind({"landmarks", "unit"}, "is no file of landmarks", "landmarks: {prn: [x, y, z], ...}");

std::optional<SourceText> load_named_source(const fs::path& file, const NamedKind& kind, Findings& findings) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  std::string bytes;
  try {
    if (!error && size <= kMaxFileBytes) bytes = read_file(file);
  } catch (const RunError&) {
    bytes.clear();  // load_source says why
  }
  std::string_view text = bytes;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const bool is_sixteen = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");  // told below
  const auto fail = [&](const Place& place, const std::string& message) {
    findings.files.push_back(file);
    add_mistake(findings, place, message, {});
    return std::nullopt;
  };
  if (!error && size == 0) return fail({file.string(), 1, 1}, kind.empty);
  if (!text.empty() && !is_sixteen) {
    if (!has_words(text)) return fail({file.string(), 1, 1}, kind.empty);
    if (!kind.is_right(text)) return fail({file.string(), 1, 1}, kind.wrong);
  }
  return load_source(file, findings);
}

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
