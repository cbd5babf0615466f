#include "sheet/subject.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "config/load_spec.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

std::string write_sly() {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "mien_sly.yaml";
  write_file(file,
             "mien: 1\ntitle: Sly\nexpressions: {sly: {brow.left: {up: 0.7}}}\n"
             "clip: {length: 2s, keys: [{at: 0s, express: neutral}, {at: 1s, express: mien/laugh}]}\n");
  return file.string();
}

SheetSubject load(const std::string& kind, const std::string& word, const std::string& express = "") {
  Options options;
  options.kind = kind;
  options.file = word;
  if (!express.empty()) options.express = express;
  return load_sheet_subject(options, shipped_stock());
}

std::string find_mistake(const std::string& kind, const std::string& word, const std::string& express = "") {
  try {
    load(kind, word, express);
  } catch (const InputError& e) {
    return e.what();
  }
  return "none";
}

const Pose& find_pose(const SheetSubject& subject, const std::string& name) {
  return find_expression(subject.spec, name).pose;
}

TEST(sheet_subject, is_a_library_by_its_name) {
  const SheetSubject subject = load("expressions", "tezuka");
  EXPECT_EQ(subject.spec.library, "tezuka");
  EXPECT_EQ(subject.spec.name, "tezuka");
  EXPECT_EQ(subject.spec.title, "The faces of tezuka");
  EXPECT_EQ(subject.spec.head.hair, "crop") << "a bald head looks startled";
  EXPECT_EQ(subject.spec.head.age, (Mix{{"adult", 1.0}}));
}

TEST(sheet_subject, is_an_expression_by_its_name) {
  const SheetSubject subject = load("heads", "tezuka/anger");
  EXPECT_EQ(subject.expression.library, "tezuka");
  EXPECT_EQ(subject.expression.pose, find_pose(subject, "tezuka/anger"));
  EXPECT_EQ(subject.spec.name, "tezuka_anger");
  EXPECT_EQ(load("heads", "smile").expression.library, "mien");
}

TEST(sheet_subject, is_a_file_with_its_posters_face_or_the_one_asked_for) {
  const std::string file = write_sly();
  EXPECT_EQ(load("expressions", file).spec.title, "Sly");
  const SheetSubject subject = load("heads", file);
  EXPECT_EQ(subject.expression.pose, find_pose(subject, "laugh"));
  EXPECT_EQ(load("heads", file, "sly").expression.pose, find_pose(subject, "sly"));
}

TEST(sheet_subject, names_what_was_meant) {
  EXPECT_EQ(find_mistake("expressions", "tezka"),
            "'tezka' is no FILE and no library; did you mean 'tezuka'?");
  EXPECT_EQ(
      find_mistake("expressions", "zzz"),
      "'zzz' is no FILE and no library; known libraries: candide, compound, emfacs, extras, mien, mouths, "
      "muscles, parke, tezuka");
  EXPECT_EQ(find_mistake("heads", "smlie"),
            "'smlie' is no FILE; unknown expression 'smlie'; did you mean 'smile'?");
  EXPECT_EQ(find_mistake("heads", write_sly(), "slyy"), "unknown expression 'slyy'; did you mean 'sly'?");
  EXPECT_NE(find_mistake("heads", "away.yaml").find("away.yaml"), std::string::npos);
  EXPECT_NE(find_mistake("expressions", "away.yaml").find("away.yaml"), std::string::npos);
}

TEST(sheet_subject, of_people_needs_no_word) {
  Options options;
  options.kind = "people";
  options.seed = 13;
  const SheetSubject subject = load_sheet_subject(options, shipped_stock());
  EXPECT_EQ(subject.seed, 13);
  EXPECT_EQ(subject.spec.name, "people");
  EXPECT_EQ(subject.spec.head.age, (Mix{{"adult", 1.0}}));
  EXPECT_EQ(load("people", write_sly()).spec.title, "Sly");
  EXPECT_EQ(load("people", write_sly()).seed, 1);
}

TEST(sheet_subject, takes_one_expression) {
  EXPECT_EQ(find_mistake("heads", "smile", "anger"),
            "--express says another expression than 'smile'; expected one of the two, or a FILE");
}

TEST(sheet_subject, knows_where_each_library_is_from) {
  const auto sources = load("expressions", "mien").sources;
  EXPECT_EQ(sources.size(), 9u);
  for (const auto& [library, source] : sources) EXPECT_FALSE(source.empty()) << library;
  EXPECT_NE(sources.at("tezuka").find("Tamkang"), std::string::npos);
}

}  // namespace
}  // namespace mien
