#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "config/area_data.hpp"
#include "core/conventions.hpp"
#include "core/error.hpp"
#include "core/pool.hpp"
#include "core/smooth.hpp"
#include "face/doctrine.hpp"
#include "face/face.hpp"
#include "head/cage.hpp"
#include "head/patterns.hpp"

namespace mien {

namespace {

// This head's face units over the adult's.
double compute_unit_ratio(const FaceUnits& here, const FaceUnits& adult, const std::string& unit) {
  if (unit == "eye_separation") return here.eye_separation / adult.eye_separation;
  if (unit == "eye_nose") return here.eye_nose / adult.eye_nose;
  if (unit == "mouth_nose") return here.mouth_nose / adult.mouth_nose;
  if (unit == "mouth_width") return here.mouth_width / adult.mouth_width;
  if (unit == "iris") return here.iris / adult.iris;
  throw RunError(fmt::format("unknown face unit '{}'", unit));
}

// The points that a table's fields leave where they are, by the word that names them.
using Anchors = std::map<std::string, std::vector<bool>>;

Anchors compute_anchors(const Cage& cage, const AreaData& data) {
  Anchors anchors;
  for (const auto& [name, own] : data.anchors) {
    PointPatterns patterns = data.anchors.at("always");
    patterns.insert(patterns.end(), own.begin(), own.end());
    anchors[name] = find_points(cage, patterns);
  }
  return anchors;
}

struct Scales {
  FaceUnits here, adult;

