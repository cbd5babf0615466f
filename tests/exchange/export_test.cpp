// What `mien export` writes is what the face does, read back by rules that are not ours.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <random>

#include "clip/moment.hpp"
#include "clip/view.hpp"
#include "config/mapping_data.hpp"
#include "core/error.hpp"
#include "core/pool.hpp"
#include "core/text.hpp"
#include "end_to_end/program.hpp"
#include "exchange/exports.hpp"
#include "exchange/gltf_probe.hpp"
#include "exchange/target_sets.hpp"
#include "import/unit_pose.hpp"
#include "shipped.hpp"
#include "takes/retarget.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

constexpr const char* kClip = R"(
clip:
  fps: 24
  length: 1.5s
  turn:
    - {at: 0s, turn: 0deg}
    - {at: 0.6s, turn: 30deg, nod: 12deg}
    - {at: 1.2s, turn: -20deg, tilt: 10deg}
  keys:
    - {at: 0s, express: neutral}
    - {at: 0.4s, express: surprise}
    - {at: 0.8s, express: laugh}
    - {at: 1.2s, express: anger, areas: {eyes: {side: 0.7, up: -0.5}}}
    - {at: 1.5s, areas: {lids: {upper: -1}}}
)";

// One face with its clip, made once a head.
struct Exported {
  Clip clip;
  Figure figure;
  Performance performance;
};

Exported open_exported(const fs::path& folder, const std::string& head) {
  write_file(folder / "face.yaml", fmt::format("mien: 1\ntitle: A face\nhead: {}{}", head, kClip));
  Options options;
  options.file = folder / "face.yaml";
  Exported made{plan_clip(options, *shipped().stock.language), {}, {}};
  made.figure = build_figure(shipped().heads, made.clip.actors.front().head);
  made.performance = made.clip.actors.front().performance;
  made.performance.idle.eyes = compute_eyes(made.figure, made.clip.spec.render);
  return made;
}

std::string write_to(const Exported& made, const Options& options, const fs::path& path) {
  write_export({options, made.clip, made.clip.actors.front().head, made.figure, shipped().stock.templates,
                made.performance, 1, made.clip.frame_count},
               path);
  return read_file(path);
}

// The farthest that a vertex of any part is from where the face has it, mm.
double measure_worst(const Exported& made, const tinygltf::Model& model, double time_s) {
  const auto told = place_gltf(model, time_s);
  const Drawing drawing = draw_moment(made.figure, sample_performance(made.performance, time_s));
  double worst = 0;
  for (std::size_t p = 0; p < made.figure.model.parts.size(); ++p) {
    const Part& part = made.figure.model.parts[p];
    if (!part.triangle_shade.empty()) continue;  // its vertices are there several times
    const std::vector<glm::dvec3>& places = told.at(part.name);
    for (std::size_t v = 0; v < places.size(); ++v) {
      if (part.name == "skin" && v >= part.rest.positions.size()) break;  // those of the cut again
      const glm::dvec3 truth =
          is_carried(part, drawing.parts[p])
              ? glm::dvec3(drawing.parts[p].world_from_rest * glm::vec4(part.rest.positions[v], 1))
              : glm::dvec3(drawing.parts[p].positions[v]);
      worst = std::max(worst, glm::distance(truth, places[v]));
    }
  }
  return worst;
}

TEST(exports, gltf_is_the_face_at_any_time) {
  const auto folder = make_folder("export_gltf");
  for (const char* head : {"{hair: crop}", "{age: child, design: comic}"}) {
    const Exported made = open_exported(folder, head);
    const tinygltf::Model model = read_gltf(write_to(made, {}, folder / "face.glb"));
    std::mt19937 random(21);
    for (int i = 0; i < 12; ++i) {
      const double time_s = std::uniform_real_distribution<double>(0, 1.5)(random);
      EXPECT_LT(measure_worst(made, model, time_s), 0.15) << head << " at " << time_s;
    }
    for (const int frame : {0, 9, 19, 36})
      EXPECT_LT(measure_worst(made, model, frame / 24.0), 0.08) << head << " frame " << frame;
  }
}

TEST(exports, exact_gltf_has_no_error_at_frames) {
  const auto folder = make_folder("export_exact");
  const Exported made = open_exported(folder, "{}");
  Options options;
  options.is_exact = true;
  const tinygltf::Model model = read_gltf(write_to(made, options, folder / "face.gltf"));
  for (const int frame : {0, 5, 9, 19, 28, 36})
    EXPECT_LT(measure_worst(made, model, frame / 24.0), 0.02) << frame;
}

