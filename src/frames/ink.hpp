// A figure drawn in ink: its skin in flat regions with crisp borders, outlines where it turns away, and
// strokes along lashes, lids, brows and lips.
//
// Outlines are hulls: the surface pushed out by a line's width, of which only what faces away from the camera
// is drawn, so that it shows beyond the edge of the surface and nowhere else. Strokes are flat tubes that
// ride on the skin, their widths a profile along them. Widths are shares of the picture, whatever its size
// and however near the camera.
#pragma once

#include <array>
#include <vector>

#include "core/model.hpp"
#include "core/staging.hpp"
#include "frames/figure.hpp"
#include "frames/ink_regions.hpp"
#include "frames/ink_strokes.hpp"
#include "frames/ink_tone.hpp"

namespace mien {

// Built once for a figure of FigureUse::ink.
struct Ink {
  Model model;                               // the figure's parts, then outlines, then strokes
  std::vector<CutVertex> cuts;               // behind the skin's own vertices
  std::vector<std::uint32_t> first, around;  // the neighbours of the skin's own vertices
  std::vector<float> off_strokes;            // of each vertex of the skin: 0 where strokes are its outline
  std::vector<float> hull_faced;             // of them: how thick the outline is where the face is seen
  std::vector<float> hull_turned;            // and where lips and nose are seen against the ground
  std::vector<float> hull_beside;            // and where the head is seen from the side
  std::vector<float> folded;                 // 1: there it has none where the head is seen from before
  std::vector<float> button;                 // 1: there it has none where the head is seen from below
  std::vector<float> beside_mouth;       // 1: about its corners, which on the far side are the head's edge
  std::vector<float> chin;               // 1: there it is lit unless the head is seen from the side or below
  std::vector<float> throat;             // 1: there it is dark where the head is seen from below
  std::array<std::uint32_t, 2> sides{};  // vertices of the skin at the head's left and right
  std::vector<Triangle> hull_triangles;  // of the cut skin, those that have one
  InkTonePointer tone;
  std::size_t caster = 0;              // in `model`: what the skin's shadow is cast by
  std::vector<float> below_mm;         // of each of its vertices: how deep it lies in the skin
  std::vector<float> below_beside_mm;  // and where the head is seen from the side or below
  std::size_t first_outline =
      0;  // in `model`: the skin's, then those of `outlined`, then the two of strokes and that of hair
  std::array<std::size_t, 2> whites{};  // in `model`: of the left and the right eye
  std::vector<std::size_t> balls;       // in `model`: they and what is drawn on them
  std::size_t sheet = 0;                // in `model`: what is dark between open lips in profile
  std::vector<std::uint32_t>
      sheet_points;             // vertices of the skin that it lies through, upper and lower in turn
  std::size_t mouth_edge = 0;   // in `model`: the line before it
  std::size_t tooth_strip = 0;  // in `model`: the teeth that are seen in profile, or the tongue
  bool is_toothless = false;    // as an infant's mouth is drawn
  bool hides_ears = false;      // its hair does
  std::vector<std::uint32_t> strip_points;  // vertices of the skin that it hangs from or stands on
  // Of the skin's vertices: how far it lies farther back in profile, and seen from below, 0..1.
  std::vector<float> cheek, lower_cheek;
  std::vector<glm::vec3> flush_places;         // of them: where in the blush they lie, see InkRegions
  float flush = 0;                             // how red that is, 0..1
  std::size_t teeth = 0, gum = 0, tongue = 0;  // in `model`; the upper teeth and their gum
  std::array<std::size_t, 2> lower{};          // in `model`: the lower teeth and their gum
  std::vector<std::size_t> bones;              // in `model`: all teeth and gums
  std::size_t veil = 0;                        // in `model`: what hangs behind the slit of shut lips
  // How high the upper teeth are, or would be in an infant, and where at rest they begin and end.
  float teeth_high_mm = 0, teeth_top_mm = 0, teeth_end_mm = 0;
  float taper_over_mm = 0;              // so far above their top the ends of the row go
  std::array<std::uint32_t, 2> lips{};  // vertices of the skin: the middle of the upper and of the lower one
  std::array<std::uint32_t, 2> corners{};              // and where they meet
  std::vector<std::uint32_t> mouth_ring;               // the lips' edge, once round
  std::array<std::array<std::uint32_t, 2>, 2> lids{};  // the middles of each eye's upper and lower lid
  std::vector<std::size_t> outlined;       // parts of the figure besides the skin that have outlines
  std::vector<std::vector<float>> before;  // of each of them, of its vertices: how far it is drawn over skin
  std::vector<InkStroke> strokes;          // those on hair last
  std::vector<FoldField> folds;            // that strokes are drawn of, without their vertices
  LimitShares limits;
  HeadDataPointer data;  // what muscles and units fold
  Redraw redraw;
  float eye_size = 1;  // of the ball against an adult's
};

// `spec` is that of the figure, its look as it is at its age.
Ink build_ink(const Figure& figure, const HeadSpec& spec, const InkColours& colours = {});

struct InkView {
  glm::dvec3 camera_mm{0, 0, 900};
  glm::dvec3 to_light{0, 0, 1};  // of length 1
  double line_mm = 1;            // at the head
};

// The buffers of one thread; contents mean nothing between calls.
struct InkBuffers {
  std::vector<glm::vec3> soft, tones, turn;
  InkToneBuffers tone;
  std::vector<std::uint32_t> used;
  std::vector<float> thick;  // of the skin's hull, of each vertex, 0..1
};

// Makes the drawing of the figure in a pose into one of ink.model, where it stands in the world.
void draw_ink(const Ink& ink, const Pose& pose, const InkView& view, InkBuffers& buffers, Drawing& drawing);

}  // namespace mien
