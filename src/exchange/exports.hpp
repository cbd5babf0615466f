// What `mien export` writes: a file's face and what it plays, for other programs. One row a format.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "clip/clip.hpp"
#include "core/templates.hpp"
#include "frames/figure.hpp"

namespace mien {

// What is exported: one actor of a clip, frames `first` to `last` of it, counted from 1.
struct ExportWork {
  const Options& options;
  const Clip& clip;
  const HeadSpec& head;
  const Figure& figure;  // of this head
  const Templates& templates;
  Performance performance;  // with the eyes of this figure
  int first = 1, last = 1;

  int frame_count() const { return last - first + 1; }
  double fps() const { return performance.clip.fps; }
  double compute_time_s(int frame) const { return (frame - 1) / fps(); }  // in the clip
  std::string title() const { return clip.spec.title.empty() ? clip.spec.name : clip.spec.title; }
};

// What a writer has to say: for people, one line each.
using ExportNotes = std::vector<std::string>;

// The endings that there are, in the order in which messages tell them: ".glb", ".obj", ...
std::vector<std::string> list_export_endings();

// Whether files of this ending hold one face each, so that a name needs a place for the frame's number:
// "face_%04d.obj".
bool is_sequence(const std::string& ending);

// "face_%04d.obj" of frame 7: "face_0007.obj". Throws InputError unless there is one such place in its name.
std::filesystem::path name_frame_file(const std::filesystem::path& pattern, int frame);

// Throws InputError for --targets or --exact where files of this ending have nothing of the kind, and for
// both at once.
void check_export_options(const std::string& ending, const Options& options);

// The file that is written beside one of this name: "setup.glb" of "setup.py"; empty if there is none.
std::filesystem::path find_companion(const std::filesystem::path& path);

// Writes the file, or those of a sequence; what must be said of it. Throws RunError, Interrupted.
ExportNotes write_export(const ExportWork& work, const std::filesystem::path& path);

}  // namespace mien