TEST(exports, gltf_names_its_targets_and_keeps_their_weights_in_range) {
  const auto folder = make_folder("export_names");
  const Exported made = open_exported(folder, "{}");
  const tinygltf::Model model = read_gltf(write_to(made, {}, folder / "face.glb"));
  std::set<std::string> names;
  for (const tinygltf::Mesh& mesh : model.meshes) {
    if (mesh.primitives[0].targets.empty()) continue;
    const tinygltf::Value& told = mesh.extras.Get("targetNames");
    ASSERT_EQ(told.ArrayLen(), mesh.primitives[0].targets.size());
    for (std::size_t i = 0; i < told.ArrayLen(); ++i)
      names.insert(told.Get(static_cast<int>(i)).Get<std::string>());
  }
  for (std::size_t move = 0; move < kMoveCount; ++move) {
    EXPECT_TRUE(names.contains(name_move_target(move, kMoves[move].high)))
        << kMoves[move].area << kMoves[move].move;
    const double low = kMoves[move].low;
    EXPECT_TRUE(low == 0 || names.contains(name_move_target(move, low)));
  }
  EXPECT_EQ(name_move_target(find_move(Area::lid, Side::left, "upper").value(), -0.5), "lid.left.shut@50");
  for (const tinygltf::AnimationChannel& channel : model.animations.at(0).channels) {
    if (channel.target_path != "weights") continue;
    const auto& accessor = model.accessors[model.animations[0].samplers[channel.sampler].output];
    const auto& view = model.bufferViews[accessor.bufferView];
    for (std::size_t i = 0; i < accessor.count; ++i) {
      float weight;
      std::memcpy(&weight, &model.buffers[0].data[view.byteOffset + 4 * i], 4);
      EXPECT_GE(weight, 0);
      EXPECT_LE(weight, 1.0001f);
    }
  }
}

TEST(exports, gltf_is_the_same_bytes_whatever_the_threads) {
  const auto folder = make_folder("export_bytes");
  const Exported made = open_exported(folder, "{}");
  set_job_count(1);
  const std::string one = write_to(made, {}, folder / "one.glb");
  set_job_count(0);
  EXPECT_EQ(write_to(made, {}, folder / "all.glb"), one);
}

TEST(exports, targets_of_expressions_play_the_clip_too) {
  const auto folder = make_folder("export_expressions");
  const Exported made = open_exported(folder, "{}");
  Options options;
  options.targets = "expressions";
  const tinygltf::Model model = read_gltf(write_to(made, options, folder / "face.glb"));
  for (const int frame : {0, 9, 19, 28}) EXPECT_LT(measure_worst(made, model, frame / 24.0), 0.15) << frame;
  try {
    build_target_set("apple", made.clip.spec);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "--targets apple: unknown set of targets; expected one of: moves, expressions, arkit, vrm");
  }
}

TEST(exports, vrm_has_the_bones_and_expressions_that_avatars_need) {
  const auto folder = make_folder("export_vrm");
  Exported made = open_exported(folder, "{hair: bob}");
  made.clip.spec.author = "An Author";
  made.clip.spec.licence = "https://example.org/terms";
  const tinygltf::Model model = read_gltf(write_to(made, {}, folder / "face.vrm"));
  EXPECT_THAT(model.extensionsUsed, testing::ElementsAre("VRMC_vrm"));
  const tinygltf::Value& vrm = model.extensions.at("VRMC_vrm");
  EXPECT_EQ(vrm.Get("specVersion").Get<std::string>(), "1.0");
  EXPECT_EQ(vrm.Get("meta").Get("authors").Get(0).Get<std::string>(), "An Author");
  EXPECT_EQ(vrm.Get("meta").Get("otherLicenseUrl").Get<std::string>(), "https://example.org/terms");
  const tinygltf::Value& bones = vrm.Get("humanoid").Get("humanBones");
  std::set<int> nodes;
  for (const char* bone :
       {"hips", "spine", "head", "leftUpperLeg", "leftLowerLeg", "leftFoot", "rightUpperLeg", "rightLowerLeg",
        "rightFoot", "leftUpperArm", "leftLowerArm", "leftHand", "rightUpperArm", "rightLowerArm",
        "rightHand", "leftEye", "rightEye", "jaw", "neck"}) {
    ASSERT_TRUE(bones.Has(bone)) << bone;
    nodes.insert(bones.Get(bone).Get("node").GetNumberAsInt());
  }
  EXPECT_EQ(nodes.size(), 19u) << "a node each";
  for (const char* preset : {"happy", "angry", "sad", "relaxed", "surprised", "aa", "ih", "ou", "ee", "oh",
                             "blink", "blinkLeft", "blinkRight"}) {
    const tinygltf::Value& binds = vrm.Get("expressions").Get("preset").Get(preset).Get("morphTargetBinds");
    ASSERT_GT(binds.ArrayLen(), 0u) << preset;
    for (std::size_t i = 0; i < binds.ArrayLen(); ++i) {
      const tinygltf::Node& node =
          model.nodes.at(binds.Get(static_cast<int>(i)).Get("node").GetNumberAsInt());
      const std::size_t target = binds.Get(static_cast<int>(i)).Get("index").GetNumberAsInt();
      const tinygltf::Mesh& mesh = model.meshes.at(node.mesh);
      ASSERT_LT(target, mesh.primitives[0].targets.size());
      EXPECT_EQ(mesh.extras.Get("targetNames").Get(static_cast<int>(target)).Get<std::string>(), preset);
    }
  }
  const auto places = place_gltf(model, 0);
  EXPECT_GT(places.at("skin")[0].y, 1200) << "feet stand on the ground";
}

