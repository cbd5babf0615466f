// Scans as files: the mesh, the landmarks beside it, and what is said of wrong ones.
#include "head/scan.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "core/crossings.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "face/face.hpp"
#include "head/binding.hpp"
#include "head/eye_fit.hpp"
#include "head/landmarks.hpp"
#include "head/nearest.hpp"
#include "head/own_half.hpp"
#include "head/surface.hpp"
#include "head/wrap.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

const HeadStock& stock() { return shipped().heads; }

fs::path find_file(const std::string& name) { return fs::path(testing::TempDir()) / "mien_scan" / name; }

// The skin of a head as OBJ in metres, x kept at or above `lowest_x`, quads as triangles.
std::string build_obj(const NeutralHead& head, double lowest_x) {
  std::string text;
  for (const glm::vec3& p : head.skin.positions)
    text += fmt::format("v {:.7f} {:.7f} {:.7f}\n", std::max<double>(p.x, lowest_x) / 1000, p.y / 1000,
                        p.z / 1000);
  for (const auto& [a, b, c, d] : head.surface->quads) {
    bool is_kept = true;
    for (const std::uint32_t v : {a, b, c, d})
      is_kept = is_kept && head.skin.positions[v].x > lowest_x - 0.01;
    if (is_kept) text += fmt::format("f {} {} {}\nf {} {} {}\n", a + 1, b + 1, c + 1, a + 1, c + 1, d + 1);
  }
  return text;
}

std::string build_landmarks(const NeutralHead& head, const std::vector<const char*>& sides) {
  std::string text = "landmarks:\n";
  for (const char* name : {"n", "prn", "sn", "gn", "en", "ex", "ch", "t"}) {
    const SkinSpot spot = find_place(head, name);
    const glm::vec3 p = head.skin.positions[spot.vertices.front()] / 1000.0f;
    if (std::abs(p.x) < 1e-5f) {
      text += fmt::format("  {}: [{}, {}, {}]\n", name, p.x, p.y, p.z);
      continue;
    }
    for (const std::string side : sides)
      text += fmt::format("  {}{}: [{}, {}, {}]\n", name, side, side == "_r" ? -p.x : p.x, p.y, p.z);
  }
  return text;
}

NeutralHead build(const fs::path& file, bool is_half) {
  HeadSpec spec;
  (is_half ? spec.mesh : spec.scan) = FileReference{file, {}};
  return build_neutral_head(shipped().heads, spec);
}

NeutralHead build_sitter() {
  HeadSpec spec;
  spec.character = -0.7;
  spec.features = {{"nose_length", 0.5}};
  return build_neutral_head(shipped().heads, spec);
}

std::string find_fault(const std::string& landmarks, const std::string& mesh = "") {
  static const std::string obj = build_obj(build_sitter(), -1e9);
  write_file(find_file("fault.obj"), mesh.empty() ? obj : mesh);
  write_file(find_file("fault.yaml"), landmarks);
  try {
    load_scan_files(stock(), find_file("fault.obj"), false);
  } catch (const InputError& e) {
    std::string text;
    for (Diagnostic diagnostic : e.diagnostics) {
      diagnostic.place.file = fs::path(diagnostic.place.file).filename();
      diagnostic.source_line.clear();
      text += format_diagnostic(diagnostic) + "\n";
    }
    return text;
  }
  return "";
}

// The same of what is told when it is wrapped.
std::string find_wrap_fault(const std::string& landmarks) {
  if (std::string fault = find_fault(landmarks); !fault.empty()) return fault;
  try {
    wrap_scan(stock(), load_scan_files(stock(), find_file("fault.obj"), false));
  } catch (const InputError& e) {
    Diagnostic diagnostic = e.diagnostics.at(0);
    diagnostic.place.file = fs::path(diagnostic.place.file).filename();
    return format_diagnostic(diagnostic) + "\n";
  }
  return "";
}

