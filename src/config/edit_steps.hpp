// What the edits of edit.hpp have in common.
#pragma once

#include <string>
#include <vector>

#include "config/edit_entries.hpp"

namespace mien {

// A value that is new: on one line, and in lines of its own where its neighbours are written so.
struct NewValue {
  std::string flow;
  std::vector<std::string> block = {};
};

// As set_value; `is_new_item`: a further item before the one that the path's last step counts.
std::string put_value(const std::string& text, const YamlPath& path, const NewValue& value, bool is_new_item);

}  // namespace mien
