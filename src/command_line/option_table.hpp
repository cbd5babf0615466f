// The options as a table: what the parser accepts and what the help says is the same.
#pragma once

#include <array>
#include <string_view>

namespace mien {

struct OptionInfo {
  std::string_view name;   // long name without dashes
  char letter;             // of its short form; 0: none
  std::string_view value;  // what follows it; empty: a flag; "[=N]": a flag that may be given a value
  std::string_view meaning;

  bool takes_word() const { return !value.empty() && value.front() != '['; }
};

inline constexpr std::array kOptions{
    OptionInfo{"at", 0, "TIME", "the moment of the clip: 1.2s, 500ms or 36f"},
    OptionInfo{"express", 0, "NAME",
               "an expression instead of the clip's: smile, tezuka/anger, or its areas in braces"},
    OptionInfo{"actor", 0, "NAME", "this one of the file's actors"},
    OptionInfo{"area", 0, "AREA", "this area alone, all its moves: brow.left, lips"},
    OptionInfo{"height", 0, "LENGTH", "height of the bust, over the file's: 80mm, 6cm"},
    OptionInfo{"stl", 0, "", "write the STL, which is the default"},
    OptionInfo{"no-stl", 0, "", "leave the STL out"},
    OptionInfo{"3mf", 0, "", "also a 3MF with units, title and colours"},
    OptionInfo{"preview", 0, "", "also a picture of the bust in plaster"},
    OptionInfo{"openscad", 0, "", "also have OpenSCAD make the source's STL and compare the two"},
    OptionInfo{"angle", 0, "DEG", "camera angle; more than 0 shows more of the character's left side"},
    OptionInfo{"wire", 0, "", "a line drawing with hidden lines hidden, as SVG and PNG"},
    OptionInfo{"cage", 0, "", "of a line drawing: the control cage instead of the skin"},
    OptionInfo{"guides", 0, "", "of a line drawing: also Loomis' guide lines"},
    OptionInfo{"limits", 0, "", "of a line drawing: also how far each area may go"},
    OptionInfo{"beside", 0, "DESIGNS", "these designs of the head, side by side: real,comic"},
    OptionInfo{"keep-scenes", 0, "", "leave POV-Ray's scenes in out/NAME/scenes/, as 'mien frames' does"},
    OptionInfo{"store", 0, "SIZE",
               "how much room drawings may take that the clip does not show: 2GB (the default), 500MB, 0"},
    OptionInfo{
        "loop", 0, "[=N]",
        "the clip N times over in one film (2 without N); .gif, .webp and .apng play N times, else for ever"},
    OptionInfo{"boomerang", 0, "", "the clip forth and back"},
    OptionInfo{"slate", 0, "", "frame, time and key written on each frame of the clip"},
    OptionInfo{"nice", 0, "[=N]", "let other work go first: a niceness of 10, or N from 1 to 19"},
    OptionInfo{"engine", 0, "WORD", "who renders: local (the default), or slurm: a cluster's job array"},
    OptionInfo{"partition", 0, "NAME", "of the cluster, for --engine slurm (default: the cluster's own)"},
    OptionInfo{"chunk", 0, "AMOUNT",
               "what a task of the array is to do: 5m, about so long (the default), or 20, so many drawings"},
    OptionInfo{"time", 0, "TIME",
               "the most that a task may take: 30m, 2h or 1-12:00:00 (default: the cluster's)"},
    OptionInfo{"no-wait", 0, "", "submit to --engine slurm and return"},
    OptionInfo{"dry-run", 0, "", "print what --engine slurm would submit, and do nothing"},
    OptionInfo{"part", 0, "I/N",
               "what a task of --engine slurm runs: its part of the plan; gather: what ends it"},
    OptionInfo{"landmarks", 0, "PATH", "also the landmarks, as JSON"},
    OptionInfo{"every", 0, "N",
               "of a clip's drawings the first, and then one in N (default: as many as fit)"},
    OptionInfo{"seed", 0, "N", "of the first head; the others have the numbers after it (default: 1)"},
    OptionInfo{"random-head", 0, "SEED", "a head drawn at random, each of its words spelled out"},
    OptionInfo{"half", 0, "", "the neutral head's left half, to edit and to name in head: {mesh: FILE}"},
    OptionInfo{"targets", 0, "SET", "what a rig is posed by: moves (the default), expressions, arkit or vrm"},
    OptionInfo{"faults", 0, "PATH", "the mesh as PLY, its faults red"},
    OptionInfo{"uv", 0, "PATH",
               "the layout of the skin's picture, for painters, as PNG; without -o that alone"},
    OptionInfo{"exact", 0, "", "a target a frame instead of one a move: no error, and nothing to pose"},
    OptionInfo{"keys", 0, "LENGTH",
               "how far the skin may be from a take: 0.5mm (the default); more is fewer keys"},
    OptionInfo{"strict", 0, "PERCENT", "an error if more of a take's motion is lost: 10"},
    OptionInfo{"smooth", 0, "HZ",
               "how quick a change of a take may be noise: 1.5 (the default), lower is calmer, 0 leaves it"},
    OptionInfo{"fps", 0, "RATE", "frames a second of a file that does not say them: 59.94"},
    OptionInfo{"port", 0, "N", "the port of the page's address (default: any that is free)"},
    OptionInfo{"open", 0, "", "also open the page in the browser"},
    OptionInfo{"read-only", 0, "", "only show: neither save the file nor make anything"},
    OptionInfo{"output", 'o', "PATH", "where to write: a folder, or the file a command makes"},
    OptionInfo{"frames", 0, "A-B", "only these frames, counted from 1"},
    OptionInfo{"size", 0, "WxH", "picture size in pixels, over the file's"},
    OptionInfo{"quality", 0, "WORD", "sketch, draft, good or best, over the file's"},
    OptionInfo{"jobs", 0, "N", "processes at once (default: as many as cores)"},
    OptionInfo{"quiet", 0, "", "say nothing but errors"},
    OptionInfo{"json", 0, "", "say everything as one JSON object a line"},
    OptionInfo{"help", 'h', "", "this text"},
};

// Options that every command with a FILE takes, and those that every command takes.
inline constexpr std::string_view kFileOptions = "output frames size quality jobs";
inline constexpr std::string_view kAllOptions = "quiet json help";

}  // namespace mien
