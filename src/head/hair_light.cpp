#include "head/hair_light.hpp"

#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

// A strand down which light runs, on a curve that ends in a point: some far and most a little. Strands are
// told apart by their degrees alone.
struct LightStrand {
  double from_deg = 0, tip_deg = 0, to_deg = 0;
  double length = 0;  // 0..1
};

std::vector<LightStrand> list_light_strands() {
  constexpr std::uint32_t kStrandSeries = 62;
  constexpr double kNarrow_deg = 13, kMore_deg = 18, kOff = 0.28, kLast_deg = 348, kShortest = 0.35,
                   kFewLong = 1.4;
  std::vector<LightStrand> strands;
  for (double from_deg = 0; from_deg < kLast_deg;) {
    const auto index = static_cast<std::uint32_t>(strands.size());
    const double wide_deg = kNarrow_deg + kMore_deg * step_golden(index + 1), end_deg = from_deg + wide_deg;
    const double to_deg = end_deg > kLast_deg ? 360 : end_deg;
    const double off = kOff * (2 * scatter(kStrandSeries, index, 1) - 1);
    const double long_one = scatter(kStrandSeries, index, 0);
    strands.push_back({from_deg, std::lerp(from_deg, to_deg, 0.5 + off), to_deg,
                       kShortest + (1 - kShortest) * std::pow(long_one, kFewLong)});
    from_deg = to_deg;
  }
  return strands;
}

// How far light runs down at a turn, 0..1.
double sample_light_strands(const std::vector<LightStrand>& strands, double turn_deg) {
  constexpr double kHollow = 1.7;  // a power; 1: straight as a tooth
  const double turn = turn_deg - 360 * std::floor(turn_deg / 360);
  for (const LightStrand& strand : strands) {
    if (turn > strand.to_deg) continue;
    const double share = turn < strand.tip_deg ? (turn - strand.from_deg) / (strand.tip_deg - strand.from_deg)
                                               : (strand.to_deg - turn) / (strand.to_deg - strand.tip_deg);
    return strand.length * std::pow(std::max(0.0, share), kHollow);
  }
  return 0;
}

}  // namespace

std::vector<LightBand> trace_light(const HairScene& scene, const std::vector<DrawnEdge>& edges,
                                   const std::function<double(const HairPlace&)>& compute_up) {
  constexpr double kUp = 0.64, kLeast = 0.12, kAbove = 0.93;  // how far up it looks; ways
  constexpr double kThin_mm = 0.6, kThick_mm = 9, kStrand_mm = 22;
  constexpr double kSwells = 3, kFaster = 2;  // times around the head
  // Two waves about a mean, of how thick it gets, and where they begin; what runs down a strand where it is
  // thin.
  constexpr double kMean = 0.5, kSlow = 0.3, kQuick = 0.2, kSlow_rad = 0.7, kQuick_rad = 2.1,
                   kLeastRun = 0.35;
  const double way_of_mm = scene.chart.size / scene.chart.drop_mm;
  const std::vector<LightStrand> strands = list_light_strands();
  std::vector<LightBand> bands;
  for (const DrawnEdge& edge : edges) {
    const double azimuth = wrap_azimuth(edge.turn_deg), turn = edge.turn_deg * kRadiansPerDegree;
    double high = 0, low = std::min(1.0, edge.way);
    for (int i = 0; i < 24; ++i) {
      const double middle = 0.5 * (high + low);
      (compute_up({azimuth, middle}) > kUp ? high : low) = middle;
    }
    const double most = kAbove * edge.way;
    const bool is_there = high > kLeast;
    const double swell = kMean + kSlow * std::cos(kSwells * turn + kSlow_rad) +
                         kQuick * std::cos((kSwells + kFaster) * turn + kQuick_rad);
    const double thick = way_of_mm * (kThin_mm + kThick_mm * swell);
    const double runs = way_of_mm * kStrand_mm * std::lerp(kLeastRun, 1.0, swell) *
                        sample_light_strands(strands, edge.turn_deg);
    const double begins = std::max(kLeast * 0.5, high - 0.5 * thick);
    const double ends = std::min(most, high + 0.5 * thick + runs);
    bands.push_back({std::min(begins, 0.95 * ends), ends, is_there});
    if (!is_there) bands.back() = {0.5 * most, 0.55 * most, false};
  }
  return bands;
}

}  // namespace mien