// The mouth's bag is the adult's, made smaller: it stays inside a lower lip that is short and falls back.
TEST(scan, keeps_the_mouth_inside_a_lower_lip_that_falls_back) {
  constexpr float kBack_mm = 9;
  HeadSpec spec;
  spec.age = {{"infant", 1.0}};
  NeutralHead sitter = build_neutral_head(shipped().heads, spec);
  const auto find = [&](const char* name) { return sitter.skin.positions[find_point(sitter.cage, name)]; };
  const glm::vec3 meeting = find("M1_12"), border = find("M3_12"), chin = find("M6_12"),
                  corner = find("M1_6");
  for (glm::vec3& p : sitter.skin.positions) {
    if (p.z < corner.z - 8 || p.y > meeting.y - 1) continue;
    const float down = std::clamp((meeting.y - 1 - p.y) / (meeting.y - border.y), 0.0f, 1.0f);
    const float rest = std::clamp((p.y - chin.y + 10) / 10, 0.0f, 1.0f);
    p.z -= kBack_mm * down * rest;
  }
  write_file(find_file("back.obj"), build_obj(sitter, -1e9));
  write_file(find_file("back.yaml"), "unit: m\n" + build_landmarks(sitter, {"_l", "_r"}));
  const NeutralHead head = build(find_file("back.obj"), false);
  std::vector<bool> is_lip;
  for (const Triangle& t : head.skin.triangles) {
    const glm::vec3& p = head.skin.positions[t[0]];
    is_lip.push_back(p.z > corner.z - 10 && p.y < meeting.y && p.y > chin.y);
  }
  EXPECT_TRUE(find_crossings(head.skin.positions, head.skin.triangles, is_lip).empty());
}

TEST(scan, wraps_a_file_into_a_head_that_can_shut_its_eyes) {
  const NeutralHead sitter = build_sitter();
  write_file(find_file("face.obj"), build_obj(sitter, -1e9));
  write_file(find_file("face.yaml"), "unit: m\n" + build_landmarks(sitter, {"_l", "_r"}));
  const NeutralHead head = build(find_file("face.obj"), false);
  const SkinPatch skin = build_skin_patch(sitter.skin, {glm::vec3(-1e9F), glm::vec3(1e9F)});
  for (std::size_t v = 0; v < stock().data->half.points.size(); ++v) {
    if (stock().data->half.points[v].is_hard) continue;
    const glm::vec3 p = head.skin.positions[v];
    EXPECT_LT(glm::distance(p, find_nearest_place(skin, p).point), 0.5) << stock().adult.names[v];
    EXPECT_LT(glm::distance(p, sitter.skin.positions[v]), 2) << stock().adult.names[v];  // slid on the skin
  }
  const Face face = build_face(head);
  Pose shut;
  for (const Side side : {Side::left, Side::right}) shut.values[*find_move(Area::lid, side, "upper")] = -1;
  std::vector<glm::dvec3> points;
  pose_cage(head, face, shut, points);
  const NeutralHead asleep = build_bare_head(stock(), points);
  const auto at = [&](const char* name) { return asleep.skin.positions[find_point(head.cage, name)]; };
  for (const auto& [upper, lower] : {std::pair{"E1_3", "E1_13"}, {"E1_4", "E1_12"}, {"E1_5", "E1_11"}})
    EXPECT_LT(glm::distance(at(upper), at(lower)), 1.5) << upper;
  for (const char* name : {"E1_4", "E2_4", "E2_12", "E1_12"})
    EXPECT_GT(glm::distance(glm::dvec3(at(name)), head.eye.centre), head.eye.radius_mm) << name;
}

TEST(scan, a_half_of_other_points_is_made_whole) {
  const NeutralHead sitter = build_sitter();
  write_file(find_file("half.obj"), build_obj(sitter, 0));
  write_file(find_file("half.landmarks.yaml"), build_landmarks(sitter, {"_l"}));
  const NeutralHead head = build(find_file("half.obj"), true);
  for (const char* name : {"p_tip", "M1_6", "q12_C4", "p_F2", "E1_4", "M6_12"}) {
    const std::uint32_t v = find_point(head.cage, name);
    EXPECT_LT(glm::distance(head.skin.positions[v], sitter.skin.positions[v]), 1.5) << name;
  }
}

// The points of configs/scans/model.ply as a cloud, its landmarks beside it.
void write_cloud(const std::string& name, bool is_obj, bool has_normals) {
  const fs::path model = find_data_folder() / "configs/scans/model.ply";
  const Polygons mesh = load_polygons(model);
  const SurfaceTree tree = build_surface_tree(mesh);
  const std::size_t count = mesh.positions.size();
  std::string text;
  if (!is_obj) {
    text = fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", count);
    for (const char* property : {"x", "y", "z"}) text += fmt::format("property float {}\n", property);
    for (const char* property : {"nx", "ny", "nz"})
      if (has_normals) text += fmt::format("property float {}\n", property);
    text += "end_header\n";
  }
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 &p = mesh.positions[i], &n = tree.normals[i];
    text += fmt::format("{}{:.6f} {:.6f} {:.6f}", is_obj ? "v " : "", p.x, p.y, p.z);
    if (has_normals) text += fmt::format("{}{:.4f} {:.4f} {:.4f}", is_obj ? "\nvn " : " ", n.x, n.y, n.z);
    text += "\n";
  }
  write_file(find_file(name), text);
  write_file(find_file(name).replace_extension(".yaml"),
             read_file(fs::path(model).replace_extension(".yaml")));
}

