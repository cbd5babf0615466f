// glTF as a head to scan: read, and told where it cannot be.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>

#include "core/error.hpp"
#include "fuzz_rounds.hpp"
#include "import/reading.hpp"

namespace mien {
namespace {

using Json = nlohmann::json;

void append_word(std::string& bytes, std::uint32_t word) {
  bytes.append(reinterpret_cast<const char*>(&word), 4);
}

// Two triangles over one edge, whose corners are there twice, as where a picture is cut; their node lies 10
// above.
std::string build_bytes() {
  std::string bytes;
  for (const float number :
       {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f})
    append_word(bytes, std::bit_cast<std::uint32_t>(number));
  for (std::uint16_t index = 0; index < 6; ++index) bytes.append(reinterpret_cast<const char*>(&index), 2);
  return bytes;
}

Json build_json() {
  return Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"children": [1], "translation": [0, 10, 0]}, {"mesh": 0, "scale": [2, 2, 2]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "buffers": [{"byteLength": 84}], "bufferViews": [{"buffer": 0, "byteLength": 72},
    {"buffer": 0, "byteOffset": 72, "byteLength": 12}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3"},
    {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}]})");
}

std::string build_glb(const Json& json, const std::string& bytes) {
  std::string text = json.dump(), glb = "glTF";
  text.resize((text.size() + 3) / 4 * 4, ' ');
  append_word(glb, 2);
  append_word(glb, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + bytes.size()));
  append_word(glb, static_cast<std::uint32_t>(text.size()));
  glb += "JSON" + text;
  append_word(glb, static_cast<std::uint32_t>(bytes.size()));
  return glb + std::string("BIN\0", 4) + bytes;
}

std::string find_fault(const std::string& bytes) {
  try {
    read_gltf("head.glb", bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(gltf, joins_points_and_places_nodes) {
  const Polygons mesh = read_gltf("head.glb", build_glb(build_json(), build_bytes()));
  EXPECT_THAT(mesh.positions, testing::ElementsAre(glm::dvec3(0, 10, 0), glm::dvec3(2, 10, 0),
                                                   glm::dvec3(0, 12, 0), glm::dvec3(2, 12, 0)));
  EXPECT_THAT(mesh.corners, testing::ElementsAre(0, 1, 2, 1, 3, 2));
  EXPECT_EQ(mesh.face_count(), 2u);
}

TEST(gltf, reads_text_with_its_numbers_inside) {
  Json json = build_json();
  json["buffers"][0] = {{"byteLength", 36},
                        {"uri",
                         "data:application/octet-stream;base64,"
                         "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}};
  json["bufferViews"][0]["byteLength"] = 36;
  json["meshes"][0]["primitives"][0].erase("indices");
  json["accessors"][0]["count"] = 3;
  const Polygons mesh = read_gltf("head.gltf", json.dump());
  EXPECT_THAT(mesh.positions,
              testing::ElementsAre(glm::dvec3(0, 10, 0), glm::dvec3(2, 10, 0), glm::dvec3(0, 12, 0)));
  json["buffers"][0]["uri"] = "numbers.bin";
  EXPECT_EQ(find_fault(json.dump()),
            "head.glb: error: its numbers lie in another file; expected .glb, or .gltf with all inside");
}

TEST(gltf, tells_what_is_wrong) {
  const auto with = [](const char* pointer, const Json& value) {
    Json json = build_json();
    json[Json::json_pointer(pointer)] = value;
    return find_fault(build_glb(json, build_bytes()));
  };
  EXPECT_EQ(find_fault("no glTF"), "head.glb: error: it is no JSON; expected glTF 2.0");
  EXPECT_EQ(with("/scenes", Json::array()), "head.glb: error: it has no scene; expected one with a head");
  EXPECT_EQ(with("/scenes/0/nodes", 3), "head.glb: error: its scene is empty; expected one with a head");
  EXPECT_EQ(with("/scenes/0/nodes/0", "a"),
            "head.glb: error: a scene's node is no number; expected glTF 2.0");
  EXPECT_EQ(with("/nodes/1/mesh", 7), "head.glb: error: meshes 7 is not there; expected glTF 2.0");
  EXPECT_EQ(with("/nodes/0/children/0", 0),
            "head.glb: error: nodes lie in each other more than 64 deep; expected fewer");
  EXPECT_EQ(with("/nodes/0/translation", {1, 2}),
            "head.glb: error: a node's 'translation' has no 3 numbers; expected glTF 2.0");
  EXPECT_EQ(with("/accessors/0/count", 7),
            "head.glb: error: accessor 0 ends behind its buffer; expected the whole file");
  EXPECT_EQ(with("/accessors/0/type", "VEC2"), "head.glb: error: accessor 0 is no VEC3; expected glTF 2.0");
  EXPECT_EQ(with("/accessors/0/componentType", 5125),
            "head.glb: error: accessor 0 holds numbers of kind 5125; expected floats");
  EXPECT_EQ(with("/accessors/0/count", -1),
            "head.glb: error: 'count' is no whole number where one is needed; expected glTF 2.0");
  std::string bytes = build_bytes();
  bytes[72] = 9;
  EXPECT_EQ(find_fault(build_glb(build_json(), bytes)),
            "head.glb: error: a triangle has the vertex 9 of 6; expected one that is there");
  const std::string cut = build_glb(build_json(), bytes);
  EXPECT_THAT(find_fault(cut.substr(0, cut.size() - 5)), testing::HasSubstr("expected the whole file"));
}

TEST(gltf, damage_is_read_or_told_and_never_more) {
  std::mt19937 random(find_fuzz_seed(9));
  const std::string whole = build_glb(build_json(), build_bytes());
  for (int round = 0; round < count_fuzz_rounds(600); ++round) {
    std::string bytes = whole;
    for (int i = 0; i < 1 + static_cast<int>(random() % 4); ++i) {
      if (random() % 4 == 0)
        bytes.erase(random() % bytes.size(), 1 + random() % 8);
      else
        bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    try {
      const Polygons mesh = read_gltf("head.glb", bytes);
      for (const std::uint32_t corner : mesh.corners) EXPECT_LT(corner, mesh.positions.size());
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith("head.glb: error: ")) << round;
    }
  }
}

}  // namespace
}  // namespace mien
