// The command line of a farm's tasks, from that which was given.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "options.hpp"

namespace mien {

struct FarmWords {
  std::vector<std::string> tasks;  // mien render FILE ..., with what changes pictures or says where they are
  std::vector<std::string> clip;   // and with what is for the whole clip
  std::string asked;               // all of them in one, and how they are shared out
};

// `mien` is called as this program lies on this machine: so must it on the others.
FarmWords list_farm_words(const Options& options);

// What the jobs of a clip's folder are called, whoever calls: by it they are found again.
std::string name_farm_jobs(const std::string& clip_name, const std::filesystem::path& folder);

}  // namespace mien