  Handles apply(const MoveTable& table, const Handles& handles) const {
    glm::dvec3 scale;
    for (int axis = 0; axis < 3; ++axis) scale[axis] = compute_unit_ratio(here, adult, table.units[axis]);
    Handles scaled = handles;
    for (auto& [name, move] : scaled) move *= scale;
    return scaled;
  }
};

std::size_t require_move(const std::string& area, Side side, const std::string& move) {
  const auto found = find_move(area, side, move);
  if (!found) throw RunError(fmt::format("unknown move '{}.{}'", area, move));
  return *found;
}

bool is_sided_area(const std::string& area) {
  return std::any_of(kMoves.begin(), kMoves.end(),
                     [&](const MoveInfo& info) { return info.area == area && info.side != Side::none; });
}

DrivenField build_sided_field(const Cage& cage, std::vector<SignedMove> left, std::vector<SignedMove> right,
                              Field field) {
  fade_far_side(cage, field);
  Field mirrored = mirror_field(cage, field);
  return {std::move(left), std::move(field), std::move(right), std::move(mirrored), false, {}, {}};
}

// Solves one table's plus or minus side; for a sided move also its mirror image.
DrivenField build_move_field(const FieldSolver& solver, const Anchors& anchors, const Scales& scales,
                             const MoveTable& table, int sign) {
  Field field =
      solve_field(solver, scales.apply(table, sign > 0 ? table.plus : table.minus), anchors.at(table.anchors),
                  table.is_odd     ? Reach::odd
                  : table.is_sided ? Reach::left
                                   : Reach::both);
  const auto drive = [&](Side side) {
    return std::vector<SignedMove>{{require_move(table.area, side, table.move), sign}};
  };
  const bool is_late = table.area == "jaw";
  if (table.is_odd) {
    if (!table.even.empty()) {
      const Field even =
          solve_field(solver, scales.apply(table, table.even), anchors.at(table.anchors), Reach::both);
      for (std::size_t i = 0; i < field.size(); ++i) field[i] += even[i];
    }
    Field mirrored = mirror_field(*solver.cage, field);
    return {drive(Side::none),
            std::move(field),
            {{require_move(table.area, Side::none, table.move), -sign}},
            std::move(mirrored),
            is_late,
            {},
            {}};
  }
  if (table.is_sided)
    return build_sided_field(*solver.cage, drive(Side::left), drive(Side::right), std::move(field));
  return {drive(Side::none), std::move(field), {}, {}, is_late, {}, {}};
}

// What a design makes the move larger by. The lids keep to the eye, and what lies between goes part of the
// way; the mouth goes all of it, and the cheeks hardly: they would be pushed out of the drawn face. Nostrils
// are narrow and not drawn farther: their sides would cross.
double find_point_gain(double gain, std::string_view area, std::string_view name) {
  struct Share {
    std::string_view beginning;
    double share;
  };
  constexpr std::array kBrow{Share{"EB_", 0},    Share{"E0_", 0},    Share{"E1_", 0}, Share{"E2_", 0},
                             Share{"E3_", 0.15}, Share{"E4_", 0.35}, Share{"", 1}};
  constexpr std::array kMouth{Share{"MA", 0.85}, Share{"M5", 0.8},  Share{"M6", 0.6},   Share{"M", 1},
                              Share{"E", 0},     Share{"q13", 0.4}, Share{"q12", 0.35}, Share{"q11", 0.25},
                              Share{"n", 0},     Share{"k_", 0},    Share{"", 0.15}};
  const auto find = [&](const auto& shares) {
    return std::ranges::find_if(shares, [&](const Share& one) { return has_prefix(name, one.beginning); })
        ->share;
  };
  return 1 + (area == "brow" ? find(kBrow) : find(kMouth)) * (gain - 1);
}

void scale_field(const Cage& cage, double gain, std::string_view area, Field& field) {
  for (std::size_t i = 0; i < field.size(); ++i) field[i] *= find_point_gain(gain, area, cage.names[i]);
}

// Flat lips have less room for their rings to move against each other: what each does beyond the line where
// the lips meet shrinks as they did.
struct LipRoom {
  std::uint32_t point = 0, line = 0;
  double share = 1;
};

std::vector<LipRoom> list_lip_rooms(const Cage& cage, const DesignNumbers& design) {
  constexpr std::array<std::pair<std::string_view, double>, 3> kRings{
      {{"M2_", 1}, {"M3_", 1}, {"M4_", 0.75}}};
  std::vector<LipRoom> rooms;
  if (design.lip_height == 1) return rooms;
  for (std::uint32_t i = 0; i < cage.names.size(); ++i)
    for (const auto& [ring, flat] : kRings)
      if (has_prefix(cage.names[i], ring)) {
        const std::string_view name = strip_side(cage.names[i]);
        const std::uint32_t line = find_point(cage, "M1_" + std::string(name.substr(ring.size())));
        rooms.push_back({i, name.size() == cage.names[i].size() ? line : cage.mirror[line],
                         1 - (1 - design.lip_height) * flat});
      }
  return rooms;
}

void keep_lip_rooms(const std::vector<LipRoom>& rooms, Field& field) {
  if (field.empty()) return;
  for (const auto& [point, line, share] : rooms)
    field[point] = field[line] + share * (field[point] - field[line]);
}

// Where a design lifts the corners of the mouth further, an open jaw takes it back: the mouth would tear.
std::optional<DrivenField> build_jaw_relief(const Cage& cage, const MoveTable& table, double gain,
                                            const DrivenField& scaled) {
  if (gain == 1 || table.area != "corner") return std::nullopt;
  DrivenField relief = scaled;
  const SignedMove jaw{require_move("chin", Side::none, "down"), 1};
  relief.drivers.push_back(jaw);
  if (!relief.mirror_drivers.empty()) relief.mirror_drivers.push_back(jaw);
  for (Field* field : {&relief.field, &relief.mirror_field})
    for (std::size_t i = 0; i < field->size(); ++i) {
      const double own = find_point_gain(gain, table.area, cage.names[i]);
      (*field)[i] *= -(own - 1) / own;
    }
  return relief;
}

// Of a field of one side, what moves on that side or in the middle; of one of both, what moves on either.
void add_yields(const MoveTable& table, DrivenField& driven) {
  for (const auto& [other, share] : table.yields)
    for (const bool is_mirror : {false, true}) {
      Yield yield{{}, share};
      const Side far = is_mirror ? Side::left : Side::right;
      for (const Side side : {Side::none, Side::left, Side::right})
        if (const auto move = find_move(other.area, side, other.move);
            move && !(table.is_sided && side == far))
          yield.to.push_back({*move, other.sign});
      (is_mirror ? driven.mirror_yields : driven.yields).push_back(std::move(yield));
    }
}

DrivenField build_corrective(const FieldSolver& solver, const Anchors& anchors, const Scales& scales,
                             const CorrectiveTable& corrective) {
  Field field = solve_field(solver, scales.apply(corrective.table, corrective.table.plus),
                            anchors.at(corrective.table.anchors), Reach::left);
  const auto drivers_of = [&](Side side) {
    std::vector<SignedMove> drivers;
    for (const Driver& d : corrective.drivers)
      drivers.push_back({require_move(d.area, is_sided_area(d.area) ? side : Side::none, d.move), d.sign});
    return drivers;
  };
  DrivenField driven =
      build_sided_field(*solver.cage, drivers_of(Side::left), drivers_of(Side::right), std::move(field));
  add_yields(corrective.table, driven);
  return driven;
}

// Moves first, then correctives, in the file's order; each is solved on its own, a solver for each thread.
// Those that hold and move the same points go to one thread, one after the other.
std::vector<DrivenField> build_fields(const NeutralHead& head, const AreaData& data, const Scales& scales) {
  const Cage& cage = head.cage;
  const Anchors anchors = compute_anchors(cage, data);
  std::vector<std::function<DrivenField(const FieldSolver&)>> works;
  std::map<std::string, std::vector<std::size_t>> alike;  // works by what they hold and move
  const auto add = [&](const MoveTable& table, const Handles& handles,
                       std::function<DrivenField(const FieldSolver&)> work) {
    std::string key = fmt::format("{} {} {}", table.anchors, table.is_sided, table.is_odd);
    for (const auto& [point, move] : handles) key += ' ' + point;
    alike[key].push_back(works.size());
    works.push_back(std::move(work));
  };
  for (const MoveTable& table : data.moves)
    for (const int sign : {1, -1})
      if (!(sign > 0 ? table.plus : table.minus).empty())
        add(table, sign > 0 ? table.plus : table.minus, [&, sign](const FieldSolver& solver) {
          DrivenField driven = build_move_field(solver, anchors, scales, table, sign);
          add_yields(table, driven);
          const double gain = get_gain(head.design, table.area, table.move, sign);
          if (gain != 1)
            for (Field* field : {&driven.field, &driven.mirror_field})
              scale_field(cage, gain, table.area, *field);
          return driven;
        });
  for (const CorrectiveTable& corrective : data.correctives)
    add(corrective.table, corrective.table.plus,
        [&](const FieldSolver& solver) { return build_corrective(solver, anchors, scales, corrective); });
  MoveTable corner_in;
  corner_in.units = {"mouth_width", "mouth_nose", "mouth_width"};
  corner_in.anchors = "corner";
  corner_in.plus = data.jaw.corner_in;
  add(corner_in, corner_in.plus, [&](const FieldSolver& solver) {
    return build_corrective(solver, anchors, scales, {corner_in, {{"chin", "down", 1}}});
  });

  std::vector<DrivenField> fields(works.size());
  std::vector<std::optional<FieldSolver>> solvers(static_cast<std::size_t>(count_workers()));
  std::vector<std::vector<std::size_t>> groups;
  for (auto& [key, group] : alike) groups.push_back(std::move(group));
  for_each_index(groups.size(), count_workers(), [&](std::size_t i, int worker) {
    std::optional<FieldSolver>& solver = solvers[static_cast<std::size_t>(worker)];
    if (!solver) solver = build_field_solver(cage);
    for (const std::size_t work : groups[i]) fields[work] = works[work](*solver);
  });
  const std::vector<LipRoom> rooms = list_lip_rooms(cage, head.design);
  for (DrivenField& field : fields)
    for (Field* one : {&field.field, &field.mirror_field}) keep_lip_rooms(rooms, *one);
  std::size_t next = 0;
  std::vector<DrivenField> reliefs;
  for (const MoveTable& table : data.moves)
    for (const int sign : {1, -1})
      if (!(sign > 0 ? table.plus : table.minus).empty())
        if (auto relief = build_jaw_relief(cage, table, get_gain(head.design, table.area, table.move, sign),
                                           fields[next++]))
          reliefs.push_back(std::move(*relief));
  for (DrivenField& relief : reliefs) fields.push_back(std::move(relief));
  return fields;
}

JawRig build_jaw(const NeutralHead& head, const FieldSolver& solver, const AreaData& data,
                 const Scales& scales) {
  const JawData& jaw = data.jaw;
  std::map<std::string, double> values;
  const auto add_ring = [&](const std::string& ring, const std::array<double, 13>& columns, double factor) {
    for (int i = 0; i < 13; ++i)
      values[fmt::format("{}_{}", ring, i)] = std::clamp(columns[i] * factor, ring == "M6" ? 0.0 : -1.0, 1.0);
  };
  for (const char* ring : {"MB1", "M0", "M1", "M2", "M3", "M4", "MA", "M5"}) add_ring(ring, jaw.columns, 1);
  add_ring("M6", jaw.columns, jaw.m6_factor);
  add_ring("MB2", jaw.mb2, 1);
  const auto add_points = [&](const std::vector<std::pair<std::string, double>>& told,
                              std::map<std::string, double>& into) {
    for (const auto& [pattern, share] : told) {
      const std::vector<bool> found = find_points(head.cage, {pattern});
      for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i] && !head.cage.names[i].starts_with("R:")) into[head.cage.names[i]] = share;
    }
  };
  add_points(jaw.points, values);
  std::map<std::string, double> shut;
  add_points(jaw.shut, shut);
  JawRig rig;
  rig.weights = solve_weights(solver, values, find_points(head.cage, jaw.zero));
  rig.shut = solve_weights(solver, shut, find_points(head.cage, jaw.unshut));
  rig.open_rad = jaw.degrees * kRadiansPerDegree;
  rig.forward = jaw.forward * (scales.here.mouth_nose / scales.adult.mouth_nose);
  rig.aside = jaw.aside * (scales.here.mouth_width / scales.adult.mouth_width);
  rig.straight_mm = jaw.straight * (scales.here.mouth_nose / scales.adult.mouth_nose);
  rig.protruded = jaw.protruded * (scales.here.mouth_width / scales.adult.mouth_width);
  rig.rolled = jaw.rolled * (scales.here.mouth_width / scales.adult.mouth_width);
  return rig;
}

