// The page's own files: those of templates/live, and the libraries that the system has.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "live/server.hpp"

namespace mien {

// By what a page asks for: "view.js", "lib/three.module.js". Nothing else is served.
using LiveFiles = std::map<std::string, std::filesystem::path>;

// Throws RunError "libjs-three is not installed; install it with: apt-get install libjs-three".
LiveFiles list_live_files(const std::filesystem::path& data_folder);

// 404 for what is not among them.
LiveAnswer answer_file(const LiveFiles& files, const std::string& name);

// "text/css" of "live.css"; of an ending that is not known "application/octet-stream".
std::string find_type(const std::string& name);

// The name as it stands in an address (RFC 3986).
std::string encode_name(const std::string& name);

}  // namespace mien
