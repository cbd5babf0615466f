// The words, units and frames of reference that every file of mien uses.
//
// Names     snake_case functions and variables, UpperCamel types, kConstants. A function begins with its
// verb:
//           load_ (file to value)      build_ (values to a bigger value)  sample_ (value at a time)
//           compute_, measure_ (a number or a place from values)          list_ (several, in order)
//           find_ (looks up by name or place: may be absent, and is empty or an error then)
//           deform_ (pose to shape)    append_ (onto a text)              write_ (to a file)
//           read_, parse_ (part of a text to value)                       check_ (throws or adds mistakes)
//           describe_, format_ (value to words)                           report_ (to who runs the program)
//           is_, has_ (a yes or no)
// Units     A number that has a unit wears it: _mm _s _deg _px. Without a suffix it is a fraction or a count.
// Space     Right-handed, millimetres: x to the character's left, y up, z forward (out of the face).
//           Origin: the mid-plane, at pupil height, at the depth of the ear canals.
// Sides     left and right are the character's own, never the viewer's.
// Winding   Triangles and quads run counter-clockwise seen from outside. A writer whose format wants it
//           otherwise turns them round itself.
// Time      Seconds from the start of the clip; frame k of a clip shows the time k / fps.
// Words     vertex (of a mesh), point (of the cage), landmark, guide line, area, move, pose, key, in-between,
//           easing, drawing (one deformed head), ledger (who hit a limit).
#pragma once

#include <numbers>

namespace mien {

inline constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

// One Loomis unit on the average adult: hairline to brow line, brow line to nose base, nose base to chin.
inline constexpr double kLoomisUnit_mm = 66.0;

}  // namespace mien
