// Our own data and the solved adult: what the program begins with, read once for all tests.
#pragma once

#include "core/data.hpp"
#include "frames/resources.hpp"

namespace mien {

// Without heads, which need solving.
inline const Stock& shipped_stock() {
  static const Stock stock = load_stock(find_data_folder());
  return stock;
}

inline const Resources& shipped() {
  static const Resources resources = load_resources(find_data_folder());
  return resources;
}

}  // namespace mien
