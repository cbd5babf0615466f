// The whole program, one function a command. main.cpp turns arguments into Options and errors into exit
// statuses.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/spec.hpp"

namespace mien {

// What the command line can say. Empty means "as the file says".
struct Options {
  std::filesystem::path file;  // the YAML file (for `new`: the name of the file to make)
  std::optional<std::filesystem::path>
      output;  // -o: a folder for render, frames and bust; a file for still and mesh
  std::optional<std::pair<int, int>> frames;   // --frames A-B: first and last frame, counted from 1
  std::optional<std::pair<int, int>> size_px;  // --size WxH
  std::optional<Quality> quality;              // --quality
  int jobs = 0;                                // --jobs: processes or threads at once; 0: as many as cores
  bool is_quiet = false;                       // --quiet: errors only
  bool is_json = false;                        // --json: one JSON object a line instead of words
  std::optional<double> at_s;                  // --at, for still, mesh, bust and explain
  std::optional<double> at_frames;             // --at in frames of the clip, as in 36f; then at_s is empty
  std::optional<std::string> express;          // --express NAME, for still, mesh and bust
  std::optional<std::string> actor;            // --actor NAME, for still, mesh, bust and explain
  std::optional<std::string> area;             // --area brow.left, for explain
  std::optional<double> camera_angle_deg;      // --angle, for still
  std::optional<std::filesystem::path> landmarks;                   // --landmarks face.json, for mesh
  std::optional<double> height_mm;                                  // --height, for bust
  bool has_stl = true;                                              // --no-stl, for bust
  bool has_3mf = false, has_preview = false, has_openscad = false;  // for bust
  bool is_half = false;                                             // --half, for mesh
  std::optional<int> seed;         // --seed, of the first head, for sheet people
  std::optional<int> random_head;  // --random-head SEED, for new
};

// Each throws InputError (exit 2) before anything is written, RunError (exit 1) or Interrupted (exit 130).
// What a user should read (paths, lists, findings) goes to standard output; progress goes to standard error.
void render_clip(const Options& options);   // scenes, frames and clip into out/<name>/
void write_frames(const Options& options);  // scenes only
void render_still(const Options& options);  // one picture
void render_sheet(const std::string& kind, const Options& options);  // many heads on one page
void write_mesh(const Options& options);    // one head as OBJ, PLY or STL; landmarks as JSON
void write_busts(const Options& options);   // OpenSCAD sources, STL, 3MF and print reports
void check_file(const Options& options);    // every mistake, or one line that says what the file holds
void explain_pose(const Options& options);  // who moves what, and which limit held it
void list_kind(const std::string& kind,
               const Options& options);      // ages, skulls, features, areas, expressions, ...
std::vector<std::string> list_word_kinds();  // the kinds that list_kind knows
void write_starter(const Options& options);  // a commented file to begin with; refuses to overwrite
void print_schema();                         // the JSON Schema of the YAML file

}  // namespace mien
