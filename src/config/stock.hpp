// All of mien's own data, read and checked once: the words of the language, what heads are made from, and the
// texts that scenes and prints are written with.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "config/head_data.hpp"
#include "config/load_spec.hpp"
#include "core/templates.hpp"

namespace mien {

struct Stock {
  LanguagePointer language;                            // libraries of expressions, words of heads
  std::map<std::string, std::string> library_sources;  // library -> the work it follows
  HeadDataPointer head;
  Templates templates;  // povray/*, openscad/* and blender/* of templates/
};

// Throws InputError with every mistake of these files at its place; what cannot be read, and a broken line of
// a table, throws RunError.
Stock load_stock(const std::filesystem::path& data_folder);

}  // namespace mien
