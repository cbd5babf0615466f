#include "clip/outputs.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "clip/pictures.hpp"
#include "clip/trace.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "render/video_kind.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

// Of pictures, videos, meshes and what else files are told by: a folder of such a name is a slip.
constexpr auto kFileEndings = std::to_array<std::string_view>(
    {".png",  ".apng", ".jpg", ".jpeg", ".gif",  ".webp", ".bmp",  ".tif", ".tiff", ".tga",
     ".exr",  ".svg",  ".pdf", ".mp4",  ".m4v",  ".mov",  ".webm", ".mkv", ".avi",  ".mpg",
     ".mpeg", ".ogv",  ".obj", ".ply",  ".stl",  ".3mf",  ".scad", ".amf", ".off",  ".gltf",
     ".glb",  ".vrm",  ".usd", ".usda", ".usdc", ".usdz", ".fbx",  ".dae", ".pov",  ".inc",
     ".ini",  ".yaml", ".yml", ".json", ".csv",  ".txt",  ".wav",  ".mp3", ".ogg",  ".zip"});

// One file, whatever it is called.
using Identity = std::pair<dev_t, ino_t>;

std::optional<Identity> find_identity(const fs::path& path) {
  struct stat facts {};
  if (::stat(path.c_str(), &facts) != 0) return std::nullopt;
  return Identity{facts.st_dev, facts.st_ino};
}

// "-o face.png", or "out/a/still.png" where the command named it.
std::string name_file(const OutputFile& file) {
  return file.option.empty() ? file.path.string() : fmt::format("{} {}", file.option, file.path.string());
}

[[noreturn]] void fail_output(const OutputFile& file, const std::string& what) {
  throw InputError(fmt::format("{}: {}", name_file(file), what));
}

// ".obj, .ply or .stl".
std::string join_endings(const std::vector<std::string>& endings) {
  std::string text = endings.front();
  for (std::size_t i = 1; i < endings.size(); ++i)
    text += (i + 1 < endings.size() ? ", " : " or ") + endings[i];
  return text;
}

bool is_below(const fs::path& path, const fs::path& folder) {
  const fs::path from = path.lexically_relative(folder);
  return !from.empty() && *from.begin() != "..";
}

// mien's own data: what an author reaches by a slip, since nothing there is written by a command but
// half.obj, which is not read.
bool is_own_data(const fs::path& path) {
  std::error_code error;
  const fs::path data = fs::weakly_canonical(find_data_folder(), error),
                 file = fs::weakly_canonical(path, error);
  if (error || !fs::exists(file, error)) return false;
  return (is_below(file, data / "templates") || is_below(file, data / "configs/expressions")) &&
         file.filename() != "half.obj";
}

// The nearest place above `path` that exists must be a folder.
void check_place(const OutputFile& file, const fs::path& path) {
  std::error_code ignored;
  for (fs::path above = path.parent_path(); !above.empty(); above = above.parent_path()) {
    const fs::file_status status = fs::status(above, ignored);
    if (fs::is_directory(status)) return;
    if (fs::exists(status)) fail_output(file, fmt::format("'{}' is no folder", above.string()));
    if (above == above.parent_path()) return;
  }
}

using ReadFiles = std::map<Identity, fs::path>;

ReadFiles list_read_files(const Spec& spec) {
  ReadFiles inputs;
  for (const fs::path& file : spec.files)
    if (const auto identity = find_identity(file)) inputs.emplace(*identity, file);
  return inputs;
}

// What stands in the file's place already must be a file, and none that is read.
void check_old_file(const OutputFile& file, const std::optional<Identity>& identity,
                    const ReadFiles& inputs) {
  if (!identity) return;
  std::error_code ignored;
  if (fs::is_directory(file.path, ignored)) fail_output(file, "it is a folder; expected the name of a file");
  if (const auto input = inputs.find(*identity); input != inputs.end())
    fail_output(file, fmt::format("it is {}, which is read; expected another name",
                                  input->second == file.path ? "the file" : input->second.string()));
  if (is_own_data(file.path)) fail_output(file, "it belongs to mien's own data; expected another name");
}

// The clip's own, in its folder.
void add_videos(const Clip& clip, std::vector<fs::path>& files) {
  if (clip.videos.empty()) files.push_back(list_video_paths(clip).front().filename());
}

