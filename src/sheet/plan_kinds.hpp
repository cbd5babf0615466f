// One function a kind of sheet; plans.cpp has the table of them.
#pragma once

#include "sheet/plans.hpp"

namespace mien {

// head_plans.cpp: heads compared.
SheetPlan plan_views(const SheetSubject& subject, const HeadData& data);
SheetPlan plan_details(const SheetSubject& subject, const HeadData& data);
SheetPlan plan_ages(const SheetSubject& subject, const HeadData& data);
SheetPlan plan_skulls(const SheetSubject& subject, const HeadData& data);
SheetPlan plan_features(const SheetSubject& subject, const HeadData& data);

// design_plan.cpp: expressions in rows, designs in columns.
SheetPlan plan_designs(const SheetSubject& subject, const HeadData& data);

// people_plan.cpp: heads as a crowd has them, each with the seed that makes it.
SheetPlan plan_people(const SheetSubject& subject, const HeadData& data);

// expression_plans.cpp: faces compared. One expression on every age of four skulls; all of a library, with
// the areas that each uses; what each library means by a feeling.
SheetPlan plan_heads(const SheetSubject& subject, const HeadData& data);
SheetPlan plan_expressions(const SheetSubject& subject, const HeadData& data);
SheetPlan plan_libraries(const SheetSubject& subject, const HeadData& data);

// doctrine_plan.cpp: feelings in rows, doctrines in columns, and what each moves.
SheetPlan plan_doctrines(const SheetSubject& subject, const HeadData& data);

// mouth_plan.cpp: each mouth of speech, from the front and the side.
SheetPlan plan_mouths(const SheetSubject& subject, const HeadData& data);

// area_plans.cpp: each move of each area with arrows; the limits of the areas.
SheetPlan plan_areas(const SheetSubject& subject, const HeadData& data);
SheetPlan plan_limits(const SheetSubject& subject, const HeadData& data);
// All that the sheet of limits draws where areas end, but for levels and words.
std::vector<SheetMark> list_limit_marks();

}  // namespace mien
