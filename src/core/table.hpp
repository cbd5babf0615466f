// Tables of our own data: comma-separated lines, '#' begins a comment line, the first other line may be a
// heading.
#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace mien {

using Fields = std::vector<std::string>;

// Calls `use(fields)` for each line that is not empty, a comment or the heading; a message that it returns is
// an error. Throws RunError "FILE:LINE: ..." for it, for a line that has not `columns` fields, and for a file
// that cannot be read.
void read_table(const std::filesystem::path& file, std::size_t columns, bool has_heading,
                const std::function<std::string(const Fields&)>& use);

// The whole of `text` as a number.
std::optional<double> parse_field(const std::string& text);

// Three fields from `first` on as x, y, z; returns what is wrong with them, nothing if they are numbers.
std::string parse_vector(const Fields& fields, std::size_t first, glm::dvec3& into);

}  // namespace mien
