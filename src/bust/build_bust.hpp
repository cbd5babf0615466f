// From a figure to prints: bodies, bases, hollows and reports joined.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "config/spec.hpp"
#include "core/print.hpp"
#include "frames/bust_controls.hpp"
#include "frames/figure.hpp"
#include "print/glyphs.hpp"
#include "print/report.hpp"
#include "scene/three_mf.hpp"

namespace mien {

// A bust ready to be written.
struct MadeBust {
  std::string stem;    // of its files: "bust_laugh"
  PosableBust source;  // for OpenSCAD
  Mesh mesh;           // the whole print, closed
  PrintReport report;
  std::vector<ColourRange> colours;  // skin, eyes, mouth
};

// What busts of one head share, so that the second one of a size takes little time.
struct BustCache {
  const Figure& figure;
  std::vector<NamedPose> menu;  // the expressions that a source can show
  std::string title;
  Letters letters;  // for labels

  // Bodies by all that they depend on.
  struct Body {
    BustSize size;
    BustBody body;
    PosableBust source;
    Mesh surfaces;                               // of all poses: what a cavity keeps away from
    std::map<double, CavityPlan> cavities = {};  // by the wall asked for
  };
  std::deque<Body> bodies = {};
};

// The expressions of a source's menu: those of the busts, then the file's own and its library's. Of several
// with one name and unlike poses (of two libraries, or weaker), later busts' are called "anger_2", and the
// library's "mien/anger".
std::vector<NamedPose> list_bust_menu(const Spec& spec, const std::vector<BustSpec>& busts);

// All busts on plates, a mesh for each plate. Throws RunError "print 3 of 120 x 90 mm does not fit a plate of
// 100 x 100 mm".
std::vector<Mesh> build_plates(const std::vector<Mesh>& busts, const glm::dvec2& plate_mm);

// "Its hair is not printed: hair is finer than any nozzle." of a head with hair that its bust does not wear
// or a beard, as the report of each of its busts says; empty for others.
std::string describe_unprinted_hair(const Model& model, bool wears_hair);

// One bust. Throws RunError "a wall of 30 mm leaves nothing to hollow" and
// the like.
MadeBust make_bust(BustCache& cache, const BustSpec& bust);

}  // namespace mien
