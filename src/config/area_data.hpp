// templates/head/areas.yaml as values: what the nine areas do to the adult skin, before it is solved for a
// head.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "config/areas.hpp"
#include "config/point_names.hpp"

namespace mien {

using PointPatterns = std::vector<std::string>;

// One factor of a corrective's product: the value of area.move, its positive or its negative part.
struct Driver {
  std::string area, move;
  int sign = 1;
};

// The handles of one move, both ways. Millimetres on the adult.
struct MoveTable {
  std::string area, move;  // "brow", "up"; a corrective has only a name in `move`
  bool is_sided = false;
  bool is_odd =
      false;  // to one side: the other half's points go the same way across, and against it up and forward
  std::array<std::string, 3> units;  // face units by which x, y, z scale on another head
  std::string anchors;               // name of an anchor set
  Handles plus, minus;               // minus may be empty
  Handles even;                      // of an odd move: what both halves do alike, whichever side it goes to
  std::vector<std::pair<Driver, double>>
      yields;  // to what else moves its skin, and the share that it then lacks
};

struct CorrectiveTable {
  MoveTable table;  // plus only
  std::vector<Driver> drivers;
};

// How far a value of 2 goes; see `past_limits`.
struct PastLimit {
  Driver move;
  double reach = 2;
};

struct LidData {
  std::map<std::string, double> rows_upper, rows_lower;  // ring -> share of the lid's angle
  std::map<std::string, double> rows_shut;               // of a shut upper lid, where it is another
  std::array<double, 9> column_taper{};
  std::array<double, 9> meeting{};                     // of shut lids, in shares of the opening
  std::array<double, 9> slide_upper{}, slide_lower{};  // of a shut lid toward the nose, mm
  double least_gap_deg = 0, wide_deg = 0, raised_deg = 0;
  std::map<std::string, glm::dvec3> raised_bulge;  // ring -> mm
  double follow_up = 0, follow_down = 0, follow_lower = 0;
  double fold_least = 0, fold_forward = 0;
  std::map<std::string, double> least_radius;  // ring -> mm from the centre of a ball of 13 mm
};

struct JawData {
  glm::dvec3 axis{0};                // a point of it on the adult, mm
  double degrees = 0, straight = 0;  // at chin.down 1; mm down at chin.straight 1
  // The teeth's ways at 1 of chin.down, jaw.side, jaw.forward and lips.roll_lower.
  glm::dvec3 forward{0}, aside{0}, protruded{0}, rolled{0};
  std::array<double, 13> columns{}, mb2{};
  double m6_factor = 1;
  std::vector<std::pair<std::string, double>> points;  // pattern -> weight
  PointPatterns zero;
  // How much of its weight each point lacks where lips stay shut over the open jaw: pattern -> share.
  std::vector<std::pair<std::string, double>> shut;
  PointPatterns unshut;  // that have none
  Handles corner_in;
};

// What skin does that is pushed together: see `give_way` in areas.yaml.
struct GiveWayData {
  double from = 0, least = 0, forward = 0;
  std::vector<std::vector<std::string>> lines;  // names of control points of the left half
};

inline constexpr std::string_view kTonguePlace = "tongue";  // its tip

// Where a limit is measured and how far it is on the adult.
struct LimitPlace {
  std::string point;  // of the cage's left half, "pupil" or kTonguePlace
  int axis = -1;      // along which: 0 x, 1 y, 2 z; -1 for a turn, whose degrees are told elsewhere
  std::string unit;   // the face unit that it scales with; none for a turn
  double plus_mm = 0, minus_mm = 0;
};

struct AreaData {
  std::map<std::string, LimitPlace> limits;  // by "brow.up"
  std::map<std::string, PointPatterns> anchors;
  std::vector<MoveTable> moves;
  std::vector<CorrectiveTable> correctives;
  std::vector<PastLimit> past_limits;
  LidData lids;
  double eye_up_deg = 0, eye_down_deg = 0, eye_side_deg = 0;
  JawData jaw;
  std::map<std::string, double> lip_rows;  // ring -> share of a push
  double seal_until_mm = 0;
  std::map<std::string, double> philtrum_rows;  // ring -> share of a push
  GiveWayData give_way;
  glm::dvec3 turn_pivot{0};
  std::map<std::string, double> turn_rows;  // row of the neck -> share of the head's turn
};

// Reads templates/head/areas.yaml; what does not fit, and names that `points` has not, is added to the
// findings.
AreaData load_area_data(const std::filesystem::path& file, const PointNames& points, Findings& findings);

// "brow.up-" as a driver; empty if there is no such move or no sign.
std::optional<Driver> find_driver(std::string_view text);
// The same of a value, a mistake told otherwise.
bool load_driver(const YamlValue& value, Driver& into);

// Adds a mistake at the key unless it is a move such as "brow.up".
bool check_move(const YamlEntry& entry);

}  // namespace mien
