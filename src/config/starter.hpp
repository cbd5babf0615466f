// `mien new NAME`: a commented file to begin with, whose head is the template's or one of a crowd.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace mien {

// The text of templates/new.yaml under this title; with a seed its head is the one that `random: SEED` draws,
// every word of it spelled out. Throws InputError for mistakes in the data, at their places, RunError for
// what cannot be read.
std::string load_starter(const std::filesystem::path& data_folder, const std::string& name,
                         std::optional<int> random_head);

}  // namespace mien
