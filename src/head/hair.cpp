// Hair in masses first, then locks, then single hairs (Bammes, "Complete Guide to Life Drawing", 1991;
// Loomis, "Drawing the Head and Hands", 1956).
#include "head/hair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/pool.hpp"
#include "core/smooth.hpp"
#include "head/binding.hpp"
#include "head/cage.hpp"
#include "head/hair_drawn.hpp"
#include "head/hair_growth.hpp"
#include "head/hair_locks.hpp"
#include "head/hair_mass.hpp"
#include "head/lids.hpp"
#include "head/strands.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

float compute_luminance(const glm::vec3& srgb) { return glm::dot(srgb, glm::vec3(0.30f, 0.59f, 0.11f)); }

// Grey hair is dark and white hair side by side.
float compute_greyness(const glm::vec3& srgb) {
  const float high = std::max({srgb.r, srgb.g, srgb.b}), low = std::min({srgb.r, srgb.g, srgb.b});
  const float chroma = high > 0 ? (high - low) / high : 0;
  return (1 - smooth_step(0.05f, 0.22f, chroma)) * smooth_step(0.22f, 0.4f, high);
}

std::vector<Shade> make_tones(const glm::vec3& colour) {
  const float grey = compute_greyness(colour);
  const float spread = 0.16f - 0.1f * compute_luminance(colour) + 0.1f * grey;
  std::vector<Shade> palette;
  for (int i = 0; i < kHairTones; ++i) {
    const float way = 2.0f * static_cast<float>(i) / (kHairTones - 1) - 1;
    const glm::vec3 shade =
        colour * (1 + spread * way) + glm::vec3(0.02f, 0.008f, -0.004f) * way * (1 - grey);
    // Sheen shows on dark hair; on light hair its own colour does.
    palette.push_back(
        {glm::clamp(shade, 0.0f, 1.0f), 0.45f - 0.2f * compute_luminance(colour) + 0.12f * way});
  }
  return palette;
}

glm::vec3 compute_colour(const HairScene& scene, const Look& look) {
  constexpr float kChild = 0.18f;  // a child's is lighter, as its skin shows through
  return glm::mix(look.hair, glm::mix(look.hair, look.skin, 0.5f),
                  static_cast<float>(scene.youth) * 2 * kChild);
}

HeadPart make_part(const char* name, const char* material, std::vector<Shade> palette) {
  HeadPart part;
  part.part.name = name;
  part.part.material = material;
  part.part.is_printed = false;  // a bust's hair is a body of its own, or none
  part.part.palette = std::move(palette);
  part.mount = Mount::strands;
  return part;
}

const HairCut& find_cut(const NeutralHead& head, const std::string& name) {
  const auto found = head.data->hair.cuts.find(name);
  if (found == head.data->hair.cuts.end())
    throw RunError(fmt::format("templates/head/hair.yaml has no cut '{}'", name));
  return found->second;
}

