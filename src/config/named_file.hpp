// Files that a file names: found from the folder of the file that names them, plain ones only, by their
// endings.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "config/head_spec.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

// The folder of the file that the value stands in.
std::filesystem::path find_folder(const YamlValue& value);

// The file's one name, whatever links lead to it; of what has none, such as a pipe, the one that is given.
std::filesystem::path find_canonical(const std::filesystem::path& file);

// What is wrong with a file's name or with the file that it names; empty: nothing. Only then `path` holds.
std::string find_file_fault(const std::string& name, const std::filesystem::path& folder,
                            const Names& endings, std::filesystem::path& path);

// False, with a mistake told, if the value names no such file.
bool load_file(const YamlValue& value, std::optional<FileReference>& into);

// All texts together that a file names: a megabyte of YAML takes a second to read.
inline constexpr std::uintmax_t kMaxNamedBytes = 4 << 20;

// A kind of text that a file may name.
struct NamedKind {
  std::function<bool(std::string_view text)> is_right;  // at a glance
  std::string wrong;                                    // what is said of another kind of text
  std::string empty;                                    // and of one without any words
};

extern const NamedKind kMienFile, kLandmarkFile;

// The text as load_source reads it. Of one of another kind (whatever a path or a link leads to) one mistake
// is told, for the file as a whole, and none of its words.
std::optional<SourceText> load_named_source(const std::filesystem::path& file, const NamedKind& kind,
                                            Findings& findings);

// Whether there is room for one more text among those that are read; if not it is told at the value, as a
// mistake.
bool has_room(const YamlValue& value, const std::filesystem::path& file);
bool has_room(const YamlValue& value, Spot spot, const std::filesystem::path& file);

}  // namespace mien
