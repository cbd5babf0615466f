#include "head/hair_locks.hpp"

#include <cmath>
#include <numbers>

#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint32_t kSeries = 43;                          // of scatter()
enum Channel : std::uint32_t { kHeight, kTone, kTip, kTuft };  // of scatter()

}  // namespace

LockPlace find_lock(const HairCut& cut, double turn) {
  // Locks of many widths: the count along the head is bent a little.
  const double bent = turn + 0.45 / cut.locks * std::sin(2 * kPi * (5 * turn + 0.13)) +
                      0.3 / cut.locks * std::sin(2 * kPi * (11 * turn + 0.41));
  const double at = bent * cut.locks, whole = std::floor(at);
  const auto across = [](double share) { return 2 * (share - std::floor(share)) - 1; };
  const auto lock = static_cast<long>(whole) % cut.locks;
  return {static_cast<std::uint32_t>((lock + cut.locks) % cut.locks), across(at - whole),
          across((at - whole) * cut.split)};
}

double round_ridge(double across) { return 1 - std::pow(std::abs(across), 2.4); }

double find_tip_share(const LockPlace& lock) { return scatter(kSeries, lock.lock, kTip); }

double find_thickness_mm(const HairCut& cut, const HairPlace& place, double along) {
  const double turn = std::abs(place.azimuth_deg) / 90;
  std::vector<double> stations;
  for (std::size_t i = 0; i < cut.front_mm.size(); ++i)
    stations.push_back(static_cast<double>(i) / static_cast<double>(cut.front_mm.size() - 1));
  const auto at = [&](const std::vector<double>& table) { return sample_stations(stations, table, along); };
  const double front = std::max(0.0, 1 - turn), back = std::max(0.0, turn - 1);
  return smooth_step(0, 1, front) * at(cut.front_mm) + smooth_step(0, 1, back) * at(cut.back_mm) +
         (1 - smooth_step(0, 1, front) - smooth_step(0, 1, back)) * at(cut.side_mm);
}

Carving carve(const HairCut& cut, double turn, const HairPlace& place) {
  const LockPlace lock = find_lock(cut, turn);
  const double open = smooth_step(0.05, 0.40, place.way);  // grooves crowd at the whorl
  const double ridge = round_ridge(lock.across), fine = round_ridge(lock.split);
  Carving carving;
  carving.height_mm =
      open * (cut.lock_depth_mm * (ridge - 0.7 + 0.6 * (scatter(kSeries, lock.lock, kHeight) - 0.5)) +
              cut.split_depth_mm * (fine - 0.7));
  carving.light = 0.12 + 0.34 * ridge + 0.16 * fine + 0.34 * scatter(kSeries, lock.lock, kTone);
  if (cut.tufts > 0) {
    // Each tuft rises toward its tip and falls off sharply there; neighbours are out of step.
    const double step =
        cut.tufts * place.way + 0.9 * scatter(kSeries, lock.lock, kTuft) + 0.30 * std::abs(lock.across);
    const double rise = step - std::floor(step);
    const double saw = rise < 0.86 ? rise / 0.86 : (1 - rise) / 0.14;
    carving.height_mm += open * cut.tuft_depth_mm * (saw - 0.5);
    carving.light += 0.18 * (saw - 0.5);
  }
  return carving;
}

}  // namespace mien
