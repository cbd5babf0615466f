// Where a command's files go, judged before anything is written: no file that is read may be lost, nor one
// that is written twice, and a name says what is in it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "clip/clip.hpp"

namespace mien {

// A file that a command makes.
struct OutputFile {
  std::string option;  // that names it: "-o", "--landmarks"; empty: the command named it itself
  std::filesystem::path path;
};

// For a command that makes clips: of all that -o names those that end as clips do are `videos`, and the last
// of the others is the folder. Throws InputError for a name that ends as other files do.
Options take_videos(const Options& asked);

// What -o names, else `otherwise`.
OutputFile find_output_file(const Options& options, const std::filesystem::path& otherwise);

// Whether a name ends as files of pictures, videos, meshes and the like do; "v1.2" does not.
bool has_file_ending(const std::filesystem::path& path);

// Throws InputError "-o face.jpg: unknown kind of picture '.jpg'; expected a name that ends in .png" unless
// the name ends in one of `endings`.
void check_ending(const OutputFile& file, std::string_view kind, const std::vector<std::string>& endings);

// Throws InputError if a file is one that the spec was read from or one of mien's own data, by whatever name,
// if two of them are one, if a folder has the name, or if it lies in what is no folder.
void check_output_files(const std::vector<OutputFile>& files, const Spec& spec);

// The same of a folder, which must be none yet or a folder, with a name that no file has ("clip.gif"), and of
// the files that are to lie in it, relative to it.
void check_output_folder(const Options& options, const std::filesystem::path& folder,
                         const std::vector<std::filesystem::path>& files, const Spec& spec);

// The same of a clip's folder with its scenes, and of its pictures and video too where they are to be made.
void check_clip_folder(const Options& options, const Clip& clip, bool has_pictures);

// The same of what a sketched clip leaves.
inline constexpr const char* kSketchManifest = "manifest_sketch.json";
void check_sketch_folder(const Options& options, const Clip& clip);

}  // namespace mien
