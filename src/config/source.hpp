// A text file as lines that a message can point into: UTF-8, within its limits, line ends made one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/findings.hpp"

namespace mien {

struct SourceText {
  std::string file;                      // as it stands in messages
  std::string text;                      // without a byte order mark; lines end with '\n'
  std::vector<std::size_t> line_starts;  // offset of each line in `text`
};

// Reads the file: empty, with a mistake added, if it cannot be read, is larger than kMaxFileBytes, is not
// UTF-8, holds control characters or is indented with tabs.
std::optional<SourceText> load_source(const std::filesystem::path& file, Findings& findings);

// The same checks on bytes in memory.
std::optional<SourceText> build_source(std::string file, std::string bytes, Findings& findings);

// Line `line` (from 1) without its end; empty past the last one.
std::string_view find_line(const SourceText& source, int line);

// A spot in a text: line from 1, and bytes from the line's start, from 0.
struct Spot {
  int line = 1;
  int byte = 0;
};

// The spot as editors count: lines and characters from 1.
Place find_place(const SourceText& source, Spot spot);

// Adds a mistake with the line's text, at its place.
void add_mistake(Findings& findings, const SourceText& source, Spot spot, std::string message);

}  // namespace mien
