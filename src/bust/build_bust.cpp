#include "bust/build_bust.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "core/error.hpp"
#include "core/pool.hpp"
#include "print/base.hpp"
#include "print/cavity.hpp"
#include "print/cavity_plan.hpp"
#include "print/plates.hpp"
#include "print/thicken.hpp"

namespace mien {

namespace {

constexpr double kBaseHeight = 8.0 / 80, kBaseRadius = 15.0 / 80;  // of the whole print's height
constexpr double kPlinth = 18.5 / 80;     // half its side: a word such as "surprise" is to fit on 60 mm
constexpr double kLeastFeature_mm = 0.8;  // two lines of a common nozzle
constexpr double kSource_mm = 0.02;       // how near the source's moves come to the face's own
constexpr double kSlight_mm = 0.1;        // of an expression's offsets, what the source leaves out

BaseShape find_shape(const std::string& word) {
  if (word == "round") return BaseShape::round;
  if (word == "square") return BaseShape::square;
  return word == "plinth" ? BaseShape::plinth : BaseShape::none;
}

Base find_base(const BustSpec& bust) {
  Base base;
  base.shape = find_shape(bust.base);
  base.height_mm = base.shape == BaseShape::none ? 0 : kBaseHeight * bust.height_mm;
  base.radius_mm = (base.shape == BaseShape::plinth ? kPlinth : kBaseRadius) * bust.height_mm;
  base.label = bust.label;
  base.magnet_diameter_mm = bust.magnet_mm.x;
  base.magnet_depth_mm = bust.magnet_mm.y;
  return base;
}

// What is fine enough for layers of 0.2 mm, and still opens at once in OpenSCAD.
int count_triangles(const BustSpec& bust, bool has_hair) {
  constexpr double kAt80mm = 30000, kFewest = 15000, kMost = 45000, kHair = 4.0 / 3;  // times as many
  if (bust.triangles > 0) return bust.triangles;
  return int((has_hair ? kHair : 1) * std::clamp(kAt80mm * bust.height_mm / 80, kFewest, kMost));
}

BustSize compute_size(const BustSpec& bust, bool has_hair) {
  BustSize size;
  size.stand = bust.base == "none" ? Stand::flat : Stand::foot;
  size.whole_mm = bust.height_mm;
  size.figure_mm = bust.height_mm - find_base(bust).height_mm;
  size.triangles = static_cast<std::size_t>(count_triangles(bust, has_hair));
  return size;
}

Mesh build_figure_mesh(const BustBody& body, std::vector<glm::vec3> positions, double lift_mm) {
  for (glm::vec3& p : positions) p.z += static_cast<float>(lift_mm);
  return {std::move(positions), {}, body.triangles};
}

// Ears, lids and lips as thick as a nozzle needs, alike in every pose, and in none of the menu's through each
// other; what formulas look for stays.
void thicken(const BustCache& cache, BustBody& body) {
  constexpr double kWide = 0.7;  // a mouth so far open has drawn its lips thin
  constexpr float kStill_mm = 0.05f;
  static const std::size_t kChinDown = find_move(Area::chin, Side::none, "down").value();
  const std::vector<bool> is_fixed = list_fixed(body);
  const std::vector<glm::vec3> rest = place_bust(body, cache.figure, Pose{});
  std::vector<glm::vec3> moves = compute_thickening(build_figure_mesh(body, rest, 0), kLeastFeature_mm);
  for (std::size_t v = 0; v < moves.size(); ++v)
    if (is_fixed[v]) moves[v] = glm::vec3(0);
  for (const NamedPose& named : cache.menu) {
    if (!named.is_shown || named.pose.values[kChinDown] < kWide) continue;
    std::vector<glm::vec3> positions = place_bust(body, cache.figure, named.pose);
    std::vector<bool> is_posed(moves.size());  // the others are as they are at rest
    for (std::size_t v = 0; v < moves.size(); ++v) {
      is_posed[v] = glm::distance(positions[v], rest[v]) > kStill_mm;
      positions[v] += moves[v];
    }
    const std::vector<glm::vec3> more =
        compute_thickening(build_figure_mesh(body, std::move(positions), 0), kLeastFeature_mm);
    for (std::size_t v = 0; v < moves.size(); ++v)
      if (is_posed[v] && !is_fixed[v]) moves[v] += more[v];
  }
  std::vector<std::vector<glm::vec3>> poses(cache.menu.size());
  for_each_index(poses.size(), count_workers(),
                 [&](std::size_t i, int) { poses[i] = place_bust(body, cache.figure, cache.menu[i].pose); });
  hold_apart(poses, body.triangles, kLeastFeature_mm, moves);
  body.thicker = std::move(moves);
}

BustCache::Body& find_body(BustCache& cache, const BustSpec& bust) {
  const BustSize size = compute_size(bust, wears_hair(cache.figure));
  for (BustCache::Body& entry : cache.bodies)
    if (entry.size == size) return entry;
  BustCache::Body& entry = cache.bodies.emplace_back();
  entry.size = size;
  entry.body = build_bust_body(cache.figure, size);
  thicken(cache, entry.body);
  return entry;
}

// What the body is in all poses, once.
void add_poses(const BustCache& cache, BustCache::Body& entry) {
  if (!entry.surfaces.triangles.empty()) return;
  entry.surfaces = join_poses(entry.body.triangles, add_bust_controls(entry.body, cache.figure, cache.menu,
                                                                      kSource_mm, kSlight_mm, entry.source));
  entry.source.height_mm = entry.size.whole_mm;
  entry.source.figure_mm = entry.size.figure_mm;
}

// Where a cavity has room in every pose: for the wall asked for and some others, which the source offers.
const CavityPlan& find_cavity_plan(BustCache::Body& entry, double wall_mm) {
  constexpr double kWalls[] = {0.0125, 0.025, 0.045};  // of the height
  constexpr double kBeside = 0.1;                      // of the wall asked for: nearer ones say nothing new
  constexpr double kStraight = 0.06;  // of the figure: the drain goes straight up so far at least
  const auto [place, is_new] = entry.cavities.try_emplace(wall_mm);
  if (!is_new) return place->second;
  const Loop& foot = entry.body.foot;
  CavityRequest request;
  for (std::size_t i = 0; i < foot.size(); i += foot.size() % 2 == 0 ? 2 : 1)
    request.directions.push_back(glm::normalize(glm::dvec2(entry.source.rest[foot[i]])));
  request.low_mm = std::min(0.0, entry.source.other_foot_mm);
  request.straight_mm = std::max(0.0, entry.source.other_foot_mm) + kStraight * entry.size.figure_mm;
  request.walls_mm = {wall_mm};
  for (const double share : kWalls)
    if (const double other = share * entry.size.whole_mm; std::abs(other - wall_mm) > kBeside * wall_mm)
      request.walls_mm.push_back(other);
  std::sort(request.walls_mm.begin(), request.walls_mm.end());
  return place->second = plan_cavity(entry.surfaces, request);
}

Hollow compute_hollow(const BustSpec& bust, const Base& base) {
  Hollow hollow{bust.wall_mm, bust.drain_mm, base.height_mm};
  hollow.pocket_mm = base.magnet_diameter_mm;
  hollow.pocket_depth_mm = base.magnet_diameter_mm > 0 ? base.magnet_depth_mm : 0;
  return hollow;
}

glm::vec3 compute_colour(const Model& model, std::string_view part, const glm::vec3& otherwise) {
  for (const Part& p : model.parts)
    if (p.name == part) return p.palette.front().srgb;
  return otherwise;
}

// The triangles of a patch: they follow each other.
ColourRange find_range(const BustBody& body, const Patch& patch, std::string name, const glm::vec3& srgb) {
  ColourRange range{std::move(name), srgb, 0, 0};
  const auto is_of = [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) {
      return v >= patch.first && v < patch.first + patch.vertex_count();
    });
  };
  const auto first = std::find_if(body.triangles.begin(), body.triangles.end(), is_of);
  range.first = static_cast<std::size_t>(first - body.triangles.begin());
  range.count = static_cast<std::size_t>(std::find_if_not(first, body.triangles.end(), is_of) - first);
  return range;
}