HairCut draw_cut(HairCut cut) {
  constexpr double kWidest = 0.4;  // or the short ones beside the ears are blots
  constexpr int kFiner = 2;        // rings along a lock: its outline shows corners that shading hides
  const HairInk& ink = cut.ink;
  if (ink.count > 0) cut.locks.count = ink.count;
  if (ink.width_mm > 0) cut.locks.width_mm = ink.width_mm;
  if (ink.mass > 0) cut.mass = ink.mass;
  if (ink.jitter_deg >= 0) cut.comb.jitter_deg = ink.jitter_deg;
  for (std::vector<double>* lengths :
       {&cut.locks.length_mm.front, &cut.locks.length_mm.side, &cut.locks.length_mm.back})
    for (double& length : *lengths) length *= ink.longer;
  // A skull in profile is flatter above than a drawing may be: where hair falls, it makes the crown round.
  constexpr double kRounder =
      0.5;  // of the thickness at the whorl; none is added where hair grows at its border
  for (std::vector<double>* thick : {&cut.thick_mm.front, &cut.thick_mm.side, &cut.thick_mm.back})
    for (std::size_t i = 0; cut.covers_ears && i < thick->size(); ++i) {
      const double way = static_cast<double>(i) / static_cast<double>(thick->size() - 1);
      (*thick)[i] *= 1 + kRounder * (1 - way) * (1 - way);
    }
  // Short hair has more body than it has strands: between crown and border.
  constexpr double kBody = 1.1;
  for (std::vector<double>* thick : {&cut.thick_mm.front, &cut.thick_mm.side, &cut.thick_mm.back})
    for (std::size_t i = 0; !cut.covers_ears && !cut.comb.is_gathered && i < thick->size(); ++i) {
      const double way = static_cast<double>(i) / static_cast<double>(thick->size() - 1);
      (*thick)[i] *= 1 + kBody * 4 * way * (1 - way) * (thick == &cut.thick_mm.front ? 1 : 0.6);
    }
  constexpr double kTucked = 1.7;  // its outline turns in at the nape
  cut.tuck *= kTucked;
  cut.comb.scalp_mm = 0;  // in an outline its groove is a notch
  cut.down.count = 0;
  cut.is_drawn = true;
  cut.locks.widest = kWidest;
  cut.locks.rings *= kFiner;
  const HairLocks as_they_grow;  // few and broad ones lie as they grow
  cut.locks.from_part = as_they_grow.from_part;
  cut.locks.deepest = as_they_grow.deepest;
  cut.locks.risen = as_they_grow.risen;
  cut.locks.gathers = as_they_grow.gathers;
  return cut;
}

}  // namespace

HairCut find_drawn_cut(const NeutralHead& head, const std::string& name) {
  return draw_cut(find_cut(head, name));
}

namespace {

HeadPart build_mass(const NeutralHead&, const HairScene& scene, const Look& look, const glm::vec3& colour) {
  const glm::vec3 deep = glm::mix(colour * 0.85f, look.skin * 0.4f, 0.06f);
  HeadPart mass = make_part("hair_mass", "tress", {{deep, 0.3f}});
  if (scene.cut.is_drawn) {
    mass.part.palette.push_back({deep, 1});  // its ring of light
    append_drawn_mass(mass, scene);
  } else {
    append_mass(mass, scene);
  }
  update_normals(mass.part.rest);
  return mass;
}

HeadPart build_locks(const NeutralHead& head, const HairScene& scene, const Look& look,
                     const glm::vec3& colour) {
  HeadPart locks = make_part("hair", "lock", make_tones(colour));
  append_locks(locks, scene);
  if (scene.cut.comb.scalp_mm > 0) {
    // Of the skin, in the shade of the hair on both sides of it.
    locks.part.palette.push_back({glm::mix(look.skin, 0.8f * colour, 0.9f), 0});
    append_part_line(locks, scene);
  }
  if (scene.cut.tail.radius_mm > 0) append_tail(locks, scene);
  if (scene.cut.is_mirrored) add_mirror_image(locks, head.skin);
  if (scene.cut.bun_radius_mm > 0) append_bun(locks, scene);
  return locks;
}

// Whether each lock lies behind the middle of them all. One that shares triangles with the lock before it
// (the pieces of a parting) goes with that.
std::vector<bool> find_locks_behind(const HeadPart& locks) {
  std::vector<double> middles;
  std::vector<std::size_t> lock_of_vertex;
  for (std::size_t i = 0; i < locks.bindings.size(); ++i) {
    const Binding& lock = locks.bindings[i];
    double sum = 0;
    for (std::uint32_t v = lock.first; v < lock.first + lock.count; ++v)
      sum += locks.part.rest.positions[v].z;
    middles.push_back(sum / lock.count);
    lock_of_vertex.resize(lock.first + lock.count, i);
  }
  const double middle =
      std::accumulate(middles.begin(), middles.end(), 0.0) / static_cast<double>(middles.size());
  std::vector<bool> goes_along(middles.size(), false);
  for (const Triangle& triangle : locks.part.rest.triangles)
    for (const std::uint32_t v : triangle)
      if (lock_of_vertex[v] != lock_of_vertex[triangle[0]])
        goes_along[std::max(lock_of_vertex[v], lock_of_vertex[triangle[0]])] = true;
  std::vector<bool> is_behind;
  for (std::size_t i = 0; i < middles.size(); ++i)
    is_behind.push_back(goes_along[i] ? is_behind[i - 1] : middles[i] < middle);
  return is_behind;
}

// The locks that are chosen, in their order, as a part that is called `name`.
HeadPart take_locks(const HeadPart& locks, const char* name, const std::vector<bool>& is_chosen) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  HeadPart taken = make_part(name, locks.part.material.c_str(), locks.part.palette);
  const Mesh& from = locks.part.rest;
  Mesh& into = taken.part.rest;
  std::vector<std::uint32_t> moved(from.positions.size(), kNone);
  for (std::size_t i = 0; i < locks.bindings.size(); ++i) {
    if (!is_chosen[i]) continue;
    Binding lock = locks.bindings[i];
    lock.first = static_cast<std::uint32_t>(into.positions.size());
    for (std::uint32_t v = locks.bindings[i].first; v < locks.bindings[i].first + lock.count; ++v) {
      moved[v] = static_cast<std::uint32_t>(into.positions.size());
      into.positions.push_back(from.positions[v]);
      into.normals.push_back(from.normals[v]);
      taken.part.shade.push_back(locks.part.shade[v]);
      taken.part.grain.push_back(locks.part.grain[v]);
    }
    taken.bindings.push_back(lock);
  }
  for (const Triangle& triangle : from.triangles)
    if (moved[triangle[0]] != kNone)
      into.triangles.push_back({moved[triangle[0]], moved[triangle[1]], moved[triangle[2]]});
  return taken;
}

