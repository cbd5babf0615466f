// The numbers of a print's formulas: how eyes and mouth are carved, how the base, its label and the hollow
// are built. Each formula is worked twice, by frames/ and print/ for the STL and by OpenSCAD for the source,
// which poses itself; its numbers stand here once, and scene/openscad_numbers.hpp fills them into the source.
// _mm of eyes and mouth are millimetres of the head, all others of the print.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace mien {

// --- Eyes (frames/bust_eyes.cpp, templates/openscad/bust.scad) ---

inline constexpr float kPupilPerIris = 0.5f;  // radius; a smaller bore closes up in print
inline constexpr float kIrisWall =
    0.09f;  // of the iris radius: how far a carved wall leans, a step of the grid
inline constexpr float kEyeSeat_mm = 1;     // from a rim to where the ball's own surface begins
inline constexpr float kLeastSine = 1e-6f;  // of the angle to the gaze: on it there is no direction
// The peg of light hangs from the rim into the pupil, a little to the character's right in both eyes, as one
// lamp would have it. In radii of the iris, y up.
inline constexpr glm::vec2 kLightFrom{-0.16f, 0.34f}, kLightTo{-0.42f, 0.92f};
inline constexpr float kLightSoft = 0.12f;  // from its width to nothing; less is a step that no layer shows

// --- Lens of a drawn head (head/lens.cpp, templates/openscad/lens.scad) ---

// In radii of the ball, from the middle of the eye.
inline constexpr double kLensWide = 0.9, kLensAside = 2.1;     // to the side: all of the stretch, and none
inline constexpr double kLensBehind = -1.2, kLensFront = 0.2;  // in depth: the back of the head stays
inline constexpr double kLensForth = 0.55;                     // what stands further forth is flattened
inline constexpr double kLensFar = 2.2;                        // in height: no further

// --- Mouth (frames/bust_mouth.cpp, templates/openscad/bust.scad) ---

inline constexpr float kDepthPerGap =
    0.9f;  // of the hollow; deeper would be hidden, and hard to clean of support
inline constexpr float kDeepestMouth_mm = 17;           // behind the teeth
inline constexpr float kCrown_mm = 3;                   // from the biting edge to where the front is taken
inline constexpr float kCrownReach_mm = 3 * kCrown_mm;  // so far up the front goes on; then it stands upright
inline constexpr float kLeastCrown_mm = 0.5f;   // of one that an open jaw has turned: its slope stays finite
inline constexpr float kToothEdge_mm = 0.3f;    // half of the height over which a tooth's edge falls off
inline constexpr float kBehindLips_mm = 0.6f;   // teeth do not come through shut lips
inline constexpr float kLipLineFade_mm = 0.3f;  // a gap so wide has the whole line's depth
inline constexpr float kLeastMouthGap_mm = 0.01f;  // what is less divides as if it were this
// Rows of the grid: so many from the upper rim to just above the upper teeth's edge, as many from just below
// the lower teeth's edge to the lower rim, the others between, so that edges are crisp wherever they are.
inline constexpr int kTeethRows = 4;
inline constexpr float kNoUpperTooth = 0.3f, kNoLowerTooth = 0.7f;  // the edges' places where there is none
inline constexpr float kLeastUpperRows = 0.15f, kMostUpperRows = 0.6f;  // of the way down
inline constexpr float kLeastBetweenRows = 0.2f, kMostLowerRows = 0.85f;
inline constexpr float kMostEdgeStep = 0.05f;  // of the way down, from an edge to the next row

// --- Base (print/base.cpp, templates/openscad/base.scad) ---

// A line of the base from top to bottom, at every angle: how far out from the foot's radius to the
// outline's, and how high as a share of the base.
struct ProfilePoint {
  double out = 0, up = 0;
};
inline constexpr std::array kSocle{
    ProfilePoint{0.061, 0.925}, ProfilePoint{0.234, 0.87},  ProfilePoint{0.494, 0.835},  // hollow
    ProfilePoint{0.80, 0.815},  ProfilePoint{0.871, 0.78},                               // torus
    ProfilePoint{0.90, 0.7075}, ProfilePoint{0.871, 0.635}, ProfilePoint{0.80, 0.60},    //
    ProfilePoint{0.97, 0.60},   ProfilePoint{1, 0.57},                                   // drum
    ProfilePoint{1, 0.04},      ProfilePoint{0.96, 0},
};
inline constexpr std::array kBlock{ProfilePoint{0.97, 1}, ProfilePoint{1, 0.96}, ProfilePoint{1, 0.04},
                                   ProfilePoint{0.96, 0}};
// Of the superellipse |x|^n + |y|^n = radius^n: flat within 0.03 mm over the middle 60 % of a side of 30 mm.
inline constexpr double kSquareness = 8;
inline constexpr double kSpread =
    1.12;  // the outline is at least so much wider than the foot, or there is no step
inline constexpr double kPocketRoof_mm =
    0.8;  // two walls of a nozzle's width; thinner, the pocket breaks through

// --- Label (print/glyphs.cpp, print/label_panel.cpp, print/base.cpp, templates/openscad/base.scad) ---

inline constexpr double kCapital = 6;              // units of the letters' grid: how high a capital is
inline constexpr double kLeastPen_mm = 0.8;        // thinner than a nozzle is lost
inline constexpr double kPenShare = 0.16;          // of the size; bolder, and an 8 fills up
inline constexpr double kLetterGap = 0.9;          // units between letters, and
inline constexpr double kLeastLetterGap_mm = 0.5;  // never less: two lines would become one
inline constexpr double kLetterShrink = 0.98;      // from one size that is tried to the next
inline constexpr double kLeastLetter_mm = 3;       // smaller ones run together under the thinnest pen
inline constexpr double kMostLetter_mm = 8;        // unless larger ones are asked for
inline constexpr double kLabelRaise_mm = 0.8;      // smaller, and it is lost between two layers
inline constexpr double kLabelSector =
    0.8;  // of half the breadth: further round nobody reads, and squares turn
inline constexpr double kLabelStep_mm = 0.2;     // of the relief's grid; four points across the thinnest pen
inline constexpr double kMostLabelSteps = 400;   // of a very long label
inline constexpr double kLabelMargin_mm = 0.15;  // of plain wall around the letters
inline constexpr double kLabelFrame = 0.8;       // of the margin: how far the relief goes above and below
inline constexpr double kLabelSlope_mm =
    0.25;  // that the letters' sides take: steep, yet no step of the grid
// The upright front, by the number of its lower ring from the bottom; the label's place.
inline constexpr std::size_t kLabelRing = 2;

// --- Hollow (print/cavity.cpp, templates/openscad/hollow.scad and bust.scad) ---

inline constexpr double kCavityStep_mm = 0.3;  // rows nearer to the floor or the top than this make slivers
inline constexpr double kDrainShare = 0.95;  // of the floor's breadth: the corners of a round drain stand out
inline constexpr double kMagnetLedge_mm = 0.8;  // that holds a magnet under its drain
inline constexpr double kLeastDrain_mm = 1;     // through less nothing runs
// The vent, a tunnel from the drain to the base's back: with the drain alone, which lies on the bed, the
// hollow is a cup that sucks at a resin printer's film.
inline constexpr double kVentShare = 0.8;     // of the drain's width; wider, and it cuts the drain in two
inline constexpr double kVentPlate_mm = 0.8;  // below and above it: two lines of a nozzle
inline constexpr double kVentEdge_mm = 0.3;   // of plain wall above and below its mouth

}  // namespace mien
