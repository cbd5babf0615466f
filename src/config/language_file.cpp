// The table of language.hpp: the file as a whole, actors, pictures and prints.
#include <fmt/format.h>

#include <algorithm>

#include "config/language_forms.hpp"
#include "config/law_numbers.hpp"
#include "config/load_spec.hpp"

namespace mien {

namespace {

constexpr double kLowestBust_mm = 20;    // lower, eyelids are thinner than a nozzle's line
constexpr double kHighestBust_mm = 400;  // higher than any common printer
constexpr int kFewestTriangles = 8000, kMostTriangles = 80000;  // the eyes and the mouth alone have 6000

void fill_actors(Sections& all) {
  Section& place = all.place;
  place.name = "place";
  place.help = "Where an actor stands.";
  place.expected = "a mapping such as {at: [-120mm, 0, 0], turn: 25deg}";
  place.keys = {{"at",
                 {as_lengths(kMostPlace_mm)},
                 "x to the left of who looks out of the picture, y up, z toward the camera.",
                 "[0, 0, 0]"},
                {"turn", {as_angle({-360, 360})}, "About the upright axis; + to the character's left.", "0"}};
  Section& step = all.place_key;
  step.name = "place_key";
  step.help = "One key of an actor's place; what it leaves out stays as it was.";
  step.expected = "a key such as {at: 1s, to: [100mm, 0, 0]}";
  step.keys = copy_keys(all.turn_key, {"at", "ease", "between"});
  Key to = place.keys[0], turned = place.keys[1];
  to.name = "to";
  step.keys.insert(step.keys.begin() + 1, {to, turned});
  Section& actor = all.actor;
  actor.name = "actor";
  actor.help = "One of several who play together.";
  actor.expected = "a mapping such as {head: {age: child}}";
  actor.keys = {
      {"head", {as_section(all.head), as_file(kYamlEndings)}, "A head, or a file with one."},
      {"place",
       {as_section(place), as_list({as_section(step)}, 1)},
       "Where the actor stands, or keys of it. The camera frames everybody where they stand first."},
      {"from", as_waiting_time(all.wait), "When the actor comes in: nobody is there before.", "0"},
      {"to", as_waiting_time(all.wait), "When the actor has gone; without it, at the clip's end."},
      {"clip", {as_section(all.clip)}, "What this one does."}};
  actor.keys.back().forms[0].excluded = kSharedClipKeys;
}

constexpr double kThinnestLine = 0.3, kThickestLine = 3;

void fill_ink(Section& ink) {
  const InkColours plain;
  ink.name = "ink";
  ink.help = "Ink's colours. A colour stands in quotes: an unquoted `#` begins a comment.";
  ink.expected = "colours such as {line: \"#20306a\"}";
  const auto add = [&](const char* name, const char* help, const std::string& otherwise) {
    ink.keys.push_back({name, {as_colour()}, help, otherwise});
  };
  add("line", "Outlines and strokes, but for the brows.", say_colour(plain.line));
  add("shade", "What the lamp does not reach has its own colour times this one.", "");
  add("mouth", "Within the mouth.", say_colour(plain.cavity));
  add("tongue", "The tongue.", say_colour(plain.flesh));
  add("teeth", "The upper teeth.", say_colour(plain.bone));
  add("blush", "The cheeks; without it they are made from the skin's colour, as the design says.", "");
}

void fill_render(Section& render, const Section& ink) {
  const RenderSpec plain;
  render.name = "render";
  render.help = "The pictures.";
  render.expected = "a mapping such as {size: 480x600}";
  render.keys = {{"size",
                  {as_size(kMinSide_px, kMaxSide_px)},
                  "Width and height in pixels.",
                  fmt::format("{}x{}", plain.width_px, plain.height_px)},
                 {"quality",
                  {as_word("quality", kQualityWords)},
                  "How long a frame may take.",
                  std::string(kQualityWords[static_cast<std::size_t>(plain.quality)].name)},
                 {"background",
                  {as_word("background", kGroundWords)},
                  "What lies behind; `sun` behind ink.",
                  plain.background},
                 {"style",
                  {as_word("style", kStyleWords)},
                  "How the picture is drawn. Without it drawn heads are in ink, others in the studio."},
                 {"line",
                  {as_number(kThinnestLine, kThickestLine, "times as thick")},
                  "How thick ink's lines are.",
                  say(plain.line)},
                 {"ink", {as_section(ink)}, ink.help}};
}

std::vector<Key> build_print_keys() {
  const BustSpec plain;
  return {
      {"height",
       {as_length(kLowestBust_mm, kHighestBust_mm)},
       "Height of the whole print, base included.",
       say(plain.height_mm, "mm")},
      {"base", {as_word("base", kBaseWords)}, "What the bust stands on.", plain.base},
      {"label", {as_line(kMaxLabelLength)}, "Raised on the base's front."},
      {"hollow",
       {as_yes_no()},
       "With an inner wall, the same in every pose, a hole to drain it, and a vent through the base's back.",
       plain.is_hollow ? "true" : "false"},
      {"wall", {as_length(0.8, 20)}, "Thickness of a hollow bust's wall.", say(plain.wall_mm, "mm")},
      {"drain",
       {as_length(0, 20)},
       "Diameter of the hole in a hollow bust's underside, or in its magnet's pocket; 0: none.",
       say(plain.drain_mm, "mm")},
      {"magnet",
       {as_two_lengths(1, 40)},
       "Diameter and depth of a pocket for a magnet in the underside, such as 6x2mm."},
      {"triangles",
       {as_whole(kFewestTriangles, kMostTriangles, "triangles")},
       "Of the figure; without it by its height, 30000 at 80 mm."}};
}

void fill_busts(Sections& all) {
  Section& bust = all.bust;
  bust.name = "bust";
  bust.help = "A bust to print.";
  bust.expected = "a mapping such as {express: laugh, height: 80mm}";
  bust.keys = {build_express_key(false),
               build_strength_key("How much of the expression.", false),
               build_exaggerate_key("How far past their limits the areas may go; without it as the file's."),
               {"areas", {as_section(all.areas)}, all.live_areas.help}};
  bust.rules = {{KeyRule::Kind::needs, {"strength", "express"}}};

  Section& set = all.bust_set;
  set.name = "bust_set";
  set.help = "All expressions of a library, or those of a list, as busts, each with its name on the base.";
  set.expected = "a mapping such as {all: tezuka, height: 60mm}";
  set.keys = {{"all",
               {as_data_word("library", "libraries"),
                as_list({as_tag(build_asked_expression_pattern(), "expressions")}, 1)},
               "A library, or a list of expressions such as `[smile, tezuka/anger]`.",
               "",
               true},
              {"plate",
               {as_two_lengths(40, 2000)},
               "Size of the printer's plate on which all are arranged, such as 220x220mm."}};
  set.keys.push_back(build_strength_key("How much of each expression.", false));
  set.keys.push_back(
      build_exaggerate_key("How far past their limits the areas may go; without it as the file's."));
  for (const Key& key : build_print_keys()) {
    bust.keys.push_back(key);
    set.keys.push_back(key);
  }
}

void fill_file(Sections& all) {
  Section& file = all.file;
  file.name = "file";
  file.help = "A head and its performance.";
  file.expected = "a mapping that begins with 'mien: 1'";
  file.keys = {
      {"mien", {{FormKind::version}}, "The version of this language.", "", true},
      {"title", {as_line(kMaxTitleLength)}, "One line of text."},
      {"author", {as_line(kMaxTitleLength)}, "Who made it, for files that say so."},
      {"licence",
       {as_line(kMaxTitleLength)},
       "On which terms others may use it, for files that say so: a name or an address."},
      {"head", {as_section(all.head)}, all.head.help},
      {"library",
       {as_data_word("library", "libraries")},
       "Where a plain expression name is looked up after the file's own; then in mien, mouths and extras.",
       Spec{}.library},
      {"doctrine",
       {as_word("doctrine", kDoctrineWords)},
       "Who moves the skin: a plain expression name is that doctrine's, as if it stood under `library`.",
       std::string(kDoctrineWords[0].name)},
      build_exaggerate_key(
          "How far past their limits the areas may go, of every key and bust that says none of "
          "its own: every value times this, with the limits lifted as much. 1.5 reads well, 2 is "
          "caricature."),
      {"expressions",
       {as_map(build_expression_name_pattern(), {as_section(all.expression)})},
       "Expressions of your own, by name."},
      {"clip", {as_section(all.clip)}, all.clip.help},
      {"render", {as_section(all.render)}, all.render.help},
      {"busts",
       {as_list({as_section(all.bust)}), as_section(all.bust_set)},
       "Busts to print: a list, or a set such as `{all: tezuka, height: 60mm, plate: 220x220mm}` or "
       "`{all: [smile, anger]}`."},
      {"actors",
       {as_map(build_actor_name_pattern(), {as_section(all.actor)}, 1)},
       "Several who play together, by name. Frames a second, drawings, length, camera, light, background and "
       "sound "
       "stand "
       "in the `clip` at the top of the file, the rest in each actor's own."}};
  KeyRule together{KeyRule::Kind::apart, {"actors", "head"}};
  for (const Key& key : all.clip.keys)
    if (std::ranges::find(kSharedClipKeys, key.name) == kSharedClipKeys.end() &&
        std::ranges::find(kCommonClipKeys, key.name) == kCommonClipKeys.end())
      together.keys.push_back("clip." + key.name);
  file.rules = {together, {KeyRule::Kind::apart, {"doctrine", "library"}}};

  Section& library = all.library_file;
  library.name = "library_file";
  library.help = "A library of expressions, a file of configs/expressions.";
  library.expected = file.expected;
  library.keys = copy_keys(file, {"mien", "library"});
  library.keys.push_back(
      {"source", {as_line(kMaxTitleLength)}, "Where its expressions come from, in one line."});
  library.keys.push_back(
      {"rules",
       {as_word("choice of rules", kAreaRuleWords)},
       "By which rules heads move whose file has it as its `library`, and do not say themselves.",
       std::string(kAreaRuleWords[0].name)});
  library.keys.push_back(*std::ranges::find(file.keys, "expressions", &Key::name));
  library.keys[1] = {"library", {as_data_word("library", "libraries")}, "The file's own name.", "", true};
  library.keys.back().is_required = true;
  library.keys.back().help = "Its expressions, by name.";
}

}  // namespace

void fill_file_sections(Sections& all) {
  fill_actors(all);
  fill_ink(all.ink);
  fill_render(all.render, all.ink);
  fill_busts(all);
  fill_file(all);
}

}  // namespace mien
