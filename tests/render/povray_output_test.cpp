#include "render/povray_output.hpp"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(povray_output, is_unwrapped_where_it_was_folded) {
  const std::string line76 = "File 'another_rather_long_folder_name/bad.pov' line 4: Parse Error: Expected";
  const std::string line80 =
      " 'numeric expression', undeclared identifier 'undeclared_identifier_with_a_very_";
  ASSERT_EQ(line76.size(), 76u);
  ASSERT_EQ(line80.size(), 80u);
  EXPECT_EQ(unwrap_povray_output(line76 + "\n" + line80 + "\nlong_name' found instead\nRender failed\n"),
            line76 + line80 + "long_name' found instead\nRender failed");
  EXPECT_EQ(unwrap_povray_output("Parser Options\n  Input file: a\n Short\n"),
            "Parser Options\n  Input file: a\n Short");
}

TEST(povray_output, holds_the_reason_behind_its_last_heading) {
  const std::string banner = "Persistence of Vision\n==== [Parsing...] ====\n";
  EXPECT_EQ(find_povray_reason({1, banner + "Parse Error: x\nRender failed\n", 0}),
            "\nParse Error: x\nRender failed");
  EXPECT_EQ(find_povray_reason(
                {1, "Options\nFile 'a' line 2: Parse Error: x\n==== [Parsing...] ====\nRender failed\n", 0}),
            "File 'a' line 2: Parse Error: x\n\nRender failed");
  EXPECT_EQ(find_povray_reason({1, "povray: not found", 0}), "povray: not found");
  EXPECT_EQ(find_povray_reason({0, banner + "Parse Warning: x\nFinite Objects: 3\n", 0}),
            "Parse Warning: x\n");
}

TEST(povray_output, tells_an_empty_scene) {
  EXPECT_TRUE(
      is_empty_scene("-\nFinite Objects:            0\nInfinite Objects:          0\nLight Sources: 1\n"));
  EXPECT_FALSE(is_empty_scene("-\nFinite Objects:            0\nInfinite Objects:          1\n"));
  EXPECT_FALSE(is_empty_scene("-\nFinite Objects:           10\nInfinite Objects:          0\n"));
  EXPECT_TRUE(is_empty_scene("File 'a.pov' line 2: Parse Warning: No objects in scene.\n"));
}

TEST(povray_output, tells_a_machine_too_busy_to_start_on) {
  EXPECT_TRUE(is_late_start("povray: no user configuration\nTimed out waiting for worker thread startup\n"));
  EXPECT_FALSE(is_late_start("Fatal error in parser: Cannot parse input.\nRender failed\n"));
}

}  // namespace
}  // namespace mien
