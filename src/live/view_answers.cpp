#include "live/view_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/pool.hpp"
#include "live/clip_answers.hpp"
#include "live/coarse.hpp"
#include "live/view_store.hpp"
#include "sketch/light.hpp"

namespace mien {

namespace {

constexpr int kMostSky_px = 640;  // of the ground's picture; it is smooth, or dots that are large

// Of POV-Ray's space, in ours.
Json describe_place(const glm::vec3& place) { return {place.x, place.y, -place.z}; }

Json describe_rgb(const glm::vec3& rgb) { return {rgb.r, rgb.g, rgb.b}; }

std::optional<CameraKey> read_camera(const Json& asked) {
  const auto found = asked.find("camera");
  if (found == asked.end() || !found->is_object()) return std::nullopt;
  CameraKey key;
  key.angle_deg = take_number(*found, "angle", -3600, 3600);
  key.height_deg = take_number(*found, "height", -89, 89);
  key.distance = take_number(*found, "distance", 0.05, 20);
  return key;
}

Json describe_finish(const ViewFinish& finish) {
  return {{"diffuse", finish.diffuse},
          {"brilliance", finish.brilliance},
          {"specular", finish.specular},
          {"roughness", finish.roughness},
          {"phong", finish.phong},
          {"phong_size", finish.phong_size},
          {"metallic", finish.metallic},
          {"reflection", finish.reflection},
          {"emission", describe_rgb(finish.emission)}};
}

Json describe_part(const ViewPart& part) {
  return {{"name", part.name},
          {"material", part.material},
          {"vertices", part.vertices.size()},
          {"triangles", part.triangles.size()},
          {"pieces", part.pieces.size()},
          {"finish", describe_finish(part.finish)},
          {"is_clear", part.is_clear},
          {"is_seen", part.is_seen},
          {"has_shadow", part.has_shadow},
          {"is_rigid", part.is_rigid},
          {"is_outline", part.is_outline}};
}

Json describe_lamp(const SketchLamp& lamp) {
  return {{"at", describe_place(lamp.at)},     {"colour", describe_rgb(lamp.colour)},
          {"side", describe_place(lamp.side)}, {"other_side", describe_place(lamp.other_side)},
          {"has_shadow", lamp.has_shadow},     {"fade_distance", lamp.fade_distance},
          {"fade_power", lamp.fade_power}};
}

// The twelve numbers that take a place of the world, ours, to the card's own axes, column after column.
Json describe_card(const SketchCard& card) {
  Json numbers = Json::array();
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row)
      numbers.push_back((column == 2 ? -1 : 1) * card.card_from_place[column][row]);
  return {{"card_from_place", numbers},
          {"low", {card.low.x, card.low.y, card.low.z}},
          {"high", {card.high.x, card.high.y, card.high.z}},
          {"is_ball", card.is_ball},
          {"colour", describe_rgb(card.colour)}};
}

Json describe_stage(const ViewMoment& moment) {
  const SketchStage& stage = *moment.stage;
  Json lamps = Json::array(), cards = Json::array();
  for (const SketchLamp& lamp : stage.lamps) lamps.push_back(describe_lamp(lamp));
  for (const SketchCard& card : stage.cards) cards.push_back(describe_card(card));
  const CameraView& view = moment.start.view;
  const SketchCamera& camera = stage.camera;
  return {{"lamps", lamps},
          {"cards", cards},
          {"camera",
           {{"angle", view.angle_deg},
            {"height", view.height_deg},
            {"distance", view.distance},
            {"look_at", {view.look_at.x, view.look_at.y, view.look_at.z}},
            {"at", describe_place(camera.at)},
            {"forward", describe_place(camera.forward)},
            {"right", describe_place(camera.right)},
            {"up", describe_place(camera.up)},
            {"is_flat", camera.is_orthographic}}}};
}

bool knows_model(const Json& asked, const std::string& key) {
  const auto known = asked.find("known");
  return known != asked.end() && known->is_array() && std::ranges::find(*known, Json(key)) != known->end();
}

// {model, actors: [{name, parts: [{name, vertices, triangles, finish ...}]}]}; its bytes are appended.
Json describe_model(const Clip& clip, const ViewScene& scene, std::string& bytes) {
  Json actors = Json::array();
  for (std::size_t i = 0; i < scene.models.size(); ++i) {
    const Model& model = scene.heads->figures[i]->get_drawn_model();
    Json parts = Json::array();
    for (std::size_t k = 0; k < scene.models[i].parts.size(); ++k) {
      const ViewPart& part = scene.models[i].parts[k];
      parts.push_back(describe_part(part));
      append_model(bytes, part, model.parts[scene.models[i].of[k]].rest);
    }
    actors.push_back({{"name", clip.actors[i].name}, {"parts", parts}});
  }
  return {{"model", scene.key}, {"step_mm", kViewStep_mm}, {"actors", actors}};
}

// What the actors do at the moment, with the one posed whom the request names.
std::vector<Moment> list_moments(const ViewMoment& moment, const Clip& clip, const Json& asked) {
  std::vector<Moment> moments;
  for (const Performance& performance : moment.heads->performances)
    moments.push_back(sample_performance(performance, moment.time_s));
  if (const auto values = asked.find("values"); values != asked.end())
    moments[find_asked_actor(clip, asked)].pose = read_pose(*values);
  return moments;
}

}  // namespace

