// Numbers in time that formulas use by a name: a ramp or a curve through points, or a column of a table, as
// an input device recorded it.
// Source: the input variables of em, Hanrahan and Sturman, "Interactive animation of parametric models", The
// Visual Computer 1 (1985), as Yen, "Animation of Human Faces" (1990) tells them in section 2.3.2.
#pragma once

#include <memory>
#include <vector>

#include "config/clip_spec.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

struct ClipClock;

struct Series {
  std::vector<double> at_s, values;  // by rising time, one at least
  Between between = Between::linear;
  std::vector<double> slopes = {};  // a second, at each point, of a curve; else empty
  double start_s = 0;               // of the clip's time, where its own begins
};

// Its number at a time of the clip: the first one's before it, the last one's after it.
double sample_series(const Series& series, double time_s);

// `{csv: joystick.csv, column: joyz}` or `{points: [{at: 0s, value: 0}, {at: 1s, value: 1}]}` of an input.
// Empty, with mistakes told, if it is wrong.
std::shared_ptr<const Series> load_series(const YamlValue& value, const ClipClock& clock);

}  // namespace mien
