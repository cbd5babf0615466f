// What a text says, without how it is written: to check that an edit did what was asked and nothing else.
#pragma once

#include <string>
#include <vector>

#include "config/edit_text.hpp"

namespace mien {

struct Tree {
  NodeKind kind = NodeKind::nothing;
  bool is_quoted = false;
  std::string text;
  std::vector<Tree> children;    // as of YamlNode
  std::uint32_t node = kNone;    // in its document
  std::uint32_t target = kNone;  // of an alias
  static constexpr std::uint32_t kNone = UINT32_MAX;
};

Tree build_tree(const EditText& text);

// YAML of one line. Throws InputError.
Tree read_value(const std::string& value);

Tree build_key_tree(const std::string& key);

// The part that a trail of entries leads to.
Tree& find_branch(Tree& tree, const std::vector<std::size_t>& entries);

// The bytes, if they say what is expected, keys of a mapping in any order. Throws InputError otherwise.
std::string check_edit(std::string bytes, const Tree& expected, const YamlPath& path);

}  // namespace mien
