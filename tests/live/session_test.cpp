// What a page asks and what it is told, without the net between.
#include "live/session.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <thread>

#include "clip/moment.hpp"
#include "config/data_words.hpp"
#include "config/schema.hpp"
#include "core/text.hpp"
#include "live/json.hpp"
#include "places.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

constexpr const char* kText =
    "mien: 1\n"
    "clip:\n"
    "  length: 1s\n"
    "  blink: none\n"
    "  keys:\n"
    "    - {at: 0s, express: neutral}\n"
    "    - {at: 0.5s, express: smile}\n";

struct Opened {
  explicit Opened(const std::string& text = kText) {
    folder = std::filesystem::path(::testing::TempDir()) /
             (std::string("live_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder);
    write_file(folder / "face.yaml", text);
    session.shelf.resources = &shipped();
    session.shelf.file = folder / "face.yaml";
    session.schema = build_schema(load_data_words(find_data_folder()));
    session.files = {{"index.html", folder / "face.yaml"}};
    look_at_disk(session, false);
  }
  ~Opened() {
    end_session(session);
    std::filesystem::remove_all(folder);
  }

  LiveAnswer post(const std::string& path, const Json& body) {
    return answer_request(session, {true, path, {}, body.dump()});
  }
  LiveAnswer get(const std::string& path, const std::string& version = "") {
    LiveRequest request{false, path, {}, {}};
    if (!version.empty()) request.query["version"] = version;
    return answer_request(session, request);
  }
  Json ask(const std::string& path, const Json& body) {
    const LiveAnswer answer = post(path, body);
    EXPECT_EQ(answer.status, 200) << path << " " << answer.body;
    return Json::parse(answer.body, nullptr, false);
  }
  std::string check(const std::string& text = kText) { return ask("api/check", {{"text", text}})["doc"]; }

  std::filesystem::path folder;
  LiveSession session;
};

Json open_header(const std::string& body, std::size_t& at) {
  std::uint32_t size = 0;
  std::memcpy(&size, body.data(), sizeof size);
  at = sizeof size + size;
  return Json::parse(body.substr(sizeof size, size));
}

Json ask_model(Opened& opened, const std::string& doc) {
  std::size_t at = 0;
  return open_header(opened.post("api/shapes", {{"doc", doc}, {"frame", 0}}).body, at)["fresh"];
}

TEST(live_session, tells_the_file_and_what_may_be_done) {
  Opened opened;
  const Json value = Json::parse(opened.get("api/session").body);
  EXPECT_EQ(value["text"], kText);
  EXPECT_EQ(value["hash"], hash_hex(kText));
  EXPECT_EQ(value["name"], "face.yaml");
  EXPECT_FALSE(value["read_only"]);
}

TEST(live_session, a_text_is_judged_with_places) {
  Opened opened;
  const Json wrong = opened.ask("api/check", {{"text", "mien: 1\nhead: {age: adlut}\n"}});
  EXPECT_FALSE(wrong["good"]);
  ASSERT_EQ(wrong["findings"].size(), 1u);
  EXPECT_EQ(wrong["findings"][0]["line"], 2);
  EXPECT_EQ(wrong["findings"][0]["column"], 13);
  EXPECT_EQ(wrong["findings"][0]["message"], "unknown age 'adlut'; did you mean 'adult'?");
  const Json right = opened.ask("api/check", {{"text", kText}});
  EXPECT_TRUE(right["good"]);
  EXPECT_EQ(right["clip"]["frames"], 24);
  EXPECT_EQ(right["clip"]["keys"][1]["line"], 7);
  EXPECT_EQ(right["clip"]["keys"][1]["at_s"], 0.5);
}

constexpr const char* kAllTracks =
    "mien: 1\n"
    "clip:\n"
    "  length: 2s\n"
    "  blinks: [12f, 250ms]\n"
    "  camera:\n"
    "    - {at: 0s, angle: 10deg}\n"
    "    - {at: 1s, angle: 20deg}\n"
    "  light: [{at: 0.5s, set: candle}]\n"
    "  background:\n"
    "    - at: 1s\n"
    "      show: dark\n"
    "  head: [{at: 1s, age: old}]\n";

TEST(live_session, keys_of_all_tracks_have_a_place_from_which_they_can_be_moved) {
  Opened opened(kAllTracks);
  const Json clip = opened.ask("api/check", {{"text", kAllTracks}})["clip"];
  const auto expect_place = [&](const Json& key, int line, int column, double at_s) {
    EXPECT_EQ(key["line"], line) << key;
    EXPECT_EQ(key["column"], column) << key;
    EXPECT_DOUBLE_EQ(key["at_s"].get<double>(), at_s) << key;
  };
  expect_place(clip["blinks"][0], 4, 17, 0.25);  // by time, wherever they stand
  expect_place(clip["blinks"][1], 4, 12, 0.5);
  expect_place(clip["cameras"][1], 7, 7, 1);
  expect_place(clip["lights"][0], 8, 11, 0.5);
  expect_place(clip["backgrounds"][0], 10, 7, 1);
  expect_place(clip["heads"][0], 12, 10, 1);
  EXPECT_TRUE(clip["is_growing"]);
  for (const auto& [track, index, was, now] :
       std::vector<std::tuple<const char*, int, std::string, std::string>>{
           {"blinks", 0, "250ms", "1500ms"},
           {"blinks", 1, "12f", "36f"},
           {"cameras", 1, "- {at: 1s, angle", "- {at: 1.5s, angle"},
           {"lights", 0, "[{at: 0.5s", "[{at: 1.5s"},
           {"backgrounds", 0, "at: 1s\n", "at: 1.5s\n"},
           {"heads", 0, "[{at: 1s", "[{at: 1.5s"}}) {
    const Json& key = clip[track][index];
    const Json moved = opened.ask("api/edit", {{"text", kAllTracks},
                                               {"do", "move"},
                                               {"line", key["line"]},
                                               {"column", key["column"]},
                                               {"member", "at"},
                                               {"to_s", 1.5},
                                               {"fps", 24}});
    std::string expected = kAllTracks;
    expected.replace(expected.find(was), was.size(), now);
    EXPECT_EQ(moved["text"], expected) << track;
  }
}

TEST(live_session, what_stands_in_no_line_has_no_place) {
  Opened opened;
  write_file(opened.folder / "more.yaml", "mien: 1\nclip:\n  camera: [{at: 0.25s, angle: 30deg}]\n");
  const std::string text =
      "mien: 1\nclip:\n  include: [{file: more.yaml, at: 0s}]\n  keys:\n    - {at: 1s, name: one}\n"
      "  blinks: [{after: one, delay: -0.5s}]\n";
  const Json answer = opened.ask("api/check", {{"text", text}});
  ASSERT_TRUE(answer["good"]) << answer;
  EXPECT_EQ(answer["clip"]["cameras"][0]["at_s"], 0.25);
  EXPECT_EQ(answer["clip"]["cameras"][0]["line"], 0);
  const Json& blink = answer["clip"]["blinks"][0];  // has a line, but no plain time
  EXPECT_EQ(blink["line"], 6);
  const auto move = [&](const Json& key) {
    const LiveAnswer refused = opened.post("api/edit", {{"text", text},
                                                        {"do", "move"},
                                                        {"line", key["line"]},
                                                        {"column", key["column"]},
                                                        {"member", "at"},
                                                        {"to_s", 0.75},
                                                        {"fps", 24}});
    EXPECT_EQ(refused.status, 400);
    return std::string(Json::parse(refused.body)["error"]);
  };
  EXPECT_EQ(move(blink),
            "'clip.blinks[0]' waits for another key; expected a time such as 1.5s, 36f or 500ms");
  EXPECT_EQ(
      move(answer["clip"]["cameras"][0]),
      "it has no place in this text, but comes from another file or from mien itself; expected a key or "
      "cue of this text");
}

TEST(live_session, a_face_posed_by_hand_is_made_as_it_is_posed) {
  Opened opened;
  const auto find_command = [&](const Json& request) {
    opened.ask("api/job", request);
    const std::lock_guard lock(opened.session.jobs.mutex);
    std::string words;
    for (const std::string& word : opened.session.jobs.jobs.back().command) words += word + '|';
    return words;
  };
  const std::string file = (opened.folder / "face.yaml").string();
  EXPECT_EQ(
      find_command({{"kind", "still_sketch"},
                    {"values", {{"brow.left", {{"up", 0.5}}}, {"lips", {{"press", 0.4}}}}},
                    {"strength", 0.5}}),
      "|still|" + file + "|--json|--quality|sketch|--express={brow.left: {up: 0.25}, lips: {press: 0.2}}|");
  EXPECT_EQ(find_command({{"kind", "bust"}, {"values", Json::object()}, {"actor", "ann"}}),
            "|bust|" + file + "|--json|--no-stl|--express={}|--actor=ann|");
  EXPECT_EQ(find_command({{"kind", "stl"}, {"express", "smile"}}),
            "|bust|" + file + "|--json|--express=smile|");
  const LiveAnswer wrong = opened.post("api/job", {{"kind", "stl"}, {"values", {{"lips", {{"sing", 1}}}}}});
  EXPECT_EQ(wrong.status, 400);
  EXPECT_EQ(Json::parse(wrong.body)["error"], "'lips.sing' is no move with a number");
  const LiveAnswer strong =
      opened.post("api/job", {{"kind", "stl"}, {"values", Json::object()}, {"strength", 3}});
  EXPECT_EQ(Json::parse(strong.body)["error"], "'strength' is 3; expected 0 to 1");
}

TEST(live_session, a_pose_is_the_performance_at_the_frame) {
  Opened opened;
  const std::string doc = opened.check();
  const Json rest = opened.ask("api/pose_at", {{"doc", doc}, {"frame", 0}});
  EXPECT_EQ(rest["values"]["corner.left"]["up"], 0);
  const Json smiling = opened.ask("api/pose_at", {{"doc", doc}, {"frame", 12}});
  const Json asked = opened.ask("api/expression", {{"doc", doc}, {"name", "smile"}});
  EXPECT_EQ(smiling["values"]["corner.left"], asked["values"]["corner.left"]);
  EXPECT_GT(smiling["values"]["corner.left"]["up"], 0.3);
}

TEST(live_session, shapes_are_the_kernels_to_half_a_step) {
  Opened opened;
  const std::string doc = opened.check();
  const std::string known = ask_model(opened, doc)["model"];
  const LiveAnswer shapes = opened.post("api/shapes", {{"doc", doc}, {"frame", 12}, {"known", {known}}});
  std::size_t begin = 0;
  const Json drawn = open_header(shapes.body, begin);
  EXPECT_EQ(drawn["model"], known);
  EXPECT_FALSE(drawn.contains("fresh"));

  const DocumentPointer document = find_document(opened.session.shelf, doc);
  const auto heads = find_heads(opened.session.shelf, *document, 0.5);
  const Moment moment = sample_performance(heads->performances[0], 0.5);
  const Drawing expected = draw_moment(*heads->figures[0], moment);
  const ScenePointer scene = opened.session.views.scenes.front();
  std::size_t bytes = begin, compared = 0, skin = 0;
  for (std::size_t k = 0; k < scene->models[0].parts.size(); ++k) {
    const ViewPart& part = scene->models[0].parts[k];
    const PartShape& shape = expected.parts[scene->models[0].of[k]];
    if (part.is_rigid) {
      EXPECT_EQ(std::memcmp(shapes.body.data() + bytes, &shape.world_from_rest, 64), 0) << part.name;
      bytes += 64;
      continue;
    }
    std::vector<glm::vec3> places = shape.positions;
    if (places.empty())  // it may bend, and does not
      for (const glm::vec3& p : part.unbent.positions)
        places.emplace_back(shape.world_from_rest * glm::vec4(p, 1));
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
      std::array<std::int16_t, 4> steps{};
      std::memcpy(steps.data(), shapes.body.data() + bytes + 8 * i, 8);
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(steps[static_cast<std::size_t>(c)] * kViewStep_mm, places[part.vertices[i]][c],
                    kViewStep_mm * 0.51)
            << part.name;
      ++compared;
    }
    if (part.name == "skin") skin = part.vertices.size();
    bytes += 12 * part.vertices.size();
  }
  EXPECT_EQ(bytes, shapes.body.size());
  EXPECT_EQ(skin, expected.parts.front().positions.size());
  EXPECT_GT(compared, skin);
}

TEST(live_session, a_model_that_the_page_has_not_comes_with_its_shapes) {
  Opened opened;
  const std::string doc = opened.check();
  std::size_t at = 0;
  const LiveAnswer both = opened.post("api/shapes", {{"doc", doc}, {"frame", 12}, {"known", {"m99"}}});
  const Json header = open_header(both.body, at);
  EXPECT_EQ(header["model"], "m1");
  EXPECT_EQ(header["fresh"]["model"], "m1");
  std::size_t size = 0;
  for (const Json& part : header["fresh"]["actors"][0]["parts"]) {
    const std::size_t vertices = part["vertices"], triangles = part["triangles"], pieces = part["pieces"];
    size += 4 * vertices + 12 * (triangles + pieces) + (part["is_rigid"] ? 12 * vertices : 0);
    EXPECT_LT(pieces, 1 + triangles / 3) << part["name"];
  }
  std::size_t begin = 0;
  const LiveAnswer shapes = opened.post("api/shapes", {{"doc", doc}, {"frame", 12}, {"known", {"m1", "m0"}}});
  open_header(shapes.body, begin);
  EXPECT_EQ(both.body.substr(at + size), shapes.body.substr(begin));
}

TEST(live_session, a_text_with_the_same_heads_keeps_its_model) {
  Opened opened;
  const auto find_model = [&](const std::string& text) {
    std::size_t at = 0;
    const Json request{{"doc", opened.check(text)}, {"frame", 0}};
    return std::string(open_header(opened.post("api/shapes", request).body, at)["model"]);
  };
  std::string longer = kText;
  longer += "    - {at: 0.8s, express: anger}\n";
  EXPECT_EQ(find_model(kText), find_model(longer));
  EXPECT_NE(find_model(kText), find_model(std::string(kText) + "head: {age: child}\n"));
}

TEST(live_session, the_coarse_has_few_triangles_over_the_same_vertices) {
  Opened opened;
  const std::string doc = opened.check();
  std::size_t at = 0;
  const Json model = ask_model(opened, doc);
  const LiveAnswer answer = opened.post("api/coarse", {{"doc", doc}, {"frame", 0}});
  const Json coarse = open_header(answer.body, at);
  std::size_t fine = 0, few = 0;
  for (std::size_t k = 0; k < model["actors"][0]["parts"].size(); ++k) {
    const Json& part = model["actors"][0]["parts"][k];
    const std::size_t count = coarse["triangles"][0][k];
    EXPECT_LE(count, part["triangles"].get<std::size_t>());
    for (std::size_t i = 0; i < 3 * count; ++i, at += 4) {
      std::uint32_t vertex = 0;
      std::memcpy(&vertex, answer.body.data() + at, 4);
      ASSERT_LT(vertex, part["vertices"].get<std::uint32_t>());
    }
    fine += part["triangles"].get<std::size_t>();
    few += count;
  }
  EXPECT_EQ(at, answer.body.size());
  EXPECT_LT(few, fine / 6);
}

TEST(live_session, marks_lie_on_the_skin) {
  Opened opened;
  const std::string doc = opened.check();
  std::size_t at = 0;
  const Json model = ask_model(opened, doc);
  const std::uint32_t vertices = model["actors"][0]["parts"][0]["vertices"];
  const Json marks = opened.ask("api/marks", {{"doc", doc}, {"frame", 0}});
  EXPECT_GE(marks["guides"].size(), 8u);
  EXPECT_GE(marks["landmarks"].size(), 30u);
  for (const Json& guide : marks["guides"])
    for (const Json& line : guide["lines"]) {
      ASSERT_EQ(line.size(), 6u);
      ASSERT_LT(line[0].get<std::uint32_t>(), vertices);
      ASSERT_GE(line[2].get<double>(), 0);
      ASSERT_LE(line[2].get<double>(), 1);
    }
  const LiveAnswer areas = opened.post("api/areas", {{"doc", doc}, {"frame", 0}});
  const Json header = open_header(areas.body, at);
  EXPECT_EQ(header["areas"].size(), kAreas.size());
  EXPECT_EQ(areas.body.size() - at, 4u * vertices);
  EXPECT_FALSE(header["limits"]["lines"].empty());
}

TEST(live_session, the_ground_has_as_many_pixels_as_asked) {
  Opened opened;
  const LiveAnswer sky =
      opened.post("api/sky", {{"doc", opened.check()}, {"frame", 0}, {"width", 8}, {"height", 10}});
  std::size_t at = 0;
  open_header(sky.body, at);
  EXPECT_EQ(sky.body.size() - at, 240u);
}

TEST(live_session, a_save_replaces_what_the_page_knows) {
  Opened opened;
  const Json saved = opened.ask("api/save", {{"text", "mien: 1\n"}, {"hash", hash_hex(kText)}});
  EXPECT_EQ(saved["hash"], hash_hex("mien: 1\n"));
  EXPECT_EQ(read_file(opened.folder / "face.yaml"), "mien: 1\n");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(opened.folder), {}), 1);
}

