#include "scene/povray.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <regex>

#include "core/error.hpp"
#include "core/text.hpp"
#include "scene/povray_stage.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

using testing::HasSubstr;

// Corners 0 1 2 3 of a square that looks along +z, one shade different.
Part build_square(const std::string& name, bool is_rigid) {
  Part part;
  part.name = name;
  part.material = "plain";
  part.rest.positions = {{-40, -40, 10}, {40, -40, 10}, {40, 40, 10}, {-40, 40, 10}};
  part.rest.normals.assign(4, {0, 0, 1});
  part.rest.triangles = {{0, 1, 2}, {0, 2, 3}};
  part.palette = {Shade{{0.8f, 0.6f, 0.5f}, 0}, Shade{{0.5f, 0.2f, 0.2f}, 1}};
  part.shade = {0, 0, 0, 1};
  part.is_rigid = is_rigid;
  return part;
}

Drawing draw_at_rest(const Model& model) {
  Drawing drawing;
  for (const Part& part : model.parts) {
    PartShape shape;
    if (!part.is_rigid) {
      shape.positions = part.rest.positions;
      shape.normals = part.rest.normals;
    }
    drawing.parts.push_back(shape);
  }
  return drawing;
}

std::string format_frame(const Model& model, const Drawing& drawing, const CameraView& view = {}) {
  std::string text;
  append_povray_frame(text, model, drawing, view);
  return text;
}

// All numbers behind `start`, up to the first `end`.
std::vector<double> read_numbers(const std::string& text, const std::string& start, char end) {
  const std::size_t from = text.find(start);
  if (from == std::string::npos) return {};
  const std::string block = text.substr(from + start.size(), text.find(end, from) - from - start.size());
  const std::regex number("-?[0-9]+(\\.[0-9]+)?");
  std::vector<double> numbers;
  for (auto i = std::sregex_iterator(block.begin(), block.end(), number); i != std::sregex_iterator(); ++i)
    numbers.push_back(std::stod(i->str()));
  return numbers;
}

std::string find_error(const Model& model, const RenderSpec& render = {}) {
  try {
    build_povray_include(model, render, shipped_stock().templates);
  } catch (const RunError& e) {
    return e.what();
  }
  return "";
}

TEST(povray, negates_z_of_positions_and_normals_once) {
  // Each corner has a place and a normal that no other has.
  Model model{{build_square("card", false), build_square("eye", true)}};
  for (Part& part : model.parts) {
    part.rest.positions[3].z = 12;
    part.rest.normals = {{0, 0, 1}, {0.6f, 0, 0.8f}, {0, -1, 0}, {0, 0.8f, -0.6f}};
  }
  const std::vector<double> places{4, -40, -40, -10, 40, -40, -10, 40, 40, -10, -40, 40, -12};
  const std::vector<double> normals{4, 0, 0, -1, 0.6, 0, -0.8, 0, -1, 0, 0, 0.8, 0.6};
  const std::string frame = format_frame(model, draw_at_rest(model));
  EXPECT_EQ(read_numbers(frame, "vertex_vectors {", '}'), places);
  EXPECT_EQ(read_numbers(frame, "normal_vectors {", '}'), normals);
  const std::string parts = build_povray_parts(model, shipped_stock().templates);
  EXPECT_EQ(read_numbers(parts, "vertex_vectors {", '}'), places);
  EXPECT_EQ(read_numbers(parts, "normal_vectors {", '}'), normals);
}

TEST(povray, turns_the_words_of_an_overlay_to_the_camera) {
  Overlay overlay;
  overlay.lines.push_back({{{{{1, 2, 3}, {4, 5, 6}}}}, {}, 0.5, {1, 0, 0.5f}});
  overlay.words.push_back({"smile \"0.8\"", {10, 20, 30}, 8, {0, 0.25f, 1}, 0.5});
  CameraView view;
  view.angle_deg = 30;  // shows more of the character's left, +x: words then face +x too
  std::string text;
  append_povray_overlay(text, overlay, view);
  EXPECT_EQ(text,
            "union {\nstage_line(<1,2,-3>, <4,5,-6>, 0.5)\nstage_ink(srgb <1,0,0.5>) }\n"
            "stage_words(\"smile \\\"0.8\\\"\", <10,20,-30>, 8, 0.5, -30, srgb <0,0.25,1>)\n");
}

