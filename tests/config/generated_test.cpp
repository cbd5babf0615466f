// Files that are written from the program's own tables are as the program writes them: `./run reference`.
#include <cstdlib>

#include "config/config_fixture.hpp"
#include "config/reference.hpp"
#include "config/schema.hpp"

namespace mien {
namespace {

void expect_written(const std::filesystem::path& file, const std::string& text) {
  if (std::getenv("MIEN_WRITE_GENERATED") != nullptr) write_file(file, text);
  EXPECT_TRUE(read_file(file) == text)
      << file << " is not as the program writes it; ./run reference mends it";
}

TEST(generated, schema_for_editors) {
  expect_written(kData / "templates/mien.schema.json", build_schema(load_data_words(kData)));
}

TEST(generated, reference_of_the_language) {
  expect_written(kData / "docs/reference.md", build_reference_manual());
}

}  // namespace
}  // namespace mien