TEST(live_session, what_others_saved_is_never_overwritten) {
  Opened opened;
  write_file(opened.folder / "face.yaml", "mien: 1\ntitle: Theirs\n");
  const LiveAnswer answer = opened.post("api/save", {{"text", "mien: 1\n"}, {"hash", hash_hex(kText)}});
  EXPECT_EQ(answer.status, 409);
  EXPECT_EQ(Json::parse(answer.body)["text"], "mien: 1\ntitle: Theirs\n");
  EXPECT_EQ(read_file(opened.folder / "face.yaml"), "mien: 1\ntitle: Theirs\n");
}

TEST(live_session, a_link_stays_a_link_and_rights_stay) {
  Opened opened;
  namespace fs = std::filesystem;
  fs::rename(opened.folder / "face.yaml", opened.folder / "real.yaml");
  fs::permissions(opened.folder / "real.yaml", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.yaml", opened.folder / "face.yaml");
  opened.ask("api/save", {{"text", "mien: 1\n"}, {"hash", hash_hex(kText)}});
  EXPECT_TRUE(fs::is_symlink(opened.folder / "face.yaml"));
  EXPECT_EQ(read_file(opened.folder / "real.yaml"), "mien: 1\n");
  EXPECT_EQ(fs::status(opened.folder / "real.yaml").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST(live_session, read_only_saves_and_makes_nothing) {
  Opened opened;
  opened.session.is_read_only = true;
  EXPECT_EQ(opened.post("api/save", {{"text", ""}, {"hash", hash_hex(kText)}}).status, 403);
  EXPECT_EQ(opened.post("api/job", {{"kind", "sketch"}}).status, 403);
  EXPECT_EQ(opened.post("api/stop_job", {{"id", 1}}).status, 403);
  EXPECT_EQ(read_file(opened.folder / "face.yaml"), kText);
}

TEST(live_session, pages_hear_of_a_save_at_once) {
  Opened opened;
  std::thread saver([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    write_file(opened.folder / "face.yaml", "mien: 1\n");
    look_at_disk(opened.session, false);
  });
  const Json heard = Json::parse(opened.get("api/disk", std::to_string(opened.session.disk.version)).body);
  saver.join();
  EXPECT_EQ(heard["text"], "mien: 1\n");
  EXPECT_TRUE(heard["exists"]);
}

TEST(live_session, who_knows_less_is_answered_at_once) {
  Opened opened;
  EXPECT_EQ(Json::parse(opened.get("api/disk", "0").body)["text"], kText);
  EXPECT_EQ(Json::parse(opened.get("api/jobs", "0").body)["jobs"].size(), 0u);
}

TEST(live_session, edits_change_what_they_say) {
  Opened opened;
  const Json edited =
      opened.ask("api/edit", {{"text", kText}, {"do", "set"}, {"path", {"head", "age"}}, {"value", "child"}});
  EXPECT_TRUE(opened.ask("api/check", {{"text", edited["text"]}})["good"]);
  EXPECT_EQ(opened.ask("api/check", {{"text", edited["text"]}})["clip"]["actors"][0]["head_values"]["age"],
            "child");
}

TEST(live_session, wrong_questions_are_told_what_was_expected) {
  Opened opened;
  const std::string doc = opened.check();
  const auto expect_refusal = [&](const std::string& path, const Json& body, int status,
                                  const std::string& why) {
    const LiveAnswer answer = opened.post(path, body);
    EXPECT_EQ(answer.status, status) << path;
    EXPECT_EQ(Json::parse(answer.body)["error"], why) << path;
  };
  expect_refusal("api/nothing", {{"a", 1}}, 404, "nothing is answered there");
  expect_refusal("api/check", {{"txt", ""}}, 400, "'text' is missing; expected a text");
  expect_refusal("api/check", Json::array(), 400, "the request is no JSON object");
  expect_refusal("api/chart", {{"doc", "x"}}, 400,
                 "the text is not known any more; expected it to be checked again");
  expect_refusal("api/pose_at", {{"doc", doc}, {"frame", -1}}, 400, "'frame' is -1; expected 0 to 100000");
  expect_refusal("api/pose_at", {{"doc", doc}, {"frame", 0}, {"actor", "bob"}}, 400,
                 "there is no actor 'bob'");
  expect_refusal("api/shapes", {{"doc", doc}, {"frame", 0}, {"values", {{"lips", {{"sing", 1}}}}}}, 400,
                 "'lips.sing' is no move with a number");
  expect_refusal("api/sky", {{"doc", doc}, {"frame", 0}, {"width", 9999}, {"height", 9}}, 400,
                 "'width' is 9999; expected 1 to 640");
  expect_refusal("api/job", {{"kind", "cake"}}, 400, "unknown kind 'cake'");
  EXPECT_EQ(opened.get("api/../../etc/passwd").status, 404);
  EXPECT_EQ(opened.get("made/1/../../face.yaml").status, 404);
  EXPECT_EQ(opened.get("face.yaml").status, 404);
}

TEST(live_session, what_a_text_asks_of_a_pose_stays_within_reason) {
  Opened opened;
  const std::string doc = opened.check();
  const Json huge{{"corner.left", {{"up", 1e300}}}};
  EXPECT_EQ(opened.post("api/shapes", {{"doc", doc}, {"frame", 0}, {"values", huge}}).status, 200);
}

TEST(live_session, old_texts_are_forgotten) {
  Opened opened;
  const std::string first = opened.check();
  for (int i = 0; i < 12; ++i) opened.check(std::string(kText) + "# " + std::to_string(i) + "\n");
  EXPECT_EQ(opened.post("api/chart", {{"doc", first}}).status, 400);
}

}  // namespace
}  // namespace mien