// A light set's Turn goes to the picture's left, an author's angle to the character's.
TEST(povray, turns_lights_to_the_side_that_was_asked_for) {
  std::string text;
  append_povray_lights(text, {});
  EXPECT_EQ(text, "");
  append_povray_lights(text, {{"moon", 0.5, 20}, {"candle", 0.25, -30}});
  EXPECT_EQ(
      text,
      "#macro frame_lights(Turn)\n  light_moon(Turn + -20, 0.5)\n  light_candle(Turn + 30, 0.25)\n#end\n");
}

TEST(povray, ink_has_the_shade_that_is_asked_for) {
  RenderSpec render;
  render.style = Style::ink;
  const std::string plain = build_povray_stage("", render, shipped_stock().templates);
  render.ink.shade = glm::vec3(0.5f, 0.25f, 1);
  const std::string own = build_povray_stage("", render, shipped_stock().templates);
  const std::string words = "#declare Shade_tint = srgb <0.5, 0.25, 1>;\n";
  EXPECT_EQ(plain.find(words), std::string::npos);
  ASSERT_NE(own.find(words), std::string::npos);
  EXPECT_GT(own.find(words), own.rfind("#declare Shade_tint = rgb"));
  render.style = Style::studio;
  EXPECT_EQ(build_povray_stage("", render, shipped_stock().templates).find(words), std::string::npos);
}

// Eyes have their colours in head.inc: a lamp is told before it.
TEST(povray, tells_ink_s_lamp_before_all_that_it_shines_on) {
  FrameStart start;
  start.lamp = InkLamp{{0, 0.6, 0.8}, glm::vec3(1, 0.5f, 0.25f), glm::vec3(0.5f), glm::vec3(0.75f)};
  std::string text;
  append_povray_start(text, start);
  EXPECT_EQ(text.substr(0, text.find("stage_camera")),
            "#version 3.7;\n#declare Lamp_way = <0,0.6,-0.8>;\n#declare Lamp_lit = rgb <1,0.5,0.25>;\n"
            "#declare Lamp_dark = rgb <0.5,0.5,0.5>;\n#declare Lamp_flat = rgb <0.75,0.75,0.75>;\n"
            "#include \"head.inc\"\n");
}

TEST(povray, puts_what_is_in_front_of_the_face_toward_the_camera) {
  const Model model{{build_square("card", false)}};
  const std::vector<double> camera =
      read_numbers(format_frame(model, draw_at_rest(model)), "stage_camera(", ')');
  ASSERT_EQ(camera.size(), 9u);
  EXPECT_LT(camera[2], -800);               // mien's +z is POV-Ray's -z, where the camera stands
  EXPECT_DOUBLE_EQ(camera[2], -camera[6]);  // at distance 1, as far as the lens says
  CameraView view;
  view.angle_deg = 90;
  const std::vector<double> side =
      read_numbers(format_frame(model, draw_at_rest(model), view), "stage_camera(", ')');
  EXPECT_NEAR(side[0], side[6], 1e-3);  // + shows the character's left, which is +x
  EXPECT_NEAR(side[2], 0, 1e-3);
}

TEST(povray, turns_a_rigid_part_as_its_vertices_would_be_turned) {
  const Model model{{build_square("eye_left", true)}};
  Drawing drawing = draw_at_rest(model);
  glm::mat4& turn = drawing.parts[0].world_from_rest;
  turn = glm::translate(glm::mat4(1), {31.5f, -2.0f, 69.5f});
  turn = glm::rotate(turn, 0.4f, glm::normalize(glm::vec3(0.3f, 1.0f, -0.2f)));
  const std::vector<double> m = read_numbers(format_frame(model, drawing), "matrix <", '>');
  ASSERT_EQ(m.size(), 12u);

  const std::vector<double> rest = read_numbers(build_povray_include(model, {}, shipped_stock().templates),
                                                "part_eye_left = mesh2 {\nvertex_vectors {", '}');
  ASSERT_EQ(rest.size(), 13u);
  for (std::size_t i = 0; i < 4; ++i) {
    const double* p = &rest[1 + 3 * i];
    const glm::vec4 want = turn * glm::vec4(model.parts[0].rest.positions[i], 1);
    EXPECT_NEAR(p[0] * m[0] + p[1] * m[3] + p[2] * m[6] + m[9], want.x, 1e-3);
    EXPECT_NEAR(p[0] * m[1] + p[1] * m[4] + p[2] * m[7] + m[10], want.y, 1e-3);
    EXPECT_NEAR(p[0] * m[2] + p[1] * m[5] + p[2] * m[8] + m[11], -want.z, 1e-3);
  }
}