TEST(exports, usd_has_all_parts_joints_and_times) {
  const auto folder = make_folder("export_usd");
  const Exported made = open_exported(folder, "{}");
  const std::string usd = write_to(made, {}, folder / "face.usda");
  EXPECT_TRUE(usd.starts_with("#usda 1.0\n"));
  for (const Part& part : made.figure.model.parts)
    EXPECT_NE(usd.find(fmt::format("def Mesh \"{}\"", part.name)), usd.npos);
  EXPECT_NE(usd.find("\"shoulders/neck_1/neck_2/neck_3/neck_4/neck_5/neck_6/neck_7/head/jaw\""), usd.npos);
  EXPECT_NE(usd.find("endTimeCode = 36\n"), usd.npos);
  EXPECT_NE(usd.find("def BlendShape \"lid_left_shut\""), usd.npos);
  for (const auto& [open, shut] : {std::pair('{', '}'), {'[', ']'}, {'(', ')'}})
    EXPECT_EQ(std::ranges::count(usd, open), std::ranges::count(usd, shut)) << open;
  EXPECT_EQ(usd.find("nan"), usd.npos);
}

TEST(exports, table_is_read_back_as_the_same_performance) {
  const auto folder = make_folder("export_table");
  const Exported made = open_exported(folder, "{}");
  write_to(made, {}, folder / "moves.csv");
  write_file(folder / "again.yaml", "mien: 1\nclip: {fps: 24, length: 1.5s, tracks: [{csv: moves.csv}]}\n");
  Options options;
  options.file = folder / "again.yaml";
  const Clip again = plan_clip(options, *shipped().stock.language);
  for (int frame = 0; frame < 36; ++frame) {
    const Pose asked = sample_performance(made.performance, frame / 24.0).pose;
    const Pose told = sample_performance(again.actors.front().performance, frame / 24.0).pose;
    for (std::size_t m = 0; m < kMoveCount; ++m) EXPECT_NEAR(told.values[m], asked.values[m], 0.01) << frame;
  }
}

// How far the moves of two performances are apart at worst, and in which of them.
struct Apart {
  double most = 0;
  std::string move;
};

Apart measure_apart(const Performance& a, const Performance& b, int frames) {
  Apart apart;
  for (int frame = 0; frame < frames; ++frame) {
    const Pose one = sample_performance(a, frame / 24.0).pose, two = sample_performance(b, frame / 24.0).pose;
    for (std::size_t m = 0; m < kMoveCount; ++m)
      if (std::abs(one.values[m] - two.values[m]) > apart.most)
        apart = {std::abs(one.values[m] - two.values[m]), fmt::format("{} frame {}", name_move(m), frame)};
  }
  return apart;
}

