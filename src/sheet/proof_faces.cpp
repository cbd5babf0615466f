// Figures of faces: expressions by the areas that they use, and a clip as stills.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/text.hpp"
#include "head/surface.hpp"
#include "sheet/camera.hpp"
#include "sheet/head_pictures.hpp"
#include "sheet/proof.hpp"
#include "sheet/wire_head.hpp"
#include "timeline/performance.hpp"

namespace mien {

namespace {

constexpr PictureSize kFacePicture{270, 300};
constexpr PictureSize kStripPicture{150, 180};
constexpr double kMirrored_mm = 1e-3;  // more is seen by a judge of symmetry, less is rounding

using AreaNames = std::set<std::string>;

// Section 4.2: the areas that each uses. Eyes are free in all of them.
struct ThesisFace {
  AreaNames areas;
  bool is_symmetric = true;
};
const std::map<std::string, ThesisFace> kThesisFaces{
    {"neutral", {{}}},
    {"smile", {{"lids", "lips", "corners"}}},
    {"laugh", {{"lids", "lips", "corners"}}},
    {"anger", {{"brows", "lips"}}},
    {"surprise", {{"brows", "lids"}}},
    {"shout", {{"brows", "lids", "lips", "corners", "chin"}}},
    {"fear", {{"brows", "lids", "lips", "chin"}}},
    {"sadness", {{"brows", "lids", "corners"}}},
    {"doubt_left", {{"brows", "lids", "lips", "corners"}, false}},
    {"doubt_right", {{"brows", "lids", "lips", "corners"}, false}}};

AreaNames list_areas_used(const Pose& pose) {
  AreaNames used;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (pose.values[i] != 0 && kMoves[i].of != Area::eye) {
      const AreaInfo& area = find_area(kMoves[i].of);
      used.insert(std::string(area.plural.empty() ? area.name : area.plural));
    }
  return used;
}

std::string join_areas(const AreaNames& names) {
  return names.empty() ? "no area" : fmt::format("{}", fmt::join(names, ", "));
}

const Expression& find_tezuka(const Resources& resources, const std::string& name) {
  for (const Expression& expression : resources.stock.language->libraries.expressions)
    if (expression.library == "tezuka" && expression.name == name) return expression;
  throw RunError(fmt::format("the library 'tezuka' has no '{}'", name));
}

std::vector<glm::vec3> pose_skin(const Figure& figure, const Pose& pose) {
  DeformBuffers buffers;
  PartShape skin;
  deform_skin(figure, *figure.head.surface, pose, {}, buffers, skin);
  return skin.positions;
}

double measure_most_mm(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  float most = 0;
  for (std::size_t v = 0; v < a.size(); ++v) most = std::max(most, glm::distance(a[v], b[v]));
  return static_cast<double>(most);
}

double measure_lopsided_mm(const Figure& figure, const std::vector<glm::vec3>& skin) {
  float most = 0;
  for (std::size_t v = 0; v < skin.size(); ++v) {
    const glm::vec3& image = skin[figure.head.surface->mirror[v]];
    most = std::max(most, glm::distance(skin[v], glm::vec3(-image.x, image.y, image.z)));
  }
  return static_cast<double>(most);
}

HeadSpec build_actor() {
  HeadSpec spec;
  spec.hair = "crop";          // bald heads look startled
  spec.follows_thesis = true;  // as a file of the library is
  return spec;
}

CameraView find_face_view(const HeadMeasures& measures, double angle_deg) {
  SheetCell cell;
  cell.angle_deg = angle_deg;
  cell.framing.around = {"tr", "gn"};
  cell.framing.spread = 1.5;
  return compute_cell_view(cell, measures, measures);
}

}  // namespace

Proof prove_expressions(const Resources& resources, const std::string& number, const std::string& title,
                        const std::vector<std::string>& names, int jobs) {
  Proof proof{number, title, "Moving the comic areas, each by itself, makes the expression.", "", true, {}};
  const Figure figure = build_figure(resources.heads, build_actor());
  const HeadMeasures measures = measure_head(figure);
  const std::vector<glm::vec3> rest = pose_skin(figure, {});
  HeadStage stage = build_head_stage(kFacePicture, resources.stock.templates);
  DeformBuffers buffers;
  Drawing drawing;
  for (const std::string& name : names) {
    const ThesisFace& thesis = kThesisFaces.at(name);
    const Pose& pose = find_tezuka(resources, name).pose;
    const AreaNames used = list_areas_used(pose);
    const std::vector<glm::vec3> skin = pose_skin(figure, pose);
    const double lopsided_mm = measure_lopsided_mm(figure, skin);
    const bool is_as_told = used == thesis.areas && (lopsided_mm < kMirrored_mm) == thesis.is_symmetric;
    proof.is_met = proof.is_met && is_as_told;
    proof.verdict += fmt::format(
        "{}{}: {} ({}), the skin goes up to {:.1f} mm, left and right differ by {:.1f} mm ({}).",
        proof.verdict.empty() ? "" : " ", build_caption(name), join_areas(used),
        used == thesis.areas ? "as in the thesis's table" : "in the thesis " + join_areas(thesis.areas),
        measure_most_mm(rest, skin), lopsided_mm,
        thesis.is_symmetric ? "symmetric is wanted" : "one-sided is wanted");
    deform_figure(figure, pose, {}, buffers, drawing);
    WireModel model;
    append_wire_head(figure, {pose, {}, glm::dmat4(1)}, {}, model);
    const CameraView front = find_face_view(measures, 0);
    const WireCamera camera = build_wire_camera(front, kFacePicture);
    proof.pictures.push_back(
        {build_caption(name), build_png(sketch_head(stage, front, figure.model, drawing))});
    proof.pictures.push_back({build_caption(name) + ", lines",
                              build_png(build_paper_pixels(draw_head_lines(model, camera, jobs),
                                                           find_letters(resources.stock.templates)))});
  }
  return proof;
}

Proof prove_clip(const Resources& resources) {
  Proof proof{"6-14",
              "A clip as stills",
              "Moving the areas continuously, 24 pictures a second, makes an animation that convinces.",
              "",
              false,
              {}};
  struct Beat {
    double at_s;
    const char* name;
  };
  constexpr std::array kBeats{Beat{0, "neutral"}, Beat{0.5, "smile"}, Beat{1, "laugh"}, Beat{1.5, "surprise"},
                              Beat{2, "sadness"}};
  ClipSpec clip;
  for (const Beat& beat : kBeats) {
    PoseKey& key = clip.keys.emplace_back();
    key.at_s = beat.at_s;
    key.label = beat.name;
    key.pose = find_tezuka(resources, beat.name).pose;
  }
  clip.camera.emplace_back();
  clip.turn.emplace_back();
  clip.length_s = kBeats.back().at_s;
  const Performance performance = build_performance(clip);
  const Figure figure = build_figure(resources.heads, build_actor());
  const HeadMeasures measures = measure_head(figure);
  const int count = static_cast<int>(std::lround(clip.length_s * clip.fps)) + 1;
  double most_mm = 0, whole_mm = 0, off_mm = 0;
  std::vector<glm::vec3> before, key_before;
  for (int frame = 0; frame < count; ++frame) {
    const double time_s = static_cast<double>(frame) / clip.fps;
    const std::vector<glm::vec3> skin = pose_skin(figure, sample_performance(performance, time_s).pose);
    if (frame > 0) {
      most_mm = std::max(most_mm, measure_most_mm(before, skin));
    }
    before = skin;
    for (const PoseKey& key : clip.keys) {
      if (std::abs(key.at_s - time_s) > 1e-9) continue;
      off_mm = std::max(off_mm, measure_most_mm(skin, pose_skin(figure, key.pose)));
      if (!key_before.empty()) whole_mm = std::max(whole_mm, measure_most_mm(key_before, skin));
      key_before = skin;
    }
  }
  // A jump would be a frame that goes a third of the longest way between two keys.
  proof.is_met = off_mm == 0 && most_mm < whole_mm / 3 && clip.fps >= 24;
  proof.verdict = fmt::format(
      "{} frames at {} a second: {} keys are hit at their frames (the skin is {:.3f} mm off); the longest "
      "way between "
      "two keys is {:.1f} mm, and from one frame to the next no place of the skin goes more than {:.1f} mm.",
      count, clip.fps, clip.keys.size(), off_mm, whole_mm, most_mm);
  HeadStage stage = build_head_stage(kStripPicture, resources.stock.templates);
  DeformBuffers buffers;
  Drawing drawing;
  constexpr int kEvery = 4;
  for (int frame = 0; frame < count; frame += kEvery) {
    deform_figure(figure, sample_performance(performance, static_cast<double>(frame) / clip.fps).pose, {},
                  buffers, drawing);
    proof.pictures.push_back(
        {fmt::format("frame {}", frame + 1),
         build_png(sketch_head(stage, find_face_view(measures, 20), figure.model, drawing))});
  }
  return proof;
}

}  // namespace mien
