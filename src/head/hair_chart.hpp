// The head as hair sees it: how far out its skin lies in each direction, without ears and face.
#pragma once

#include <vector>

#include "head/head.hpp"

namespace mien {

// Strands run from the whorl down a meridian. `azimuth_deg` -180..180 tells which: 0 to the front, 90 over
// the character's left ear. `way` is 0 at the whorl and 1 at the height of the centre, and goes on
// straight down below it.
struct HairPlace {
  double azimuth_deg = 0, way = 0;
};

// A place of the skin that hair rides on.
struct HairSeat {
  std::uint32_t triangle = 0;
  glm::vec3 barycentric{1, 0, 0};
};

struct HairChart {
  glm::dvec3 centre{0};       // of the skull, mm
  glm::dvec3 whorl{0, 1, 0};  // from the centre, unit
  double drop_mm = 120;       // height of one `way` below the centre
  double size = 1;            // of this skull against the adult's
  // On a grid of kAzimuths x kWays:
  std::vector<double> skin_mm;   // distance of the skin; where ear or face is, what fits around them
  std::vector<double> cover_mm;  // the same over the ears
  std::vector<HairSeat> seats;

  static constexpr int kAzimuths = 180, kWays = 118;  // 2.5 mm apart
  static constexpr double kLongest = 2.6;             // the last way: down to the shoulders
};

// What a vertex of the skin is to hair: hair grows on the scalp and falls over ears and shoulders.
enum class HairGround { scalp, ear, face, body };
std::vector<HairGround> list_hair_grounds(const NeutralHead& head);

// `whorl_deg`: how far behind the top of the head strands begin. `centre_mm`: how far below the height of the
// broadest skull the centre lies, on the adult.
HairChart build_hair_chart(const NeutralHead& head, double whorl_deg, double centre_mm);

// Where a point of space is on the chart.
HairPlace compute_hair_place(const HairChart& chart, const glm::dvec3& point);

// The point `distance_mm` from the chart's axis in a place's direction, and that direction.
glm::dvec3 compute_hair_point(const HairChart& chart, const HairPlace& place, double distance_mm);
glm::dvec3 compute_hair_direction(const HairChart& chart, const HairPlace& place);

// `values` (skin_mm or cover_mm) between the grid's places, smoothly.
double sample_hair_chart(const HairChart& chart, const std::vector<double>& values, const HairPlace& place);

const HairSeat& find_hair_seat(const HairChart& chart, const HairPlace& place);

}  // namespace mien
