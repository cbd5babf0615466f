#include "sketch/sdl.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace mien {
namespace {

SdlValue read_value(const std::string& expression) {
  SdlNames names;
  read_sdl("#declare Found = " + expression + ";", "test", names);
  return names.values.at("Found");
}

void expect_vector(const std::string& expression, const glm::dvec3& expected) {
  const glm::dvec3 found = read_value(expression).vector();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-9) << expression << " " << i;
}

std::string find_error(const std::string& text) {
  SdlNames names;
  try {
    read_sdl(text, "test.inc", names);
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

TEST(sdl, computes_as_povray_does) {
  EXPECT_DOUBLE_EQ(read_value("1 + 2 * 3 - 8 / 4").number(), 5);
  EXPECT_DOUBLE_EQ(read_value("-(2 - .5) * min(4, 2)").number(), -3);
  EXPECT_DOUBLE_EQ(read_value("degrees(atan2(1, 1)) + mod(7, 3) + pow(2, 3) + sqrt(9)").number(), 57);
  expect_vector("<1, 2, 3> * 2 + x - z * 4", {3, 4, 2});
  expect_vector("vcross(x, y) + vnormalize(<0, 3, 4>)", {0, 0.6, 1.8});
  EXPECT_DOUBLE_EQ(read_value("<4, 5, 6>.y + vlength(<2, 3, 6>)").number(), 12);
  EXPECT_DOUBLE_EQ(
      read_value("(.5 * rgb <1, 2, 4>).red + 10 * (rgb <1, 2, 4>).green + (rgb <1, 2, 4>).blue").number(),
      24.5);
}

TEST(sdl, turns_about_x_then_y_then_z) {
  expect_vector("vrotate(z, x * 90)", {0, -1, 0});
  expect_vector("vrotate(z, y * 90)", {1, 0, 0});
  expect_vector("vrotate(x, z * 90)", {0, 1, 0});
  expect_vector("vrotate(y, <90, 90, 0>)", {1, 0, 0});
}

// Measured with POV-Ray 3.7: srgb bends the whole product that stands behind it, a declared colour is linear.
TEST(sdl, bends_srgb_behind_the_product) {
  EXPECT_NEAR(read_value("srgb <.5, .5, .5> * .5").v[0], 0.05087609, 1e-6);
  EXPECT_NEAR(read_value("srgb 1").v[1], 1, 1e-9);
  SdlNames names;
  read_sdl("#declare C = srgb <.5, .5, .5>; #declare D = color C * .5;", "test", names);
  EXPECT_NEAR(names.values.at("D").v[2], 0.5 * 0.21404114, 1e-6);
}

TEST(sdl, calls_macros_with_their_own_names) {
  SdlNames names;
  const SdlBlock all = read_sdl(
      "#declare Size = 7;\n"
      "#macro half(Size) Size / 2 #end\n"
      "#macro lamp(At, Bright) #local Size = 3; light_source { At color rgb Bright * Size #end\n"
      "lamp(<1, 2, 3>, half(4)) shadowless }\n"
      "#declare After = Size + half(Size);",
      "test", names);
  ASSERT_EQ(all.items.size(), 1u);
  const SdlBlock& lamp = *all.items[0].block;
  EXPECT_EQ(lamp.name, "light_source");
  EXPECT_EQ(lamp.items[0].value.vector(), glm::dvec3(1, 2, 3));
  EXPECT_DOUBLE_EQ(lamp.items[1].value.v[0], 6);
  EXPECT_TRUE(has_word(lamp, "shadowless"));
  EXPECT_DOUBLE_EQ(names.values.at("After").number(), 10.5);
}

TEST(sdl, goes_round_and_leaves_out) {
  SdlNames names;
  const SdlBlock all = read_sdl(
      "#for (I, -2, 2) ball { I #if (I != 0) shadowless #else bright #end } #end\n"
      "#ifdef (Nothing) wrong #else right #end #ifndef (Nothing) too #end /* not { this */ // nor } that\n",
      "test", names);
  ASSERT_EQ(all.items.size(), 7u);
  for (int i = 0; i < 5; ++i) {
    const SdlBlock& ball = *all.items[static_cast<std::size_t>(i)].block;
    EXPECT_DOUBLE_EQ(ball.items[0].value.number(), i - 2);
    EXPECT_EQ(has_word(ball, "shadowless"), i != 2);
    EXPECT_EQ(has_word(ball, "bright"), i == 2);
  }
  EXPECT_EQ(all.items[5].word, "right");
  EXPECT_EQ(all.items[6].word, "too");
}

TEST(sdl, keeps_functions_for_later) {
  SdlNames names;
  const SdlBlock all = read_sdl(
      "#declare K = 2; p { function { sqrt(x*x + (y - 1)*(y - 1)) / max(z, .5) * K } }", "test", names);
  const SdlBlock* const function = find_block(*all.items[0].block, "function");
  ASSERT_TRUE(function);
  EXPECT_DOUBLE_EQ(evaluate(function->function, {3, 5, 0}), 20);
  EXPECT_DOUBLE_EQ(evaluate(function->function, {3, 5, 2}), 5);
}

TEST(sdl, finds_values_maps_and_matrices) {
  SdlNames names;
  const SdlBlock all = read_sdl(
      "texture { pigment { color_map { [.2 rgb 1 filter 1] [.8 rgb 0] } matrix <1,0,0, 0,1,0, 0,0,1, 5,6,7> }"
      " finish { diffuse .75 specular .1 } }",
      "test", names);
  const SdlBlock& texture = *all.items[0].block;
  EXPECT_DOUBLE_EQ(find_value(*find_block(texture, "finish"), "specular")->number(), 0.1);
  EXPECT_EQ(find_value(*find_block(texture, "finish"), "phong"), nullptr);
  const SdlBlock& pigment = *find_block(texture, "pigment");
  EXPECT_EQ(find_block(pigment, "color_map")->items.size(), 2u);
  EXPECT_EQ(pigment.items.back().matrix.size(), 12u);
}

TEST(sdl, says_where_it_does_not_understand) {
  EXPECT_EQ(find_error("a\n#declare X = Unknown;"), "test.inc:2: unknown name 'Unknown'");
  EXPECT_EQ(find_error("\n\n#while (1) #end"), "test.inc:3: '#while' is not known here");
  EXPECT_EQ(find_error("box { 1"), "test.inc:1: 'box' is never closed");
  EXPECT_EQ(find_error("#if (1 > 2)\nbox {}"), "test.inc:1: a part without its #end");
  EXPECT_EQ(find_error("#declare X = <1, 2, 3;"), "test.inc:1: expected '>', found ';'");
  EXPECT_EQ(find_error("#declare X = <1, 2, 3, 4, 5, 6>;"), "test.inc:1: a vector of more than five numbers");
  EXPECT_EQ(find_error("#declare X = max(1);"), "test.inc:1: max takes 2 values");
  EXPECT_EQ(find_error("#macro m(A) A #end #declare X = m(1, 2);"), "test.inc:1: m takes 1 values, not 2");
  EXPECT_EQ(find_error("#macro m() m() #end m()"), "test.inc:1: m calls itself without end");
  EXPECT_EQ(find_error("#declare X ="), "test.inc:1: the text ends too soon");
  EXPECT_EQ(find_error("#declare X = x.w;#declare V = <1,2>; #declare W = V.w;"),
            "test.inc:1: unexpected '.'");
  EXPECT_EQ(find_error("#declare V = <1,2>; #declare W = V.w;"), "test.inc:1: unknown component 'w'");
  EXPECT_EQ(find_error("p { matrix <1, 2> }"), "test.inc:1: a matrix needs twelve numbers");
  EXPECT_EQ(find_error("p { \"text\" }"), "test.inc:1: a text is not known here");
  EXPECT_EQ(find_error("/* never\nended"), "test.inc:1: a comment without its end");
  EXPECT_EQ(find_error("\"never"), "test.inc:1: a text without its end");
  EXPECT_EQ(find_error("a\n  %"), "test.inc:2: unexpected '%'");
  EXPECT_EQ(find_error("#for (I, 3, 1, -1) a #end"), "test.inc:1: a loop that goes down is not known here");
  EXPECT_EQ(find_error("p { function { foo(x) } }"), "test.inc:1: unknown name 'foo' in a function");
}

}  // namespace
}  // namespace mien
