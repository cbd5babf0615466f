#include "scene/openscad_numbers.hpp"

#include <fmt/format.h>

#include <span>

#include "core/print_numbers.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

// Decimals enough for all of them; a float's own error is behind these.
constexpr int kDecimals = 6;

std::string number(double value) { return format_number(value, kDecimals); }

// A length of the head in the template's words, in which `mm` is one of the head's.
std::string of_head(double value_mm) {
  return value_mm == 1 ? "mm" : fmt::format("{} * mm", number(value_mm));
}

std::string pair(const glm::vec2& p) { return fmt::format("{}, {}", number(p.x), number(p.y)); }

std::string list_profile(std::span<const ProfilePoint> profile) {
  constexpr std::size_t kPerLine = 6;
  std::string text;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (i > 0) text += i % kPerLine == 0 ? ",\n              " : ", ";
    text += fmt::format("[{}, {}]", number(profile[i].out), number(profile[i].up));
  }
  return text;
}

}  // namespace

ScadValues list_scad_base() {
  return {{"socle", list_profile(kSocle)},
          {"block", list_profile(kBlock)},
          {"squareness", number(kSquareness)},
          {"spread", number(kSpread)},
          {"capital", number(kCapital)},
          {"least_pen", number(kLeastPen_mm)},
          {"pen_share", number(kPenShare)},
          {"letter_gap", number(kLetterGap)},
          {"least_letter_gap", number(kLeastLetterGap_mm)},
          {"letter_shrink", number(kLetterShrink)},
          {"least_letter", number(kLeastLetter_mm)},
          {"most_letter", number(kMostLetter_mm)},
          {"narrowest_letter", number(kLeastPen_mm + kLeastLetterGap_mm)},
          {"label_sector", number(kLabelSector)},
          {"label_margin", number(kLabelMargin_mm)},
          {"label_frame", number(kLabelFrame)},
          {"label_slope", number(kLabelSlope_mm)},
          {"most_label_steps", number(kMostLabelSteps)}};
}

ScadValues list_scad_hollow() {
  return {{"cavity_step", number(kCavityStep_mm)}, {"label_ring", number(static_cast<double>(kLabelRing))},
          {"vent_share", number(kVentShare)},      {"vent_plate", number(kVentPlate_mm)},
          {"vent_edge", number(kVentEdge_mm)},     {"magnet_ledge", number(kMagnetLedge_mm)},
          {"least_drain", number(kLeastDrain_mm)}};
}

ScadValues list_scad_carving() {
  return {{"label_step", number(kLabelStep_mm)},
          {"label_raise", number(kLabelRaise_mm)},
          {"label_ring", number(static_cast<double>(kLabelRing))},
          {"pocket_roof", number(kPocketRoof_mm)},
          {"drain_share", number(2 * kDrainShare)},  // of the radius
          {"magnet_ledges", number(2 * kMagnetLedge_mm)},
          {"least_drain", number(kLeastDrain_mm)},
          {"light_from", pair(kLightFrom)},
          {"light_along", pair(kLightTo - kLightFrom)},
          {"light_soft", number(kLightSoft)},
          {"iris_wall", number(kIrisWall)},
          {"iris_inside", number(1 - kIrisWall)},
          {"iris_outside", number(1 + kIrisWall)},
          {"pupil_inside", number(kPupilPerIris - kIrisWall)},
          {"pupil_outside", number(kPupilPerIris + kIrisWall)},
          {"eye_seat", of_head(kEyeSeat_mm)},
          {"least_sine", number(kLeastSine)},
          {"least_crown", of_head(kLeastCrown_mm)},
          {"crown_reach", of_head(kCrownReach_mm)},
          {"tooth_edge", of_head(kToothEdge_mm)},
          {"least_mouth_gap", of_head(kLeastMouthGap_mm)},
          {"no_upper_tooth", number(kNoUpperTooth)},
          {"no_lower_tooth", number(kNoLowerTooth)},
          {"least_upper_rows", number(kLeastUpperRows)},
          {"most_upper_rows", number(kMostUpperRows)},
          {"least_between_rows", number(kLeastBetweenRows)},
          {"most_lower_rows", number(kMostLowerRows)},
          {"most_edge_step", number(kMostEdgeStep)},
          {"teeth_rows", number(kTeethRows)},
          {"first_between_row", number(kTeethRows + 1)},
          {"edge_rows", number(2 * kTeethRows + 2)},
          {"lip_line_fade", of_head(kLipLineFade_mm)},
          {"depth_per_gap", number(kDepthPerGap)},
          {"deepest_mouth", of_head(kDeepestMouth_mm)},
          {"behind_lips", of_head(kBehindLips_mm)}};
}

ScadValues list_scad_lens(const BustLens& lens) {
  return {{"lens_middle",
           fmt::format("[{}, {}, {}]", number(lens.middle.x), number(lens.middle.y), number(lens.middle.z))},
          {"lens_radius", number(lens.radius_mm)},
          {"lens_taller", number(lens.taller)},
          {"lens_full", number(lens.full)},
          {"lens_end", number(lens.end)},
          {"lens_flat", number(lens.flat)},
          {"lens_wide", number(kLensWide)},
          {"lens_aside", number(kLensAside)},
          {"lens_behind", number(kLensBehind)},
          {"lens_front", number(kLensFront)},
          {"lens_forth", number(kLensForth)},
          {"lens_far", number(kLensFar)}};
}

}  // namespace mien