// The locks before their middle and those behind it: a ray that ends at a face need not try the hair behind
// that.
void split_locks(std::vector<HeadPart>& parts) {
  const auto locks = std::ranges::find(parts, "hair", [](const HeadPart& part) { return part.part.name; });
  if (locks == parts.end()) return;
  std::vector<bool> is_behind = find_locks_behind(*locks);
  HeadPart behind = take_locks(*locks, "hair_back", is_behind);
  if (behind.bindings.empty()) return;
  is_behind.flip();
  *locks = take_locks(*locks, "hair", is_behind);
  parts.insert(locks + 1, std::move(behind));
}

HeadPart build_down(const NeutralHead& head, const HairScene& scene, const Look&, const glm::vec3& colour) {
  HeadPart down = make_part("hair_fine", "hair", make_hair_palette(colour, 0.3f, 0.2f));
  append_down(down, scene);
  if (scene.cut.is_mirrored) add_mirror_image(down, head.skin);
  return down;
}

std::vector<HeadPart> grow_hair(const NeutralHead& head, const HairScene& scene, const Look& look) {
  const glm::vec3 colour = compute_colour(scene, look);
  std::vector<HeadPart (*)(const NeutralHead&, const HairScene&, const Look&, const glm::vec3&)> works;
  if (scene.cut.mass > 0) works.push_back(build_mass);
  if (scene.cut.locks.count > 0 && !scene.cut.is_drawn) works.push_back(build_locks);
  if (scene.cut.down.count > 0) works.push_back(build_down);
  std::vector<HeadPart> parts(works.size());
  for_each_index(works.size(), count_workers(),
                 [&](std::size_t i, int) { parts[i] = works[i](head, scene, look, colour); });
  split_locks(parts);
  return parts;
}

