// Where drawn hair ends: its edge, which is cut into a few pointed locks.
#pragma once

#include "head/hair_growth.hpp"

namespace mien {

// The same azimuth within -180..180 degrees.
double wrap_azimuth(double turn_deg);

// Where hair that falls goes from the forehead down beside the face: from there, and there it is as long as
// it gets; nothing where it does not.
struct Fall {
  double from_deg = 0, to_deg = 0;
  bool is_there = false;
};
Fall find_fall(const HairScene& scene);

// A lock of the mass's edge: where it begins, has its tip and ends, in degrees from the front on over the
// character's left ear, a whole turn from the first on; how far its tip goes below where it parts from those
// beside it, mm of the adult; and how far its tip is bent aside, degrees.
struct DrawnLock {
  double from_deg = 0, tip_deg = 0, to_deg = 0;
  double from_mm = 0, to_mm = 0, bent_deg = 0;
};

// All around the head, each from where the one before it ends; none where the cut has none in ink.
std::vector<DrawnLock> list_drawn_locks(const HairScene& scene);

// Where the mass ends along one meridian.
struct DrawnEdge {
  double turn_deg = 0, way = 0;  // as above
  double bent_deg = 0;           // there, of the lock
  double lifts = 0;              // 0: it ends on the skin .. 1: it hangs over what is under it
};

// In the order of their degrees: every tip, every place where locks part, and what is between them.
std::vector<DrawnEdge> trace_drawn_edge(const HairScene& scene);

}  // namespace mien
