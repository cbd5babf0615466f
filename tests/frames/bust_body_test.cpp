// Busts as one body: closed but for the foot, the same triangles in every pose, nothing through anything.
#include "frames/bust_body.hpp"

#include <gtest/gtest.h>

#include "frames/bust_controls.hpp"
#include "places.hpp"
#include "scene/openscad.hpp"
#include "scene/mesh_files.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace mien {
namespace {

TEST(bust_scratch, writes) {
  const char* spec_age = std::getenv("AGE");
  HeadSpec spec;
  if (spec_age) spec.age = {{spec_age, 1.0}};
  const Figure figure = build_figure(spec, source_folder());
  const auto t0 = std::chrono::steady_clock::now();
  BustSize size;
  if (const char* n = std::getenv("TRI")) size.triangles = std::size_t(std::atoi(n));
  const BustBody body = build_bust_body(figure, size);
  const auto t1 = std::chrono::steady_clock::now();
  std::printf("body %zu of %zu vertices, %zu triangles, %.2f s\n", body.kept.size(), body.all_count,
              body.triangles.size(), std::chrono::duration<double>(t1 - t0).count());
  const auto set = [](Pose& pose, std::string_view area, std::string_view move, double value) {
    for (std::size_t i = 0; i < kMoveCount; ++i)
      if (kMoves[i].area == area && kMoves[i].move == move) pose.values[i] = value;
  };
  std::vector<std::pair<std::string, Pose>> poses{{"neutral", {}}};
  Pose p;
  set(p, "lid", "upper", -1);
  set(p, "lips", "press", 1);
  poses.push_back({"shut", p});
  p = {};
  set(p, "chin", "down", 0.7);
  set(p, "corner", "up", 0.9);
  set(p, "corner", "out", 0.8);
  set(p, "lips", "upper", 0.5);
  set(p, "lips", "lower", -0.4);
  set(p, "lid", "lower", 0.7);
  poses.push_back({"laugh", p});
  p = {};
  set(p, "chin", "down", 1);
  set(p, "brow", "up", 1);
  set(p, "lid", "upper", 1);
  set(p, "eye", "side", 0.7);
  poses.push_back({"shout", p});
  PosableBust bust;
  bust.title = "Scratch";
  bust.expression = "shout";
  bust.height_mm = size.whole_mm;
  bust.figure_mm = size.figure_mm;
  std::vector<NamedPose> named;
  for (const auto& [name, pose] : poses) named.push_back({name, pose});
  const auto t2 = std::chrono::steady_clock::now();
  add_bust_controls(body, figure, named, 0.02, 0.1, bust);
  const auto t3 = std::chrono::steady_clock::now();
  const std::string scad = build_openscad_bust(bust, std::filesystem::path(source_folder()) / "templates");
  std::printf("states %zu, controls %.2f s, source %zu bytes\n", bust.states.size(), std::chrono::duration<double>(t3 - t2).count(), scad.size());
  std::ofstream("/tmp/scratch.scad") << scad;
  for (const auto& [name, pose] : poses) {
    Mesh mesh;
    mesh.positions = place_bust(body, figure, pose);
    mesh.triangles = body.triangles;
    append_fan_cap(mesh, find_boundary_loops(mesh.triangles).at(0), glm::vec3(0));
    EXPECT_EQ(count_open_edges(mesh.triangles), 0U);
    std::ofstream file("/tmp/bust_" + name + ".obj");
    for (const glm::vec3& q : mesh.positions) file << "v " << q.x << ' ' << q.y << ' ' << q.z << '\n';
    for (const Triangle& t : mesh.triangles) file << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
    std::printf("%s volume %.0f\n", name.c_str(), compute_volume_mm3(mesh));
  }
}

}  // namespace
}  // namespace mien