std::vector<float> paint_ground(const NeutralHead& head, const HairScene& scene) {
  const std::vector<HairGround> grounds = list_hair_grounds(head);
  // Hair is finer at the temples.
  constexpr double kFirst_deg = 34, kWhole_deg = 52, kFinest = 0.9;
  const auto find_soft_mm = [&](double azimuth_deg) {
    return scene.cut.soft_mm * (1 + kFinest * smooth_step(kFirst_deg, kWhole_deg, std::abs(azimuth_deg)) *
                                        (1 - smooth_step(80, 100, std::abs(azimuth_deg))));
  };
  std::vector<float> covers;
  for (std::size_t v = 0; v < head.skin.positions.size(); ++v) {
    float cover = 0;
    if (grounds[v] == HairGround::scalp) {
      const HairPlace place = compute_hair_place(scene.chart, glm::dvec3(head.skin.positions[v]));
      const double soft_mm = find_soft_mm(place.azimuth_deg);
      cover = static_cast<float>(scene.cut.scalp *
                                 smooth_step(-0.5 * soft_mm, soft_mm, compute_inside_mm(scene, place)));
      // What lies far under the chart's ground is an inside: an ear's back, a mouth.
      const double ground = sample_hair_chart(scene.chart, scene.chart.skin_mm, place);
      const double far =
          glm::distance(compute_hair_point(scene.chart, place, 0), glm::dvec3(head.skin.positions[v]));
      if (ground - far > 8 * scene.chart.size) cover = 0;
    }
    covers.push_back(cover);
  }
  return covers;
}

// Large eyes reach under the hair that falls beside a face: it gives way there, back and aside.
void leave_eyes_free(const NeutralHead& head, std::vector<HeadPart>& parts) {
  constexpr float kUsual_mm = 32, kLarge_mm = 47;      // an eye's width from corner to corner
  constexpr float kAll_mm = 26, kNone_mm = 72;         // from its outer corner
  constexpr float kBehind_mm = -42, kBeside_mm = -20;  // sideburns stay: they lie behind it
  const glm::vec3 way_mm(2, 0, -10);
  const glm::vec3 outer = head.skin.positions[find_point(head.cage, "E1_8")],
                  inner = head.skin.positions[find_point(head.cage, "E1_0")];
  const float large = smooth_step(kUsual_mm, kLarge_mm, glm::distance(outer, inner));
  if (large == 0) return;
  for (HeadPart& part : parts)
    for (glm::vec3& place : part.part.rest.positions) {
      const float side = place.x < 0 ? -1.0f : 1.0f;
      const float far_mm = glm::distance(glm::vec3(side * place.x, place.y, place.z), outer);
      const float share = smooth_step(kBehind_mm, kBeside_mm, place.z - outer.z) *
                          (1 - smooth_step(kAll_mm, kNone_mm, far_mm));
      place += large * share * glm::vec3(side, 1, 1) * way_mm;
    }
}

}  // namespace

std::vector<HeadPart> build_hair(const NeutralHead& head, const std::string& name, const Look& look,
                                 bool is_drawn) {
  if (name == "none") return {};
  const HairCut& worn = find_cut(head, name);
  const HairScene scene = build_hair_scene(head, is_drawn ? draw_cut(worn) : worn);
  std::vector<HeadPart> parts = grow_hair(head, scene, look);
  if (is_drawn) leave_eyes_free(head, parts);
  return parts;
}

std::vector<float> paint_scalp(const NeutralHead& head, const std::string& name) {
  if (name == "none") return {};
  return paint_ground(head, build_hair_scene(head, find_cut(head, name)));
}

WornHair build_worn_hair(const NeutralHead& head, const std::string& name, const Look& look) {
  WornHair hair;
  if (name == "none") return hair;
  const HairScene scene = build_hair_scene(head, find_cut(head, name));
  for_each_index(2, count_workers(), [&](std::size_t i, int) {
    if (i == 0)
      hair.parts = grow_hair(head, scene, look);
    else
      hair.scalp = paint_ground(head, scene);
  });
  return hair;
}

}  // namespace mien
