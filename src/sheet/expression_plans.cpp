// Sheets that compare faces, one function each: which expressions, on which heads.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "config/head_words.hpp"
#include "config/words.hpp"
#include "core/error.hpp"
#include "sheet/area_table.hpp"
#include "sheet/plan_kinds.hpp"

namespace mien {

namespace {

constexpr std::size_t kLeastInARow = 4, kMostInARow = 6;

// The face from hairline to chin: what moves, as large as it can be.
SheetCell build_face_cell(const std::string& caption, std::size_t head, const Pose& pose) {
  SheetCell cell{caption, head, pose};
  cell.framing.around = {"tr", "gn"};
  cell.framing.spread = 1.45;
  cell.framing.has_crown = true;
  cell.framing.scale_of = head;
  return cell;
}

// Those of a library, neutral first; of "" the file's own.
std::vector<Expression> list_of_library(const Spec& spec, const std::string& library) {
  std::vector<Expression> found;
  for (const Expression& expression : spec.expressions)
    if (expression.library == library) found.push_back(expression);
  std::stable_partition(found.begin(), found.end(), [](const Expression& e) { return e.pose == Pose{}; });
  return found;
}

// So many in a row that the last one is the fullest.
std::size_t find_columns(std::size_t count) {
  std::size_t best = std::min(count, kMostInARow), least = kMostInARow;
  for (std::size_t columns = kMostInARow; columns >= kLeastInARow && count > kMostInARow; --columns) {
    const std::size_t empty = (columns - count % columns) % columns;
    if (empty < least) best = columns, least = empty;
  }
  return best;
}

SheetBlock build_face_block(const std::string& heading, const std::string& note,
                            const std::vector<Expression>& expressions, std::size_t columns) {
  SheetBlock block{heading, note, {}, columns, 0, {}};
  for (const Expression& expression : expressions)
    block.cells.push_back(build_face_cell(build_caption(expression.name), 0, expression.pose));
  return block;
}

// One feeling in the words of each library; those that have none leave it out.
struct Feeling {
  const char* tezuka;
  const char* emfacs;
  const char* mien;
};
constexpr std::array kFeelings{Feeling{"smile", "joy", "smile"},
                               Feeling{"sadness", "sadness", "sadness"},
                               Feeling{"surprise", "surprise", "surprise"},
                               Feeling{"fear", "fear", "fear"},
                               Feeling{"anger", "anger", "anger"},
                               Feeling{"doubt_left", "contempt_left", "contempt"}};
struct LibraryRow {
  const char* library;
  const char* heading;
  const char* Feeling::*name;
};
constexpr std::array kLibraryRows{LibraryRow{"tezuka", "tezuka: the comic artist's", &Feeling::tezuka},
                                  LibraryRow{"emfacs", "emfacs: the anatomists'", &Feeling::emfacs},
                                  LibraryRow{"mien", "mien: the house's own", &Feeling::mien}};

const Pose& find_pose(const Spec& spec, const std::string& library, const std::string& name) {
  for (const Expression& expression : spec.expressions)
    if (expression.library == library && expression.name == name) return expression.pose;
  throw RunError(
      fmt::format("the library '{}' has no '{}', which a sheet of libraries shows", library, name));
}

}  // namespace

SheetPlan plan_heads(const SheetSubject& subject, const HeadData& data) {
  SheetPlan plan;
  plan.cell_px = {400, 480};
  const Expression& expression = subject.expression;
  for (const std::string& skull : kSkulls) {
    if (skull == kSkulls.front()) continue;  // the average of the others
    SheetBlock& block = plan.blocks.emplace_back();
    block.heading = build_caption(skull);
    for (const std::string& age : kAges) {
      SheetCell cell{build_caption(age), plan.heads.size(), expression.pose};
      cell.framing.scale_of = cell.head;
      block.cells.push_back(cell);
      plan.heads.push_back(subject.spec.head);
      plan.heads.back().age = {{age, 1.0}};
      plan.heads.back().skull = {{skull, 1.0}};
      plan.heads.back().guides.clear();  // each age has its own
      set_greying(data.words.greying, plan.heads.back().look);
    }
  }
  const std::string library = expression.library.empty() ? "" : expression.library + "/";
  plan.blocks.front().note =
      "each head's areas go the same shares of their own limits: " + library + expression.name;
  return plan;
}

SheetPlan plan_expressions(const SheetSubject& subject, const HeadData&) {
  SheetPlan plan;
  plan.cell_px = {400, 400};
  plan.heads = {subject.spec.head};
  std::vector<Expression> shown = list_of_library(subject.spec, subject.spec.library);
  const std::size_t columns = find_columns(shown.size());
  const std::vector<Expression> own = list_of_library(subject.spec, "");
  if (!own.empty()) plan.blocks.push_back(build_face_block("Of this file", "", own, columns));
  plan.blocks.push_back(build_face_block("Library " + subject.spec.library,
                                         subject.sources.at(subject.spec.library), shown, columns));
  shown.insert(shown.begin(), own.begin(), own.end());
  SheetBlock& block = plan.blocks.emplace_back();
  block.heading = "The areas that each uses";
  block.note = "arrows as you see the face; left and right are the character's own; 1 is the area's limit";
  block.table = build_area_table(shown);
  return plan;
}

SheetPlan plan_libraries(const SheetSubject& subject, const HeadData&) {
  SheetPlan plan;
  plan.cell_px = {400, 400};
  plan.heads = {subject.spec.head};
  for (const LibraryRow& row : kLibraryRows) {
    SheetBlock& block = plan.blocks.emplace_back();
    block.heading = row.heading;
    block.note = subject.sources.at(row.library);
    for (const Feeling& feeling : kFeelings) {
      const std::string name = feeling.*row.name;
      block.cells.push_back(
          build_face_cell(build_caption(name), 0, find_pose(subject.spec, row.library, name)));
    }
  }
  return plan;
}

}  // namespace mien
