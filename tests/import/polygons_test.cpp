// Meshes of other programs: what is read, and what is said of files that are none.
#include "import/polygons.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <random>

#include "core/error.hpp"
#include "core/text.hpp"
#include "fuzz_rounds.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

fs::path write_mesh(const std::string& name, const std::string& bytes) {
  const fs::path file = fs::path(testing::TempDir()) / "mien_import" / name;
  write_file(file, bytes);
  return file;
}

// What is said of the file, with its bare name; empty if it is read.
std::string find_fault(const fs::path& file) {
  try {
    load_polygons(file);
  } catch (const InputError& e) {
    Diagnostic diagnostic = e.diagnostics.at(0);
    diagnostic.place.file = fs::path(diagnostic.place.file).filename();
    return format_diagnostic(diagnostic);
  }
  return "";
}

std::string find_fault(const std::string& name, const std::string& bytes) {
  return find_fault(write_mesh(name, bytes));
}

template <typename Number>
void append_bytes(std::string& bytes, Number number) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  bytes.append(raw.data(), raw.size());  // little-endian, as every machine that mien runs on
}

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string build_binary_stl(std::uint32_t count, std::size_t facets, float x) {
  std::string bytes(80, ' ');
  append_bytes(bytes, count);
  for (std::size_t f = 0; f < facets; ++f) {
    for (const float v : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, x, 0.f, 0.f, 0.f, 1.f, float(f)})
      append_bytes(bytes, v);
    append_bytes(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string build_ply_head(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment a square\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
         "property uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string build_binary_ply(float last = 0) {
  std::string bytes = build_ply_head("binary_little_endian");
  for (const auto& [x, y] : {std::pair{0.f, 0.f}, {1.f, 0.f}, {1.f, 1.f}, {last, 1.f}}) {
    append_bytes(bytes, x);
    append_bytes(bytes, y);
    append_bytes(bytes, 0.f);
    append_bytes(bytes, std::uint8_t{200});
  }
  append_bytes(bytes, std::uint8_t{4});
  for (const std::int32_t i : {0, 1, 2, 3}) append_bytes(bytes, i);
  return bytes;
}

TEST(obj, is_read_with_all_that_programs_write) {
  const Polygons mesh = load_polygons(
      write_mesh("full.OBJ",
                 "# made by hand\r\nmtllib a.mtl\no half\nv 0 0 0 1 0.5 0.5\nv 1 0 0\nv 1 1e0 0\n"
                 "vn 0 0 1\nvt 0 0\ns 1\nusemtl skin\nf 1/1/1 2//1 -1 # three\nv +0 1 0\nf 1 2 3 4\n"));
  ASSERT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.positions[2], glm::dvec3(1, 1, 0));
  EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 2, 3}));
  EXPECT_EQ(mesh.first, (std::vector<std::uint32_t>{0, 3, 7}));
  EXPECT_EQ(mesh.lines, (std::vector<std::uint32_t>{4, 5, 6, 12}));
}

TEST(obj, tells_what_is_wrong_and_in_which_line) {
  EXPECT_EQ(find_fault("good.obj", kTriangle), "");
  EXPECT_EQ(find_fault("a.obj", "v 0 0\n"), "a.obj:1: error: a point of 2 numbers; expected v X Y Z");
  EXPECT_EQ(find_fault("a.obj", "v 0 0 nan\n"),
            "a.obj:1: error: 'nan' is no coordinate; expected a number from -1000000 to 1000000");
  EXPECT_EQ(find_fault("a.obj", "\nv 0 0 1e9\n"),
            "a.obj:2: error: '1e9' is no coordinate; expected a number from -1000000 to 1000000");
  EXPECT_EQ(find_fault("a.obj", "v 0 inf 0,5\n"),
            "a.obj:1: error: 'inf' is no coordinate; expected a number from -1000000 to 1000000");
  EXPECT_EQ(find_fault("a.obj", kTriangle + "f 0 1 2\n"),
            "a.obj:5: error: a face names point 0; expected numbers from 1");
  EXPECT_EQ(find_fault("a.obj", kTriangle + "f 1 2 9\n"),
            "a.obj:5: error: a face names point 9; expected numbers from 1 to 3");
  EXPECT_EQ(find_fault("a.obj", kTriangle + "f 1 2 -9\n"),
            "a.obj:5: error: a face names point -9; expected numbers from 1 to 3");
  EXPECT_EQ(find_fault("a.obj", kTriangle + "f 1 2 x\n"),
            "a.obj:5: error: 'x' names no point; expected a number from 1, as in f 1 2 3 4");
  EXPECT_EQ(find_fault("a.obj", kTriangle + "f 1 2\n"),
            "a.obj:5: error: a face of 2 points; expected 3 at least");
  EXPECT_EQ(find_fault("a.obj", kTriangle + "\x01\x7F 9\n"),
            "a.obj:5: error: unknown word '?\?'; expected v, f or another word of an OBJ file");
  EXPECT_EQ(find_fault("a.obj", "v 0 0 0\nv 1 0 0\n"),
            "a.obj: error: has no faces; expected a surface of triangles or quads");
}

