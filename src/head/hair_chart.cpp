// Ray against triangle: Moeller and Trumbore, "Fast, minimum storage ray-triangle intersection", 1997.
#include "head/hair_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/conventions.hpp"
#include "core/pool.hpp"
#include "core/smooth.hpp"
#include "head/cage.hpp"
#include "head/lids.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

constexpr int kAzimuths = HairChart::kAzimuths, kWays = HairChart::kWays;
constexpr std::size_t kShare = 1024;  // vertices that a thread takes at a time

HairGround find_ground(std::string_view name) {
  name = strip_side(name);
  const bool is_ear_floor =
      name == "s4_L8" || name == "s4_L9" || name == "s4_L10" || name == "s4_C1" || name == "s4_C2";
  if (is_ear_floor || (name.starts_with("er") && !name.starts_with("er1_"))) return HairGround::ear;
  if (name[0] == 'M' || name[0] == 'E' || name[0] == 'n') return HairGround::face;
  const auto ring = name.find("_N");
  if (ring != name.npos && name[ring + 2] >= '3') return HairGround::body;
  return HairGround::scalp;
}

int wrap(int azimuth) { return ((azimuth % kAzimuths) + kAzimuths) % kAzimuths; }

HairPlace place_of(int azimuth, int way) {
  return {360.0 * azimuth / kAzimuths - 180, HairChart::kLongest * way / (kWays - 1)};
}

std::size_t slot(int azimuth, int way) { return static_cast<std::size_t>(wrap(azimuth) * kWays + way); }

// A triangle that a column's rays may meet, and on which ways.
struct Target {
  std::uint32_t triangle = 0;
  double first_way = 0, last_way = 0;
};

// Those of scalp and ears, in their order.
std::vector<std::vector<Target>> sort_by_azimuth(const NeutralHead& head, const HairChart& chart,
                                                 const std::vector<HairGround>& grounds) {
  constexpr double kMore = 0.06;  // of a way: between its corners a triangle may reach a little further
  std::vector<HairPlace> places(head.skin.positions.size());
  for_each_index(places.size() / kShare + 1, count_workers(), [&](std::size_t share, int) {
    for (std::size_t v = share * kShare; v < std::min(places.size(), (share + 1) * kShare); ++v)
      places[v] = compute_hair_place(chart, glm::dvec3(head.skin.positions[v]));
  });
  std::vector<std::vector<Target>> bins(kAzimuths);
  for (std::uint32_t t = 0; t < head.skin.triangles.size(); ++t) {
    const HairGround ground = grounds[head.skin.triangles[t][0]];
    if (ground != HairGround::scalp && ground != HairGround::ear) continue;
    double low = 1e9, high = -1e9, nearest = 1e9, furthest = -1e9;
    for (const std::uint32_t v : head.skin.triangles[t]) {
      const HairPlace& place = places[v];
      low = std::min(low, place.azimuth_deg);
      high = std::max(high, place.azimuth_deg);
      nearest = std::min(nearest, place.way);
      furthest = std::max(furthest, place.way);
    }
    const bool is_round = high - low > 180;  // across the back
    const bool is_all = nearest < 0.12;      // near the whorl every meridian may meet it
    const double step = 360.0 / kAzimuths;
    const int first = static_cast<int>(std::floor(((is_round ? high : low) + 180) / step)) - 1;
    const int last = static_cast<int>(std::ceil(((is_round ? low + 360 : high) + 180) / step)) + 1;
    for (int i = is_all ? 0 : first; i <= (is_all ? kAzimuths - 1 : std::min(last, first + kAzimuths - 1));
         ++i)
      bins[static_cast<std::size_t>(wrap(i))].push_back({t, is_all ? 0 : nearest - kMore, furthest + kMore});
  }
  return bins;
}

struct Hit {
  double distance_mm = 0;
  HairSeat seat;
};

void meet(const NeutralHead& head, std::uint32_t t, const glm::dvec3& origin, const glm::dvec3& way,
          Hit& hit) {
  const auto& [i, j, k] = head.skin.triangles[t];
  const glm::dvec3 a(head.skin.positions[i]);
  const glm::dvec3 ab = glm::dvec3(head.skin.positions[j]) - a, ac = glm::dvec3(head.skin.positions[k]) - a;
  const glm::dvec3 p = glm::cross(way, ac), s = origin - a;
  const double determinant = glm::dot(ab, p);
  if (std::abs(determinant) < 1e-12) return;
  const double u = glm::dot(s, p) / determinant;
  if (u < -1e-6 || u > 1 + 1e-6) return;
  const glm::dvec3 q = glm::cross(s, ab);
  const double v = glm::dot(way, q) / determinant;
  if (v < -1e-6 || u + v > 1 + 1e-6) return;
  const double distance = glm::dot(ac, q) / determinant;
  if (distance > hit.distance_mm) hit = {distance, {t, glm::vec3(1 - u - v, u, v)}};
}

