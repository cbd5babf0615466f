// 3MF packages: the same bytes every time, read by others as what they are.
#include "scene/three_mf.hpp"

#include <Model/COM/NMR_DLLInterfaces.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "core/error.hpp"
#include "core/text.hpp"
#include "scene/mesh_files.hpp"
#include "scene/stl.hpp"
#include "solids.hpp"

namespace mien {
namespace {

using testing::HasSubstr;

std::vector<PrintObject> list_objects() {
  return {
      {"box", build_box({0, 0, 0}, {10, 10, 20}), {{"skin", {1, 0.5f, 0}, 0, 8}, {"eye", {0, 0, 1}, 8, 4}}},
      {"ball <&> \"x\"", build_ball({30, 5, 10}, 10, 12), {}}};
}

// What lib3mf reads back.
struct Package {
  std::vector<std::string> metadata;  // "key=value" as it stands in the XML
  std::vector<std::string> objects;   // "name: vertices, triangles, closed"
  std::vector<std::string> colours;   // "name #rrggbbaa"
  std::vector<DWORD> colour_of;       // the first object's triangles
  DWORD unit = 0, warnings = 0;
};

template <typename Read>
std::string read_text(const Read& read) {
  std::string text(300, ' ');
  ULONG length = 0;
  EXPECT_EQ(read(text.data(), ULONG(text.size()), &length), 0);
  return text.substr(0, std::strlen(text.c_str()));
}

Package read_3mf(std::string bytes) {
  using namespace NMR;
  Package package;
  PLib3MFBase *model = nullptr, *reader = nullptr, *list = nullptr, *item = nullptr;
  EXPECT_EQ(lib3mf_createmodel(&model), 0);
  EXPECT_EQ(lib3mf_model_queryreader(model, "3mf", &reader), 0);
  EXPECT_EQ(lib3mf_reader_readfrombuffer(reader, reinterpret_cast<BYTE*>(bytes.data()), bytes.size()), 0);
  lib3mf_reader_getwarningcount(reader, &package.warnings);
  lib3mf_model_getunit(model, &package.unit);
  DWORD count = 0;
  lib3mf_model_getmetadatacount(model, &count);
  for (DWORD i = 0; i < count; ++i)
    package.metadata.push_back(read_text([&](char* text, ULONG size, ULONG* length) {
                                 return lib3mf_model_getmetadatakeyutf8(model, i, text, size, length);
                               }) +
                               "=" + read_text([&](char* text, ULONG size, ULONG* length) {
                                 return lib3mf_model_getmetadatavalueutf8(model, i, text, size, length);
                               }));
  BOOL has = 0;
  lib3mf_model_getbasematerials(model, &list);
  while (lib3mf_resourceiterator_movenext(list, &has) == 0 && has != 0) {
    lib3mf_resourceiterator_getcurrent(list, &item);
    lib3mf_basematerial_getcount(item, &count);
    for (DWORD i = 0; i < count; ++i) {
      BYTE red = 0, green = 0, blue = 0, alpha = 0;
      lib3mf_basematerial_getdisplaycolor(item, i, &red, &green, &blue, &alpha);
      package.colours.push_back(read_text([&](char* text, ULONG size, ULONG* length) {
                                  return lib3mf_basematerial_getnameutf8(item, i, text, size, length);
                                }) +
                                fmt::format(" #{:02X}{:02X}{:02X}{:02X}", red, green, blue, alpha));
    }
    lib3mf_release(item);
  }
  lib3mf_release(list);
  lib3mf_model_getmeshobjects(model, &list);
  while (lib3mf_resourceiterator_movenext(list, &has) == 0 && has != 0) {
    lib3mf_resourceiterator_getcurrent(list, &item);
    DWORD vertices = 0, triangles = 0, group = 0;
    BOOL is_closed = 0;
    lib3mf_meshobject_getvertexcount(item, &vertices);
    lib3mf_meshobject_gettrianglecount(item, &triangles);
    lib3mf_meshobject_ismanifoldandoriented(item, &is_closed);
    package.objects.push_back(read_text([&](char* text, ULONG size, ULONG* length) {
                                return lib3mf_object_getnameutf8(item, text, size, length);
                              }) +
                              fmt::format(": {}, {}, {}", vertices, triangles, is_closed != 0));
    if (package.objects.size() == 1) {
      PLib3MFBase* handler = nullptr;
      lib3mf_meshobject_createpropertyhandler(item, &handler);
      package.colour_of.resize(triangles);
      for (DWORD i = 0; i < triangles; ++i)
        lib3mf_propertyhandler_getbasematerial(handler, i, &group, &package.colour_of[i]);
      lib3mf_release(handler);
    }
    lib3mf_release(item);
  }
  for (PLib3MFBase* handle : {list, reader, model}) lib3mf_release(handle);
  return package;
}

TEST(three_mf, is_the_same_and_says_unit_title_and_colours) {
  const std::string one = build_3mf("A & B", list_objects());
  EXPECT_EQ(one, build_3mf("A & B", list_objects()));
  const Package package = read_3mf(one);
  EXPECT_EQ(package.warnings, 0u);
  EXPECT_EQ(package.unit, DWORD(NMR::MODELUNIT_MILLIMETER));
  EXPECT_THAT(package.metadata, testing::ElementsAre("Title=A &#38; B", "Application=mien"));
  EXPECT_THAT(package.colours, testing::ElementsAre("skin #FF8000FF", "eye #0000FFFF"));
  const std::size_t ball = list_objects()[1].mesh.positions.size(),
                    sides = list_objects()[1].mesh.triangles.size();
  EXPECT_THAT(
      package.objects,
      testing::ElementsAre("box: 8, 12, true", fmt::format("ball <&> \"x\": {}, {}, true", ball, sides)));
  EXPECT_THAT(package.colour_of, testing::ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1));
}

TEST(three_mf, odd_text_is_no_markup) {
  const Package package =
      read_3mf(build_3mf("</metadata>\n\xFF\xED\xA0\x80\xF0\x9F\x98\x80", list_objects()));
  EXPECT_EQ(package.metadata.front(), "Title=&#60;/metadata&#62; ????\xF0\x9F\x98\x80");
  EXPECT_EQ(package.metadata.size(), 2u);
}

TEST(three_mf, a_slicer_reads_it) {
  if (std::system("command -v prusa-slicer >/dev/null") != 0) GTEST_SKIP() << "prusa-slicer is not installed";
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mien_3mf";
  write_file(folder / "two.3mf", build_3mf("two </metadata>", list_objects()));
  const std::string command =
      fmt::format("cd '{}' && prusa-slicer --info two.3mf >info 2>&1", folder.string());
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(folder / "info");
  const std::string info = read_file(folder / "info");
  EXPECT_THAT(info, HasSubstr("manifold = yes"));
  EXPECT_THAT(info, HasSubstr("size_z = 20.0"));
  EXPECT_THAT(info, Not(HasSubstr("manifold = no")));
}

TEST(three_mf, no_number_no_file) {
  std::vector<PrintObject> objects = list_objects();
  objects[0].mesh.positions[3].y = NAN;
  EXPECT_THROW(build_3mf("x", objects), RunError);
}

TEST(binary_stl, is_read_back_as_it_was) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mien_3mf";
  write_file(folder / "ball.stl", build_binary_stl(build_ball({30, 5, 10}, 10, 12), "a\nball"));
  const StlFacts facts = check_stl(folder / "ball.stl");
  EXPECT_EQ(facts.parts, 1u);
  EXPECT_EQ(facts.open_edges, 0u);
  EXPECT_NEAR(facts.volume_mm3, compute_volume_mm3(build_ball({30, 5, 10}, 10, 12)), 0.01);
}

}  // namespace
}  // namespace mien