TEST(povray, writes_faces_and_shades_once_in_the_include) {
  const std::string include =
      build_povray_include({{build_square("card", false)}}, {}, shipped_stock().templates);
  EXPECT_THAT(include,
              HasSubstr("#macro surface_of_card()\ntexture_list { 2,\n"
                        "plain_texture(srgb <0.8,0.6,0.5>, 0),\nplain_texture(srgb <0.5,0.2,0.2>, 1) }\n"
                        "face_indices { 2,\n<0,1,2>,0,\n<0,2,3>,0,0,1 }\n#end\n"));
  EXPECT_EQ(include.find("{{"), std::string::npos);
  Part plain = build_square("card", false);
  plain.shade.clear();
  EXPECT_THAT(
      build_povray_include({{plain}}, {}, shipped_stock().templates),
      HasSubstr("\nface_indices { 2,\n<0,1,2>,\n<0,2,3> }\nplain_texture(srgb <0.8,0.6,0.5>, 0)\n#end\n"));
}

TEST(povray, writes_the_grain_as_texture_coordinates) {
  Part part = build_square("card", false);
  part.grain = {{-40, -40}, {40.5f, -40}, {40, 40}, {-40, 40.25f}};
  EXPECT_THAT(build_povray_include({{part}}, {}, shipped_stock().templates),
              HasSubstr("uv_vectors { 4,\n<-40,-40>,\n<40.5,-40>,\n<40,40>,\n<-40,40.25> }\ntexture_list {"));
  part.grain.pop_back();
  EXPECT_EQ(find_error({{part}}), "internal: part 'card' has not one place on its grain a vertex");
}

TEST(povray, a_picture_lies_over_a_part_by_places_of_its_own) {
  Part part = build_square("card", false);
  part.material = "skin";
  part.grain = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  // Cut along the diagonal: two of its corners are there twice.
  const auto atlas =
      std::make_shared<Atlas>(Atlas{{{0, 0}, {0.5f, 0}, {0.5f, 1}, {0.5f, 0}, {1, 1}, {0.5f, 0.125f}},
                                    {0, 1, 2, 0, 2, 3},
                                    {{0, 1, 2}, {3, 4, 5}}});
  part.picture =
      std::make_shared<PartPicture>(PartPicture{"skin.png", "skin_0123456789abcdef.png", atlas, 250});
  const std::string text = build_povray_parts({{part}}, shipped_stock().templates);
  EXPECT_THAT(text,
              HasSubstr("#declare painted_card = pigment { uv_mapping image_map { png "
                        "\"skin_0123456789abcdef.png\" gamma srgb interpolate 2 } }\n"
                        "\n#macro surface_of_card()\nuv_vectors { 6,\n<0,0>,\n<0.5,0>,\n<0.5,1>,\n<0.5,0>,"
                        "\n<1,1>,\n<0.5,0.125> }\n"
                        "texture_list { 2,\npainted_skin_texture(painted_card, 0, 250),\n"
                        "painted_skin_texture(painted_card, 1, 250) }\n"
                        "face_indices { 2,\n<0,1,2>,0,\n<0,2,3>,0,0,1 }\n"
                        "uv_indices { 2,\n<0,1,2>,\n<3,4,5> }\n"));
  EXPECT_THAT(text, HasSubstr("#macro painted_skin_texture("));
  part.picture = nullptr;
  EXPECT_EQ(build_povray_parts({{part}}, shipped_stock().templates).find("painted"), std::string::npos);
  atlas->triangles.pop_back();
  part.picture =
      std::make_shared<PartPicture>(PartPicture{"skin.png", "skin_0123456789abcdef.png", atlas, 250});
  EXPECT_EQ(find_error({{part}}), "internal: part 'card' has not one triangle of its picture a triangle");
}