TEST(scan, a_cloud_of_points_is_as_good_as_its_surface) {
  const NeutralHead surface = build(find_data_folder() / "configs/scans/model.ply", false);
  for (const bool is_obj : {false, true})
    for (const bool has_normals : {false, true}) {
      const std::string name = is_obj ? "cloud.obj" : "cloud.ply";
      write_cloud(name, is_obj, has_normals);
      const NeutralHead head = build(find_file(name), false);
      std::vector<glm::dvec3> from, to, normals;  // of the face
      for (std::size_t v = 0; v < head.skin.positions.size(); ++v) {
        const glm::vec3& p = surface.skin.positions[v];
        if (p.z < 30 || p.y < -90) continue;
        from.emplace_back(head.skin.positions[v]);
        to.emplace_back(p);
        normals.emplace_back(surface.skin.normals[v]);
      }
      const Similarity same = fit_similarity(from, to);  // eyes and ears say where a head stands, and differ
      double sum = 0;
      for (std::size_t i = 0; i < from.size(); ++i)
        sum += std::abs(glm::dot(apply_similarity(same, from[i]) - to[i], normals[i]));
      EXPECT_LT(sum / static_cast<double>(from.size()), 0.5)
          << name << (has_normals ? " with normals" : " without");
    }
}

TEST(scan, refuses_a_cloud_that_is_no_surface) {
  EXPECT_EQ(find_fault(build_landmarks(build_sitter(), {"_l", "_r"}), "v 0 0 0\nv 1 0 0\n"),
            "fault.obj: error: has 2 points and no faces; expected a surface, or a cloud of 100 points at "
            "least\n");
}

TEST(scan, tells_what_is_wrong_with_its_landmarks) {
  const std::string good = build_landmarks(build_sitter(), {"_l", "_r"});
  EXPECT_EQ(find_fault(good), "");
  EXPECT_EQ(find_fault(good + "unit: feet\n"),
            fmt::format("fault.yaml:{}:7: error: unknown unit 'feet'; known: mm, cm, m, in\n",
                        std::ranges::count(good, '\n') + 1));
  EXPECT_EQ(find_fault("landmarks: {prm: [0, 0, 0]}\n"),
            "fault.yaml:1:13: error: unknown landmark 'prm' in 'landmarks'; did you mean 'prn'?\n");
  EXPECT_EQ(find_fault("landmarks: {prn: [0, 0]}\n"),
            "fault.yaml:1:18: error: 'landmarks.prn' has 2 numbers; expected three, x y z\n");
  EXPECT_EQ(
      find_fault("landmarks: {prn: 1000000}\n"),
      fmt::format(
          "fault.yaml:1:18: error: 'landmarks.prn' is '1000000'; expected a whole number from 1 to {} (a "
          "point of the mesh), or a place such as [0, -30.5, 112]\n",
          stock().surface->vertex_count()));
  EXPECT_EQ(find_fault("landmarks: {prn: [0, 0, 1]}\n").substr(0, 47),
            "fault.yaml:1:18: error: landmark 'prn' lies 0.8");
  EXPECT_EQ(find_fault("landmarks: {prn: 1, ex_l: 2, ex_r: 3}\n"),
            "fault.yaml:1:1: error: landmarks are missing: n, sn, gn, en_l, en_r, ch_l, ch_r, t_l, t_r; "
            "expected all of "
            "these, more are welcome\n");
  EXPECT_EQ(find_fault("unit: mm\n"),
            "fault.yaml:1:1: error: the file has no 'landmarks'; expected names and places\n");
  EXPECT_EQ(find_fault("mien: 1\nlandmarks: {}\n").substr(0, 50),
            "fault.yaml:1:1: error: unknown key 'mien'; known: ");
}