// A point given on the adult, where it is on this head: by the height of the face and the depth of the
// forehead.
glm::dvec3 carry_point(const NeutralHead& head, const glm::dvec3& adult) {
  const std::uint32_t chin = find_point(head.cage, "m12_D1"), brow = find_point(head.cage, "p_g");
  return {adult.x, adult.y * head.cage.points[chin].y / head.adult_points[chin].y,
          adult.z * head.cage.points[brow].z / head.adult_points[brow].z};
}

std::vector<LipColumn> build_lips(const Cage& cage, const AreaData& data) {
  std::vector<LipColumn> lips;
  for (const bool is_right : {false, true})
    for (int i = is_right ? 1 : 0; i < 6;
         ++i) {  // column 6 is the corner, 0 the middle, which both sides share
      const auto point = [&](const std::string& ring, int column) {
        const std::uint32_t p = find_point(cage, fmt::format("{}_{}", ring, column));
        return is_right ? cage.mirror[p] : p;
      };
      LipColumn column;
      for (const auto& [ring, share] : data.lip_rows) {
        column.upper.emplace_back(point(ring, i), share);
        column.lower.emplace_back(point(ring, 12 - i), share);
      }
      column.upper_contact = point("M1", i);
      column.lower_contact = point("M1", 12 - i);
      column.rest_gap_mm = cage.points[column.upper_contact].y - cage.points[column.lower_contact].y;
      column.upper_edge = {point("M0", i), point("M1", i), point("M2", i)};
      column.lower_edge = {point("M0", 12 - i), point("M1", 12 - i), point("M2", 12 - i)};
      column.inward = point("M1", std::max(i - 1, 0));
      column.outward = point("M1", i == 0 ? 0 : i + 1);
      column.rest_skin_gap_mm = compute_skin_gap_mm(column, cage.points);
      column.rest_leaning_gap_mm = column.rest_skin_gap_mm + compute_lean_mm(column, cage.points);
      lips.push_back(std::move(column));
    }
  return lips;
}