// Of a body that has hair: its last triangles.
ColourRange find_hair(const BustBody& body, const Model& model) {
  const auto first = std::ranges::find_if(body.triangles, [&](const Triangle& t) {
    return std::ranges::any_of(t, [&](std::uint32_t v) { return v >= body.first_hair; });
  });
  const auto before = static_cast<std::size_t>(first - body.triangles.begin());
  return {"hair", compute_colour(model, "hair_mass", glm::vec3(0.3f)), before,
          body.triangles.size() - before};
}

std::vector<ColourRange> list_colours(const BustBody& body, const Model& model) {
  const glm::vec3 white = compute_colour(model, "eye_left", glm::vec3(0.92f));
  const glm::vec3 red = compute_colour(model, "tongue", {0.55f, 0.2f, 0.2f});
  std::vector<ColourRange> ranges{{"skin", compute_colour(model, "skin", glm::vec3(0.8f)), 0, 0},
                                  find_range(body, body.eyes[0], "eye left", white),
                                  find_range(body, body.eyes[1], "eye right", white),
                                  find_range(body, body.mouth, "mouth", red)};
  if (body.hair.is_on()) ranges.push_back(find_hair(body, model));
  ranges[0].count = ranges[1].first;  // and all that is in no range
  return ranges;
}

// The menu's entry with this expression's pose and, at its beginning, its name; nullptr if there is none.
const NamedPose* find_menu_entry(const std::vector<NamedPose>& menu, const Expression& expression) {
  for (const NamedPose& known : menu)
    if (known.name.starts_with(expression.name) && known.pose.values == expression.pose.values) return &known;
  return nullptr;
}

