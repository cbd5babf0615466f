// The numbers of a print's formulas stand once, in core/print_numbers.hpp: OpenSCAD's templates have them
// filled in, and the C++ beside them has no second copy.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "core/text.hpp"
#include "house/sources.hpp"

namespace mien {
namespace {

using Numbers = std::set<double>;

// The numbers in a text of C++ or OpenSCAD: not those of comments, strings, names, placeholders and indices.
Numbers find_numbers(const std::string& text) {
  Numbers numbers;
  const auto is_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  std::size_t i = 0;
  const auto skip_to = [&](const char* end) {
    const std::size_t at = text.find(end, i);
    i = at == std::string::npos ? text.size() : at + std::string_view(end).size();
  };
  while (i < text.size()) {
    const char c = text[i];
    if (text.compare(i, 2, "//") == 0 || c == '#') {
      skip_to("\n");
    } else if (text.compare(i, 2, "/*") == 0) {
      skip_to("*/");
    } else if (c == '\'') {  // a character
      i += text.compare(i + 1, 1, "\\") == 0 ? 4 : 3;
    } else if (c == '"') {
      for (++i; i < text.size() && text[i] != '"'; ++i) i += text[i] == '\\';
      ++i;
    } else if (text.compare(i, 2, "{{") == 0 && i + 2 < text.size() && std::islower(text[i + 2])) {
      skip_to("}}");
    } else if (std::isdigit(static_cast<unsigned char>(c))) {
      char* end = nullptr;
      const double value = std::strtod(text.c_str() + i, &end);
      const auto after = static_cast<std::size_t>(end - text.c_str());
      const bool is_index = i > 0 && text[i - 1] == '[' && after < text.size() && text[after] == ']';
      if (!is_index) numbers.insert(value);
      for (i = after; i < text.size() && is_of_name(text[i]); ++i) continue;
    } else if (is_of_name(c)) {
      while (i < text.size() && is_of_name(text[i])) ++i;
    } else {
      ++i;
    }
  }
  return numbers;
}

std::string read_source(const std::string& path) {
  return read_file(std::filesystem::path(source_folder()) / path);
}

TEST(print_numbers, are_found_in_code_only) {
  EXPECT_EQ(find_numbers("a1 = 0.25 * b[3] - {{three}} // 7\n  + \"9\\\"8\" + x_2(1e-6f, '\"') /* 8 */;"),
            (Numbers{0.25, 1e-6}));
}

TEST(print_numbers, templates_have_none_that_is_not_openscads_own) {
  const Numbers structure{0, 0.5, 1, 2, 3, 4};  // halves, neighbours, powers, the smooth step's 3 - 2 t
  const std::map<std::string, Numbers> own{
      {"base", {32, 97, 122, 127}},  // character codes
      // How high and how wide the Customizer's own bounds are; the polyhedron's convexity; half a turn.
      {"bust", {1.6, 10, 12, 180}},
      {"hollow", {0.01, 0.1, 100}},  // walls between two that are known: a hundredth of a millimetre, no room
  };
  for (const auto& [name, allowed] : own) {
    Numbers found = find_numbers(read_source("templates/openscad/" + name + ".scad"));
    for (const double number : structure) found.erase(number);
    EXPECT_EQ(found, allowed) << name << ".scad: a number that C++ knows too belongs into "
                              << "src/core/print_numbers.hpp and src/scene/openscad_numbers.cpp";
  }
}

TEST(print_numbers, formulas_have_no_second_copy) {
  const auto is_telling = [](double number) { return number != std::floor(number) || number >= 10; };
  Numbers known;
  for (const double number : find_numbers(read_source("src/core/print_numbers.hpp")))
    if (is_telling(number) && number != 0.5) known.insert(number);
  EXPECT_GT(known.size(), 30U);
  int files = 0;
  for (const char* folder : {"src/frames", "src/print", "src/scene"})
    for (const SourceFile& source : load_sources(folder)) {
      const std::string name = std::filesystem::path(source.path).stem().string();
      static const std::set<std::string> kFormulas{
          "bust_eyes", "bust_mouth", "bust_patch",     "bust_controls",   "base", "label_panel", "glyphs",
          "cavity",    "openscad",   "openscad_lists", "openscad_numbers"};
      if (!kFormulas.contains(name)) continue;
      ++files;
      for (const double number : find_numbers(read_source(source.path)))
        EXPECT_FALSE(known.contains(number)) << source.path << " has " << number << " once more";
    }
  EXPECT_GE(files, 20);
}

}  // namespace
}  // namespace mien