// Columns 0 to 4 of both sides; further out the cheek hangs on no nose.
std::vector<PhiltrumColumn> build_philtrum(const Cage& cage, const AreaData& data) {
  std::vector<PhiltrumColumn> philtrum;
  for (const bool is_right : {false, true})
    for (int i = is_right ? 1 : 0; i < 5; ++i) {
      const auto point = [&](const std::string& ring) {
        const std::uint32_t p = find_point(cage, fmt::format("{}_{}", ring, i));
        return is_right ? cage.mirror[p] : p;
      };
      PhiltrumColumn column{point("M6"), {}, 0};
      for (const auto& [ring, share] : data.philtrum_rows) column.rows.emplace_back(point(ring), share);
      std::ranges::sort(column.rows, std::greater{}, [](const auto& row) { return row.second; });
      column.rest_gap_mm = cage.points[column.nose].y - cage.points[column.rows.front().first].y;
      philtrum.push_back(std::move(column));
    }
  return philtrum;
}

GiveWay build_give_way(const Cage& cage, const GiveWayData& data) {
  GiveWay give_way{data.from, data.least, data.forward, {}};
  for (const bool is_right : {false, true})
    for (const std::vector<std::string>& names : data.lines) {
      GiveWayLine line;
      for (const std::string& name : names) {
        const std::uint32_t point = find_point(cage, name);
        line.points.push_back(is_right ? cage.mirror[point] : point);
      }
      for (std::size_t i = 1; i < line.points.size(); ++i) {
        const glm::dvec3 way = cage.points[line.points[i]] - cage.points[line.points[i - 1]];
        line.rest_mm.push_back(glm::length(way));
        line.ways.push_back(glm::normalize(way));
      }
      give_way.lines.push_back(std::move(line));
    }
  return give_way;
}

