// Sources that are compiled together share one unnamed namespace: what two of them name alike ends the build
// that most people have, and not the one of a developer who compiles each alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <regex>
#include <sstream>

#include "house/sources.hpp"

namespace mien {
namespace {

// What cmake/unity.cmake says of a list or a number: the words behind "set(NAME".
std::vector<std::string> read_words(const std::string& name) {
  std::ifstream in(std::filesystem::path(source_folder()) / "cmake/unity.cmake");
  std::stringstream all;
  all << in.rdbuf();
  const std::string text = all.str();
  const std::size_t begin = text.find("set(" + name + " ");
  if (begin == std::string::npos) return {};
  std::istringstream words(text.substr(begin, text.find(')', begin) - begin));
  std::vector<std::string> list;
  std::string word;
  words >> word;
  while (words >> word) list.push_back(word);
  return list;
}

bool holds(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// The names of a source's unnamed namespaces that may stand there once: constants, types, and functions with
// the types of what they take.
std::vector<std::string> find_own_names(const SourceFile& source) {
  static const std::regex kType(R"re(^(?:struct|class|enum class|using) (\w+)\b.*[{=])re");
  static const std::regex kConstant(R"re(^(?:inline )?(?:static )?(?:constexpr|const) [^=({]*?\b(k\w+)\b)re");
  static const std::regex kFunction(R"re(^[a-zA-Z][^;=(]*?\b(\w+)\(([^)]*)\).*\{$)re");
  std::vector<std::string> names;
  bool is_inside = false;
  for (const std::string& line : source.lines) {
    if (line == "namespace {") is_inside = true;
    if (line == "}  // namespace") is_inside = false;
    std::smatch found;
    if (!is_inside) continue;
    if (std::regex_search(line, found, kType) || std::regex_search(line, found, kConstant))
      names.push_back(found[1]);
    else if (std::regex_search(line, found, kFunction))
      names.push_back(fmt::format("{}({})", found[1].str(), found[2].str()));
  }
  return names;
}

// "src/a/x.cpp and src/a/y.cpp: kName" for each name that two sources compiled together both have.
std::string find_name_twice(const std::vector<SourceFile>& sources) {
  const auto alone = read_words("MIEN_ALONE"), solvers = read_words("MIEN_SOLVERS");
  const int together = std::stoi(read_words("MIEN_TOGETHER").at(0));
  std::map<std::string, int> count;
  std::map<std::pair<std::string, std::string>, std::string> first;  // (group, name) -> source
  std::string twice;
  for (const SourceFile& source : sources) {
    const std::string name = source.path.substr(4, source.path.size() - 4 - 4);
    const std::size_t slash = name.find('/');
    if (!source.path.ends_with(".cpp") || slash == std::string::npos || holds(alone, name)) continue;
    const std::string room = name.substr(0, slash);
    const std::string group =
        holds(solvers, name) ? "solvers" : fmt::format("{}_{}", room, count[room]++ / together);
    for (const std::string& own : find_own_names(source)) {
      const auto [at, is_new] = first.emplace(std::pair(group, own), source.path);
      if (!is_new && at->second != source.path)
        twice += fmt::format("{} and {}: {}\n", at->second, source.path, own);
    }
  }
  return twice;
}

TEST(house, sources_compiled_together_name_nothing_alike) {
  const auto sources = load_sources("src");
  EXPECT_GT(sources.size(), 20u);
  EXPECT_EQ(find_name_twice(sources), "");
}

TEST(house, a_name_that_two_sources_have_is_found) {
  const std::vector<std::string> lines{"namespace {",     "constexpr int kWide_px = 3;  // of a picture",
                                       "struct Row {",    "double share(int of) {",
                                       "}  // namespace", "constexpr int kOutside = 2;"};
  EXPECT_EQ(
      find_name_twice({{"src/sheet/a.cpp", lines}, {"src/sheet/b.cpp", lines}, {"src/clip/c.cpp", lines}}),
      "src/sheet/a.cpp and src/sheet/b.cpp: kWide_px\n"
      "src/sheet/a.cpp and src/sheet/b.cpp: Row\n"
      "src/sheet/a.cpp and src/sheet/b.cpp: share(int of)\n");
  EXPECT_EQ(find_name_twice({{"src/head/hair_mass.cpp", lines}, {"src/head/beard.cpp", lines}}), "")
      << "those on the list of the lone ones";
}

}  // namespace
}  // namespace mien
