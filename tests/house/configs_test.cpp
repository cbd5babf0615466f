// Every file an author may begin from is right, and the documents name nothing that is not there.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "config/load_spec.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "places.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const std::filesystem::path kRoot = source_folder();

TEST(house, every_example_loads) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kRoot / "configs")) {
    if (entry.path().extension() != ".yaml") continue;
    ++count;
    EXPECT_NO_THROW({
      const Spec spec = load_spec(entry.path(), *shipped().stock.language);
      EXPECT_GE(count_frames(spec.clip), 1);
    }) << entry.path();
  }
  EXPECT_GE(count, 1);
}

// The Markdown of the README between "```yaml" and "```", each a file of its own.
TEST(house, every_example_of_the_readme_loads) {
  const std::string readme = read_file(kRoot / "README.md");
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mien_readme";
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(kRoot / "templates/head/half.obj", folder / "my_half.obj",
                             std::filesystem::copy_options::overwrite_existing);
  static const std::regex kExample("```yaml\n([^`]*)```");
  int count = 0;
  for (std::sregex_iterator found(readme.begin(), readme.end(), kExample), end; found != end; ++found) {
    const std::filesystem::path file = folder / ("example" + std::to_string(++count) + ".yaml");
    write_file(file, (*found)[1].str());
    try {
      load_spec(file, *shipped().stock.language);
    } catch (const InputError& e) {
      for (const Diagnostic& diagnostic : e.diagnostics) ADD_FAILURE() << format_diagnostic(diagnostic);
    }
  }
  EXPECT_GE(count, 1);
}

TEST(house, documents_link_to_what_is_there) {
  static const std::regex kLink(R"re(\]\(([^)#:]+)\)|src="([^":]+)")re");
  for (const char* name : {"README.md", "CHANGELOG.md", "CONTRIBUTING.md"}) {
    const std::string text = read_file(kRoot / name);
    for (std::sregex_iterator found(text.begin(), text.end(), kLink), end; found != end; ++found) {
      const std::string target = (*found)[1].matched ? (*found)[1].str() : (*found)[2].str();
      EXPECT_TRUE(std::filesystem::exists(kRoot / target)) << name << " links to " << target;
    }
  }
}

}  // namespace
}  // namespace mien
