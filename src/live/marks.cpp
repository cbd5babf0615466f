#include "live/marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "head/landmarks.hpp"
#include "live/clip_answers.hpp"
#include "live/view_answers.hpp"
#include "live/view_store.hpp"
#include "sheet/camera.hpp"
#include "sheet/marks.hpp"
#include "sheet/plans.hpp"

namespace mien {

namespace {

// Far enough apart for all who see colours otherwise. Source: Okabe and Ito, "Color Universal Design" (2008).
constexpr std::array<glm::u8vec3, 8> kAreaColours{{{230, 159, 0},
                                                   {86, 180, 233},
                                                   {0, 158, 115},
                                                   {204, 121, 167},
                                                   {213, 94, 0},
                                                   {0, 114, 178},
                                                   {240, 228, 66},
                                                   {120, 120, 120}}};
constexpr float kFull_mm = 3;  // moved so far, skin has all of its area's colour

// A moment's figure with the view of its skin.
struct SkinView {
  const DrawnFigure& figure;
  const Part& part;
  const ViewPart& view;
};

SkinView find_skin(const ViewScene& scene, std::size_t actor) {
  const DrawnFigure& figure = *scene.heads->figures[actor];
  const Model& model = figure.get_drawn_model();
  const auto part = std::ranges::find(model.parts, "skin", &Part::name);
  const auto view = std::ranges::find(scene.models[actor].parts, part->name, &ViewPart::name);
  return {figure, *part, *view};
}

// Of each vertex of the model's skin the first of the view's; those that the view lacks are its first.
std::vector<std::uint32_t> find_view_vertices(const SkinView& skin) {
  std::vector<std::uint32_t> of(skin.part.rest.positions.size(), 0);
  for (std::size_t i = skin.view.vertices.size(); i-- > 0;)
    of[skin.view.vertices[i]] = static_cast<std::uint32_t>(i);
  return of;
}

// Where a plane cuts the skin, as [a, b, t, a, b, t]: from chin to crown these are Loomis' lines.
Json cut_skin(const SkinView& skin, const std::vector<std::uint32_t>& of, int axis, double at_mm,
              double floor_mm) {
  const Mesh& rest = skin.figure.head.skin;
  Json lines = Json::array();
  for (const Triangle& triangle : rest.triangles) {
    Json line = Json::array();
    for (std::size_t i = 0; i < 3 && line.size() < 6; ++i) {
      const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
      const double from = rest.positions[a][axis] - at_mm, to = rest.positions[b][axis] - at_mm;
      if ((from < 0) == (to < 0) || rest.positions[a].y < floor_mm) continue;
      line.insert(line.end(), {of[a], of[b], std::round(1e4 * from / (from - to)) / 1e4});
    }
    if (line.size() == 6) lines.push_back(line);
  }
  return lines;
}

Json describe_landmarks(const SkinView& skin, const std::vector<std::uint32_t>& of) {
  Json all = Json::array();
  for (const Landmark& landmark : find_landmarks(skin.figure.head)) {
    if (!landmark.is_skin()) continue;
    Json vertices = Json::array();
    for (const std::uint32_t vertex : landmark.vertices) vertices.push_back(of[vertex]);
    all.push_back({{"name", landmark.name}, {"vertices", vertices}, {"shares", landmark.shares}});
  }
  return all;
}

// How far an area takes each vertex of the head's own skin, at most, mm.
std::vector<float> measure_ways(const Figure& figure, Area area) {
  DeformBuffers buffers;
  PartShape rest, posed;
  deform_skin(figure, *figure.head.surface, {}, {}, buffers, rest);
  std::vector<float> ways(rest.positions.size(), 0);
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    if (kMoves[i].of != area) continue;
    for (const double value : {kMoves[i].low, kMoves[i].high}) {
      if (value == 0) continue;
      Pose pose;
      pose.values[i] = value;
      deform_skin(figure, *figure.head.surface, pose, {}, buffers, posed);
      for (std::size_t v = 0; v < ways.size(); ++v)
        ways[v] = std::max(ways[v], glm::distance(rest.positions[v], posed.positions[v]));
    }
  }
  return ways;
}

// Lines of a sheet's cell, which lie in the picture's plane, put to the depth of the face. Its words would
// lie on each other where all areas are shown at once.
void append_overlay(const Overlay& overlay, const CameraView& view, float depth_mm, Json& lines) {
  const glm::vec3 toward = compute_toward_camera(view);
  const auto place = [&](const glm::vec3& at) {
    const glm::vec3 on = at - toward * (glm::dot(at - view.look_at, toward) - depth_mm);
    const auto round = [](float x) { return std::round(100 * x) / 100; };
    return Json{round(on.x), round(on.y), round(on.z)};
  };
  const auto colour = [](const glm::vec3& srgb) { return Json{srgb.r, srgb.g, srgb.b}; };
  for (const OverlayLine& line : overlay.lines) {
    Json segments = Json::array();
    for (const auto& segment : line.segments) segments.push_back({place(segment[0]), place(segment[1])});
    lines.push_back({{"colour", colour(line.srgb)}, {"segments", segments}});
  }
}

// The rectangles and levels of `mien sheet limits`, on this head from this side.
Json describe_limits(LiveSession& session, const Spec& spec, const HeadSpec& head, const Figure& figure,
                     const CameraView& view) {
  SheetSubject subject;
  subject.spec = spec;
  subject.spec.head = head;
  const SheetPlan plan = build_sheet_plan("limits", subject, *session.shelf.resources->stock.head);
  const FigurePlaces places = build_places(figure);
  const PlacesOfPose rest = places({});
  const glm::vec3 toward = compute_toward_camera(view);
  const float depth_mm = glm::dot(glm::vec3(rest.at("sn")) - view.look_at, toward);
  Json lines = Json::array();
  for (const SheetBlock& block : plan.blocks)
    for (const SheetCell& cell : block.cells)
      append_overlay(draw_marks(cell, places, view, {400, 500}).overlay, view, depth_mm, lines);
  return {{"lines", lines}};
}

}  // namespace

