// Includes go one way: main -> command_line -> commands -> the rooms -> core. A room may use only the rooms
// named here; nobody includes its caller.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "house/sources.hpp"

namespace mien {
namespace {

using Rooms = std::set<std::string>;

const std::map<std::string, Rooms> kMayUse{
    {"core", {}},
    {"import", {"core"}},
    {"takes", {"import", "core"}},
    {"config", {"takes", "import", "core"}},
    {"head", {"import", "config", "core"}},
    {"face", {"head", "config", "core"}},
    {"timeline", {"config", "core"}},
    {"frames", {"timeline", "face", "head", "config", "core"}},
    {"print", {"core"}},
    {"scene", {"core"}},
    {"render", {"config", "core"}},
    {"options", {"config"}},
    {"sketch", {"render", "scene", "print", "core"}},
    {"wire", {"sketch", "render", "scene", "print", "core"}},
    {"voice", {"render", "import", "config", "core"}},
    {"mien_speak", {}},
    {"clip",
     {"options", "sketch", "voice", "render", "scene", "frames", "timeline", "face", "head", "config",
      "core"}},
    {"exchange",
     {"clip", "options", "render", "scene", "frames", "timeline", "face", "head", "config", "core"}},
    {"bust", {"clip", "options", "render", "scene", "print", "frames", "face", "head", "config", "core"}},
    {"sheet",
     {"wire", "clip", "options", "sketch", "render", "scene", "frames", "timeline", "face", "head", "config",
      "core"}},
    {"live",
     {"sheet", "clip", "sketch", "voice", "render", "scene", "frames", "timeline", "face", "head", "config",
      "core"}},
    {"commands",
     {"live", "sheet", "bust", "exchange", "wire", "clip", "options", "sketch", "voice", "render", "scene",
      "frames", "timeline", "face", "head", "import", "config", "core"}},
    {"command_line", {"commands", "options", "config", "core"}},
    {"mien_pages", {"command_line", "commands", "options", "config", "core"}},
    {"main", {"command_line", "render", "core"}},
};

// "src/core/mesh.hpp" and "core/mesh.hpp" are of "core"; "src/main.cpp" is of "main".
std::string compute_room(std::string path) {
  if (path.starts_with("src/")) path.erase(0, 4);
  return path.substr(0, path.find_first_of("/."));
}

// "src/core/mesh.cpp:3: core may not include head/head.hpp" for each wrong line.
std::string find_wrong_includes(const std::vector<SourceFile>& sources) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*"([^"]+)")re");
  std::string wrong;
  for (const SourceFile& source : sources) {
    const std::string room = compute_room(source.path);
    const auto may_use = kMayUse.find(room);
    if (may_use == kMayUse.end()) {
      wrong += fmt::format("{}: '{}' is no room of the house\n", source.path, room);
      continue;
    }
    for (std::size_t i = 0; i < source.lines.size(); ++i) {
      std::smatch found;
      if (!std::regex_search(source.lines[i], found, kInclude)) continue;
      const std::string used = compute_room(found[1]);
      if (used != room && !may_use->second.contains(used))
        wrong += fmt::format("{}:{}: {} may not include {}\n", source.path, i + 1, room, found[1].str());
    }
  }
  return wrong;
}

TEST(house, includes_go_one_way) {
  const auto sources = load_sources("src");
  EXPECT_GT(sources.size(), 20u);
  EXPECT_EQ(find_wrong_includes(sources), "");
}

TEST(house, a_wrong_include_is_told_with_its_line) {
  EXPECT_EQ(find_wrong_includes(
                {{"src/core/mesh.cpp", {"#include \"core/mesh.hpp\"", "# include \"head/head.hpp\""}}}),
            "src/core/mesh.cpp:2: core may not include head/head.hpp\n");
  EXPECT_EQ(find_wrong_includes({{"src/scene/povray.cpp", {"#include \"render/driver.hpp\""}}}),
            "src/scene/povray.cpp:1: scene may not include render/driver.hpp\n");
  EXPECT_EQ(find_wrong_includes({{"src/attic/a.cpp", {}}}),
            "src/attic/a.cpp: 'attic' is no room of the house\n");
  EXPECT_EQ(
      find_wrong_includes({{"src/main.cpp", {"#include \"command_line/help.hpp\"", "#include <vector>"}}}),
      "");
  EXPECT_EQ(find_wrong_includes({{"src/sheet/sheet.cpp", {"#include \"commands/report.hpp\""}}}),
            "src/sheet/sheet.cpp:1: sheet may not include commands/report.hpp\n");
}

TEST(house, no_room_leads_back_to_itself) {
  for (const auto& [room, used] : kMayUse) {
    std::vector<std::string> open(used.begin(), used.end());
    for (Rooms seen; !open.empty();) {
      const std::string next = open.back();
      open.pop_back();
      EXPECT_NE(next, room);
      if (!seen.insert(next).second) continue;
      open.insert(open.end(), kMayUse.at(next).begin(), kMayUse.at(next).end());
    }
  }
}

}  // namespace
}  // namespace mien