TEST(exports, gltf_and_live_link_are_read_back_as_the_same_performance) {
  const auto folder = make_folder("export_back");
  const Exported made = open_exported(folder, "{}");
  write_to(made, {}, folder / "face.glb");
  Options arkit;
  arkit.targets = "arkit";
  write_to(made, arkit, folder / "take.csv");
  for (const char* track : {"gltf: face.glb", "live_link: take.csv, fps: 24, smooth: 0"}) {
    write_file(folder / "again.yaml",
               fmt::format("mien: 1\nclip: {{fps: 24, length: 1.5s, tracks: [{{{}}}]}}\n", track));
    Options options;
    options.file = folder / "again.yaml";
    const Clip again = plan_clip(options, *shipped().stock.language);
    const Performance& told = again.actors.front().performance;
    const Apart apart = measure_apart(made.performance, told, 36);
    EXPECT_LT(apart.most, 0.01) << track << ", " << apart.move;
    for (int frame = 0; frame < 36; ++frame)
      EXPECT_NEAR(sample_performance(told, frame / 24.0).turn.turn_deg,
                  sample_performance(made.performance, frame / 24.0).turn.turn_deg, 0.3)
          << track << " frame " << frame;
  }
}

TEST(exports, a_face_of_mpfb_is_read_back_as_the_same_pose) {
  const auto folder = make_folder("export_face_back");
  const MappingData& data = *shipped().stock.language->libraries.mappings;
  std::mt19937 random(7);
  for (int round = 0; round < 6; ++round) {
    Exported made = open_exported(folder, "{}");
    Pose asked;
    for (std::size_t m = 0; m < kMoveCount; ++m)
      if (random() % 3 == 0)
        asked.values[m] = std::uniform_real_distribution<double>(kMoves[m].low, kMoves[m].high)(random);
    std::string csv = "time", row = "0";
    for (std::size_t m = 0; m < kMoveCount; ++m) {
      csv += "," + name_move(m);
      row += fmt::format(",{:.4f}", asked.values[m]);
    }
    write_file(folder / "pose.csv", csv + "\n" + row + "\n1" + row.substr(1) + "\n");
    write_file(folder / "pose.yaml", "mien: 1\nclip: {fps: 24, length: 1s, tracks: [{csv: pose.csv}]}\n");
    Options options;
    options.file = folder / "pose.yaml";
    made.clip = plan_clip(options, *shipped().stock.language);
    made.performance = made.clip.actors.front().performance;
    write_to(made, {}, folder / "face.json");
    const UnitPose units = load_unit_pose(folder / "face.json");
    const TakeMoves told = retarget_take(build_unit_take(units), find_mapping(data, "arkit"), data.moves);
    for (std::size_t m = 0; m < kMoveCount; ++m)
      EXPECT_NEAR(told.values[m], asked.values[m], 0.01) << name_move(m) << " round " << round;
  }
}

// A clip of faces that ARKit's units make: written as Live Link Face does, and followed again.
TEST(exports, live_link_is_read_back_as_the_same_performance) {
  const auto folder = make_folder("export_live_link");
  const Exported plain = open_exported(folder, "{}");
  const std::vector<TargetPose> units = build_target_set("arkit", plain.clip.spec);
  EXPECT_EQ(units.size(), 52u);
  std::string csv = "time";
  for (std::size_t m = 0; m < kMoveCount; ++m) csv += "," + name_move(m);
  csv += "\n";
  std::mt19937 random(4);
  for (int frame = 0; frame < 24; ++frame) {
    Pose pose;
    for (const char* name :
         {"mouthSmileLeft", "mouthSmileRight", "browInnerUp", "eyeBlinkLeft", "jawOpen", "eyeLookUpLeft"})
      for (const TargetPose& unit : units) {
        if (unit.name != name) continue;
        const double share = 0.1 * static_cast<double>(random() % 10);
        for (std::size_t m = 0; m < kMoveCount; ++m) pose.values[m] += share * unit.pose.values[m];
      }
    // mouthClose: a share of how far the jaw is open.
    if (pose.values[*find_move(Area::chin, Side::none, "down")] > 0)
      pose.values[*find_move(Area::lips, Side::none, "shut")] = 0.1 * static_cast<double>(random() % 11);
    csv += fmt::format("{}", frame / 24.0);
    for (std::size_t m = 0; m < kMoveCount; ++m) csv += fmt::format(",{:.6f}", pose.values[m]);
    csv += "\n";
  }
  write_file(folder / "made.csv", csv);
  const auto open_track = [&](const char* name, const std::string& track) {
    write_file(folder / name,
               fmt::format("mien: 1\nclip: {{fps: 24, length: 1s, tracks: [{{{}}}]}}\n", track));
    Options options;
    options.file = folder / name;
    return plan_clip(options, *shipped().stock.language);
  };
  const Clip made = open_track("made.yaml", "csv: made.csv");
  Options options;
  options.targets = "arkit";
  const Performance& performance = made.actors.front().performance;
  write_export(
      {options, made, made.actors.front().head, plain.figure, shipped().stock.templates, performance, 1, 24},
      folder / "take.csv");
  const Clip again = open_track("again.yaml", "live_link: take.csv, fps: 24, smooth: 0");
  for (int frame = 0; frame < 24; ++frame) {
    const Pose asked = sample_performance(performance, frame / 24.0).pose;
    const Pose told = sample_performance(again.actors.front().performance, frame / 24.0).pose;
    for (std::size_t m = 0; m < kMoveCount; ++m)
      EXPECT_NEAR(told.values[m], asked.values[m], 0.01) << name_move(m) << " frame " << frame;
  }
}

