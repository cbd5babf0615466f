// The table of language.hpp: `head` and what stands in it.
#include <fmt/format.h>

#include "config/conformation.hpp"
#include "config/head_spec.hpp"
#include "config/language_forms.hpp"
#include "config/limits.hpp"
#include "core/seeded.hpp"
#include "import/polygons.hpp"

namespace mien {

namespace {

constexpr double kLowestGuide = 0.05, kHighestGuide = 0.95;  // further out a line would leave the face
constexpr double kLeastRadius_mm = 5, kMostRadius_mm = 150;  // of a sculpting stroke
constexpr double kMostMove_mm = 50;                          // of a sculpting stroke, each way

void fill_look(Section& look) {
  look.name = "look";
  look.help = "Colours, a beard, and spots. A colour stands in quotes: an unquoted `#` begins a comment.";
  look.expected = "colours such as {skin: \"#dcae8f\"}";
  const Look plain;
  const std::string dial = say(0);
  look.keys = {
      {"skin",
       {as_data_word("skin", "looks"), as_colour()},
       "The skin: a name, which brings brows, hair and irises with it (`mien list looks`), or a colour.",
       say_colour(plain.skin)},
      {"lips", {as_colour()}, "The lips; without it they are made from the skin's colour."},
      {"iris", {as_colour()}, "The irises.", say_colour(plain.iris)},
      {"brow",
       {as_data_word("hair", "hair_colours"), as_colour()},
       "Brows and lashes, by a hair's name or as a colour.",
       say_colour(plain.brow)},
      {"hair",
       {as_data_word("hair", "hair_colours"), as_colour()},
       "Hair on the head, if it has any: a name, which brings brows with it (`mien list looks`), or a "
       "colour.",
       say_colour(plain.hair)},
      {"beard",
       {as_word("beard", kBeardWords)},
       "A beard, of the hair's and the brows' colour. It grows with the head: a child has none.",
       plain.beard},
      {"freckles",
       {as_number(0, 1)},
       "Freckles on nose, cheeks and forehead: 0 none, 1 as many as a face has.",
       dial},
      {"age_spots",
       {as_number(0, 1)},
       "The brown spots of old skin on temples, forehead and cheekbones: 0 none, 1 many. Without it an old "
       "head "
       "has some.",
       dial},
      {"texture",
       {as_file({".png"})},
       "A painted skin: a picture on the layout that `mien export FILE --uv uv.png` draws, the same for "
       "every head. Its "
       "colours take the place of the skin's, as finely as the skin has points."}};
  find_first_form(look, "beard").data = "beards";
}

void fill_sculpt(Section& sculpt) {
  sculpt.name = "sculpt";
  sculpt.help =
      "A local edit. The head stays its own mirror image: what is done to one side is done to both.";
  sculpt.expected = "a mapping such as {at: chin, move: [0, -2mm, 3mm], radius: 25mm}";
  sculpt.keys = {
      {"at",
       {as_data_word("place", "places")},
       "A place: a landmark of `mien list landmarks`, or an everyday word such as chin or cheek.",
       "",
       true},
      {"move",
       {as_lengths(kMostMove_mm)},
       "How far the place goes: x outward (0 in the middle), y up, z forward."},
      {"scale",
       {as_number(0.3, 3)},
       "How many times as large the place becomes; it stays where it is itself.",
       say(SculptStroke{}.scale)},
      {"turn",
       {as_angle({-90, 90})},
       "How far it is turned about itself, on the character's left; the other side turns as its mirror "
       "image.",
       say(SculptStroke{}.turn_deg, "deg")},
      {"about",
       {as_word("axis", kAxisWords)},
       "The axis of `turn`, counter-clockwise where it points at you; a place in the middle turns about x.",
       SculptStroke{}.about},
      {"radius",
       {as_length(kLeastRadius_mm, kMostRadius_mm)},
       "How far along the skin the edit reaches.",
       say(SculptStroke{}.radius_mm, "mm")}};
  sculpt.rules = {{KeyRule::Kind::one_of, {"move", "scale", "turn"}},
                  {KeyRule::Kind::needs, {"about", "turn"}}};
}

void fill_guides(Section& guides) {
  guides.name = "guides";
  guides.help =
      "Guide lines moved from where the age has them (`mien list guides`): fractions of the head's height "
      "above "
      "the chin, each above the one before.";
  guides.expected = "guide lines such as {eye_line: 0.49}";
  guides.noun = "guide line";
  for (const auto words : {std::span<const Word>(kGuideWords), std::span<const Word>(kEarGuideWords)})
    for (const Word& word : words)
      guides.keys.push_back({std::string(word.name),
                             {as_number(kLowestGuide, kHighestGuide, "of the head's height")},
                             fmt::format("Height of {}.", word.meaning)});
}

// "0.3eye_nose": a length in a face unit.
std::string build_unit_pattern() {
  std::string units;
  for (const std::string_view unit : kFaceUnits) units += fmt::format("{}{}", units.empty() ? "" : "|", unit);
  return fmt::format("^[0-9]*\\.?[0-9]+ ?({})$", units);
}

void fill_limits(Section& limits) {
  limits.name = "limits";
  limits.help =
      "How far the areas of this head go: times the head's own limit (1 as it is, 0.5 half as far, 0 not at "
      "all), or a "
      "length on this head: 12mm, or 0.3eye_nose in a unit of the face. Names are ours or the thesis's, "
      "whose left and "
      "right are the viewer's. `mien list limits` names and measures them.";
  limits.expected = "limits such as {brow.left.up: 0.8}";
  limits.noun = "limit";
  const Forms forms{as_number(0, kMaxLimit, "times the head's own"), as_length(0, kMaxLimit_mm),
                    as_tag(build_unit_pattern())};
  const auto add = [&](const std::string& name, const char* help) {
    if (!name.empty() && find_key(limits, name) == nullptr) limits.keys.push_back({name, forms, help, "1"});
  };
  for (const LimitName& limit : list_limits())
    add(limit.plural.empty() ? limit.name : limit.plural,
        limit.plural.empty() ? "This limit." : "Both sides; a sided name overrides one.");
  for (const LimitName& limit : list_limits()) add(limit.name, "This limit.");
  for (const LimitName& limit : list_limits())
    add(limit.thesis,
        "The thesis's name of it; where several have it, all of them. Our own names override it.");
  Key& level = *std::ranges::find(limits.keys, kMatchLevel, &Key::name);
  level.forms[1] = as_length(-kMaxMatchLevel_mm, kMaxMatchLevel_mm);
  level.help =
      "Where both lips and the chin stop. A length is the height of that level over where the lips meet at "
      "rest: "
      "the upper lip goes no lower and the lower lip and the chin no higher, and lips that both go past it "
      "meet "
      "there. A plain number is a share of each of their limits.";
}

}  // namespace

void fill_conformation(Section& section) {
  section.name = kConformationKey;
  section.help =
      "Parke's conformation parameters (1982), in features of our heads; what they shape is so where "
      "`features` "
      "says nothing of it.";
  section.noun = "parameter";
  section.expected = "parameters such as {jaw_width: 0.5}";
  for (const ConformationRow& row : kConformationRows)
    section.keys.push_back({std::string(row.name), {as_number(-1, 1)}, begin_great(row.meaning)});
}

void fill_head_sections(Sections& all) {
  fill_look(all.look);
  fill_conformation(all.conformation);
  fill_sculpt(all.sculpt);
  fill_guides(all.guides);
  fill_limits(all.limits);

  Form features = as_map("", {as_number(-1, 1)});
  features.noun = "feature";
  features.data = "features";
  Forms designs = as_mix("", {});
  designs[0].noun = "design";
  designs[0].data = "designs";
  designs.insert(designs.begin(), as_data_word("design", "designs"));
  Section& head = all.head;
  head.name = "head";
  head.help = "Whose face it is.";
  head.expected = "a mapping such as {age: adult}";
  head.keys = {
      {"age", as_mix("age", kAgeWords), "An age, or weights of several.", std::string(kAdult)},
      {"skull", as_mix("skull", kSkullWords), "The shape of the skull, or weights of several.",
       HeadSpec{}.skull.begin()->first},
      {"character",
       {as_word("character", kCharacterWords), as_number(-1, 1)},
       "female (-1), male (1), or anything between.",
       say(HeadSpec{}.character)},
      {"design", designs, "How it is drawn: a design, or weights of several.",
       HeadSpec{}.design.begin()->first},
      {"guides", {as_section(all.guides)}, all.guides.help},
      {"features", {features}, "Features of the face: 0 is the head's own. `mien list features` names them."},
      {std::string(kConformationKey), {as_section(all.conformation)}, all.conformation.help},
      {"look", {as_section(all.look)}, "Colours, a beard, and spots."},
      {"mesh",
       {as_file({".obj"})},
       "Your own half head instead of the shipped one: templates/head/half.obj (or `mien mesh FILE --half`) "
       "with "
       "its points moved, in millimetres; or half a head of any other mesh with landmarks in a YAML file "
       "beside "
       "it. The path is seen from this file."},
      {"scan",
       {as_file(list_geometry_endings())},
       "A digitised head, which the shipped one is wrapped around: a surface, a cloud of points, or slices, "
       "with "
       "its landmarks in a YAML file beside it. "
       "One half is kept and mirrored."},
      {"mix", as_mix("", {}),
       "Heads of other files, mixed: each file's `head` with a weight; only the weights' proportions count."},
      {"sculpt", {as_list({as_section(all.sculpt)})}, "Local edits after all else, in this order."},
      {"hair", {as_word("cut of hair", kHairWords)}, "A cut of hair: `mien list hair`.", HeadSpec{}.hair},
      {"limits", {as_section(all.limits)}, all.limits.help},
      {"random",
       {as_whole(0, kMaxSeed)},
       "A seed: one of a crowd. Skull, character, features, look and hair are drawn as people differ; what "
       "stands "
       "beside it holds instead."},
      {"areas",
       {as_word("choice of areas", kAreasWords)},
       "Which areas may move: a file with a head of nine refuses the tongue and all else that is beyond "
       "them, and its "
       "speech does without.",
       std::string(kAreasWords[0].name)},
      {"rules",
       {as_word("choice of rules", kAreaRuleWords)},
       "By which rules the areas move. `thesis`: a brow turns about its end and its highest and lowest "
       "points "
       "stay in its rectangle, lids end where the lower one rests, the eyeballs keep to the lids' outline at "
       "rest, one level stops both lips and the chin. The default where the file's `library` is one that "
       "says "
       "so, as tezuka is.",
       std::string(kAreaRuleWords[0].name)}};
  find_first_form(head, "mix").pattern = build_file_pattern(kYamlEndings);
  find_first_form(head, "hair").data = "hair";
  head.rules = {{KeyRule::Kind::apart, {"mesh", "scan", "mix"}}, {KeyRule::Kind::apart, {"scan", "mix"}}};
}

}  // namespace mien
