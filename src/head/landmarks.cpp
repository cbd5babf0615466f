#include "head/landmarks.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "head/cage.hpp"
#include "head/guides.hpp"
#include "head/patterns.hpp"

namespace mien {

namespace {

// How far the front of the cornea stands before the centre of a ball of 13 mm.
constexpr double kCornea_mm = 14.05;

double measure(const std::string& rule, const glm::vec3& p) {
  if (rule == "highest") return p.y;
  if (rule == "lowest") return -p.y;
  if (rule == "rearmost") return -p.z;
  if (rule == "widest") return std::abs(p.x);
  throw RunError(fmt::format("unknown rule '{}'; expected highest, lowest, rearmost or widest", rule));
}

// The vertex of the left half (or the mid-plane) that has most of what the rule asks for.
std::uint32_t find_extreme(const NeutralHead& head, const std::string& rule, const std::string& pattern) {
  const bool is_any = pattern == "*";
  const std::vector<bool> among = find_points(head.cage, {pattern});
  const std::size_t count = is_any ? head.skin.positions.size() : head.cage.points.size();
  std::uint32_t best = 0;
  double most = -1e9;
  for (std::uint32_t v = 0; v < count; ++v) {
    const glm::vec3& p = head.skin.positions[v];
    if (p.x < 0 || (!is_any && !among[v])) continue;
    const double here = measure(rule, p);
    if (here > most) {
      most = here;
      best = v;
    }
  }
  return best;
}

std::vector<std::uint32_t> find_vertices(const NeutralHead& head, const LandmarkRule& rule) {
  if (rule.kind == LandmarkRule::Kind::extreme) return {find_extreme(head, rule.rule, rule.pattern)};
  std::vector<std::uint32_t> vertices;
  for (const std::string& point : rule.points) vertices.push_back(find_point(head.cage, point));
  return vertices;
}

std::vector<double> share_equally(const std::vector<std::uint32_t>& vertices) {
  return std::vector<double>(vertices.size(), 1.0 / static_cast<double>(vertices.size()));
}

Landmark find_skin_landmark(const NeutralHead& head, const std::string& name, const LandmarkRule& rule) {
  if (rule.kind == LandmarkRule::Kind::hairline) {
    const HairlineMark mark = compute_hairline(head.cage, head.hairline);
    return {name, {mark.below, mark.above}, {1 - mark.share, mark.share}, false, Side::none};
  }
  if (rule.kind == LandmarkRule::Kind::tongue) return {name, {}, {}, false, Side::none, true};
  const std::vector<std::uint32_t> vertices = find_vertices(head, rule);
  return {name, vertices, share_equally(vertices), false, Side::none};
}

glm::dvec3 measure_pupil(const NeutralHead& head, Side side, const Model& model, const Drawing& drawing) {
  const double sign = side == Side::left ? 1 : -1;
  const double reach = kCornea_mm / 13.0 * head.eye.radius_mm;
  const glm::vec3 rest(glm::dvec3(sign * head.eye.centre.x, head.eye.centre.y, head.eye.centre.z + reach));
  const std::string suffix = side == Side::left ? "_left" : "_right";
  for (std::size_t i = 0; i < model.parts.size(); ++i)
    if ((model.parts[i].name == "cornea" + suffix || model.parts[i].name == "pupil" + suffix) &&
        !model.parts[i].is_rigid)
      return glm::dvec3(drawing.parts[i].positions.front());  // its highest place
  for (std::size_t i = 0; i < model.parts.size(); ++i)
    if (model.parts[i].name == "eye" + suffix)
      return glm::dvec3(drawing.parts[i].world_from_rest * glm::vec4(rest, 1));
  throw RunError(fmt::format("internal: the model has no part 'eye{}'", suffix));
}

glm::dvec3 measure_tongue(const Model& model, const Drawing& drawing) {
  for (std::size_t i = 0; i < model.parts.size(); ++i)
    if (model.parts[i].name == "tongue") {
      const PartShape& shape = drawing.parts[i];
      if (!shape.positions.empty()) return glm::dvec3(shape.positions.back());
      return glm::dvec3(shape.world_from_rest * glm::vec4(model.parts[i].rest.positions.back(), 1));
    }
  throw RunError("internal: the model has no part 'tongue'");
}

}  // namespace

std::vector<Landmark> find_landmarks(const NeutralHead& head) {
  const LandmarkData& data = head.data->landmarks;
  std::vector<Landmark> landmarks;
  for (const auto& [name, rule] : data.middle) landmarks.push_back(find_skin_landmark(head, name, rule));
  for (const auto& [name, rule] : data.sided) {
    if (rule.kind == LandmarkRule::Kind::pupil) {
      landmarks.push_back({name + "_l", {}, {}, true, Side::left});
      landmarks.push_back({name + "_r", {}, {}, true, Side::right});
      continue;
    }
    const std::vector<std::uint32_t> left = find_vertices(head, rule);
    std::vector<std::uint32_t> right;
    for (const std::uint32_t v : left) right.push_back(head.cage.mirror[v]);
    landmarks.push_back({name + "_l", left, share_equally(left), false, Side::left});
    landmarks.push_back({name + "_r", right, share_equally(left), false, Side::right});
  }
  return landmarks;
}

SkinSpot find_place(const NeutralHead& head, const std::string& name) {
  const LandmarkData& data = head.data->landmarks;
  std::string code = name;
  for (const auto* words : {&data.everyday_middle, &data.everyday_sided})
    for (const auto& [word, meaning] : *words)
      if (word == name) code = meaning;
  LandmarkRule point;
  const LandmarkRule* rule = find_landmark_rule(data, code);
  if (rule == nullptr && code != name) {
    point.points = {code};
    rule = &point;
  }
  if (rule == nullptr || rule->kind == LandmarkRule::Kind::pupil || rule->kind == LandmarkRule::Kind::tongue)
    throw RunError(fmt::format("no place of the skin is called '{}'", name));
  Landmark place = find_skin_landmark(head, name, *rule);
  return {std::move(place.vertices), std::move(place.shares), rule->kind != LandmarkRule::Kind::points};
}

std::map<std::string, glm::dvec3> measure_landmarks(const NeutralHead& head,
                                                    const std::vector<Landmark>& landmarks,
                                                    const Model& model, const Drawing& drawing) {
  std::map<std::string, glm::dvec3> places;
  for (const Landmark& landmark : landmarks) {
    if (landmark.is_pupil) {
      places[landmark.name] = measure_pupil(head, landmark.side, model, drawing);
      continue;
    }
    if (landmark.is_tongue) {
      places[landmark.name] = measure_tongue(model, drawing);
      continue;
    }
    glm::dvec3 sum{0};
    for (std::size_t i = 0; i < landmark.vertices.size(); ++i)
      sum += landmark.shares[i] * glm::dvec3(drawing.parts.front().positions[landmark.vertices[i]]);
    places[landmark.name] = sum;
  }
  return places;
}

std::string build_landmarks_json(const std::map<std::string, glm::dvec3>& landmarks) {
  std::string text = "{";
  for (const auto& [name, place] : landmarks) {
    text += fmt::format("{}\n  \"{}\": [", text.size() > 1 ? "," : "", name);
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) text += ", ";
      append_number(text, place[axis], 3);
    }
    text += "]";
  }
  return text + "\n}\n";
}

}  // namespace mien
