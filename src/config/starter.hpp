// `mien new NAME`: a commented file to begin with, whose head is the template's or one of a crowd.
#pragma once

#include <optional>
#include <string>

#include "config/stock.hpp"

namespace mien {

// The text of templates/new.yaml under this title; with a seed its head is the one that `random: SEED` draws,
// every word of it spelled out.
std::string build_starter(const Stock& stock, const std::string& name, std::optional<int> random_head);

}  // namespace mien