// What no ray met takes the mean of its neighbours until it settles.
void fill_gaps(std::vector<double>& values, const std::vector<bool>& is_known) {
  constexpr int kRounds = 400;  // the gap behind an ear is 30 places wide
  std::vector<std::pair<int, int>> gaps;
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    for (int way = 0; way < kWays; ++way)
      if (!is_known[slot(azimuth, way)]) gaps.emplace_back(azimuth, way);
  // A value of 0 is unknown, and stands for neighbours beyond the chart's ends too.
  const std::size_t nowhere = values.size();
  values.push_back(0);
  struct Gap {
    std::size_t at = 0;
    std::array<std::size_t, 4> beside{};
  };
  std::vector<Gap> filled;
  for (const auto& [azimuth, way] : gaps)
    filled.push_back(
        {slot(azimuth, way),
         {slot(azimuth - 1, way), slot(azimuth + 1, way), way > 0 ? slot(azimuth, way - 1) : nowhere,
          way + 1 < kWays ? slot(azimuth, way + 1) : nowhere}});
  for (int round = 0; round < kRounds; ++round) {
    bool is_settled = true;
    for (const Gap& gap : filled) {
      double sum = 0, count = 0;
      for (const std::size_t other : gap.beside) {
        sum += values[other];
        count += values[other] != 0 ? 1 : 0;
      }
      if (count == 0) continue;
      const double mean = sum / count;
      is_settled = is_settled && mean == values[gap.at];
      values[gap.at] = mean;
    }
    if (is_settled) break;
  }
  values.pop_back();
}

// Both halves take the mean of both: rays of the two meet other triangles, a rounding apart.
void mirror_values(std::vector<double>& values) {
  for (int azimuth = 1; azimuth < kAzimuths / 2; ++azimuth)
    for (int way = 0; way < kWays; ++way) {
      double &left = values[slot(kAzimuths / 2 + azimuth, way)],
             &right = values[slot(kAzimuths / 2 - azimuth, way)];
      left = right = 0.5 * (left + right);
    }
}

// The seat of the nearest known place up the same meridian.
void fill_seats(std::vector<HairSeat>& seats, const std::vector<bool>& is_known) {
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    for (int way = 1; way < kWays; ++way)
      if (!is_known[slot(azimuth, way)]) seats[slot(azimuth, way)] = seats[slot(azimuth, way - 1)];
}

// What hangs over `values` straight down from where they are broadest, in soft folds: it spans from an ear to
// what is around it.
void drape(std::vector<double>& values) {
  constexpr double kFalls = 0.85;      // the way from which hair falls free
  constexpr int kSpan = 9, kSoft = 7;  // places to either side: 18 and 14 degrees
  std::vector<double> hung = values;
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    for (int way = 1; way < kWays; ++way)
      if (place_of(0, way).way > kFalls)
        hung[slot(azimuth, way)] = std::max(hung[slot(azimuth, way)], hung[slot(azimuth, way - 1)]);
  constexpr double kSlope_mm = 0.55;  // a place: steeper shows the ear's upper edge as a step
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    for (int way = kWays - 2; way > 0; --way)
      hung[slot(azimuth, way)] = std::max(hung[slot(azimuth, way)], hung[slot(azimuth, way + 1)] - kSlope_mm);
  std::vector<double> wide(values.size());
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    for (int way = 0; way < kWays; ++way) {
      double most = 0;
      for (int i = -kSpan; i <= kSpan; ++i) most = std::max(most, hung[slot(azimuth + i, way)]);
      wide[slot(azimuth, way)] = most;
    }
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    for (int way = 0; way < kWays; ++way) {
      double sum = 0;
      for (int i = -kSoft; i <= kSoft; ++i) sum += wide[slot(azimuth + i, way)] / (2 * kSoft + 1);
      const double free = smooth_step(kFalls - 0.5, kFalls + 0.1, place_of(0, way).way);
      double& value = values[slot(azimuth, way)];
      value = std::max(value, glm::mix(value, sum, free));
    }
}

}  // namespace

std::vector<HairGround> list_hair_grounds(const NeutralHead& head) {
  const Surface& surface = *head.surface;
  std::vector<HairGround> by_point, grounds;
  for (const std::string& name : head.cage.names) by_point.push_back(find_ground(name));
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
    std::uint32_t best = surface.first[v];
    for (std::uint32_t k = best; k < surface.first[v + 1]; ++k)
      if (surface.weight[k] > surface.weight[best]) best = k;
    grounds.push_back(by_point[surface.point[best]]);
  }
  return grounds;
}

glm::dvec3 compute_hair_direction(const HairChart& chart, const HairPlace& place) {
  const double turn = place.azimuth_deg * kRadiansPerDegree;
  const glm::dvec3 level(std::sin(turn), 0, std::cos(turn));
  if (place.way >= 1) return level;
  const double angle = std::acos(glm::dot(level, chart.whorl));  // along the great circle
  return (std::sin((1 - place.way) * angle) * chart.whorl + std::sin(place.way * angle) * level) /
         std::sin(angle);
}

glm::dvec3 compute_hair_point(const HairChart& chart, const HairPlace& place, double distance_mm) {
  const double down_mm = std::max(0.0, place.way - 1) * chart.drop_mm;
  return chart.centre - glm::dvec3(0, down_mm, 0) + distance_mm * compute_hair_direction(chart, place);
}

