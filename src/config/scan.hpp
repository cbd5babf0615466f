// A YAML text as a tree of plain nodes, built from yaml-cpp's events. What YAML itself can do wrong (syntax,
// duplicate keys, tags, aliases, depth, several documents) is found here; what the words mean is
// yaml_reader's affair.
//
// The tree is ours and not yaml-cpp's, since its nodes forget duplicate keys and let an alias hold itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/source.hpp"

namespace mien {

enum class NodeKind {
  nothing,  // no value, or null
  text,
  list,
  mapping,
  alias,   // another node's content again
  broken,  // a mistake was told already; readers pass over it
};

struct YamlNode {
  NodeKind kind = NodeKind::nothing;
  bool is_quoted = false;  // a text in quotes or a block: never a number
  Spot spot;
  std::string text;
  // Of a list its items; of a mapping key, value, key, value, ..., where each key is a text and stands once.
  std::vector<std::uint32_t> children;
  std::uint32_t target = 0;  // of an alias
};

struct YamlDocument {
  SourceText source;
  std::vector<YamlNode> nodes;
  std::uint32_t root = 0;
};

// The one document of the text. Empty, with mistakes added, if it is no YAML, is empty or passes a limit;
// duplicate keys, keys that are no words, and tags are added too but leave a tree.
std::optional<YamlDocument> scan_document(SourceText source, Findings& findings);

}  // namespace mien