// Of a file of another kind, whatever link leads to it, nothing is shown.
TEST(geometry, shows_nothing_of_a_file_that_is_no_mesh) {
  const std::string secret = "root:x:hidden\nv hidden\n";
  EXPECT_EQ(find_fault("a.obj", secret),
            "a.obj:1: error: no word of an OBJ file; expected v, f or another one");
  EXPECT_EQ(find_fault("a.ply", secret),
            "a.ply:1: error: the file does not begin with the word 'ply'; expected a PLY file");
  EXPECT_EQ(find_fault("a.stl", secret),
            "a.stl: error: ends at byte 23, within its head; expected an STL of 84 bytes at least");
}

TEST(geometry, opens_only_what_it_can_read) {
  EXPECT_EQ(find_fault("empty.obj", " \n"), "empty.obj: error: is empty; expected a mesh");
  EXPECT_EQ(find_fault("a.blend", "x"),
            "a.blend: error: the name ends otherwise; expected .obj, .ply, .stl, .glb, .gltf, .xyz, .pts, "
            ".asc or .csv");
  const fs::path folder = fs::path(testing::TempDir()) / "mien_import";
  fs::create_directories(folder / "folder.obj");
  EXPECT_EQ(find_fault(folder / "folder.obj"), "folder.obj: error: is a folder; expected a mesh");
  EXPECT_EQ(find_fault(folder / "none.obj"), "none.obj: error: there is no such file; expected a mesh");
  fs::remove(folder / "zero.obj");
  fs::create_symlink("/dev/zero", folder / "zero.obj");
  EXPECT_EQ(find_fault(folder / "zero.obj"), "zero.obj: error: is no plain file; expected a mesh");
  const fs::path large = write_mesh("large.stl", "x");
  fs::resize_file(large, kMaxGeometryBytes + 1);  // a hole: it takes no place on the disk
  EXPECT_EQ(find_fault(large), "large.stl: error: has 200000001 bytes; expected 200000000 at most");
  fs::remove(large);
}

TEST(stl, makes_equal_corners_one_point) {
  const Polygons binary = load_polygons(write_mesh("two.stl", build_binary_stl(2, 2, 1)));
  EXPECT_EQ(binary.positions.size(), 4u);  // two triangles on one edge
  EXPECT_EQ(binary.face_count(), 2u);
  EXPECT_EQ(binary.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 3}));
  const Polygons text = load_polygons(
      write_mesh("text.stl",
                 "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
                 "   vertex 0 1 0\n  endloop\n endfacet\nendsolid a\n"));
  EXPECT_EQ(text.positions.size(), 3u);
}