LiveAnswer answer_marks(LiveSession& session, const Json& asked) {
  const DocumentPointer document = find_document(session.shelf, take_text(asked, "doc"));
  const ViewMoment moment = find_asked_moment(session, *document, asked);
  const ScenePointer scene = find_scene(session.views, moment);
  const SkinView skin = find_skin(*scene, find_asked_actor(*document->clip, asked));
  const std::vector<std::uint32_t> of = find_view_vertices(skin);
  const HeadMeasures measures = measure_head(skin.figure);
  Json guides = Json::array();
  for (const auto& [name, y_mm] : measures.guides)
    guides.push_back({{"name", name}, {"lines", cut_skin(skin, of, 1, y_mm, measures.chin_mm())}});
  guides.push_back({{"name", "middle"}, {"lines", cut_skin(skin, of, 0, 0.01, measures.chin_mm())}});
  return build_answer({{"guides", guides}, {"landmarks", describe_landmarks(skin, of)}});
}

LiveAnswer answer_areas(LiveSession& session, const Json& asked) {
  const DocumentPointer document = find_document(session.shelf, take_text(asked, "doc"));
  const ViewMoment moment = find_asked_moment(session, *document, asked);
  const ScenePointer scene = find_scene(session.views, moment);
  const std::size_t actor = find_asked_actor(*document->clip, asked);
  const SkinView skin = find_skin(*scene, actor);
  Json areas = Json::array();
  std::vector<std::size_t> most(skin.part.rest.positions.size(), 0);
  std::vector<float> way_mm(most.size(), 0);
  for (std::size_t a = 0; a < kAreas.size(); ++a) {
    const std::vector<float> ways = measure_ways(skin.figure, kAreas[a].area);
    for (std::size_t v = 0; v < ways.size(); ++v)
      if (ways[v] > way_mm[v]) {
        way_mm[v] = ways[v];
        most[v] = a;
      }
    const glm::u8vec3 colour = kAreaColours[a % kAreaColours.size()];
    areas.push_back({{"name", kAreas[a].in_words},
                     {"colour", {colour.r, colour.g, colour.b}},
                     {"mm", std::round(10 * *std::ranges::max_element(ways)) / 10}});
  }
  std::string bytes;
  for (const std::uint32_t vertex : skin.view.vertices) {
    const glm::u8vec3 colour = kAreaColours[most[vertex] % kAreaColours.size()];
    const float share = std::clamp(way_mm[vertex] / kFull_mm, 0.0f, 1.0f);
    for (const int byte : {int{colour.r}, int{colour.g}, int{colour.b}, static_cast<int>(255 * share)})
      bytes += static_cast<char>(byte);
  }
  return build_bytes(
      {{"areas", areas},
       {"limits", describe_limits(session, document->clip->spec, document->clip->actors[actor].head,
                                  skin.figure, moment.start.view)}},
      bytes);
}

}  // namespace mien