// What the source says beyond its body.
PosableBust describe_source(const BustCache& cache, const PosableBust& body, const BustSpec& bust,
                            const Base& base) {
  PosableBust source = body;
  source.title = fmt::format("{}: {}", cache.title, bust.expression.name);
  const NamedPose* entry = find_menu_entry(cache.menu, bust.expression);
  source.expression = entry != nullptr ? entry->name : bust.expression.name;
  source.base_shape = bust.base;
  source.base_height_mm = base.shape == BaseShape::none ? kBaseHeight * bust.height_mm : base.height_mm;
  source.base_radius_mm = base.radius_mm;
  source.label = base.shape == BaseShape::none ? "" : bust.label;
  source.letters = build_openscad_letters(cache.letters);
  source.magnet_diameter_mm = bust.magnet_mm.x;
  source.magnet_depth_mm = bust.magnet_mm.x > 0 ? bust.magnet_mm.y : 2;
  source.is_hollow = bust.is_hollow;
  source.wall_mm = bust.wall_mm;
  source.drain_mm = bust.drain_mm;
  return source;
}

// The figure on its base, closed but for the drain's loop in the underside and the vent's mouth in the back.
Loop build_outside(const BustBody& body, const std::vector<glm::vec3>& positions, const Base& base,
                   const Letters& letters, double drain_mm, Mesh& mesh, VentMouth* vent = nullptr) {
  mesh = build_figure_mesh(body, positions, base.height_mm);
  return append_base(mesh, body.foot, base, letters, drain_mm, vent);
}

void hollow_out(const BustBody& body, const std::vector<glm::vec3>& positions, const Base& base,
                const Letters& letters, const Cavity& cavity, double drain_mm, MadeBust& made) {
  const Mesh solid = std::move(made.mesh);
  VentMouth vent{find_vent(base, cavity.drain_mm), {}, {}};
  const Loop drain = build_outside(body, positions, base, letters, cavity.drain_mm, made.mesh, &vent);
  const std::size_t first = append_cavity(made.mesh, cavity, drain, vent);
  made.report = measure_print(made.mesh, first, made.mesh.triangles.size() - first);
  made.report.least_wall_mm = measure_wall_mm(solid, cavity);
  made.report.drain_mm = cavity.drain_mm;
  made.report.vent_mm = {vent.vent.width_mm, vent.vent.high_mm - vent.vent.low_mm};
  update_warnings(made.report);
  if (cavity.drain_mm < drain_mm - 0.05)
    made.report.warnings.push_back(fmt::format(
        "Its drain is {:.1f} mm wide instead of {} mm: the base leaves no room for more. A thinner "
        "wall makes room, and so does 'base: none'.",
        cavity.drain_mm, drain_mm));
}

// What was left of a label that is too long for its base.
void report_label(const Base& base, const BustBody& body, const std::vector<glm::vec3>& positions,
                  const Letters& letters, PrintReport& report) {
  std::vector<glm::vec3> foot;
  for (const std::uint32_t v : body.foot)
    foot.push_back(positions[v] + glm::vec3(0, 0, static_cast<float>(base.height_mm)));
  const Label label = fit_label(base, foot, letters);
  if (label.is_cut) report.warnings.push_back(fmt::format("Its label has room for '{}' only.", label.text));
}

}  // namespace

