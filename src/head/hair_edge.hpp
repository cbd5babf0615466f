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
// character's left ear, a whole turn from the first on; how far each of the three is above the border that
// its cut has, mm of the adult; how far its tip is bent aside, degrees, and which way it leans, -1..1: its
// outline is full on one side and hollow on the other.
struct DrawnLock {
  double from_deg = 0, tip_deg = 0, to_deg = 0;
  double from_mm = 0, tip_mm = 0, to_mm = 0;
  double bent_deg = 0, lean = 0;
};

// All around the head, each from where the one before it ends; none where the cut has none in ink.
std::vector<DrawnLock> list_drawn_locks(const HairScene& scene);

// Where the mass ends along one meridian.
struct DrawnEdge {
  double turn_deg = 0, way = 0;  // as above
  double bent_deg = 0;           // there, of the lock
  double lifts = 0;              // 0: it ends on the skin .. 1: it hangs over what is under it
  double across = 0;             // of its lock: -1 where it begins, 0 at its tip .. 1 where it ends
  double deep_mm = 0;            // how deep the lock is parted from the one on that side, mm of the adult
  std::size_t lock = 0;
};

// In the order of their degrees: every tip, every place where locks part, and what is between them.
std::vector<DrawnEdge> trace_drawn_edge(const HairScene& scene);

}  // namespace mien
