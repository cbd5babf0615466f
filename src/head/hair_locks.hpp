// The threads of a cut as geometry: tapered locks, and single hairs along the hairline.
#pragma once

#include "head/hair_strand.hpp"

namespace mien {

inline constexpr int kHairTones = 8;  // of one head of hair, dark to light

// Of a lock's way: where it has come to its width; how late it runs out in its tip, as a power; and how much
// of its width it begins with; till where it comes up strand by strand.
struct LockForm {
  double widens = 0.16, runs_out = 2.2, begins = 0.25, comes_up = 0;
};

// One lock as a ribbon that ends in a point, its normals fanned across as if it were round; its vertices get
// one binding, the seat of the strand's root. `shade` 0..1 of kHairTones. The grain runs along it: u mm
// across, v 0 at the root to 100 at the tip.
void append_lock(HeadPart& part, const HairSeat& seat, const HairStrand& strand, double width_mm,
                 double shade, std::uint32_t index, const LockForm& form = {});

// All locks of the scene, of the left half only if it is mirrored.
void append_locks(HeadPart& part, const HairScene& scene);

// The scalp that shows along the part, in the shade kHairTones, over the mass.
void append_part_line(HeadPart& part, const HairScene& scene);

// A curve hanging from the knot: out, then down; from 0 to 1.
struct TailLine {
  glm::dvec3 start, out;
  double reach_mm = 0, fall_mm = 0;
  glm::dvec3 at(double s) const;
};

// The locks that hang from the knot, of the left half; those that wind round it, all of them: they turn one
// way.
void append_tail(HeadPart& part, const HairScene& scene);
void append_bun(HeadPart& part, const HairScene& scene);

// Single hairs.
void append_down(HeadPart& part, const HairScene& scene);

// Where what grows at a place rides.
const HairSeat& find_seat(const HairScene& scene, const HairPlace& place);

}  // namespace mien
