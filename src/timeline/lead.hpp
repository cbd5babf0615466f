// Which areas lead on a way from one face to another.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "config/clip_spec.hpp"
#include "core/ticks.hpp"

namespace mien {

// How much later than the first each channel of a track sets out, and arrives so much earlier than the last.
struct Lead {
  std::vector<Ticks> after;  // one a channel; empty: all together
  Ticks widest = 0;          // that of the last to set out
  double most_share = 0.25;  // of a way: nobody is later than that, or a short way would be a jump
  const struct WayKind* kind = nullptr;  // of the ways that it is for; null: of plain ones
};

// A way on which another order than the natural one keeps a mouth from showing what nobody means.
struct WayKind {
  std::string_view what;  // what is seen of it, for `mien explain`
  LeadSpec lead;
  double most_share = 0;
};

// The kind of the way between two faces, as `asked`: null for a plain one, and for all of an order that the
// author gave.
//   to a round open mouth    the corners narrow first, then lips and jaw open: else it grins in between
//   from a round open mouth  lips and jaw shut first, then the corners widen: else it shouts in between
//   from an open smile down  the jaw shuts first, the corners follow, the brows come last: else it cries out
const WayKind* find_way_kind(const LeadSpec& asked, const Pose& from, const Pose& to);

// The lead of a pose's channels, kChannelCount of them, on a way of a kind or, without one, as `asked`.
Lead build_lead(const LeadSpec& asked, const WayKind* kind = nullptr);

// Which of `leads` is that of the way between two faces; it is added if it is the first one of its kind.
std::size_t take_lead(const LeadSpec& asked, const Pose& from, const Pose& to, std::vector<Lead>& leads);

// Which part of `lead` a move belongs to.
LeadPart find_lead_part(std::size_t move);

// The share of a way's time, from `begin` to `end`, that is gone for one who sets out `after` later than the
// first and arrives so much earlier than the last, who sets out `widest` later. Nobody is later than
// `most_share` of the way, and all are there at `end`.
double compute_led_fraction(Ticks begin, Ticks end, Ticks after, Ticks widest, Ticks time,
                            double most_share = 0.25);

}  // namespace mien