// Mistakes that only the heads' shape shows have their place in the file all the same.
TEST(scan, tells_where_a_landmark_is_wrong) {
  std::string text = build_landmarks(build_sitter(), {"_l", "_r"});
  const auto find_line_of = [&](const std::string& name) {
    const auto at = text.begin() + static_cast<std::ptrdiff_t>(text.find("  " + name + ":"));
    return std::count(text.begin(), at, '\n') + 1;
  };
  const std::string unit_told = text + "unit: mm\n";
  EXPECT_EQ(
      find_wrap_fault(unit_told),
      fmt::format("fault.yaml:{}:7: error: with this unit the head is 0.000968 times as large as an adult's; "
                  "expected 0.4 to 2.5, or no unit at all\n  unit: mm\n        ^\n",
                  std::ranges::count(text, '\n') + 1));
  const std::size_t inner = text.find("en_l"), outer = text.find("ex_l");
  text.replace(outer, 4, "en_l");
  text.replace(inner, 4, "ex_l");
  const std::string fault = find_wrap_fault(text);
  EXPECT_TRUE(fault.starts_with(fmt::format("fault.yaml:{}:9: error: landmarks '", find_line_of("en_l"))))
      << fault;
  EXPECT_NE(fault.find("look exchanged: they lie "), std::string::npos) << fault;
}

TEST(scan, tells_a_file_of_landmarks_that_is_none) {
  EXPECT_EQ(find_fault(""),
            "fault.yaml:1:1: error: the file is empty; expected landmarks: {prn: [x, y, z], ...}\n");
  EXPECT_EQ(
      find_fault("root:x:hidden\n- [hidden\n"),
      "fault.yaml:1:1: error: is no file of landmarks: it has none of the keys landmarks, unit; expected "
      "landmarks: {prn: [x, y, z], ...}\n");
}

// A point a kilometre off made one box of the whole head: a minute of looking.
TEST(scan, points_astray_are_left_out_and_told) {
  const NeutralHead sitter = build_sitter();
  const std::string obj = build_obj(sitter, -1e9);
  write_file(find_file("stray.yaml"), build_landmarks(sitter, {"_l", "_r"}));
  write_file(find_file("stray.obj"), obj);
  const Scan plain = load_scan_files(stock(), find_file("stray.obj"), false);
  EXPECT_TRUE(plain.warnings.empty());
  const std::size_t count = plain.mesh.positions.size();
  write_file(find_file("stray.obj"), obj + fmt::format("v 1000 0 0\nv 0 2000 0\nf 1 2 {}\n", count + 1));
  const Scan stray = load_scan_files(stock(), find_file("stray.obj"), false);
  EXPECT_TRUE(stray.mesh.positions == plain.mesh.positions);
  EXPECT_EQ(stray.mesh.corners, plain.mesh.corners);
  ASSERT_EQ(stray.warnings.size(), 1u);
  EXPECT_TRUE(stray.warnings[0].is_warning);
  EXPECT_EQ(stray.warnings[0].message.substr(0, 68),
            fmt::format("2 of {} points are astray, up to 2000 from the middle of the others,", count + 2)
                .substr(0, 68));
  EXPECT_EQ(wrap_scan(stock(), stray).form.points, wrap_scan(stock(), plain).form.points);
}

TEST(scan, refuses_what_has_no_surface) {
  const std::string landmarks = build_landmarks(build_sitter(), {"_l", "_r"});
  std::string points;
  for (int i = 0; i < 300; ++i) points += "v 0 0 0\n";
  EXPECT_EQ(find_fault(landmarks, points),
            "fault.obj: error: has 1 different points and no faces; expected a surface, or a cloud of 100 "
            "points at "
            "least\n");
  EXPECT_EQ(find_fault(landmarks, points + "f 1 2 3\nf 4 5 6\n"),
            "fault.obj: error: none of its 2 faces has an area; expected a surface\n");
}

// What a scan was made into stays with the stock: a head that grows is sixty heads and one scan.
TEST(scan, is_wrapped_once) {
  HeadSpec spec;
  spec.scan = FileReference{find_data_folder() / "configs/scans/model.ply", {}};
  const HeadForm plain = build_form(stock(), spec);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(build_form(stock(), spec).points, plain.points);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
  const std::vector<StartNote> notes = list_start_notes(stock(), spec);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_TRUE(notes[0].warnings.empty()) << format_diagnostic(notes[0].warnings.front());
}

}  // namespace
}  // namespace mien
