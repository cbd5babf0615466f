// Distances between landmarks on the skin of the neutral head, beside people's: Farkas, "Anthropometry of the
// Head and Face" (1994), and ANSUR II (Gordon et al. 2014) where it has them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/data.hpp"
#include "frames/figure.hpp"
#include "head/landmarks.hpp"
#include "shipped.hpp"

namespace mien {

using Places = std::map<std::string, glm::dvec3>;

inline Places measure(const HeadSpec& spec) {
  const Figure figure = build_figure(shipped().heads, spec);
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(figure, Pose{}, TurnKey{}, buffers, drawing);
  return measure_landmarks(figure.head, find_landmarks(figure.head), figure.model, drawing);
}

inline double between(const Places& p, const std::string& a, const std::string& b) {
  return glm::distance(p.at(a), p.at(b));
}
inline double across(const Places& p, const std::string& pair) {
  return between(p, pair + "_l", pair + "_r");
}
inline double head_height(const Places& p) { return p.at("v").y - p.at("gn").y; }

struct Distance {
  const char* name;
  double ours_mm;
  double man_mm, man_sd, woman_mm, woman_sd;
};

inline std::vector<Distance> list_distances(const Places& p) {
  return {{"g-op", between(p, "g", "op"), 199.5, 7.0, 189.8, 7.4},
          {"eu-eu", across(p, "eu"), 154.3, 5.5, 147.8, 5.2},
          {"zy-zy", across(p, "zy"), 142.6, 6.2, 133.8, 5.6},
          {"go-go, on the skin", across(p, "go"), 120.4, 10.4, 110.1, 8.9},
          {"v-gn", head_height(p), 232, 9, 218, 10},
          {"n-gn", between(p, "n", "gn"), 122.6, 6.7, 113.1, 6.1},
          {"t-v, upright", p.at("v").y - p.at("t_l").y, 131.1, 6.2, 126.5, 6.5},
          {"pupils", across(p, "pupil"), 64.0, 3.4, 61.7, 3.6},
          {"sa-sba", between(p, "sa_l", "sba_l"), 64.2, 4.5, 59.4, 3.9},
          {"tr-n", between(p, "tr", "n"), 67, 7, 63, 6},
          {"n-sn", between(p, "n", "sn"), 54.8, 3.3, 50.6, 3.1},
          {"sn-gn", between(p, "sn", "gn"), 72.6, 4.5, 64.3, 4.0},
          {"sn-prn", between(p, "sn", "prn"), 19.5, 1.9, 19.7, 1.6},
          {"al-al", across(p, "al"), 34.9, 2.1, 31.4, 2.0},
          {"en-en", across(p, "en"), 33.3, 2.7, 31.8, 2.3},
          {"ex-ex", across(p, "ex"), 91.2, 3.0, 87.8, 3.2},
          {"en-ex", between(p, "en_l", "ex_l"), 31.3, 1.2, 30.7, 1.2},
          {"lid aperture", between(p, "lid_upper_l", "lid_lower_l"), 10.8, 0.9, 11.1, 1.2},
          {"ch-ch", across(p, "ch"), 54.5, 3.0, 50.2, 3.5},
          {"sn-sto", between(p, "sn", "sto"), 22.3, 2.1, 20.1, 2.0},
          {"sn-ls", between(p, "sn", "ls"), 15.9, 2.3, 13.8, 1.9},
          {"ls-sto", between(p, "ls", "sto"), 8.0, 1.4, 8.7, 1.3},
          {"sto-li", between(p, "sto", "li"), 9.3, 1.6, 9.4, 1.5},
          {"sto-sl", between(p, "sto", "sl"), 19.7, 1.9, 17.8, 1.7}};
}

}  // namespace mien