TEST(stl, tells_what_is_wrong_and_where) {
  EXPECT_EQ(find_fault("a.stl", "garbage"),
            "a.stl: error: ends at byte 7, within its head; expected an STL of 84 bytes at least");
  EXPECT_EQ(find_fault("a.stl", build_binary_stl(3, 2, 1)),
            "a.stl: error: ends at byte 184, within triangle 3 of 3; expected 50 bytes more");
  EXPECT_EQ(find_fault("a.stl", build_binary_stl(1, 1, NAN)),
            "a.stl: error: the point at byte 108 has the x nan; expected a number from -1000000 to 1000000");
  EXPECT_EQ(find_fault("a.stl", build_binary_stl(0, 0, 0)),
            "a.stl: error: has no faces; expected a surface of triangles or quads");
  EXPECT_EQ(find_fault("a.stl", "solid a\nfacet normal 0 0 1\nvertex 0 0\n"),
            "a.stl:3: error: a vertex of 2 numbers; expected 3");
  EXPECT_EQ(find_fault("a.stl", "solid a\nfacet normal 0 0 1\nvertex 0 0 1\nendfacet\n"),
            "a.stl:4: error: a facet of 1 vertices; expected 3");
  EXPECT_EQ(find_fault("a.stl", "solid a\n"),
            "a.stl:1: error: the file ends without 'endsolid'; expected a whole STL");
  EXPECT_EQ(find_fault("a.stl", "solid a\nfoo\n"),
            "a.stl:2: error: unknown word 'foo'; expected facet, outer loop, vertex, endloop, endfacet or "
            "endsolid");
}

TEST(ply, is_read_as_text_and_binary) {
  const std::string text = build_ply_head("ascii") + "0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n4 0 1 2 3\n";
  for (const std::string& bytes : {text, build_binary_ply()}) {
    const Polygons mesh = load_polygons(write_mesh("square.ply", bytes));
    ASSERT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.positions[2], glm::dvec3(1, 1, 0));
    EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  }
}

template <typename Number>
void append_turned(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

TEST(ply, is_read_with_numbers_of_any_kind_in_either_order_of_bytes) {
  const auto build = [](const std::string& format, const auto& append) {
    std::string bytes = "ply\nformat " + format +
                        " 1.0\nelement vertex 3\nproperty char x\nproperty double y\nproperty short z\n"
                        "property ushort more\nelement face 1\nproperty list uchar uint vertex_index\n"
                        "property int side\nend_header\n";
    for (const int i : {0, 1, 2}) {
      append(bytes, static_cast<std::int8_t>(-7 * i));
      append(bytes, 0.1 * i * i);
      append(bytes, static_cast<std::int16_t>(-300 * i));
      append(bytes, std::uint16_t{65535});
    }
    append(bytes, std::uint8_t{3});
    for (const std::uint32_t v : {0u, 1u, 2u}) append(bytes, v);
    append(bytes, std::int32_t{-1});
    return bytes;
  };
  for (const std::string& bytes :
       {build("binary_little_endian", [](std::string&to, auto number) { append_bytes(to, number); }),
        build("binary_big_endian", [](std::string&to, auto number) { append_turned(to, number); })}) {
    const Polygons mesh = load_polygons(write_mesh("kinds.ply", bytes));
    EXPECT_EQ(mesh.positions,
              (std::vector<glm::dvec3>{{0, 0, 0}, {-7, 0.1, -300}, {-14, 0.1 * 2 * 2, -600}}));
    EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2}));
  }
}

TEST(geometry, is_read_with_the_line_ends_of_windows) {
  const auto turn = [](const std::string& text) {
    std::string turned;
    for (const char c : text) turned += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return turned;
  };
  EXPECT_EQ(load_polygons(write_mesh("windows.obj", turn(kTriangle))).positions.size(), 3u);
  EXPECT_EQ(load_polygons(write_mesh("windows.ply", turn(build_ply_head("ascii") +
                                                         "0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n4 0 1 2 3\n")))
                .corners.size(),
            4u);
}

TEST(geometry, a_cloud_has_a_normal_a_point_or_none) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", normal = "vn 0 0 1\n";
  const auto count_normals = [](const std::string& text) {
    return load_polygons(write_mesh("cloud.obj", text), Faces::optional).normals.size();
  };
  EXPECT_EQ(count_normals(points + normal + normal + normal), 3u);
  EXPECT_EQ(count_normals(points + normal + normal), 0u);
  EXPECT_EQ(count_normals(normal + normal + normal + points + "f 1 2 3\n"), 0u)
      << "of a surface the faces tell";
}

