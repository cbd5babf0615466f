// What README and manual say is true: their examples load, their links and pictures lead to something, their
// command lines are understood.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "command_line/arguments.hpp"
#include "command_line/help.hpp"
#include "config/load_spec.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "places.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = source_folder();

// From the project's folder, by name: README.md and its like, then all pages of docs/.
std::vector<std::string> list_documents() {
  std::vector<std::string> documents;
  for (const char* folder : {".", "docs"})
    for (const auto& entry : fs::directory_iterator(kRoot / folder))
      if (entry.path().extension() == ".md")
        documents.push_back(fs::relative(entry.path(), kRoot).generic_string());
  std::sort(documents.begin(), documents.end());
  return documents;
}

// Those that tell how mien is used today.
std::vector<std::string> list_manual() {
  std::vector<std::string> documents = list_documents();
  std::erase(documents, "CHANGELOG.md");
  return documents;
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// What stands between "```LANGUAGE" and "```", each block a text of its own.
std::vector<std::string> list_blocks(const std::string& markdown, const std::string& language) {
  std::vector<std::string> blocks;
  bool is_inside = false, is_wanted = false;
  for (const std::string& line : split_lines(markdown)) {
    if (line.starts_with("```")) {
      is_inside = !is_inside;
      is_wanted = is_inside && line.substr(3) == language;
      if (is_wanted) blocks.emplace_back();
    } else if (is_wanted) {
      blocks.back() += line + "\n";
    }
  }
  return blocks;
}

// The same without any block.
std::string remove_blocks(const std::string& markdown) {
  std::string text;
  bool is_inside = false;
  for (const std::string& line : split_lines(markdown)) {
    if (line.starts_with("```"))
      is_inside = !is_inside;
    else if (!is_inside)
      text += line + "\n";
  }
  return text;
}

// Where a Markdown text links to and what pictures it shows, without what lies on the web.
std::vector<std::string> list_links(const std::string& markdown) {
  static const std::regex kLink(R"re(\]\(([^)\s]+)\)|(?:src|href)="([^"]+)")re");
  std::vector<std::string> links;
  const std::string text = remove_blocks(markdown);
  for (std::sregex_iterator found(text.begin(), text.end(), kLink), end; found != end; ++found) {
    const std::string link = (*found)[1].matched ? (*found)[1].str() : (*found)[2].str();
    if (link.find("://") == link.npos) links.push_back(link);
  }
  return links;
}

// The names by which a page's headings are linked to: lower case, "-" for a blank, no other signs but "_".
std::set<std::string> list_anchors(const std::string& markdown) {
  std::set<std::string> anchors;
  for (const std::string& line : split_lines(remove_blocks(markdown))) {
    const std::size_t level = line.find_first_not_of('#');
    if (level == 0 || level == line.npos || line[level] != ' ') continue;
    std::string anchor;
    for (const char c : line.substr(level + 1)) {
      if (c == ' ') anchor += '-';
      if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
        anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    anchors.insert(anchor);
  }
  return anchors;
}

// What is wrong with a link of a document; empty: nothing.
std::string find_link_fault(const std::string& document, const std::string& link) {
  const std::size_t hash = link.find('#');
  const fs::path file = kRoot / document;
  const fs::path target = hash == 0 ? file : file.parent_path() / link.substr(0, hash);
  if (!fs::exists(target)) return "there is no such file";
  if (hash == link.npos) return {};
  return list_anchors(read_file(target)).contains(link.substr(hash + 1)) ? "" : "there is no such heading";
}

// A line of a shell as the words of each `mien` or `build/mien` that it runs, without comments, and without
// what goes into a file.
std::vector<std::vector<std::string>> split_commands(const std::string& line) {
  std::vector<std::vector<std::string>> commands;
  std::istringstream in(line.substr(0, line.find(" #")));
  bool is_ours = false, begins = true;
  for (std::string word; in >> word;) {
    if (word == "&&" || word == "|" || word == ";") {
      begins = true;
      continue;
    }
    if (begins && (word == "mien" || word == "build/mien")) {
      commands.emplace_back();
      is_ours = true;
    } else if (begins || word.starts_with(">")) {
      is_ours = false;
    }
    begins = false;
    if (is_ours) commands.back().push_back(word);
  }
  return commands;
}

// What mien says against a command line before it reads a file; empty: nothing.
std::string find_command_fault(const std::vector<std::string>& words) {
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  try {
    const Request request = read_arguments(static_cast<int>(argv.size()), argv.data());
    if (!request.command || !request.command->list_kinds) return {};
    const std::vector<std::string> kinds = request.command->list_kinds();
    return std::ranges::find(kinds, request.options.kind) != kinds.end() ? ""
                                                                         : "unknown " + request.options.kind;
  } catch (const InputError& e) {
    return e.what();
  }
}

// What is wrong with a command named in running text, which may lack its FILE and say KIND for a word: its
// name, an option, or what it lists.
std::string find_mention_fault(const std::string& mention) {
  std::istringstream in(mention);
  std::string mien, name, kind;
  in >> mien >> name;
  const CommandInfo* command = find_command(name);
  if (!command) return name == "COMMAND" || name.starts_with("-") ? "" : "unknown command";
  static const std::regex kOption("--([a-z0-9-]+)");
  for (std::sregex_iterator found(mention.begin(), mention.end(), kOption), end; found != end; ++found) {
    const auto options = list_options(*command);
    if (std::ranges::find(options, (*found)[1].str(), &OptionInfo::name) == options.end())
      return "unknown option " + found->str();
  }
  if (!command->list_kinds || !(in >> kind) || kind == "KIND") return {};
  const std::vector<std::string> kinds = command->list_kinds();
  return std::ranges::find(kinds, kind) != kinds.end() ? "" : "unknown " + kind;
}

// Examples may name a mesh of one's own.
TEST(house, every_example_of_the_documents_loads) {
  const fs::path folder = fs::path(testing::TempDir()) / "mien_documents";
  fs::create_directories(folder);
  fs::copy_file(kRoot / "templates/head/half.obj", folder / "my_half.obj",
                fs::copy_options::overwrite_existing);
  int count = 0;
  for (const std::string& document : list_manual())
    for (const std::string& block : list_blocks(read_file(kRoot / document), "yaml")) {
      const fs::path file = folder / ("example" + std::to_string(++count) + ".yaml");
      write_file(file, block);
      try {
        load_spec(file, *shipped().stock.language);
      } catch (const InputError& e) {
        for (const Diagnostic& diagnostic : e.diagnostics)
          ADD_FAILURE() << document << ": " << format_diagnostic(diagnostic);
      }
    }
  EXPECT_GE(count, 10);
}

TEST(house, documents_link_to_what_is_there) {
  std::size_t count = 0;
  for (const std::string& document : list_documents())
    for (const std::string& link : list_links(read_file(kRoot / document))) {
      ++count;
      EXPECT_EQ(find_link_fault(document, link), "") << document << " links to " << link;
    }
  EXPECT_GE(count, 100u);
}

TEST(house, a_link_to_nothing_is_found) {
  EXPECT_EQ(list_links("[a](b.md#c) ![d](e.png) <img src=\"f.jpg\"> [g](https://h.i)\n```\n[j](k)\n```\n"),
            (std::vector<std::string>{"b.md#c", "e.png", "f.jpg"}));
  EXPECT_EQ(find_link_fault("README.md", "docs/no_such_page.md"), "there is no such file");
  EXPECT_EQ(find_link_fault("README.md", "docs/reference.md#no-such-key"), "there is no such heading");
  EXPECT_EQ(find_link_fault("docs/install.md", "../README.md#where-the-rest-is"), "");
}

TEST(house, the_readme_leads_to_every_page) {
  const std::vector<std::string> links = list_links(read_file(kRoot / "README.md"));
  for (const std::string& document : list_documents()) {
    if (document == "README.md") continue;
    EXPECT_NE(std::ranges::find(links, document), links.end()) << "README.md says nothing of " << document;
  }
}

TEST(house, the_readme_is_short) {
  constexpr std::size_t kMostLines = 150;  // what somebody reads who has never heard of mien
  EXPECT_LE(split_lines(read_file(kRoot / "README.md")).size(), kMostLines);
}

TEST(house, command_lines_of_the_documents_are_understood) {
  std::size_t count = 0;
  for (const std::string& document : list_manual())
    for (const std::string& block : list_blocks(read_file(kRoot / document), "sh"))
      for (const std::string& line : split_lines(block))
        for (const std::vector<std::string>& words : split_commands(line)) {
          ++count;
          EXPECT_EQ(find_command_fault(words), "") << document << ": " << line;
        }
  EXPECT_GE(count, 40u);
}

TEST(house, commands_named_in_the_documents_exist) {
  static const std::regex kMention("(?:`|<code>)((?:build/)?mien [^`<]*)(?:`|</code>)");
  std::size_t count = 0;
  for (const std::string& document : list_manual()) {
    const std::string text = remove_blocks(read_file(kRoot / document));
    for (std::sregex_iterator found(text.begin(), text.end(), kMention), end; found != end; ++found) {
      ++count;
      EXPECT_EQ(find_mention_fault((*found)[1].str()), "") << document << ": " << found->str();
    }
  }
  EXPECT_GE(count, 60u);
}

TEST(house, a_wrong_command_of_a_document_is_found) {
  EXPECT_EQ(split_commands("build/mien new a && mien list ages > b   # mien nothing"),
            (std::vector<std::vector<std::string>>{{"build/mien", "new", "a"}, {"mien", "list", "ages"}}));
  EXPECT_NE(find_command_fault({"mien", "rendr", "a.yaml"}), "");
  EXPECT_NE(find_command_fault({"mien", "render", "a.yaml", "--at", "1s"}), "");
  EXPECT_NE(find_command_fault({"mien", "list", "noses"}), "");
  EXPECT_EQ(find_command_fault({"mien", "sheet", "people"}), "");
  EXPECT_EQ(find_mention_fault("mien rendr FILE"), "unknown command");
  EXPECT_EQ(find_mention_fault("mien still --hollow"), "unknown option --hollow");
  EXPECT_EQ(find_mention_fault("mien list noses"), "unknown noses");
  EXPECT_EQ(find_mention_fault("mien list KIND"), "");
}

// `./run WORD`, in a block or in running text, is a command that its help tells.
TEST(house, run_commands_of_the_documents_exist) {
  static const std::regex kRun(R"re((?:^|\n|`)\./run ([a-z]+))re");
  const std::string run = read_file(kRoot / "run");
  std::size_t count = 0;
  for (const std::string& document : list_manual()) {
    const std::string text = read_file(kRoot / document);
    for (std::sregex_iterator found(text.begin(), text.end(), kRun), end; found != end; ++found) {
      ++count;
      EXPECT_TRUE(std::regex_search(run, std::regex("\n  " + (*found)[1].str() + "[ \n]")))
          << document << ": ./run " << (*found)[1].str();
    }
  }
  EXPECT_GE(count, 10u);
}

}  // namespace
}  // namespace mien