HairPlace compute_hair_place(const HairChart& chart, const glm::dvec3& point) {
  const glm::dvec3 arm = point - chart.centre;
  const glm::dvec3 level =
      arm.y <= 0 ? glm::dvec3(arm.x, 0, arm.z) : arm - chart.whorl * (arm.y / chart.whorl.y);
  HairPlace place;
  place.azimuth_deg = std::atan2(level.x, level.z) / kRadiansPerDegree;
  if (arm.y <= 0) {
    place.way = 1 - arm.y / chart.drop_mm;
    return place;
  }
  const double length = glm::length(level);
  if (length < 1e-9) return {0, 0};
  const double whole = std::acos(glm::dot(level / length, chart.whorl));
  place.way = std::acos(std::clamp(glm::dot(glm::normalize(arm), chart.whorl), -1.0, 1.0)) / whole;
  return place;
}

double sample_hair_chart(const HairChart&, const std::vector<double>& values, const HairPlace& place) {
  const double a = (place.azimuth_deg + 180) * kAzimuths / 360;
  const double w = std::clamp(place.way / HairChart::kLongest, 0.0, 1.0) * (kWays - 1);
  const int i = static_cast<int>(std::floor(a)), j = std::min(static_cast<int>(w), kWays - 2);
  const double s = a - i, t = w - j;
  return glm::mix(glm::mix(values[slot(i, j)], values[slot(i + 1, j)], s),
                  glm::mix(values[slot(i, j + 1)], values[slot(i + 1, j + 1)], s), t);
}

const HairSeat& find_hair_seat(const HairChart& chart, const HairPlace& place) {
  const auto azimuth = static_cast<int>(std::lround((place.azimuth_deg + 180) * kAzimuths / 360));
  const auto way = static_cast<int>(std::lround(place.way / HairChart::kLongest * (kWays - 1)));
  return chart.seats[slot(azimuth, std::clamp(way, 0, kWays - 1))];
}

HairChart build_hair_chart(const NeutralHead& head, double whorl_deg, double centre_mm) {
  HairChart chart;
  const glm::dvec3 front(find_named_point(head, "p_F2")), back(find_named_point(head, "s9_F2"));
  const glm::dvec3 side(find_named_point(head, "s4_F1"));
  constexpr double kAdultSide_mm = 75;
  chart.size = side.x / kAdultSide_mm;
  chart.centre = {0, side.y - centre_mm * chart.size, 0.5 * (front.z + back.z)};
  chart.whorl = {0, std::cos(whorl_deg * kRadiansPerDegree), -std::sin(whorl_deg * kRadiansPerDegree)};
  chart.drop_mm *= chart.size;

  const std::vector<HairGround> grounds = list_hair_grounds(head);
  const auto bins = sort_by_azimuth(head, chart, grounds);
  const std::size_t count = static_cast<std::size_t>(kAzimuths) * kWays;
  chart.skin_mm.assign(count, 0);
  chart.cover_mm.assign(count, 0);
  chart.seats.resize(count);
  for_each_index(kAzimuths, count_workers(), [&](std::size_t azimuth, int) {
    struct Ray {
      double way = 0;
      glm::dvec3 origin{0}, out{0};
      Hit scalp, ear;
    };
    std::array<Ray, kWays> rays;
    for (int way = 0; way < kWays; ++way) {
      const HairPlace place = place_of(static_cast<int>(azimuth), way);
      rays[static_cast<std::size_t>(way)] = {
          place.way, compute_hair_point(chart, place, 0), compute_hair_direction(chart, place), {}, {}};
    }
    for (const auto& [t, first_way, last_way] : bins[azimuth]) {
      const bool is_ear = grounds[head.skin.triangles[t][0]] == HairGround::ear;
      auto ray = std::ranges::lower_bound(rays, first_way, {}, &Ray::way);
      for (; ray != rays.end() && ray->way <= last_way; ++ray)
        meet(head, t, ray->origin, ray->out, is_ear ? ray->ear : ray->scalp);
    }
    for (int way = 0; way < kWays; ++way) {
      const Ray& ray = rays[static_cast<std::size_t>(way)];
      const std::size_t at = slot(static_cast<int>(azimuth), way);
      chart.skin_mm[at] = ray.scalp.distance_mm;
      chart.cover_mm[at] = ray.ear.distance_mm;
      chart.seats[at] = ray.scalp.seat;
    }
  });
  std::vector<bool> is_known(count);
  for (std::size_t i = 0; i < count; ++i) is_known[i] = chart.skin_mm[i] > 0;
  fill_gaps(chart.skin_mm, is_known);
  fill_seats(chart.seats, is_known);
  for (std::size_t i = 0; i < count; ++i) chart.cover_mm[i] = std::max(chart.cover_mm[i], chart.skin_mm[i]);
  drape(chart.cover_mm);
  for (std::vector<double>* values : {&chart.skin_mm, &chart.cover_mm}) mirror_values(*values);
  return chart;
}

}  // namespace mien
