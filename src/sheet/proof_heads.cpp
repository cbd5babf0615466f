// Figures of heads: skulls on their outlines, ages on their guide lines, one age on its way to another.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/smooth.hpp"
#include "core/text.hpp"
#include "head/shapes.hpp"
#include "sheet/camera.hpp"
#include "sheet/head_pictures.hpp"
#include "sheet/plans.hpp"
#include "sheet/proof.hpp"
#include "sheet/wire_head.hpp"
#include "wire/slice.hpp"

namespace mien {

namespace {

constexpr PictureSize kProofPicture{300, 360};
constexpr PictureSize kGrowthPicture{150, 180};
constexpr double kUnitsOfAHead = 3.5;  // Loomis: chin to crown

HeadSpec build_spec(const std::string& age, const std::string& skull) {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  spec.skull = {{skull, 1.0}};
  return spec;
}

// A head at rest with all that its pictures need.
struct RestingHead {
  Figure figure;
  Drawing drawing;
  HeadMeasures measures;
};

RestingHead build_resting(const Resources& resources, const HeadSpec& spec) {
  RestingHead head{build_figure(resources.heads, spec), {}, {}};
  DeformBuffers buffers;
  deform_figure(head.figure, {}, {}, buffers, head.drawing);
  head.measures = measure_head(head.figure);
  return head;
}

CameraView find_proof_view(const HeadMeasures& own, const HeadMeasures& scale, double angle_deg) {
  SheetCell cell;
  cell.angle_deg = angle_deg;
  return compute_cell_view(cell, own, scale);
}

std::string draw_lines(const WireModel& model, const CameraView& view, const Templates& templates, int jobs) {
  const WireCamera camera = build_wire_camera(view, kProofPicture);
  return build_png(build_paper_pixels(draw_head_lines(model, camera, jobs), find_letters(templates)));
}

// Half of the head's width at a height, mm.
double measure_half_width_mm(const WireSolid& skin, double y_mm) {
  double half_mm = 0;
  for (const WireLine& line : slice_solid(skin, {0, 1, 0}, y_mm, Pen::guide))
    for (const glm::vec3& p : line.points) half_mm = std::max(half_mm, static_cast<double>(std::abs(p.x)));
  return half_mm;
}

// Where the average's outline is to go for a skull: widths and heights of templates/head/heads.yaml.
glm::dvec2 draw_outline_point(const Warp& warp, const glm::dvec2& p) {
  constexpr double kFeatures_mm = 20, kSkull_mm = 62;  // as that file says
  const double outer = smooth_step(kFeatures_mm, kSkull_mm, p.x);
  return {p.x * std::lerp(sample_curve(warp.inner, p.y), sample_curve(warp.outer, p.y), outer),
          sample_curve(warp.height, p.y, true)};
}

}  // namespace

Proof prove_skull(const Resources& resources, const std::string& number, const std::string& skull, int jobs) {
  Proof proof{number,
              fmt::format("The {} head", skull),
              "The shape of the skull decides most of how a person looks: the head that is computed has the "
              "outline that was drawn for it.",
              "",
              false,
              {}};
  const RestingHead average = build_resting(resources, build_spec(kAdult, "average"));
  const RestingHead head = build_resting(resources, build_spec(kAdult, skull));
  const Warp& warp = resources.stock.head->shapes.heads.warps.at(skull);
  WireModel plain, model;
  append_wire_head(average.figure, {}, {}, plain);
  append_wire_head(head.figure, {}, {}, model);

  // Ears are not of the outline: heights above and below them.
  const auto guides =
      measure_guides(head.figure.head.cage, {average.figure.head.cage.points, average.figure.head.eye});
  const double chin_mm = average.measures.chin_mm(), tall_mm = average.measures.height_mm();
  const std::array<std::array<double, 2>, 2> zones{
      {{0.05, guides.at("ear_base") - 0.03}, {guides.at("ear_top") + 0.03, 0.95}}};
  constexpr int kHeightsAZone = 20;
  double sum_mm = 0, most_mm = 0, other_mm = 0;
  int count = 0;
  for (const auto& [low, high] : zones) {
    WireLine left{{}, Pen::limit, true}, right = left;
    for (int i = 0; i <= kHeightsAZone; ++i) {
      const double y_mm = chin_mm + tall_mm * std::lerp(low, high, static_cast<double>(i) / kHeightsAZone);
      const double average_mm = measure_half_width_mm(plain.solids.front(), y_mm);
      const glm::dvec2 drawn = draw_outline_point(warp, {average_mm, y_mm});
      const double half_mm = measure_half_width_mm(model.solids.front(), drawn.y);
      const double off_mm = std::abs(half_mm - drawn.x);
      sum_mm += off_mm;
      most_mm = std::max(most_mm, off_mm);
      other_mm = std::max(other_mm, std::abs(half_mm - measure_half_width_mm(plain.solids.front(), drawn.y)));
      ++count;
      left.points.emplace_back(drawn.x, drawn.y, 0);
      right.points.emplace_back(-drawn.x, drawn.y, 0);
    }
    model.lines.push_back(left);
    model.lines.push_back(right);
  }
  const double unit_mm = tall_mm / kUnitsOfAHead;
  proof.is_met = most_mm < kOutline_units * unit_mm && other_mm > kOutline_units * unit_mm;
  proof.verdict = fmt::format(
      "At {} heights the mesh is {:.1f} mm from the drawn outline on average, {:.1f} mm at most, which is "
      "{:.3f} "
      "units (at most {} wanted); the average head's outline is up to {:.1f} mm away.",
      count, sum_mm / count, most_mm, most_mm / unit_mm, kOutline_units, other_mm);
  HeadStage stage = build_head_stage(kProofPicture, resources.stock.templates);
  const CameraView front = find_proof_view(head.measures, average.measures, 0);
  proof.pictures = {
      {"the mesh, and in blue the drawn outline", draw_lines(model, front, resources.stock.templates, jobs)},
      {"front", build_png(sketch_head(stage, front, head.figure.model, head.drawing))},
      {"three-quarter", build_png(sketch_head(stage, find_proof_view(head.measures, average.measures, 35),
                                              head.figure.model, head.drawing))}};
  return proof;
}

Proof prove_guides(const Resources& resources, const std::string& number, const std::string& age, int jobs) {
  Proof proof{
      number,
      fmt::format("The guide lines of the {}", age),
      "Guide lines stay valid when they are moved: the head of this age lies on the lines of its chart.",
      "",
      false,
      {}};
  const RestingHead head = build_resting(resources, build_spec(age, "average"));
  const GuideChart& chart = resources.stock.head->shapes.heads.charts.at(age);
  const double unit_mm = head.measures.height_mm() / kUnitsOfAHead;
  double most = 0;
  std::string worst;
  for (const auto& [name, y_mm] : head.measures.guides) {
    const auto line = chart.lines.find(name);
    if (line == chart.lines.end()) continue;
    const double off = std::abs((y_mm - head.measures.chin_mm()) / unit_mm - line->second * kUnitsOfAHead);
    if (worst.empty() || off > most) most = off, worst = build_caption(name);
  }
  const glm::dvec3 size(head.measures.head.high - head.measures.head.low);
  proof.is_met = most < kGuide_units;
  proof.verdict = fmt::format(
      "All lines lie within {:.3f} units of the chart ({}; at most {} wanted). The head is {:.1f} mm high "
      "(chart: "
      "{:.1f}), and with 3.5 units for that {:.2f} units wide with its ears and {:.2f} deep with its nose.",
      most, worst, kGuide_units, head.measures.height_mm(), chart.height_mm, size.x / unit_mm,
      size.z / unit_mm);
  WireOptions wanted;
  wanted.has_guides = true;
  WireModel model;
  append_wire_head(head.figure, {}, wanted, model);
  HeadStage stage = build_head_stage(kProofPicture, resources.stock.templates);
  for (const auto& [caption, angle_deg] : {std::pair("front", 0.0), {"side", 90.0}})
    proof.pictures.push_back(
        {caption, draw_lines(model, find_proof_view(head.measures, head.measures, angle_deg),
                             resources.stock.templates, jobs)});
  proof.pictures.push_back(
      {"three-quarter", build_png(sketch_head(stage, find_proof_view(head.measures, head.measures, 35),
                                              head.figure.model, head.drawing))});
  return proof;
}

Proof prove_growth(const Resources& resources) {
  constexpr int kStages = 7;
  Proof proof{"6-6, in motion",
              "The child becomes the adult",
              "One age turns into another gradually, by moving the guide lines and no point by hand.",
              "",
              false,
              {}};
  std::vector<RestingHead> heads;
  std::vector<double> steps_mm;
  bool is_growing = true;
  for (int i = 0; i < kStages; ++i) {
    HeadSpec spec;
    const double share = static_cast<double>(i) / (kStages - 1);
    spec.age = {{"child", 1 - share}, {kAdult, share}};
    if (i == 0) spec.age = {{"child", 1.0}};
    if (i + 1 == kStages) spec.age = {{kAdult, 1.0}};
    heads.push_back(build_resting(resources, spec));
    if (i == 0) continue;
    is_growing = is_growing && heads[i].measures.height_mm() > heads[i - 1].measures.height_mm();
    const auto &before = heads[i - 1].figure.head.skin.positions, &now = heads[i].figure.head.skin.positions;
    double sum_mm = 0;
    for (std::size_t v = 0; v < now.size(); ++v)
      sum_mm += static_cast<double>(glm::distance(before[v], now[v]));
    steps_mm.push_back(sum_mm / static_cast<double>(now.size()));
  }
  double mean_mm = 0;
  for (const double step_mm : steps_mm) mean_mm += step_mm / static_cast<double>(steps_mm.size());
  const auto [least, most] = std::ranges::minmax(steps_mm);
  proof.is_met = is_growing && most < 2 * mean_mm;
  proof.verdict = fmt::format(
      "In {} steps the head grows from {:.1f} to {:.1f} mm, {}; its skin goes {:.1f} to {:.1f} mm a step on "
      "average.",
      steps_mm.size(), heads.front().measures.height_mm(), heads.back().measures.height_mm(),
      is_growing ? "at each step" : "but not at each step", least, most);
  HeadStage stage = build_head_stage(kGrowthPicture, resources.stock.templates);
  for (const RestingHead& head : heads)
    proof.pictures.push_back(
        {fmt::format("{:.0f} mm", head.measures.height_mm()),
         build_png(sketch_head(stage, find_proof_view(head.measures, heads.back().measures, 20),
                               head.figure.model, head.drawing))});
  return proof;
}

}  // namespace mien
