// Words of the language that the data defines, each with its meaning: what the table of language.hpp calls
// `data`.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mien {

struct DataWord {
  std::string name;
  std::string meaning;  // one line; may be empty
};

// By list: features, looks, hair_colours, hair, beards, places, libraries and expressions ("smile" of a
// library that plain names are looked up in, "tezuka/smile" of each).
using DataWords = std::map<std::string, std::vector<DataWord>>;

// From the files that define them. Throws InputError with every mistake of one of them at its place, RunError
// for what cannot be read.
DataWords load_data_words(const std::filesystem::path& data_folder);

}  // namespace mien