// Live Link Face's table tells how the head turns, and a take of it turns it so again.
TEST(exports, head_turns_are_in_live_links_table) {
  constexpr double kThinned_deg = 0.2;  // turns of a take are keys, as few as it needs
  const auto folder = make_folder("export_turns");
  const Exported made = open_exported(folder, "{}");
  Options options;
  options.targets = "arkit";
  const std::string table = write_to(made, options, folder / "take.csv");
  EXPECT_NE(table.substr(0, table.find('\n')).find(",HeadYaw,HeadPitch,HeadRoll,"), table.npos);
  write_file(folder / "again.yaml",
             "mien: 1\nclip: {fps: 24, length: 1.5s, tracks: [{live_link: take.csv, fps: 24, smooth: 0}]}\n");
  Options again_options;
  again_options.file = folder / "again.yaml";
  const Clip again = plan_clip(again_options, *shipped().stock.language);
  double most = 0;
  for (int frame = 0; frame < 36; ++frame) {
    const TurnKey asked = sample_performance(made.performance, frame / 24.0).turn;
    const TurnKey told = sample_performance(again.actors.front().performance, frame / 24.0).turn;
    EXPECT_NEAR(told.turn_deg, asked.turn_deg, kThinned_deg) << frame;
    EXPECT_NEAR(told.nod_deg, asked.nod_deg, kThinned_deg) << frame;
    EXPECT_NEAR(told.tilt_deg, asked.tilt_deg, kThinned_deg) << frame;
    most = std::max(most, std::abs(asked.turn_deg));
  }
  EXPECT_GT(most, 25);
}

TEST(exports, arkit_targets_have_all_names) {
  const auto folder = make_folder("export_arkit");
  const Exported made = open_exported(folder, "{}");
  Options options;
  options.targets = "arkit";
  const tinygltf::Model model = read_gltf(write_to(made, options, folder / "face.glb"));
  std::set<std::string> names;
  for (const tinygltf::Mesh& mesh : model.meshes)
    if (mesh.name == "skin")
      for (std::size_t i = 0; i < mesh.primitives[0].targets.size(); ++i)
        names.insert(mesh.extras.Get("targetNames").Get(static_cast<int>(i)).Get<std::string>());
  for (const TargetPose& unit : build_target_set("arkit", made.clip.spec))
    EXPECT_TRUE(names.contains(unit.name)) << unit.name;
  for (const int frame : {0, 9, 19, 28}) EXPECT_LT(measure_worst(made, model, frame / 24.0), 0.15) << frame;
  write_to(made, {}, folder / "face.json");
  EXPECT_TRUE(nlohmann::json::parse(read_file(folder / "face.json")).contains("face_units"));
}

TEST(exports, sequences_have_a_file_a_frame) {
  const auto folder = make_folder("export_sequence");
  const Exported made = open_exported(folder, "{}");
  write_export({{},
                made.clip,
                made.clip.actors.front().head,
                made.figure,
                shipped().stock.templates,
                made.performance,
                10,
                11},
               folder / "face_%04d.obj");
  EXPECT_THAT(list_files(folder),
              testing::UnorderedElementsAre("face.yaml", "face_0010.obj", "face_0011.obj"));
  EXPECT_EQ(name_frame_file("a/b%d.ply", 12), "a/b12.ply");
  for (const char* wrong : {"face.obj", "face_%s.obj", "a%04d_%04d.obj"}) try {
      name_frame_file(wrong, 1);
      FAIL() << wrong;
    } catch (const InputError& error) {
      EXPECT_EQ(
          error.what(),
          fmt::format(
              "-o {}: each frame is a file of its own; expected a name with a place for its number, such "
              "as {}_%04d.obj",
              wrong, fs::path(wrong).stem().string()));
    }
}

}  // namespace
}  // namespace mien