TEST(povray, tells_a_material_how_worn_its_part_is_and_no_other) {
  Part fresh = build_square("fresh", false), worn = build_square("worn", false);
  worn.wear = 0.25;
  const std::string text = build_povray_parts({{worn, fresh}}, shipped_stock().templates);
  const std::size_t begins = text.find("#declare Wear = 0.25;"), ends = text.find("#declare Wear = 0;");
  EXPECT_LT(begins, text.find("texture_list"));
  EXPECT_LT(begins, ends);
  EXPECT_LT(ends, text.find("surface_of_fresh"));
  EXPECT_EQ(text.find("Wear", ends + 20), text.npos);
}

TEST(povray, strands_have_lamps_of_their_own) {
  Part skin = build_square("skin", false), locks = build_square("hair", false);
  locks.material = "lock";
  const Model model{{locks, skin}};
  const std::string text = format_frame(model, draw_at_rest(model));
  EXPECT_THAT(text, HasSubstr("light_group { strand_lamps()\nmesh2 {"));
  EXPECT_THAT(text, HasSubstr("surface_of_hair() }\nglobal_lights off }\nmesh2 {"));
  EXPECT_EQ(text.find("light_group"), text.rfind("light_group")) << "skin has the frame's";
}

TEST(povray, a_stretched_part_pales_where_it_has_blood) {
  Part part = build_square("lips", false);
  part.material = "skin";
  part.palette[1].blood = 0.75f;
  EXPECT_THAT(
      build_povray_parts({{part}}, shipped_stock().templates),
      HasSubstr("skin_texture(srgb <0.8,0.6,0.5>, 0),\nskin_texture(srgb <0.5,0.2,0.2> * pale(0.75), 1)"));
  Drawing drawing = draw_at_rest({{part}});
  EXPECT_EQ(format_frame({{part}}, drawing).find("Paling"), std::string::npos);
  drawing.parts[0].paling = 0.4;
  const std::string text = format_frame({{part}}, drawing);
  EXPECT_LT(text.find("#declare Paling = 0.4;\nmesh2 {"),
            text.find("surface_of_lips() }\n#declare Paling = 0;\n"));
}

TEST(povray, says_what_is_wrong_with_a_part) {
  Part part = build_square("card", false);
  part.material = "velvet";
  EXPECT_EQ(find_error({{part}}), "part 'card': unknown material 'velvet'");
  part = build_square("card", false);
  part.rest.triangles[0][1] = 4;
  EXPECT_EQ(find_error({{part}}), "internal: part 'card' has a triangle outside its vertices");
  part.rest.triangles.clear();
  EXPECT_EQ(find_error({{part}}), "internal: part 'card' has no triangles");
  part = build_square("card", false);
  part.shade[0] = 2;
  EXPECT_EQ(find_error({{part}}), "internal: part 'card' has a shade outside its palette");
  part.shade.pop_back();
  EXPECT_EQ(find_error({{part}}), "internal: part 'card' has not one shade a vertex");
  part.palette.clear();
  EXPECT_EQ(find_error({{part}}), "internal: part 'card' has no palette");
  part = build_square("card", true);
  part.rest.normals.pop_back();
  EXPECT_EQ(find_error({{part}}), "internal: part 'card' has not one normal a vertex");
}

TEST(povray, knows_its_backgrounds_only) {
  RenderSpec render;
  for (const char* name : {"studio", "light", "dark"}) {
    render.background = name;
    EXPECT_EQ(find_error({{build_square("card", false)}}, render), "");
  }
  for (const char* name : {"beach", "../background_studio", ""}) {
    render.background = name;
    EXPECT_THAT(find_error({{build_square("card", false)}}, render),
                testing::StartsWith("unknown background '" + std::string(name) + "': "));
  }
}

