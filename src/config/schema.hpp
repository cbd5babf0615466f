// The JSON Schema of the YAML file (draft 2020-12), written from the table of language.hpp and the words of
// the data. It passes a validator's strict mode, and takes every file that mien takes.
#pragma once

#include <string>

#include "config/data_words.hpp"

namespace mien {

// The whole schema as indented JSON, with a newline at its end. A library of expressions is told by its
// `source:`. What a schema cannot say (the order of keys, names of the file's own, ranges of texts with a
// unit) it leaves to `mien check`.
std::string build_schema(const DataWords& data);

}  // namespace mien
