// The reference of the YAML language, docs/reference.md, written from the table of language.hpp: a heading
// and a table of keys for each mapping.
#pragma once

#include <string>

namespace mien {

std::string build_reference_manual();

}  // namespace mien
