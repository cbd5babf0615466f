// Every file an author may begin from is right.
#include <gtest/gtest.h>

#include <filesystem>

#include "config/load_spec.hpp"
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

}  // namespace
}  // namespace mien
