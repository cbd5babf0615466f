// The table of language.hpp: areas, their moves, and expressions.
#include <fmt/format.h>

#include <cctype>

#include "config/areas.hpp"
#include "config/language_forms.hpp"
#include "config/ledger.hpp"
#include "config/parke.hpp"
#include "config/spec.hpp"

namespace mien {

namespace {

constexpr double kMaxAttack_s = 10;                     // nothing that comes more slowly is seen to come
constexpr double kMaxDominance = 10;                    // more leaves nothing to see of the other
constexpr double kLeastGrowth = 0.25, kMostGrowth = 4;  // beyond, half a strength is all or nothing

// The moves of one area; those of one side where it has two.
void fill_moves(const AreaInfo& area, bool is_live, Section& section) {
  section.name = fmt::format("{}{}", is_live ? "live_" : "", area.name);
  section.help = fmt::format(
      "Moves of {}, as fractions of its limit: 1 is the limit, 0 is rest; further, up to {:g}, is held there "
      "and "
      "told by `mien check`.{}",
      area.in_words, kMaxExaggerate, is_live ? " Each may be a formula of t, in quotes." : "");
  section.expected = "moves such as {up: 0.5}";
  section.noun = "move";
  for (const MoveInfo& move : kMoves) {
    if (move.of != area.area || move.side == Side::right) continue;
    Forms forms{as_number(kMaxExaggerate * move.low, kMaxExaggerate * move.high, "times its limit")};
    if (is_live) forms.push_back(as_formula());
    section.keys.push_back({std::string(move.move), forms, begin_great(move.meaning)});
  }
}

std::string describe_side(const AreaKey& key) {
  if (key.is_both) return fmt::format("Both sides; {0}.left and {0}.right override one.", key.area);
  if (key.side == Side::none) return fmt::format("Moves of the {}.", key.area);
  return fmt::format("The character's own {} side.", key.side == Side::left ? "left" : "right");
}

std::vector<Key> build_area_keys(const std::array<Section, kAreas.size()>& moves) {
  std::vector<Key> keys;
  for (const AreaKey& key : kAreaKeys)
    for (std::size_t i = 0; i < kAreas.size(); ++i)
      if (kAreas[i].name == key.area)
        keys.push_back({std::string(key.key), {as_section(moves[i])}, describe_side(key)});
  return keys;
}

// Muscles or units by their names; those of a pair by both or by one.
template <std::size_t Count>
void fill_channels(const std::array<ChannelRow, Count>& rows, const std::string& name,
                   const std::string& what, bool is_live, Section& section) {
  section.name = (is_live ? "live_" : "") + name;
  section.help = what + (is_live ? " Each may be a formula of t, in quotes." : "");
  section.noun = name == kMusclesKey ? "muscle" : "unit";
  section.expected = fmt::format("{}s such as {{{}: 0.5}}", section.noun, rows[0].name);
  const auto add = [&](std::string key, const ChannelRow& row, std::string help) {
    Forms forms{as_number(kMaxExaggerate * row.low, kMaxExaggerate * row.high, "times its limit")};
    if (is_live) forms.push_back(as_formula());
    section.keys.push_back({std::move(key), std::move(forms), std::move(help)});
  };
  for (const ChannelRow& row : rows)
    for (const std::string_view called : {row.name, row.alias}) {
      if (called.empty()) continue;
      const bool is_alias = called == row.alias;
      add(std::string(called), row,
          is_alias ? fmt::format("The same as {}.", row.name) : begin_great(row.meaning));
      if (!row.is_sided) continue;
      for (const char* side : {"left", "right"})
        add(fmt::format("{}.{}", called, side), row, fmt::format("The character's own {} one.", side));
    }
}

void fill_parke(Section& section) {
  section.name = kParkeKey;
  section.help =
      "Parke's expression parameters (1982), in moves of our areas; what they move is set where no area says "
      "otherwise.";
  section.noun = "parameter";
  section.expected = "parameters such as {jaw_rotation: 0.5}";
  for (const ParkeRow& row : kParkeRows)
    section.keys.push_back(
        {std::string(row.name), {as_number(row.low, row.high, "times its limit")}, begin_great(row.meaning)});
}

std::vector<Key> build_doctrine_keys(const Sections& all, bool is_live) {
  return {{std::string(kMusclesKey),
           {as_section(is_live ? all.live_muscles : all.muscles)},
           "Muscles after Waters, beside the areas."},
          {std::string(kCandideKey),
           {as_section(is_live ? all.live_candide : all.candide)},
           "Animation units of CANDIDE-3, beside the areas."},
          {std::string(kParkeKey), {as_section(all.parke)}, "Parke's parameters, in place of areas."}};
}

void fill_areas(const std::array<Section, kAreas.size()>& moves, bool is_live, Section& areas) {
  areas.name = is_live ? "live_areas" : "areas";
  areas.help = is_live ? "Areas of the face, set on top of the expression." : "Areas of the face.";
  areas.expected = "areas such as {brows: {up: 0.5}}";
  areas.noun = "area";
  areas.keys = build_area_keys(moves);
}

void fill_numbers(std::string name, std::string help, double low, double high, Section& section) {
  section.name = std::move(name);
  section.help = std::move(help);
  section.expected = "areas such as {brows: 0.5}";
  section.noun = "area";
  for (const AreaKey& key : kAreaKeys)
    section.keys.push_back({std::string(key.key), {as_number(low, high)}, "For all its moves.", "1"});
}

}  // namespace

void fill_face_sections(Sections& all) {
  for (std::size_t i = 0; i < kAreas.size(); ++i) {
    fill_moves(kAreas[i], false, all.moves[i]);
    fill_moves(kAreas[i], true, all.live_moves[i]);
  }
  fill_areas(all.moves, false, all.areas);
  fill_areas(all.live_moves, true, all.live_areas);
  for (const bool is_live : {false, true}) {
    fill_channels(kMuscleRows, std::string(kMusclesKey),
                  "Muscles after Waters (1987): 1 is contracted as far as a muscle is.", is_live,
                  is_live ? all.live_muscles : all.muscles);
    fill_channels(kUnitRows, std::string(kCandideKey),
                  "Animation units of CANDIDE-3: 1 is its file's full activation.", is_live,
                  is_live ? all.live_candide : all.candide);
  }
  fill_parke(all.parke);
  for (const bool is_live : {false, true})
    for (Key& key : build_doctrine_keys(all, is_live))
      (is_live ? all.live_areas : all.areas).keys.push_back(std::move(key));
  fill_numbers("dominance",
               "How much each area has to say where another expression wants the opposite, in a mix.", 0,
               kMaxDominance, all.dominance);
  fill_numbers("growth",
               "The power of the strength that each area goes with: late if over 1, early if under.",
               kLeastGrowth, kMostGrowth, all.growth);

  Section& expression = all.expression;
  expression.name = "expression";
  expression.help = "An expression of your own: another one as a start, and the areas you change.";
  expression.expected = "areas such as {brows: {up: 0.5}}";
  expression.keys = {
      {"from",
       {as_tag(build_asked_expression_pattern(), "expressions")},
       "The expression to start from.",
       "neutral"},
      {"doctrine",
       {as_word("doctrine", kDoctrineWords)},
       "Whose expression of that name, instead of the file's: `muscles` is `muscles/smile` for `smile`."},
      build_strength_key("How much of what it starts from.", false),
      build_exaggerate_key("How far past their limits its areas may go: every value times this."),
      {"attack",
       {as_seconds(0, kMaxAttack_s)},
       "How long it takes to come, as a cue.",
       say(kDefaultAttack_s, "s")},
      {"dominance", {as_section(all.dominance)}, all.dominance.help},
      {"growth", {as_section(all.growth)}, all.growth.help}};
  for (Key& key : build_area_keys(all.moves)) expression.keys.push_back(std::move(key));
  for (Key& key : build_doctrine_keys(all, false)) expression.keys.push_back(std::move(key));
  expression.rules = {{KeyRule::Kind::needs, {"strength", "from"}},
                      {KeyRule::Kind::needs, {"doctrine", "from"}}};
}

}  // namespace mien
