// What ink makes of a figure once: its parts, their materials, and what lines are drawn of.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/smooth.hpp"
#include "frames/ink.hpp"
#include "frames/ink_hair.hpp"
#include "frames/ink_parts.hpp"
#include "frames/ink_regions.hpp"
#include "frames/ink_strokes.hpp"
#include "head/cage.hpp"

namespace mien {

namespace {

void list_neighbours(const FineSkin& fine, Ink& ink) {
  std::vector<std::vector<std::uint32_t>> around(fine.vertex_count());
  for (const Triangle& t : fine.triangles)
    for (int i = 0; i < 3; ++i) {
      around[t[i]].push_back(t[(i + 1) % 3]);
      around[t[i]].push_back(t[(i + 2) % 3]);
    }
  ink.first.push_back(0);
  for (std::vector<std::uint32_t>& all : around) {
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    ink.around.insert(ink.around.end(), all.begin(), all.end());
    ink.first.push_back(static_cast<std::uint32_t>(ink.around.size()));
  }
}

// Where a chin is lit and where a throat is dark.
void measure_shades(const Cage& cage, const std::vector<glm::vec3>& positions, Ink& ink) {
  // A chin that is pushed up would be swallowed by its shade.
  constexpr float kChin_mm = 6, kBesideChin_mm = 16;
  // Seen from below, the shade under a chin is one band along the jaw: what a lamp casts there is a lobe.
  constexpr float kUnder_mm = 12, kBesideUnder_mm = 20;
  std::vector<glm::vec3> chin, under;
  const auto add = [&](const std::string& point, std::vector<glm::vec3>& places) {
    const std::uint32_t left = find_point(cage, point);
    for (const std::uint32_t v : {left, cage.mirror[left]}) places.push_back(positions[v]);
  };
  for (const char* point : {"M6_12", "M6_11", "M6_10"}) add(point, chin);
  for (const char* column : {"m12", "m11", "m10", "m9", "m8", "q12", "q11", "q10", "s1", "s2", "s3", "s4"})
    for (const char* row : {"N0", "N1"}) add(fmt::format("{}_{}", column, row), under);
  const auto measure = [&](const std::vector<glm::vec3>& places, const glm::vec3& at, float whole_mm,
                           float none_mm) {
    float least_mm = 2 * none_mm;
    for (const glm::vec3& place : places) least_mm = std::min(least_mm, glm::distance(place, at));
    return 1 - smooth_step(whole_mm, none_mm, least_mm / ink.eye_size);
  };
  for (const glm::vec3& p : positions) {
    ink.chin.push_back(measure(chin, p, kChin_mm, kBesideChin_mm));
    ink.throat.push_back(measure(under, p, kUnder_mm, kBesideUnder_mm));
  }
}

// None in mouth and nostrils, none at the margins of lids and lips, which have strokes, and none on the lids,
// the bags beneath them and where the cheek meets the nose: in profile they would leave ticks above and below
// the eye, and a line from there to the mouth.
void measure_hull(const Figure& figure, const std::vector<bool>& is_opening,
                  const std::vector<glm::vec3>& positions, Ink& ink) {
  constexpr float kNone_mm = 0.5f, kAll_mm = 5;
  constexpr float kCheekNone_mm = 6, kCheekAll_mm = 11;
  const FineSkin& fine = figure.folds.skin;
  std::vector<glm::vec3> margins, cheeks, lips, slit;
  const auto add = [&](const char* point, std::vector<glm::vec3>& places) {
    const std::uint32_t left = find_point(figure.head.cage, point);
    for (const std::uint32_t v : {left, figure.head.cage.mirror[left]}) places.push_back(positions[v]);
  };
  for (std::size_t i = 0; i < figure.head.cage.names.size(); ++i)
    for (const auto& [ring, places] :
         {std::pair{"E0_", &margins}, {"E1_", &margins}, {"M0_", &slit}, {"M1_", &slit}, {"M2_", &lips}})
      if (has_prefix(figure.head.cage.names[i], ring)) places->push_back(positions[i]);
  lips.insert(lips.end(), slit.begin(), slit.end());
  for (const char* point : {"E2_6",  "E2_7",  "E2_8",  "E2_9",  "E3_6",  "E3_7",  "E3_8",  "E3_9",  "E2_1",
                            "E2_2",  "E2_3",  "E2_4",  "E2_5",  "E2_10", "E2_11", "E2_12", "E2_13", "E2_14",
                            "E3_1",  "E3_2",  "E3_3",  "E3_4",  "E3_5",  "E3_10", "E3_11", "E3_12", "E3_13",
                            "E3_14", "E4_10", "E4_11", "E4_12", "E4_13", "E4_14", "E5_11", "E5_12", "E5_13"})
    add(point, margins);
  // In an ear hulls leave crumbs of its many small folds, and before it where the cheek goes over into it:
  // strokes draw it.
  constexpr float kEarNone_mm = 2.5f, kEarAll_mm = 4.5f;
  std::vector<glm::vec3> ears;
  const auto is_lobe = [](std::string_view name) {
    for (const char* end : {"r7_6", "r7_7", "r7_8", "r7_9", "r8_6", "r8_7", "r8_8", "r8_9"})
      if (name.ends_with(end)) return true;
    return false;
  };
  for (std::size_t i = 0; i < figure.head.cage.names.size(); ++i)
    for (const char* ring : {"er7_", "er8_", "er9_", "er10_", "er11_"})
      if (has_prefix(figure.head.cage.names[i], ring) && !is_lobe(figure.head.cage.names[i]))
        ears.push_back(positions[i]);
  for (const char* ring : {"er1", "er2", "er3", "er4", "er5", "er6"})
    for (const char* place : {"12", "13", "14", "15"}) add(fmt::format("{}_{}", ring, place).c_str(), ears);
  for (const char* point :
       {"E5_12", "E5_13", "E5_14", "q13_C1", "q13_C2", "q13_C3", "q13_C4", "q12_C4", "M6_5"})
    add(point, cheeks);
  // In profile the bag below the eye ends before the nose: a line there looks like a tear. Neither is there a
  // thread where the lid goes over into the brow, nor behind the corner of an open mouth.
  constexpr float kBagNone_mm = 12, kBagAll_mm = 20;
  std::vector<glm::vec3> bags;
  for (const char* point :
       {"E3_12", "E3_13", "E3_14", "E3_15", "E4_12", "E4_13", "E4_14", "E4_15", "E5_13", "E5_14", "E5_15",
        "E4_1",  "E4_2",  "E4_3",  "E4_4",  "E4_5",  "E5_2",  "E5_3",  "E5_4",  "E5_5",  "M3_6",  "M3_7",
        "M3_8",  "M4_6",  "M4_7",  "M4_8",  "M5_5",  "M5_6",  "M5_7",  "M6_6",  "M6_7"})
    add(point, bags);
  // But the middle of the face is its outline there, lips and the nose's bridge as well.
  constexpr float kMiddle_mm = 3, kBesideMiddle_mm = 7, kSeamNone_mm = 0.5f, kSeamAll_mm = 2.5f;
  std::vector<glm::vec3> seam;
  for (const char* point : {"M0_0", "M0_12", "M1_0", "M1_12"}) add(point, seam);
  // A short neck's crease would be a row of dashes, and so would a cheekbone that is seen from below.
  constexpr float kThroat_mm = 12, kBelowThroat_mm = 20, kBone_mm = 7, kBesideBone_mm = 11;
  std::vector<glm::vec3> throat, bones;
  for (const char* point : {"m12_N0", "m10_N0", "m12_N1", "m10_N1"}) add(point, throat);
  for (const char* point : {"E5_9", "E5_10", "q10_C1", "s1_L9", "s1_L10", "s1_C1"}) add(point, bones);
  // Nor do a nostril's rims have one where they are no outline of the nose: ticks about the hole.
  constexpr float kNostrilNone_mm = 2, kNostrilAll_mm = 5;
  std::vector<glm::vec3> nostrils;
  for (std::size_t i = 0; i < figure.head.cage.names.size(); ++i)
    if (has_prefix(figure.head.cage.names[i], "nr_")) nostrils.push_back(positions[i]);
  // About the corner of a mouth the outline of a far cheek would have a gap.
  constexpr float kEnd_mm = 5, kBesideEnd_mm = 10;
  std::vector<glm::vec3> ends;
  for (const char* point : {"M2_6", "M3_6", "M4_6", "M5_6", "M6_5", "M6_6"}) add(point, ends);
  // Seen from below a button of a nose would have a caret on it.
  constexpr float kButton_mm = 10, kBesideButton_mm = 16;
  const bool is_button = measure_nose_mm(figure) < kButtonNose_mm;
  const glm::vec3 tip = positions[find_point(figure.head.cage, "p_tip")];
  const std::uint32_t outer = find_point(figure.head.cage, "E3_8");
  ink.sides = {outer, figure.head.cage.mirror[outer]};
  const auto measure = [](const std::vector<glm::vec3>& places, const glm::vec3& at, float most) {
    for (const glm::vec3& place : places) most = std::min(most, glm::distance(place, at));
    return most;
  };
  for (std::size_t v = 0; v < fine.vertex_count(); ++v) {
    const float margin = measure(margins, positions[v], 2 * kAll_mm) / ink.eye_size;
    const float cheek = measure(cheeks, positions[v], 2 * kCheekAll_mm) / ink.eye_size;
    const float nostril = measure(nostrils, positions[v], 2 * kNostrilAll_mm) / ink.eye_size;
    const float ear = measure(ears, positions[v], 2 * kEarAll_mm) / ink.eye_size;
    const float bag = measure(bags, positions[v], 2 * kBagAll_mm) / ink.eye_size;
    const float neck = measure(throat, positions[v], 2 * kBelowThroat_mm) / ink.eye_size;
    const float bone = measure(bones, positions[v], 2 * kBesideBone_mm) / ink.eye_size;
    ink.folded.push_back(1 - smooth_step(kThroat_mm, kBelowThroat_mm, neck) *
                                 smooth_step(kBone_mm, kBesideBone_mm, bone));
    const float mouth = measure(slit, positions[v], 2 * kSeamAll_mm) / ink.eye_size;
    ink.beside_mouth.push_back(
        smooth_step(kSeamNone_mm, kSeamAll_mm, mouth) *
        (1 -
         smooth_step(kEnd_mm, kBesideEnd_mm, measure(ends, positions[v], 2 * kBesideEnd_mm) / ink.eye_size)));
    const float from_tip = glm::distance(tip, positions[v]) / ink.eye_size;
    ink.button.push_back(is_button ? 1 - smooth_step(kButton_mm, kBesideButton_mm, from_tip) : 0);
    const float lip = measure(lips, positions[v], 2 * kAll_mm) / ink.eye_size;
    const float beside_mouth = smooth_step(kNone_mm, kAll_mm, margin) *
                               smooth_step(kCheekNone_mm, kCheekAll_mm, cheek) *
                               smooth_step(kEarNone_mm, kEarAll_mm, ear);
    const float off_lips = beside_mouth * smooth_step(kNone_mm, kAll_mm, lip);
    ink.off_strokes.push_back(off_lips);
    ink.hull_faced.push_back(off_lips * smooth_step(kNostrilNone_mm, kNostrilAll_mm, nostril));
    ink.hull_turned.push_back(beside_mouth * smooth_step(kSeamNone_mm, kSeamAll_mm, mouth));
    const float middle =
        (1 - smooth_step(kMiddle_mm, kBesideMiddle_mm, std::abs(positions[v].x) / ink.eye_size)) *
        smooth_step(kSeamNone_mm, kSeamAll_mm, measure(seam, positions[v], 2 * kSeamAll_mm) / ink.eye_size);
    ink.hull_beside.push_back(std::max(middle, off_lips * smooth_step(kBagNone_mm, kBagAll_mm, bag)));
  }
  for (const Triangle& t : fine.triangles)
    if (!is_opening[t[0]] && !is_opening[t[1]] && !is_opening[t[2]]) ink.hull_triangles.push_back(t);
}

Part make_outline(const std::string& name, const InkColours& colours) {
  Part part = make_flat_part(name + "_outline", "ink_line", colours.line);
  part.is_outline = true;
  return part;
}

// The skin's shadow is that of a skin below it: near the border of its tones facets would cast theirs on
// their neighbours, and a raised cheek a dot on itself. In thin ears it would come out on the other side.
// Lips, the mouth and what is about the eyes cast none: it would be crumbs about them. At the nostrils, whose
// rims would be crumbs as well, it lies deeper: with a hole there, the nose's shadow would end as raggedly as
// its triangles do.
Part make_caster(const Figure& figure, const std::vector<bool>& is_opening,
                 const std::vector<glm::vec3>& positions, Ink& ink) {
  constexpr float kLips_mm = 7, kBridge_mm = 9, kEye_mm = 5, kBelowEye_mm = 8;
  constexpr float kThin_mm = 0.9f, kBelow_mm = 3.5f, kNostril_mm = 8;
  constexpr float kDeep = 0.7f, kNose = 2;  // of how far the nose's tip stands out over the lip
  constexpr float kLeastNose_mm = 14;
  constexpr float kBeside_mm = 5, kEar_mm = 6;
  // In profile a cheek that a laugh has raised would cast a dot beside the mouth's corner.
  constexpr float kPad_mm = 9, kPadWhole_mm = 14, kPadNone_mm = 26;
  std::vector<std::pair<glm::vec3, float>> places;
  std::vector<glm::vec3> nostrils, ears;
  for (std::size_t i = 0; i < figure.head.cage.names.size(); ++i) {
    const std::string_view name = figure.head.cage.names[i];
    for (const auto& [ring, reach_mm] : {std::pair{"M0_", kLips_mm},
                                         {"M1_", kLips_mm},
                                         {"M2_", kLips_mm},
                                         {"M3_", kLips_mm},
                                         {"E3_", kEye_mm},
                                         {"E4_", kEye_mm},
                                         {"E5_", kEye_mm},
                                         {"q12_C1", kBelowEye_mm},
                                         {"q13_C1", kBelowEye_mm}})
      if (has_prefix(name, ring)) places.emplace_back(positions[i], reach_mm);
    if (is_bridge(name.starts_with("R:") ? name.substr(2) : name))
      places.emplace_back(positions[i], kBridge_mm);
    if (has_prefix(name, "er")) ears.push_back(positions[i]);
    if (has_prefix(name, "nr_") || has_prefix(name, "ni_")) nostrils.push_back(positions[i]);
  }
  // The longer a nose is, the deeper and the farther around, or its shadow would run into the lips.
  const auto find = [&](const char* name) { return positions[find_point(figure.head.cage, name)]; };
  const glm::vec3 corner = find("M5_6");
  const float stands_mm = measure_nose_mm(figure);
  const float nose_mm = std::max(kLeastNose_mm, kNose * stands_mm);
  // A button of a nose casts none either: what there is of it would be a chip beside a nostril.
  if (stands_mm < kButtonNose_mm) {
    places.emplace_back(find("p_tip"), nose_mm);
    for (const glm::vec3& place : nostrils) places.emplace_back(place, nose_mm);
  }
  std::vector<bool> is_none;
  for (std::size_t v = 0; v < figure.head.skin.positions.size(); ++v) {
    float away_mm = nose_mm;
    for (const glm::vec3& place : nostrils) away_mm = std::min(away_mm, glm::distance(place, positions[v]));
    is_none.push_back((is_opening[v] && away_mm > kNostril_mm) ||
                      std::ranges::any_of(places, [&](const auto& place) {
                        return glm::distance(place.first, positions[v]) < place.second;
                      }));
    const bool is_ear = std::ranges::any_of(
        ears, [&](const glm::vec3& place) { return glm::distance(place, positions[v]) < kEar_mm; });
    const float below_mm = is_ear ? kThin_mm
                                  : std::lerp(std::max(kBelow_mm, kDeep * stands_mm), kBelow_mm,
                                              smooth_step(kNostril_mm, nose_mm, away_mm));
    ink.below_mm.push_back(ink.eye_size * below_mm);
    const glm::vec3 mirrored(std::abs(positions[v].x), positions[v].y, positions[v].z);
    const float beside_mm =
        std::lerp(kPad_mm, kBeside_mm,
                  smooth_step(kPadWhole_mm, kPadNone_mm, glm::distance(mirrored, corner) / ink.eye_size));
    ink.below_beside_mm.push_back(ink.eye_size * (is_ear ? below_mm : std::max(below_mm, beside_mm)));
  }
  Part part = make_flat_part("shadow", "ink_caster", glm::vec3(0));
  part.rest.positions.resize(figure.head.skin.positions.size());
  for (const Triangle& t : figure.head.skin.triangles)
    if (!is_none[t[0]] || !is_none[t[1]] || !is_none[t[2]]) part.rest.triangles.push_back(t);
  return part;
}

void find_mouth(const Figure& figure, Ink& ink) {
  ink.teeth = find_model_part(ink.model, "teeth_upper");
  ink.tongue = find_model_part(ink.model, "tongue");
  ink.lower = {find_model_part(ink.model, "teeth_lower"), find_model_part(ink.model, "gum_lower")};
  ink.gum = find_model_part(ink.model, "gum_upper");
  ink.bones = {ink.teeth, ink.gum, ink.lower[0], ink.lower[1]};
  ink.veil = find_model_part(ink.model, "lip_veil");
  const Box box = compute_bounds(ink.model.parts[ink.teeth].rest.positions);
  constexpr float kLeast_mm = 7, kOver = 0.5f;
  ink.teeth_high_mm = std::max(box.high.y - box.low.y, kLeast_mm * ink.eye_size);
  ink.taper_over_mm = kOver * ink.teeth_high_mm;
  ink.teeth_top_mm = box.high.y;
  ink.teeth_end_mm = box.low.y;
  for (const std::size_t part : {ink.teeth, ink.gum})
    taper_row(glm::mat3(1), ink.taper_over_mm, ink.model.parts[part].rest.positions);
  const Cage& cage = figure.head.cage;
  ink.lips = {find_point(cage, "M1_0"), find_point(cage, "M1_12")};
  ink.corners = {find_point(cage, "M1_6"), cage.mirror[find_point(cage, "M1_6")]};
  constexpr int kLipPoints = 12;  // of the left half's edge from the upper lip's middle to the lower one's
  for (int i = 0; i <= kLipPoints; ++i) ink.mouth_ring.push_back(find_point(cage, fmt::format("M1_{}", i)));
  for (int i = kLipPoints - 1; i > 0; --i)
    ink.mouth_ring.push_back(cage.mirror[ink.mouth_ring[static_cast<std::size_t>(i)]]);
}

void find_eyes(const Figure& figure, Ink& ink) {
  const Cage& cage = figure.head.cage;
  ink.lids[0] = {find_point(cage, "E1_4"), find_point(cage, "E1_12")};
  ink.lids[1] = {cage.mirror[ink.lids[0][0]], cage.mirror[ink.lids[0][1]]};
  ink.whites = {find_model_part(ink.model, "eye_left"), find_model_part(ink.model, "eye_right")};
  for (std::size_t i = 0; i < ink.model.parts.size(); ++i)
    for (const char* name : {"eye_", "iris_", "pupil_"})
      if (ink.model.parts[i].name.starts_with(name)) ink.balls.push_back(i);
}

void add_strokes(const Figure& figure, const HeadSpec& spec, const InkColours& colours, Ink& ink) {
  Part lines = make_flat_part("lines", "ink_line", colours.line);
  Part brows = make_flat_part("brow_strokes", "ink_line", 0.8f * spec.look.brow);
  ink.strokes = list_strokes(figure, spec, ink.folds);
  const auto cut = figure.head.data->hair.cuts.find(figure.hair);
  if (cut != figure.head.data->hair.cuts.end() && cut->second.covers_ears)
    std::erase_if(ink.strokes, [](const InkStroke& stroke) {
      return std::string_view(stroke.rule.name).starts_with("ear_");
    });
  for (const InkStroke& stroke : ink.strokes) {
    Mesh& mesh = (stroke.rule.is_brow ? brows : lines).rest;
    for (const Triangle& t : list_stroke_triangles(static_cast<std::uint32_t>(mesh.positions.size())))
      mesh.triangles.push_back(t);
    mesh.positions.resize(mesh.positions.size() + kStrokeVertices);
  }
  // The last of the lines is the cornea's.
  for (const Triangle& t : list_stroke_triangles(static_cast<std::uint32_t>(lines.rest.positions.size())))
    lines.rest.triangles.push_back(t);
  lines.rest.positions.resize(lines.rest.positions.size() + kStrokeVertices);
  ink.model.parts.push_back(std::move(lines));
  ink.model.parts.push_back(std::move(brows));
}

// Lines on hair are darker hair, not the face's line.
void add_hair_strokes(const Figure& figure, const InkColours& colours, Ink& ink) {
  constexpr float kHair = 0.3f, kLine = 0.45f;
  const auto mass = std::ranges::find(figure.model.parts, "hair_mass", &Part::name);
  if (mass == figure.model.parts.end()) return;
  const std::vector<glm::vec3> bowls = list_ear_bowls(figure.head);
  std::vector<InkStroke> strokes = list_hair_strokes(figure.head, figure.hair, mass->rest);
  if (strokes.empty()) return;
  const glm::vec3 hair = ink.model.parts[find_model_part(ink.model, "hair_mass")].palette.front().srgb;
  Part part = make_flat_part("hair_lines", "ink_line", glm::mix(kHair * hair, colours.line, kLine));
  for (InkStroke& stroke : strokes) {
    const auto is_hidden = [&](const StrokePoint& point) {
      glm::vec3 place(0);
      for (int k = 0; k < 3; ++k) place += point.shares[k] * mass->rest.positions[point.vertices[k]];
      return is_in_ear(bowls, place, ink.eye_size);
    };
    std::erase_if(stroke.points, is_hidden);
    if (stroke.points.size() < 2) continue;
    const auto first = static_cast<std::uint32_t>(part.rest.positions.size());
    for (const Triangle& t : list_hair_line_triangles(first)) part.rest.triangles.push_back(t);
    part.rest.positions.resize(first + std::size_t{2} * kHairLineSteps);
    ink.strokes.push_back(stroke);
  }
  ink.model.parts.push_back(std::move(part));
}

}  // namespace

Ink build_ink(const Figure& figure, const HeadSpec& spec, const InkColours& colours) {
  Ink ink;
  ink.eye_size = static_cast<float>(figure.head.eye.radius_mm / figure.head.adult_eye.radius_mm);
  ink.model = figure.model;
  set_materials(spec.look, colours, ink);
  Part& skin = ink.model.parts.front();
  const std::vector<glm::vec3> positions = skin.rest.positions;
  InkRegions regions = cut_regions(figure, spec, colours, positions);
  skin.material = "ink_skin";
  skin.palette = std::move(regions.palette);
  skin.shade.clear();
  skin.triangle_shade = std::move(regions.shade);
  skin.rest.triangles = std::move(regions.triangles);
  ink.cuts = std::move(regions.cuts);
  for (const auto& [from, to, share] : ink.cuts)
    skin.rest.positions.push_back(glm::mix(skin.rest.positions[from], skin.rest.positions[to], share));
  skin.rest.normals.resize(skin.rest.positions.size(), glm::vec3(0, 0, 1));
  list_neighbours(figure.folds.skin, ink);
  find_eyes(figure, ink);
  find_mouth(figure, ink);
  measure_hull(figure, regions.is_opening, positions, ink);
  measure_shades(figure.head.cage, positions, ink);
  ink.cheek = std::move(regions.cheek);
  ink.lower_cheek = std::move(regions.lower_cheek);
  ink.flush_places = std::move(regions.flush_places);
  ink.flush = regions.flush;
  hide_ears(figure, ink);
  clear_ears(figure, ink);
  ink.tone = build_ink_tone(figure);
  ink.limits = figure.limits;
  ink.data = figure.head.data;
  ink.redraw = figure.redraw;
  ink.caster = ink.model.parts.size();
  ink.model.parts.push_back(make_caster(figure, regions.is_opening, positions, ink));
  ink.sheet = ink.model.parts.size();
  ink.model.parts.push_back(make_mouth_sheet(figure, colours, ink));
  ink.mouth_edge = ink.model.parts.size();
  ink.model.parts.push_back(make_mouth_edge(colours));
  ink.tooth_strip = ink.model.parts.size();
  ink.model.parts.push_back(make_tooth_strip(figure, colours, ink));
  ink.first_outline = ink.model.parts.size();
  std::vector<Part> outlines{make_outline("skin", colours)};
  for (std::size_t i = 1; i < ink.model.parts.size(); ++i)
    if (ink.model.parts[i].material == "ink_hair") {
      outlines.push_back(make_outline(ink.model.parts[i].name, colours));
      ink.outlined.push_back(i);
      ink.before.push_back(measure_before(ink.model.parts[i].rest.positions));
    }
  for (Part& outline : outlines) ink.model.parts.push_back(std::move(outline));
  add_strokes(figure, spec, colours, ink);
  add_hair_strokes(figure, colours, ink);
  return ink;
}

}  // namespace mien