// How far each point goes with a turning head: by row down the neck, all the way above it.
std::vector<double> build_turn_weights(const Cage& cage, const AreaData& data) {
  std::vector<double> weights(cage.points.size(), 1.0);
  for (const auto& [row, share] : data.turn_rows) {
    const std::vector<bool> found = find_points(cage, {"*_" + row});
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i]) weights[i] = share;
  }
  return weights;
}

}  // namespace

void fade_far_side(const Cage& cage, Field& field) {
  constexpr double kFrom_mm = 12,
                   kTo_mm = 22;  // nearer: a crease beside the nose; further: a mouth corner shakes
  for (std::size_t i = 0; i < field.size(); ++i)
    field[i] *= 1 - smooth_step(kFrom_mm, kTo_mm, -cage.points[i].x);
}

FaceUnits measure_face(const Cage& cage, const std::vector<glm::dvec3>& points, const Eye& eye) {
  const auto at = [&](const char* name) { return points[find_point(cage, name)]; };
  return {2 * eye.centre.x, eye.centre.y - at("p_cb").y, at("M6_0").y - at("M1_0").y, 2 * at("M1_6").x,
          0.954 * eye.radius_mm};
}

double get_gain(const DesignNumbers& design, std::string_view area, std::string_view move, int sign) {
  // What is drawn larger is the way up and down: sideways brows and corners have little room.
  // Sunken corners soon meet the chin.
  constexpr double kSideways = 0.35, kFalling = 0.5;
  const double gain = area == "brow"     ? move == "up" && sign > 0 ? design.brow_rise_gain : design.brow_gain
                      : area == "lips"   ? design.lips_gain
                      : area == "corner" ? design.corner_gain
                                         : 1;
  const double share = move == "out" ? kSideways : area == "corner" && sign < 0 ? kFalling : 1;
  return 1 + share * (gain - 1);
}

Face build_face(const NeutralHead& head) {
  const AreaData& data = head.data->areas;
  const Scales scales{measure_face(head.cage, head.cage.points, head.eye),
                      measure_face(head.cage, head.adult_points, head.adult_eye)};
  Face face;
  face.units = scales.here;
  face.doctrines = std::make_shared<DoctrineFields>();
  face.fields = build_fields(head, data, scales);
  face.plus_reach.fill(2);
  face.minus_reach.fill(2);
  for (const auto& [move, reach] : data.past_limits)
    for (const Side side : {Side::none, Side::left, Side::right})
      if (const auto found = find_move(move.area, side, move.move))
        (move.sign > 0 ? face.plus_reach : face.minus_reach)[*found] = reach;
  face.lids = build_lid_rig(head, data.lids);
  face.eye_up_rad = data.eye_up_deg * kRadiansPerDegree;
  face.eye_down_rad = data.eye_down_deg * kRadiansPerDegree;
  face.eye_side_rad = data.eye_side_deg * kRadiansPerDegree;
  face.jaw = build_jaw(head, build_field_solver(head.cage), data, scales);
  face.jaw.axis = carry_point(head, data.jaw.axis);
  face.lips = build_lips(head.cage, data);
  face.philtrum = build_philtrum(head.cage, data);
  face.give_way = build_give_way(head.cage, data.give_way);
  face.red_border = build_red_border(head.cage);
  face.upper_lip = build_lip_sheet(*head.surface, head.cage, true);
  face.lower_lip = build_lip_sheet(*head.surface, head.cage, false);
  face.seal_until_mm = data.seal_until_mm * (scales.here.mouth_nose / scales.adult.mouth_nose);
  const auto reach_mm = [&](const char* limit) {
    const LimitPlace& place = data.limits.at(limit);
    return place.plus_mm * compute_unit_ratio(scales.here, scales.adult, place.unit);
  };
  face.tongue_out_mm = reach_mm("tongue.out");
  face.tongue_up_mm = reach_mm("tongue.up");
  face.turn_pivot = carry_point(head, data.turn_pivot);
  face.turn_weights = build_turn_weights(head.cage, data);
  return face;
}

}  // namespace mien