TEST(povray, refuses_a_drawing_that_does_not_fit) {
  const Model model{{build_square("card", false)}};
  std::string text;
  EXPECT_THROW(append_povray_frame(text, model, Drawing{}, {}), RunError);
  Drawing drawing = draw_at_rest(model);
  drawing.parts[0].normals.pop_back();
  EXPECT_THROW(append_povray_frame(text, model, drawing, {}), RunError);
  drawing = draw_at_rest(model);
  drawing.parts[0].positions[2].y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(append_povray_frame(text, model, drawing, {}), RunError);
}

TEST(povray, writes_the_same_text_under_any_locale) {
  const Model model{{build_square("card", false), build_square("eye_left", true)}};
  const std::string frame = format_frame(model, draw_at_rest(model));
  const std::string include = build_povray_include(model, {}, shipped_stock().templates);
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  EXPECT_EQ(format_frame(model, draw_at_rest(model)), frame);
  EXPECT_EQ(build_povray_include(model, {}, shipped_stock().templates), include);
  std::setlocale(LC_ALL, "C");
}

TEST(povray, names_the_frames_of_the_ini_as_mien_does) {
  RenderSpec render;
  EXPECT_THAT(build_povray_ini(render, "hello", 72, "out/hello", {1, 72}),
              HasSubstr("Input_File_Name=\"loop.pov\"\nLibrary_Path=\"out/hello/scenes\"\n"
                        "Output_File_Name=\"out/hello/frames/f00.png\"\n"
                        "Initial_Frame=1\nFinal_Frame=72\nWidth=480\nHeight=600\n"));
  EXPECT_THAT(build_povray_ini(render, "hello", 12345, "out/hello", {1, 12345}),
              HasSubstr("frames/f.png\"\n"));
}

TEST(povray, names_only_the_frames_that_were_written) {
  EXPECT_EQ(build_povray_ini({}, "hello", 72, "out/hello", {1, 72}).find("Subset"), std::string::npos);
  EXPECT_THAT(build_povray_ini({}, "hello", 72, "out/hello", {10, 20}),
              HasSubstr("Initial_Frame=1\nFinal_Frame=72\nWidth=480\nHeight=600\n"
                        "Subset_Start_Frame=10\nSubset_End_Frame=20\n"));
}

// POV-Ray itself reads what we write: a folder as mien fills it, a picture of two frames out of the .ini.
TEST(povray, povray_renders_the_ini_from_the_folder_above_out) {
  const std::filesystem::path root = std::filesystem::path(testing::TempDir()) / "mien_povray_test";
  std::filesystem::remove_all(root);
  const std::filesystem::path clip = root / "out/two_cards";
  std::filesystem::create_directories(clip / "frames");
  const Model model{{build_square("card", false), build_square("eye_left", true)}};
  RenderSpec render;
  render.width_px = 32;
  render.height_px = 40;
  render.quality = Quality::draft;
  write_file(clip / "scenes/head.inc", build_povray_include(model, render, shipped_stock().templates));
  write_file(clip / "scenes/loop.pov", build_povray_loop());
  write_file(clip / "scenes/cards.ini", build_povray_ini(render, "cards", 2, "out/two_cards", {1, 2}));
  write_file(clip / "scenes/f0001.pov", format_frame(model, draw_at_rest(model)));
  CameraView from_above;
  from_above.height_deg = 90;
  write_file(clip / "scenes/f0002.pov", format_frame(model, draw_at_rest(model), from_above));
  const std::string command =
      "cd '" + root.string() + "' && povray 'out/two_cards/scenes/cards.ini' > log 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(root / "log");
  EXPECT_EQ(read_file(root / "log").find("Parse Warning"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(clip / "frames/f0001.png"));
  EXPECT_TRUE(std::filesystem::exists(clip / "frames/f0002.png"));
  // A clip of one frame has a numbered picture, too.
  std::filesystem::remove(clip / "frames/f0001.png");
  write_file(clip / "scenes/cards.ini", build_povray_ini(render, "cards", 1, "out/two_cards", {1, 1}));
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(root / "log");
  EXPECT_TRUE(std::filesystem::exists(clip / "frames/f0001.png"));
  std::filesystem::remove_all(root);
}

}  // namespace
}  // namespace mien