std::vector<NamedPose> list_bust_menu(const Spec& spec, const std::vector<BustSpec>& busts) {
  std::vector<NamedPose> menu;
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(menu.begin(), menu.end(), [&](const NamedPose& known) { return known.name == name; });
  };
  for (const BustSpec& bust : busts) {
    const Expression& expression = bust.expression;
    if (find_menu_entry(menu, expression) != nullptr) continue;
    std::string name = expression.name;
    for (int number = 2; is_taken(name); ++number) name = fmt::format("{}_{}", expression.name, number);
    menu.push_back({name, expression.pose, true});
  }
  for (const Expression& expression : spec.expressions) {
    if (!expression.library.empty() && expression.library != spec.library) continue;
    if (find_menu_entry(menu, expression) != nullptr) continue;
    const std::string whole = fmt::format("{}/{}", spec.library, expression.name);
    menu.push_back({is_taken(expression.name) ? whole : expression.name, expression.pose});
  }
  return menu;
}

std::vector<Mesh> build_plates(const std::vector<Mesh>& busts, const glm::dvec2& plate_mm) {
  constexpr double kGap_mm = 5;  // a skirt and a scraper between two
  std::vector<glm::dvec2> footprints;
  std::vector<Box> boxes;
  for (const Mesh& bust : busts) {
    boxes.push_back(compute_bounds(bust.positions));
    footprints.emplace_back(glm::dvec3(boxes.back().high) - glm::dvec3(boxes.back().low));
  }
  std::vector<Mesh> plates;
  const std::vector<PlatePlace> places = arrange_plates(footprints, plate_mm, kGap_mm);
  for (std::size_t i = 0; i < busts.size(); ++i) {
    if (places[i].plate >= plates.size()) plates.resize(places[i].plate + 1);
    Mesh moved = busts[i];
    const glm::vec3 shift(glm::vec2(places[i].low) - glm::vec2(boxes[i].low), 0);
    for (glm::vec3& p : moved.positions) p += shift;
    append_mesh(plates[places[i].plate], moved);
  }
  return plates;
}

std::string describe_unprinted_hair(const Model& model, bool wears_hair) {
  const auto has = [&](std::string_view name) {
    return std::any_of(model.parts.begin(), model.parts.end(),
                       [&](const Part& part) { return part.name.starts_with(name); });
  };
  const bool has_hair = has("hair") && !wears_hair, has_beard = has("beard");
  if (!has_hair && !has_beard) return {};
  return fmt::format("Its {} not printed: hair is finer than any nozzle.", has_hair && has_beard
                                                                               ? "hair and beard are"
                                                                           : has_hair ? "hair is"
                                                                                      : "beard is");
}

MadeBust make_bust(BustCache& cache, const BustSpec& bust) {
  BustCache::Body& entry = find_body(cache, bust);
  const Base base = find_base(bust);
  std::vector<glm::vec3> positions = place_bust(entry.body, cache.figure, bust.expression.pose);
  relax_print(entry.body, positions);
  MadeBust made;
  made.colours = list_colours(entry.body, cache.figure.model);
  const std::array<std::function<void()>, 2> works{
      [&] {
        add_poses(cache, entry);
        made.source = describe_source(cache, entry.source, bust, base);
        made.source.cavity = find_cavity_plan(entry, bust.wall_mm);
      },
      [&] {
        build_outside(entry.body, positions, base, cache.letters, 0, made.mesh);
        if (!bust.is_hollow) made.report = measure_print(made.mesh);
      }};
  for_each_index(works.size(), count_workers(), [&](std::size_t i, int) { works[i](); });
  if (bust.is_hollow)
    hollow_out(entry.body, positions, base, cache.letters,
               build_cavity(made.source.cavity, compute_hollow(bust, base)), bust.drain_mm, made);
  report_label(base, entry.body, positions, cache.letters, made.report);
  if (const std::string hair = describe_unprinted_hair(cache.figure.model, entry.body.hair.is_on());
      !hair.empty())
    made.report.warnings.push_back(hair);
  return made;
}

}  // namespace mien