ViewMoment find_asked_moment(LiveSession& session, LiveDocument& document, const Json& asked) {
  return find_moment(session.shelf, session.views, document, find_asked_time_s(*document.clip, asked),
                     read_camera(asked));
}

LiveAnswer answer_shapes(LiveSession& session, const Json& asked) {
  const DocumentPointer document = find_document(session.shelf, take_text(asked, "doc"));
  const Clip& clip = *document->clip;
  const ViewMoment moment = find_asked_moment(session, *document, asked);
  const ScenePointer scene = find_scene(session.views, moment);
  const bool is_known = knows_model(asked, scene->key);
  const std::vector<Moment> moments = list_moments(moment, clip, asked);
  const InkView ink = compute_ink_view(moment.start.view, clip.spec.render, moment.start.lamp);
  const BorrowedBuffers borrowed(session.views);
  Json outlines = Json::array();
  std::string bytes;
  const Json fresh = is_known ? Json(nullptr) : describe_model(clip, *scene, bytes);
  Drawing drawing;
  for (std::size_t i = 0; i < scene->models.size(); ++i) {
    draw_actor(*moment.heads, i, moments[i], ink, *borrowed.buffers, drawing);
    if (drawing.is_away)
      for (PartShape& shape : drawing.parts) std::ranges::fill(shape.positions, glm::vec3(0));  // to a point
    for (std::size_t k = 0; k < scene->models[i].parts.size(); ++k) {
      const ViewPart& part = scene->models[i].parts[k];
      const PartShape& shape = drawing.parts[scene->models[i].of[k]];
      if (part.is_outline) outlines.push_back({shape.positions.size(), shape.triangles.size()});
      append_shape(bytes, part, shape);
    }
  }
  Json head{{"model", scene->key}, {"stage", describe_stage(moment)}, {"outlines", outlines}};
  if (!is_known) head["fresh"] = fresh;
  return build_bytes(head, bytes);
}

LiveAnswer answer_coarse(LiveSession& session, const Json& asked) {
  const DocumentPointer document = find_document(session.shelf, take_text(asked, "doc"));
  const ScenePointer scene = find_scene(session.views, find_asked_moment(session, *document, asked));
  Json counts = Json::array();
  std::string bytes;
  for (std::size_t i = 0; i < scene->models.size(); ++i) {
    const ViewModel& view = scene->models[i];
    const Model& model = scene->heads->figures[i]->get_drawn_model();
    std::vector<std::vector<Triangle>> triangles(view.parts.size());
    for_each_index(view.parts.size(), count_workers(), [&](std::size_t k, int) {
      if (!view.parts[k].is_outline) triangles[k] = build_coarse(view.parts[k], model.parts[view.of[k]].rest);
    });
    Json& of_actor = counts.emplace_back(Json::array());
    for (const std::vector<Triangle>& part : triangles) {
      of_actor.push_back(part.size());
      bytes.append(reinterpret_cast<const char*>(part.data()), part.size() * sizeof(Triangle));
    }
  }
  return build_bytes({{"model", scene->key}, {"triangles", counts}}, bytes);
}

// What the page shows where a picture is transparent, linear.
constexpr glm::vec3 kBehindNothing{0.2f};

LiveAnswer answer_sky(LiveSession& session, const Json& asked) {
  const DocumentPointer document = find_document(session.shelf, take_text(asked, "doc"));
  const ViewMoment moment = find_asked_moment(session, *document, asked);
  const int width = static_cast<int>(take_number(asked, "width", 1, kMostSky_px));
  const int height = static_cast<int>(take_number(asked, "height", 1, kMostSky_px));
  const SketchCamera& camera = moment.stage->camera;
  std::string bytes;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 0.5f;
      const float v = 0.5f - (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
      const glm::vec3 aside = camera.is_orthographic ? glm::vec3(0) : u * camera.right + v * camera.up;
      const glm::vec4 sky = sample_sky(*moment.stage, camera.forward + aside);
      const glm::vec3 light = glm::clamp(glm::vec3(sky) + (1 - sky.a) * kBehindNothing, 0.0f, 1.0f);
      for (int c = 0; c < 3; ++c) bytes += static_cast<char>(std::lround(255 * encode_srgb(light[c])));
    }
  return build_bytes({{"width", width}, {"height", height}}, bytes);
}

}  // namespace mien
