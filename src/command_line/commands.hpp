// The commands and their options as tables: what the parser accepts and what the help says is the same.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

// `usage` is mien without a command; `text` wants nothing but a text shown: help, or the version.
enum class Command {
  usage,
  text,
  render,
  frames,
  still,
  sheet,
  mesh,
  bust,
  check,
  explain,
  list,
  create,
  schema
};

struct OptionInfo {
  std::string_view name;   // long name without dashes
  char letter;             // of its short form; 0: none
  std::string_view value;  // what follows it; empty: a flag
  std::string_view meaning;
};

inline constexpr std::array kOptions{
    OptionInfo{"at", 0, "TIME", "the moment of the clip: 1.2s, 500ms or 36f"},
    OptionInfo{"express", 0, "NAME", "an expression instead of the clip's: smile, tezuka/anger"},
    OptionInfo{"actor", 0, "NAME", "this one of the file's actors"},
    OptionInfo{"area", 0, "AREA", "this area alone, all its moves: brow.left, lips"},
    OptionInfo{"height", 0, "LENGTH", "height of the bust, over the file's: 80mm, 6cm"},
    OptionInfo{"stl", 0, "", "write the STL, which is the default"},
    OptionInfo{"no-stl", 0, "", "leave the STL out"},
    OptionInfo{"3mf", 0, "", "also a 3MF with units, title and colours"},
    OptionInfo{"preview", 0, "", "also a picture of the bust in plaster"},
    OptionInfo{"openscad", 0, "", "also have OpenSCAD make the source's STL and compare the two"},
    OptionInfo{"angle", 0, "DEG", "camera angle; more than 0 shows more of the character's left side"},
    OptionInfo{"landmarks", 0, "PATH", "also the landmarks, as JSON"},
    OptionInfo{"seed", 0, "N", "of the first head; the others have the numbers after it (default: 1)"},
    OptionInfo{"random-head", 0, "SEED", "a head drawn at random, each of its words spelled out"},
    OptionInfo{"half", 0, "", "the neutral head's left half, to edit and to name in head: {mesh: FILE}"},
    OptionInfo{"output", 'o', "PATH", "where to write: a folder, or the one file a command makes"},
    OptionInfo{"frames", 0, "A-B", "only these frames, counted from 1"},
    OptionInfo{"size", 0, "WxH", "picture size in pixels, over the file's"},
    OptionInfo{"quality", 0, "WORD", "draft, good or best, over the file's"},
    OptionInfo{"jobs", 0, "N", "processes at once (default: as many as cores)"},
    OptionInfo{"quiet", 0, "", "say nothing but errors"},
    OptionInfo{"json", 0, "", "say everything as one JSON object a line"},
    OptionInfo{"help", 'h', "", "this text"},
};

struct CommandInfo {
  Command command;
  std::string_view name;
  std::string_view argument;  // the words it needs: "FILE", "KIND FILE"; empty: none
  std::string_view summary;
  std::string_view details;   // the first paragraph of its own help
  std::string_view options;   // long names with spaces between, beyond the common ones
  std::string_view examples;  // lines; without the indent
};

// Options that every command with a FILE takes, and those that every command takes.
inline constexpr std::string_view kFileOptions = "output frames size quality jobs";
inline constexpr std::string_view kAllOptions = "quiet json help";

