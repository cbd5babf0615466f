// Overlap of areas after Thomas and Johnston, "The Illusion of Life" (1981), "follow through and overlapping
// action"; a mouth that narrows before it opens after Blair, "Advanced Animation" (1949), dialogue.
#include "timeline/lead.hpp"

#include <algorithm>
#include <array>

namespace mien {

namespace {

constexpr WayKind kRounds{"the corners narrow before the mouth opens", build_lead_spec(&AreaLead::rounds_s),
                          0.34};
constexpr WayKind kUnrounds{"the mouth shuts before the corners widen",
                            build_lead_spec(&AreaLead::unrounds_s), 0.34};
constexpr WayKind kFalls{"the jaw shuts before the corners fall, the brows come last",
                         build_lead_spec(&AreaLead::falls_s), 0.4};

// What it takes to be of a kind, as shares of the limits. Below them both orders look alike.
constexpr double kNarrower = 0.25, kRound = -0.15;  // corners go in by so much, and to there
constexpr double kOpener = 0.1;                     // more of the mouth opens or shuts
constexpr double kLower = 0.4, kSmiling = 0.3;      // corners fall by so much, from there

constexpr std::size_t find_one(Area area, Side side, std::string_view move) {
  return *find_move(area, side, move);
}

double compute_corners(const Pose& pose, std::string_view move) {
  return (pose.values[find_one(Area::corner, Side::left, move)] +
          pose.values[find_one(Area::corner, Side::right, move)]) /
         2;
}

// How far a mouth is open, as a share of the jaw's way: lips at their limits open a third as far.
double compute_opening(const Pose& pose) {
  constexpr std::size_t kDown = find_one(Area::chin, Side::none, "down"),
                        kUpper = find_one(Area::lips, Side::none, "upper"),
                        kLowerLip = find_one(Area::lips, Side::none, "lower");
  constexpr double kLips = 1.0 / 6;  // of each
  return std::max(pose.values[kDown] + kLips * (pose.values[kUpper] - pose.values[kLowerLip]), 0.0);
}

}  // namespace

const WayKind* find_way_kind(const LeadSpec& asked, const Pose& from, const Pose& to) {
  if (!asked.suits_shapes) return nullptr;
  const double wider = compute_corners(to, "out") - compute_corners(from, "out");
  const double opens = compute_opening(to) - compute_opening(from);
  if (wider <= -kNarrower && compute_corners(to, "out") <= kRound && opens >= kOpener) return &kRounds;
  if (wider >= kNarrower && compute_corners(from, "out") <= kRound && opens <= -kOpener) return &kUnrounds;
  const bool is_smile = compute_corners(from, "up") >= kSmiling;
  if (is_smile && compute_corners(from, "up") - compute_corners(to, "up") >= kLower && opens <= -kOpener)
    return &kFalls;
  return nullptr;
}

Lead build_lead(const LeadSpec& asked, const WayKind* kind) {
  const LeadSpec& spec = kind != nullptr ? kind->lead : asked;
  Lead lead;
  for (std::size_t i = 0; i < kChannelCount; ++i)
    lead.after.push_back(compute_ticks(spec.after_s[static_cast<std::size_t>(find_lead_part(i))]));
  lead.widest = compute_ticks(std::ranges::max(spec.after_s));
  if (kind != nullptr) lead.most_share = kind->most_share;
  lead.kind = kind;
  return lead;
}

std::size_t take_lead(const LeadSpec& asked, const Pose& from, const Pose& to, std::vector<Lead>& leads) {
  const WayKind* kind = find_way_kind(asked, from, to);
  const auto found =
      std::ranges::find_if(leads, [&](const Lead& lead) { return !lead.after.empty() && lead.kind == kind; });
  const auto at = static_cast<std::size_t>(found - leads.begin());
  if (found == leads.end()) leads.push_back(build_lead(asked, kind));
  return at;
}

LeadPart find_lead_part(std::size_t move) { return find_area(kChannels[move].of).lead.part; }

double compute_led_fraction(Ticks begin, Ticks end, Ticks after, Ticks widest, Ticks time,
                            double most_share) {
  const Ticks length = end - begin;
  if (time >= end) return 1;
  if (length <= 0 || time <= begin) return 0;
  double out = static_cast<double>(after), early = static_cast<double>(widest - after);
  const double most = most_share * static_cast<double>(length);
  if (static_cast<double>(widest) > most) {
    out *= most / static_cast<double>(widest);
    early *= most / static_cast<double>(widest);
  }
  const double fraction =
      (static_cast<double>(time - begin) - out) / (static_cast<double>(length) - out - early);
  return std::clamp(fraction, 0.0, 1.0);
}

}  // namespace mien
