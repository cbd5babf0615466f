// Numbers with three digits behind the point, from tables: a scene has hundreds of thousands of them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace mien {

// All there is to be told of numbers below a thousand with three digits behind the point, which are nearly
// all numbers of a scene: "0" to "999" with their length as the fourth byte, and "", ".001" to ".999" without
// zeros at their end.
struct Thousands {
  std::array<std::array<char, 4>, 1000> whole{}, fraction{};
  std::array<std::uint8_t, 1000> length{};  // of the fraction
};
constexpr Thousands build_thousands() {
  Thousands all;
  for (int i = 0; i < 1000; ++i) {
    const std::array<char, 3> digits{static_cast<char>('0' + i / 100), static_cast<char>('0' + i / 10 % 10),
                                     static_cast<char>('0' + i % 10)};
    const int leading = i < 10 ? 2 : i < 100 ? 1 : 0;
    for (int k = leading; k < 3; ++k) all.whole[i][k - leading] = digits[k];
    all.whole[i][3] = static_cast<char>(3 - leading);
    all.fraction[i] = {'.', digits[0], digits[1], digits[2]};
    all.length[i] = i == 0 ? 0 : i % 100 == 0 ? 2 : i % 10 == 0 ? 3 : 4;
  }
  return all;
}
inline constexpr Thousands kThousands = build_thousands();

// "-1" to "1" in thousandths, with their length as the eighth byte: the numbers of normals, each at one look.
constexpr std::array<std::array<char, 8>, 2001> build_units() {
  constexpr Thousands kAll = build_thousands();
  std::array<std::array<char, 8>, 2001> units{};
  for (int i = -1000; i <= 1000; ++i) {
    std::array<char, 8>& unit = units[i + 1000];
    const int size = i < 0 ? -i : i;
    int length = 0;
    if (i < 0) unit[length++] = '-';
    unit[length++] = size == 1000 ? '1' : '0';
    for (int k = 0; k < kAll.length[size % 1000]; ++k) unit[length++] = kAll.fraction[size % 1000][k];
    unit[7] = static_cast<char>(length);
  }
  return units;
}
inline constexpr std::array<std::array<char, 8>, 2001> kUnits = build_units();

// What write_number of core/text.hpp writes with three decimals, without a branch that could be guessed
// wrong; eight bytes may be written over. nullptr for what is not below a thousand, or not finite: nothing is
// written.
inline char* write_thousandths(char* text, double value) {
  const double scaled = std::abs(value) * 1000 + 0.5;
  if (!(scaled < 1e6)) return nullptr;
  const auto rest = static_cast<std::uint32_t>(scaled);
  if (rest <= 1000) {
    const auto& unit = kUnits[value < 0 ? 1000 - rest : 1000 + rest];
    std::memcpy(text, unit.data(), unit.size());
    return text + unit[7];
  }
  const std::uint32_t whole = rest / 1000, fraction = rest - 1000 * whole;
  *text = '-';
  text += value < 0;
  std::memcpy(text, kThousands.whole[whole].data(), 4);
  text += kThousands.whole[whole][3];
  std::memcpy(text, kThousands.fraction[fraction].data(), 4);
  return text + kThousands.length[fraction];
}

}  // namespace mien