TEST(ply, tells_what_is_wrong_and_where) {
  const std::string whole = build_binary_ply(), head = build_ply_head("ascii");
  EXPECT_EQ(find_fault("a.ply", "x\n"),
            "a.ply:1: error: the file does not begin with the word 'ply'; expected a PLY file");
  EXPECT_EQ(
      find_fault("a.ply", "ply\nformat text 1.0\n"),
      "a.ply:2: error: unknown format 'text'; expected ascii, binary_little_endian or binary_big_endian");
  EXPECT_EQ(find_fault("a.ply", "ply\nformat ascii 1.0\n"),
            "a.ply:2: error: the file ends within its head; expected end_header");
  EXPECT_EQ(find_fault("a.ply", "ply\nformat ascii 1.0\nelement vertex 3000000\n"),
            "a.ply:3: error: more than 2000000 points; expected fewer");
  EXPECT_EQ(find_fault("a.ply", whole.substr(0, whole.size() - 3)),
            "a.ply: error: ends at byte 271, within face 1 of 1; expected all of them");
  EXPECT_EQ(
      find_fault("a.ply", build_binary_ply(INFINITY)),
      "a.ply: error: before byte 248: the x of vertex 3 is inf; expected a number from -1000000 to 1000000");
  EXPECT_EQ(find_fault("a.ply", whole.substr(0, whole.find("end_header") + 10)),
            "a.ply: error: ends at byte 204, within vertex 1 of 4; expected all of them");
  EXPECT_EQ(find_fault("a.ply", head + "0 0 0 1\n1 0 0 1\n1 1 x 1\n"),
            "a.ply:14: error: 'x' is no number; expected one");
  EXPECT_EQ(find_fault("a.ply", head + "0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n4 0 1 2 4\n"),
            "a.ply:16: error: face 0 names vertex 4; expected numbers from 0 to 3");
  EXPECT_EQ(find_fault("a.ply", head + "0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n2 0 1\n"),
            "a.ply:16: error: face 0 is a list of 2; expected 3 points or more");
  EXPECT_EQ(find_fault("a.ply", head + "0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n-1\n"),
            "a.ply:16: error: face 0 has a list of -1; expected 0 to 10000");
  EXPECT_EQ(
      find_fault("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 1\nproperty list float float x\nproperty float y\n"
                 "property float z\nend_header\n1e300 1\n"),
      "a.ply:8: error: vertex 0 has a list of 1e+300; expected 0 to 10000");
  EXPECT_EQ(
      find_fault("a.ply", "ply\nformat ascii 1.0\nelement vertex 2000000\nproperty float x\nend_header\n"),
      "a.ply:5: error: element vertex has no property 'y'; expected x, y and z");
  EXPECT_EQ(find_fault("a.ply", head + "0 0 0 1\n"),
            "a.ply:12: error: the file ends within vertex 2 of 4; expected all of them");
}

// Eight thousand million of them: whoever counts them does not come back.
TEST(ply, elements_without_properties_cost_nothing) {
  std::string bytes = build_ply_head("ascii");
  std::string empty;
  for (int i = 0; i < 1000; ++i) empty += "element e" + std::to_string(i) + " 8000000\n";
  bytes.insert(bytes.find("end_header"), empty);
  const Polygons mesh =
      load_polygons(write_mesh("empty.ply", bytes + "0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n4 0 1 2 3\n"));
  EXPECT_EQ(mesh.face_count(), 1u);
}

// Bytes cut off, changed or made up: told or read, and never more than that.
TEST(geometry, survives_broken_files) {
  std::mt19937 random(find_fuzz_seed(5));
  const std::string whole[] = {kTriangle, build_binary_stl(9, 9, 1), build_binary_ply(),
                               build_ply_head("ascii") + "0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n4 0 1 2 3\n"};
  const int rounds = count_fuzz_rounds(400);
  const char* names[] = {"broken.obj", "broken.stl", "broken.ply", "text.ply"};
  for (int round = 0; round < rounds; ++round) {
    std::string bytes = whole[round % 4];
    if (round % 3 == 0) bytes.resize(random() % bytes.size());
    for (std::size_t i = random() % 4; i > 0 && !bytes.empty(); --i)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    find_fault(names[round % 4], bytes);
  }
}

}  // namespace
}  // namespace mien
