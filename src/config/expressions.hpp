// Named expressions: where they are looked up, and how a file's `expressions:` becomes poses.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/load_areas.hpp"
#include "config/load_formula.hpp"
#include "config/pose_mix.hpp"
#include "config/spec.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

struct MappingData;  // mapping_data.hpp

// All that can be named, and the order in which a plain name is looked up.
struct ExpressionBook {
  std::vector<Expression> expressions;
  std::map<std::string, std::size_t> index;  // "mien/smile", "/sly" for one of the file's own
  Names libraries;                           // known ones
  std::string library = "mien";              // the file's `library:`
  double exaggerate = 1;                     // the file's own, for what says none
  std::shared_ptr<const MappingData> mappings =
      {};  // by which notations of action units are read; none: they are not
};

void append_expressions(ExpressionBook& book, std::vector<Expression> expressions);

// The expression that `name` ("smile", "tezuka/smile") means in the file; in a library file, whose name is
// given, plain names are looked up in that library first.
std::optional<std::size_t> find_expression(const ExpressionBook& book, const std::string& name,
                                           const std::string& of_library = "");

// "unknown expression 'smlie'; did you mean 'smile'?".
std::string describe_unknown_expression(const ExpressionBook& book, const std::string& name,
                                        const std::string& of_library = "");

// An expression that stands in the book already, but whose pose is still to be made.
struct ExpressionDraft {
  std::size_t expression = 0;     // index in the book
  std::optional<YamlValue> from;  // the name it starts from
  std::string doctrine;           // whose: its library is looked through first; empty: as the file has it
  double strength = 1;            // of what it starts from
  double exaggerate = 1;
  AreaValues areas;
  std::optional<double> attack_s;  // empty: that of what it starts from
  AreaNumbers dominance, growth;   // where they are empty, those of what it starts from
  std::size_t numbers = 0;         // of areas, muscles, units and parameters that it says
};

// Reads `expressions:` into the book and its drafts; `library` is empty for a file's own. The document must
// outlive the drafts.
void load_drafts(const YamlValue& value, const std::string& library, ExpressionBook& book,
                 std::vector<ExpressionDraft>& drafts);

// Makes the poses of the drafts, each after the one it starts from; a circle is a mistake.
void build_drafts(const std::vector<ExpressionDraft>& drafts, ExpressionBook& book);

// One name of a mix.
struct ExpressShare {
  double weight = 1;
  std::size_t expression = 0;  // index in the book
  Spot spot;
  FormulaPointer formula = {};  // instead of the weight
};

// The shares of a mix with their poses; weights that are formulas are left at 0.
std::vector<PoseShare> list_shares(const std::vector<ExpressShare>& mix, const ExpressionBook& book);

// What `express:` means: a name or a mix of names.
struct Express {
  std::string label;    // "smile", "surprise 0.6 + smile 0.4"
  std::string name;     // for file names: "smile", "surprise_smile"
  std::string library;  // of the first name
  Pose pose;
  double reach = 1;
  std::vector<Held> held;  // its own, and those of the expressions it names
  std::vector<ExpressShare> shares;
  double attack_s = kDefaultAttack_s;         // of the one with the most weight
  std::shared_ptr<const LivePose> live = {};  // instead of the pose, if numbers of it are formulas
};
// Without `formulas` a weight that is one is a mistake.
Express load_express(const YamlValue& value, const ExpressionBook& book,
                     const FormulaReader* formulas = nullptr);

// `exaggerate: 1.5`.
void load_exaggerate(const YamlMapping& entries, double& into);

// `express`, `strength`, `exaggerate` and `areas` of a key or a bust. Without `express` it is neutral.
// Numbers may be formulas if there are `formulas`.
Express load_posed(const YamlMapping& entries, const ExpressionBook& book,
                   const FormulaReader* formulas = nullptr);

}  // namespace mien
