// The numbers of the parts: templates/head/parts.yaml as plain values. What each means stands there, beside
// it.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "config/findings.hpp"

namespace mien {

struct TearNumbers {
  double first = 0, last = 0, mix = 0, above_mm = 0, radius_mm = 0;
  int rings = 0;
};

struct KnobNumbers {
  double mix = 0, sink_mm = 0;
  std::array<double, 3> half_mm{};
};

// The cornea rises by cornea_rise (1 - share^2)^kCorneaSwell above the ball, share of the way to its edge: 1
// would leave a kink there, 2 a pointed apex. The lift keeps its rim from flickering in the white.
inline constexpr double kCorneaSwell = 1.2, kCorneaLift_mm = 0.015;

struct EyeNumbers {
  double ball_mm = 0, outward_deg = 0, limbus_mm = 0, pupil_floor_mm = 0, cornea_rise_mm = 0,
         cornea_edge_mm = 0;
  std::array<double, 2> iris_edge_mm{}, iris_inner_mm{};  // radius, z
  int fibres = 0;
  TearNumbers tear;
  KnobNumbers caruncle, plica;
};

struct LashRowNumbers {
  int count = 0;
  double from = 0, to = 0, shortest_mm = 0, longest_mm = 0, radius_mm = 0, fan = 0;
  std::array<double, 2> out{}, up{};  // factors of s and s^2
};

struct LashNumbers {
  double root = 0, clump = 0, margin_mm = 0, infant = 0;
  LashRowNumbers upper, lower;
};

struct BrowCoat {
  int hairs = 0;
  double radius_mm = 0;
  std::vector<double> lift_mm;
};

struct BrowNumbers {
  double line_mm = 0, infant_blend = 0, under_blend = 0, paint = 0, infant_paint = 0;
  std::array<double, 2> grown_mm{};
  BrowCoat over, under;
  std::vector<double> station, above_mm, half_mm, density, length_mm, lower_angle_deg, upper_angle_deg;
};

inline constexpr std::size_t kTeeth = 7;      // of half a row, wisdom teeth left out
inline constexpr std::size_t kMilkTeeth = 5;  // of them have a milk tooth before them

template <typename T>
using PerTooth = std::array<T, kTeeth>;  // from the middle outward

struct TeethRowNumbers {
  double gum_mm = 0, edge_mm = 0, lean_mm = 0, inset_mm = 0;
  PerTooth<double> width_mm{}, thick_mm{}, table_mm{}, rise_mm{}, point_mm{}, neck_mm{}, turn_deg{}, years{};
  PerTooth<int> cusps{};
  std::array<double, kMilkTeeth> milk{}, milk_years{}, shed_years{};
};

struct ArchNumbers {
  double depth_mm = 0, square = 2;
  std::array<double, 2> half_mm{};
};

struct TongueNumbers {
  double half_mm = 0, tip_mm = 0, top_mm = 0, rise_mm = 0, back_mm = 0, room_mm = 0;
};

// Control points of the cavity's skin, column by column as the rings M0, MB1 and MB2 have them.
struct MouthBagNumbers {
  static constexpr std::size_t kColumns = 13;
  std::array<std::array<double, 3>, kColumns> front_mm{}, back_mm{};
};

struct MouthNumbers {
  double corner_mm = 0, setback_mm = 0, clearance_mm = 0;
  ArchNumbers arch;
  TeethRowNumbers upper, lower;
  std::array<double, 2> growing_years{};
  double milk_height = 1, milk_space_mm = 0;
  std::map<std::string, double> years;            // by an age's name
  std::vector<std::array<double, 2>> scan_years;  // eye to chin in mm, years; both rising
  double scallop_mm = 0, ridge_mm = 0, gum_thick_mm = 0;
  TongueNumbers tongue;
  MouthBagNumbers bag;
};

struct PartNumbers {
  EyeNumbers eye;
  LashNumbers lashes;
  BrowNumbers brow;
  MouthNumbers mouth;
};

// Reads templates/head/parts.yaml; what does not fit is added to the findings.
PartNumbers load_part_numbers(const std::filesystem::path& file, Findings& findings);

}  // namespace mien
