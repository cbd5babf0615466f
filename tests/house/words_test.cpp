// Whose words are whose: areas are named in one table, and core has never seen a face.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "config/areas.hpp"
#include "house/sources.hpp"

namespace mien {
namespace {

// A line without its comment.
std::string find_code(const std::string& line) { return line.substr(0, line.find("//")); }

// The text literals of a line of code that are the key of an area, or its name.
std::vector<std::string> find_area_names(const std::string& line) {
  static const std::regex kLiteral(R"re("((?:[^"\\]|\\.)*)")re");
  std::set<std::string_view> names;
  for (const AreaInfo& area : kAreas) names.insert(area.name);
  for (const AreaKey& key : kAreaKeys) names.insert(key.key);
  std::vector<std::string> found;
  const std::string code = find_code(line);
  for (std::sregex_iterator at(code.begin(), code.end(), kLiteral), end; at != end; ++at)
    if (names.contains((*at)[1].str())) found.push_back((*at)[1]);
  return found;
}

// The files that read mien's own data take each key by its name, and such a file may call a part as an area
// is called. Colours of a head's look have names of their own, which two areas happen to have, too; so have
// ink's; a landmark is the tip of the tongue; and a guide line that ends the face below is called as what it
// touches.
const std::set<std::pair<std::string, std::string>> kOtherThings{
    // What holds a brow, moves that doctrines have for their own, the thesis's table of faces, parts of a
    // head.
    {"src/commands/explain.cpp", "brow"},
    {"src/config/load_doctrine_data.cpp", "eye"},
    {"src/config/load_doctrine_data.cpp", "lips"},
    {"src/sheet/proof_faces.cpp", "brows"},
    {"src/sheet/proof_faces.cpp", "chin"},
    {"src/sheet/proof_faces.cpp", "corners"},
    {"src/sheet/proof_faces.cpp", "lids"},
    {"src/sheet/proof_faces.cpp", "lips"},
    {"src/sheet/wire_head.cpp", "chin"},
    {"src/sheet/wire_head.cpp", "tongue"},
    {"src/config/words.hpp", "brow"},
    {"src/config/words.hpp", "lips"},
    {"src/config/load_people.cpp", "brow"},
    {"src/config/load_head.cpp", "brow"},
    {"src/config/head_words.cpp", "brow"},
    {"src/config/head_words.cpp", "lips"},
    {"src/config/language_head.cpp", "brow"},
    {"src/config/language_head.cpp", "lips"},
    {"src/config/language_file.cpp", "mouth"},
    {"src/config/language_file.cpp", "tongue"},
    {"src/config/load_render.cpp", "mouth"},
    {"src/config/load_render.cpp", "tongue"},
    {"src/config/area_data.hpp", "tongue"},
    {"src/config/head_words.cpp", "tongue"},
    {"src/config/load_landmark_data.cpp", "tongue"},
    {"src/sheet/camera.cpp", "chin"}};

// The rooms that take areas from the table; the kernel, frames and scene speak of single ones.
bool takes_areas_from_the_table(const std::string& path) {
  static const std::regex kPath("src/((timeline|sheet|config|command_line|commands)/.*|[a-z_]+\\.[ch]pp)");
  static const std::set<std::string> kReaders{
      "src/config/areas.hpp",          "src/config/design_data.hpp",
      "src/config/load_area_data.cpp", "src/config/load_part_numbers.cpp",
      "src/config/load_shapes.cpp",    "src/config/parke.hpp"};
  return std::regex_match(path, kPath) && !kReaders.contains(path);
}

TEST(house, areas_are_named_in_one_table) {
  std::size_t looked_at = 0;
  for (const SourceFile& source : load_sources("src")) {
    if (!takes_areas_from_the_table(source.path)) continue;
    ++looked_at;
    for (std::size_t i = 0; i < source.lines.size(); ++i)
      for (const std::string& name : find_area_names(source.lines[i]))
        EXPECT_TRUE(kOtherThings.contains({source.path, name}))
            << source.path << ":" << i + 1 << ": \"" << name << "\" is the table's (config/areas.hpp)";
  }
  EXPECT_GT(looked_at, 100u);
}

TEST(house, an_area_named_elsewhere_is_found) {
  EXPECT_EQ(find_area_names("if (info.area == \"brow\" || key == \"corner.left\")  // \"lid\""),
            (std::vector<std::string>{"brow", "corner.left"}));
  EXPECT_TRUE(find_area_names("\"areas such as {brows: {up: 0.5}}\", \"eyelash\"").empty());
}

TEST(house, core_knows_no_faces) {
  static const std::regex kFace(
      R"re((^|[^a-z])(brow|lid|lip|eye|eyelid|mouth|chin|jaw|nose|cheek|tooth|teeth|tongue|hair|skin|face|head|bust)s?([^a-z]|$))re",
      std::regex::icase);
  // Where mien's data lie is told by a folder that holds a head's; and what frames/ makes and scene/ writes,
  // which may not know each other, has no other common ground.
  const std::set<std::string> exceptions{"src/core/data.cpp", "src/core/print.hpp"};
  for (const SourceFile& source : load_sources("src/core"))
    for (std::size_t i = 0; i < source.lines.size(); ++i) {
      const std::string code = find_code(source.lines[i]);
      if (code.starts_with("#include") || exceptions.contains(source.path)) continue;
      EXPECT_FALSE(std::regex_search(code, kFace)) << source.path << ":" << i + 1 << ": " << code;
    }
}

}  // namespace
}  // namespace mien
