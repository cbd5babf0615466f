#include "live/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr auto kTypes =
    std::to_array<std::pair<std::string_view, const char*>>({{".html", "text/html; charset=utf-8"},
                                                             {".js", "text/javascript; charset=utf-8"},
                                                             {".css", "text/css; charset=utf-8"},
                                                             {".svg", "image/svg+xml"},
                                                             {".png", "image/png"},
                                                             {".mp4", "video/mp4"},
                                                             {".json", "application/json"},
                                                             {".stl", "model/stl"},
                                                             {".3mf", "model/3mf"},
                                                             {".scad", "text/plain; charset=utf-8"},
                                                             {".txt", "text/plain; charset=utf-8"}});

// Of the file NAME that a page asks for as lib/NAME.
struct Library {
  std::string_view package;
  const char* folder;
  std::initializer_list<std::string_view> files;
};

const std::array<Library, 2>& list_libraries() {
  static const std::array<Library, 2> libraries{
      {{"libjs-three", "/usr/share/javascript/three", {"build/three.module.js"}},
       {"libjs-codemirror",
        "/usr/share/javascript/codemirror",
        {"lib/codemirror.js",           "lib/codemirror.css",
         "mode/yaml/yaml.js",           "addon/hint/show-hint.js",
         "addon/hint/show-hint.css",    "addon/lint/lint.js",
         "addon/lint/lint.css",         "addon/search/searchcursor.js",
         "addon/search/search.js",      "addon/search/jump-to-line.js",
         "addon/dialog/dialog.js",      "addon/dialog/dialog.css",
         "addon/comment/comment.js",    "addon/edit/matchbrackets.js",
         "addon/edit/closebrackets.js", "addon/selection/active-line.js",
         "addon/fold/foldcode.js",      "addon/fold/foldgutter.js",
         "addon/fold/foldgutter.css",   "addon/fold/indent-fold.js"}}}};
  return libraries;
}

}  // namespace

LiveFiles list_live_files(const fs::path& data_folder) {
  LiveFiles files;
  const fs::path folder = data_folder / "templates" / "live";
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file()) files[entry.path().filename().string()] = entry.path();
  if (error) throw RunError(fmt::format("cannot read {}: {}", folder.string(), error.message()));
  for (const Library& library : list_libraries())
    for (const std::string_view name : library.files) {
      const fs::path path = fs::path(library.folder) / name;
      if (!fs::is_regular_file(path, error))
        throw RunError(
            fmt::format("{0} is not installed; install it with: apt-get install {0}", library.package));
      files["lib/" + path.filename().string()] = path;
    }
  return files;
}

LiveAnswer answer_file(const LiveFiles& files, const std::string& name) {
  const auto found = files.find(name.empty() ? "index.html" : name);
  if (found == files.end()) return build_refusal(404, "there is no such file");
  return {200, find_type(found->first), read_file(found->second)};
}

std::string find_type(const std::string& name) {
  for (const auto& [ending, type] : kTypes)
    if (name.ends_with(ending)) return type;
  return "application/octet-stream";
}

std::string encode_name(const std::string& name) {
  std::string text;
  for (const char letter : name) {
    const bool is_plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                          (letter >= '0' && letter <= '9') ||
                          std::string_view("-._~").find(letter) != std::string_view::npos;
    if (is_plain)
      text += letter;
    else
      text += fmt::format("%{:02X}", static_cast<unsigned char>(letter));
  }
  return text;
}

}  // namespace mien