// Those that -o names, anywhere.
void check_videos(const Clip& clip) {
  std::vector<OutputFile> files;
  for (const fs::path& video : clip.videos) files.push_back({"-o", video});
  check_output_files(files, clip.spec);
}

void check_folder(const OutputFile& folder) {
  std::error_code ignored;
  const fs::file_status status = fs::status(folder.path, ignored);
  if (fs::exists(status) && !fs::is_directory(status)) fail_output(folder, "it is a file; expected a folder");
  check_place(folder, folder.path);
}

}  // namespace

Options take_videos(const Options& asked) {
  Options options = asked;
  options.output.reset();
  for (const fs::path& path : asked.outputs)
    if (is_video_name(path) && !fs::is_directory(path))
      options.videos.push_back(path);
    else if (has_file_ending(path))
      fail_output(
          {"-o", path},
          fmt::format(
              "expected a folder or a clip, whose name ends in {}; '{}' is the ending of another file",
              join_endings(list_video_endings()), path.extension().string()));
    else
      options.output = path;
  return options;
}

OutputFile find_output_file(const Options& options, const fs::path& otherwise) {
  return options.output ? OutputFile{"-o", *options.output} : OutputFile{"", otherwise};
}

bool has_file_ending(const fs::path& path) {
  return std::ranges::find(kFileEndings, find_ending(path)) != kFileEndings.end();
}

void check_ending(const OutputFile& file, std::string_view kind, const std::vector<std::string>& endings) {
  if (std::ranges::find(endings, find_ending(file.path)) == endings.end())
    fail_output(file, fmt::format("unknown kind of {} '{}'; expected a name that ends in {}", kind,
                                  file.path.extension().string(), join_endings(endings)));
}

void check_output_files(const std::vector<OutputFile>& files, const Spec& spec) {
  const ReadFiles inputs = list_read_files(spec);
  std::map<Identity, const OutputFile*> old;
  std::map<fs::path, const OutputFile*> named;
  const auto check_first = [](const OutputFile& file, const OutputFile& first) {
    if (&file != &first) fail_output(file, fmt::format("it is {} too; expected two files", name_file(first)));
  };
  for (const OutputFile& file : files) {
    const auto identity = find_identity(file.path);
    check_old_file(file, identity, inputs);
    check_place(file, file.path);
    if (identity) check_first(file, *old.emplace(*identity, &file).first->second);
    std::error_code error;
    const fs::path name = fs::weakly_canonical(fs::absolute(file.path), error);
    check_first(file, *named.emplace(error ? file.path : name, &file).first->second);
  }
}

void check_output_folder(const Options& options, const fs::path& folder, const std::vector<fs::path>& files,
                         const Spec& spec) {
  const OutputFile named{options.output ? "-o" : "", folder};
  if (options.output && has_file_ending(folder))
    fail_output(named, fmt::format("expected the name of a folder; '{}' is the ending of a file",
                                   folder.extension().string()));
  check_folder(named);
  const ReadFiles inputs = list_read_files(spec);
  for (const fs::path& file : files) {
    const OutputFile inside{"", folder / file};
    if (file.has_parent_path()) check_folder({"", inside.path.parent_path()});
    check_old_file(inside, find_identity(inside.path), inputs);
  }
}

void check_sketch_folder(const Options& options, const Clip& clip) {
  std::vector<fs::path> all{kSketchManifest};
  add_videos(clip, all);
  check_output_folder(options, clip.files.folder, all, clip.spec);
  check_videos(clip);
}

void check_clip_folder(const Options& options, const Clip& clip, bool has_pictures) {
  const ClipFiles files{{}, clip.files.name};
  std::vector<fs::path> all{files.scenes() / "head.inc", files.scenes() / "loop.pov",
                            files.scenes() / (files.name + ".ini")};
  for (const int frame : clip.plan.frames) {
    all.push_back(files.scene(frame));
    all.push_back(files.scenes() / name_heads(frame));
    if (has_pictures) all.push_back(files.picture(frame));
  }
  if (has_pictures) {
    for (const fs::path& path :
         {fs::path("manifest.json"), find_preview_path(clip).filename(), fs::path("poster.png")})
      all.push_back(path);
    add_videos(clip, all);
  }
  check_output_folder(options, clip.files.folder, all, clip.spec);
  if (has_pictures) {
    check_folder({"", find_store(clip).folder});
    check_videos(clip);
  } else {
    check_folder({"", clip.files.folder / "frames"});
  }
}

}  // namespace mien