inline constexpr std::array kCommands{
    CommandInfo{
        Command::render, "render", "FILE", "scenes, frames and clip into out/NAME/",
        "Computes every drawing of the clip, has POV-Ray render it and ffmpeg join the frames. Frames that\n"
        "are right already are kept: after an interruption the same command goes on where it stopped.",
        "", "mien render configs/hello.yaml\nmien render configs/hello.yaml --quality draft --size 240x300"},
    CommandInfo{Command::frames, "frames", "FILE", "scenes only, for POV-Ray alone",
                "Writes the scenes and an .ini that POV-Ray alone renders to the same frames.", "",
                "mien frames configs/hello.yaml && povray out/hello/scenes/hello.ini"},
    CommandInfo{Command::still, "still", "FILE", "one picture, of a time or of an expression",
                "Renders one picture: the clip at a time, or the head with one expression.",
                "at express actor angle",
                "mien still configs/hello.yaml --at 1.2s -o face.png\n"
                "mien still configs/hello.yaml --express surprise --angle 30 -o face.png"},
    CommandInfo{
        Command::sheet, "sheet", "KIND FILE", "many heads on one page, to compare them",
        "Renders a page of pictures without perspective, each named: views (from all sides, with Loomis'\n"
        "guide lines), details (eye, mouth, nose and ear close by), ages, skulls, features (each at -1, 0\n"
        "and 1), areas (each move with its arrows), limits (of each area, drawn on the face), expressions,\n"
        "libraries (what each means by six feelings), heads (one expression at five ages of four skulls) or\n"
        "people (twelve random heads, each with the seed that makes it; FILE, which may be left out, says\n"
        "what they have in common). FILE may be a library's name after expressions and an expression's after "
        "heads, for a FILE of\n"
        "which --express names another than its poster's. --size is the size of one picture. Two kinds put\n"
        "the clip itself on paper: strip (drawings and the curves of each area, as SVG) and exposure (each\n"
        "frame's drawing and what changed, as CSV).",
        "actor express seed",
        "mien sheet views configs/hello.yaml\nmien sheet ages configs/hello.yaml -o ages.png\n"
        "mien sheet expressions tezuka\nmien sheet heads smile\nmien sheet people --seed 13"},
    CommandInfo{
        Command::mesh, "mesh", "FILE", "one head as OBJ, PLY or STL, its landmarks as JSON",
        "Writes one head in millimetres, right-handed (x to the character's left, y up, z forward), in the\n"
        "format that the name after -o ends in: .obj (one group a part), .ply (with colours and each face's\n"
        "part) or .stl.",
        "at express actor landmarks half",
        "mien mesh configs/hello.yaml --express smile -o face.obj --landmarks face.json\n"
        "mien mesh configs/hello.yaml --half -o my_half.obj"},
    CommandInfo{
        Command::bust, "bust", "FILE", "OpenSCAD source, STL, 3MF and print report",
        "Writes each bust of the file, or one with the expression or of the time that is given (its face: a\n"
        "bust looks ahead, however the head is turned): the STL, ready for the slicer, in millimetres; an\n"
        "OpenSCAD source that needs nothing else, whose Customizer poses the face, hollows and labels it; "
        "and\n"
        "a report of what a printer will make of it. Exit status 1 if one is not printable.",
        "at express actor height stl no-stl 3mf preview openscad",
        "mien bust configs/hello.yaml --express laugh --height 60mm -o busts\n"
        "mien bust configs/busts.yaml --3mf --preview"},
    CommandInfo{
        Command::check, "check", "FILE", "every mistake in the file; writes nothing",
        "Reads and judges the file, warns of what will not read well (holds too short, skin that jumps,\n"
        "faces never drawn in full) and draws the clip as a chart: areas by time, as wide as the\n"
        "terminal, in plain ASCII into a pipe or a file. Writes nothing.",
        "", "mien check configs/hello.yaml"},
    CommandInfo{
        Command::explain, "explain", "FILE", "who moves what, and which limit held it",
        "Tells one moment of the clip, or one expression, in full: the keys it lies between, the value of\n"
        "each area's moves, the limits (and what they held back), and the millimetres that the skin moved\n"
        "at the area's landmark on this head.",
        "at express actor area",
        "mien explain configs/hello.yaml --at 1.2s\n"
        "mien explain configs/hello.yaml --express smile --area corner.left"},
    CommandInfo{
        Command::list, "list", "KIND", "the words of the language",
        "Lists one kind of word: ages, skulls, guides, features, hair, looks, areas, limits, expressions,\n"
        "landmarks or qualities; people tells how far random heads differ and what of them goes together.",
        "", "mien list expressions\nmien list areas --json"},
    CommandInfo{
        Command::create, "new", "NAME", "a commented file to begin with",
        "Writes NAME.yaml with a short performance and a comment on every part of the language. With\n"
        "--random-head its head is one of a crowd, the same as `head: {random: SEED}` gives, with its\n"
        "skull, character, features, look and hair in words to go on from.",
        "random-head", "mien new my_face && mien render my_face.yaml\nmien new otto --random-head 7"},
    CommandInfo{Command::schema, "schema", "", "the JSON Schema of the file, for editors",
                "Prints the JSON Schema of the YAML file. Editors complete and check with it.", "",
                "mien schema > mien.schema.json"},
};

// The table's entry of an option or of a command; nullptr if there is none such.
const OptionInfo* find_option(std::string_view name);
const CommandInfo* find_command(std::string_view name);

// The options a command takes, in the order its help tells them.
std::vector<const OptionInfo*> list_options(const CommandInfo& command);

// "Usage: mien COMMAND ..." in a few lines; all that mien can do; what one command can do.
std::string build_usage();
std::string build_help();
std::string build_command_help(const CommandInfo& command);

}  // namespace mien
