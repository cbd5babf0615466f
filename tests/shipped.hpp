// Our own data and the solved adult: what the program begins with, read once for all tests.
#pragma once

#include "frames/resources.hpp"
#include "places.hpp"

namespace mien {

// Without heads, which need solving.
inline const Stock& shipped_stock() {
  static const Stock stock = load_stock(source_folder());
  return stock;
}

inline const Resources& shipped() {
  static const Resources resources = load_resources(source_folder());
  return resources;
}

}  // namespace mien
