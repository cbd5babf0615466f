#include "config/edit_tree.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <unordered_map>

namespace mien {

namespace {

Tree build_branch(const YamlDocument& document, std::uint32_t index) {
  const YamlNode& node = document.nodes[index];
  Tree tree{node.kind, node.is_quoted, node.text, {}, index, Tree::kNone};
  if (node.kind == NodeKind::alias) tree.target = node.target;
  for (const std::uint32_t child : node.children) tree.children.push_back(build_branch(document, child));
  return tree;
}

// Nodes of one document by those of the other.
using Twins = std::unordered_map<std::uint32_t, std::uint32_t>;

bool is_same(const Tree& expected, const Tree& found, Twins& twins);

bool are_entries_same(const Tree& expected, const Tree& found, Twins& twins) {
  std::unordered_map<std::string_view, const Tree*> values;
  for (std::size_t i = 0; i < found.children.size(); i += 2)
    values[found.children[i].text] = &found.children[i + 1];
  for (std::size_t i = 0; i < expected.children.size(); i += 2) {
    const auto value = values.find(expected.children[i].text);
    if (value == values.end() || !is_same(expected.children[i + 1], *value->second, twins)) return false;
  }
  return true;
}

bool is_same(const Tree& expected, const Tree& found, Twins& twins) {
  if (expected.kind != found.kind || expected.is_quoted != found.is_quoted || expected.text != found.text ||
      expected.children.size() != found.children.size())
    return false;
  if (expected.node != Tree::kNone) twins[expected.node] = found.node;
  if (expected.kind == NodeKind::alias) {
    const auto twin = twins.find(expected.target);
    return twin != twins.end() && twin->second == found.target;
  }
  if (expected.kind == NodeKind::mapping) return are_entries_same(expected, found, twins);
  for (std::size_t i = 0; i < expected.children.size(); ++i)
    if (!is_same(expected.children[i], found.children[i], twins)) return false;
  return true;
}

}  // namespace

Tree build_tree(const EditText& text) {
  if (text.is_empty) return {NodeKind::mapping, false, "", {}, Tree::kNone, Tree::kNone};
  return build_branch(text.document, text.document.root);
}

Tree read_value(const std::string& value) {
  constexpr std::string_view kKey = "v: ";
  const auto refuse = [&] {
    throw InputError(
        fmt::format("the value '{}' is no YAML of one line; expected a word, a number, a text in quotes, "
                    "or a list or mapping in brackets",
                    show_word(value)));
  };
  if (value.empty() || value.find_first_of("\r\n") != value.npos) refuse();
  EditText text;
  try {
    text = open_text(std::string(kKey) + value);
  } catch (const InputError&) {
    refuse();
  }
  // With a blank, a comment or an anchor about it the value would not be all of the text.
  const Range range = text.ranges[text.document.nodes[text.document.root].children.at(1)];
  if (range.begin != kKey.size() || range.end != text.bytes.size()) refuse();
  Tree tree = build_tree(text).children[1];
  const auto forget_nodes = [](auto&& self, Tree& part) -> void {
    part.node = Tree::kNone;
    for (Tree& child : part.children) self(self, child);
  };
  forget_nodes(forget_nodes, tree);
  return tree;
}

Tree build_key_tree(const std::string& key) {
  return {NodeKind::text, false, key, {}, Tree::kNone, Tree::kNone};
}

Tree& find_branch(Tree& tree, const std::vector<std::size_t>& entries) {
  Tree* part = &tree;
  for (const std::size_t entry : entries)
    part = &part->children[part->kind == NodeKind::list ? entry : 2 * entry + 1];
  return *part;
}

std::string check_edit(std::string bytes, const Tree& expected, const YamlPath& path) {
  Twins twins;
  bool is_right = false;
  try {
    is_right = is_same(expected, build_tree(open_text(bytes)), twins);
  } catch (const InputError&) {
    is_right = false;
  }
  if (!is_right)
    throw InputError(
        fmt::format("{} cannot be changed alone, as the text is written; expected a change by hand",
                    describe_path(path)));
  return bytes;
}

}  // namespace mien
