// Words of the language that the data defines, each with its meaning: what the table of language.hpp calls
// `data`.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "config/stock.hpp"

namespace mien {

struct DataWord {
  std::string name;
  std::string meaning;  // one line; may be empty
};

// By list: features, looks, hair_colours, hair, beards, places, libraries and expressions ("smile" of a
// library that plain names are looked up in, "tezuka/smile" of each).
using DataWords = std::map<std::string, std::vector<DataWord>>;

DataWords list_data_words(const Stock& stock);

}  // namespace mien
