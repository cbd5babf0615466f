// The table of kinds: another kind is another row.
#include "sheet/plans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/text.hpp"
#include "sheet/plan_kinds.hpp"

namespace mien {

namespace {

struct SheetKind {
  const char* name;
  const char* subject;
  SheetPlan (*plan)(const SheetSubject& subject, const HeadData& data);
};
constexpr std::array kKinds{SheetKind{"views", "Views", plan_views},
                            SheetKind{"details", "Details", plan_details},
                            SheetKind{"ages", "Ages", plan_ages},
                            SheetKind{"skulls", "Skulls", plan_skulls},
                            SheetKind{"features", "Features", plan_features},
                            SheetKind{"expressions", "Expressions", plan_expressions},
                            SheetKind{"libraries", "Libraries", plan_libraries},
                            SheetKind{"designs", "Designs", plan_designs},
                            SheetKind{"doctrines", "Four doctrines", plan_doctrines},
                            SheetKind{"heads", "On twenty-four heads", plan_heads},
                            SheetKind{"people", "Twelve people", plan_people},
                            SheetKind{"mouths", "Mouths of speech", plan_mouths},
                            SheetKind{"areas", "Areas: the ways of the skin", plan_areas},
                            SheetKind{"limits", "Limits in red, rest in blue", plan_limits}};

const SheetKind* find_kind(const std::string& name) {
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(), [&](const auto& k) { return k.name == name; });
  return kind == kKinds.end() ? nullptr : &*kind;
}

// "views, details or ages".
std::string join_kinds(const std::vector<std::string>& names) {
  std::string words;
  for (std::size_t i = 0; i < names.size(); ++i)
    words += fmt::format("{}{}", i == 0 ? "" : i + 1 == names.size() ? " or " : ", ", names[i]);
  return words;
}

}  // namespace

std::string build_caption(std::string word) {
  std::replace(word.begin(), word.end(), '_', ' ');
  return word;
}

std::vector<std::string> list_sheet_kinds() {
  std::vector<std::string> names;
  for (const SheetKind& kind : kKinds) names.emplace_back(kind.name);
  names.insert(names.end(), {std::string(kWireSheet), std::string(kCompareSheet), std::string(kProofsSheet)});
  names.insert(names.end(), kClipSheets.begin(), kClipSheets.end());
  return names;
}

bool is_of_face(const std::string& kind) { return kind == "views" || kind == kWireSheet; }

void check_sheet_kind(const std::string& kind) {
  const std::vector<std::string> names = list_sheet_kinds();
  if (std::ranges::find(names, kind) != names.end()) return;
  const std::string near = find_nearest(kind, names);
  throw InputError(near.empty() ? fmt::format("unknown kind '{}'; expected {}", kind, join_kinds(names))
                                : fmt::format("unknown kind '{}'; did you mean '{}'?", kind, near));
}

SheetPlan build_sheet_plan(const std::string& kind, const SheetSubject& subject, const HeadData& data) {
  check_sheet_kind(kind);
  const SheetKind* known = find_kind(kind);
  if (!known) throw RunError(fmt::format("internal: the sheet '{}' has no plan", kind));
  SheetPlan plan = known->plan(subject, data);
  plan.subject = known->subject;
  return plan;
}

}  // namespace mien
