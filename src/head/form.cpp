#include "head/form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <list>
#include <map>
#include <mutex>

#include "config/head_files.hpp"
#include "config/part_numbers.hpp"
#include "core/pool.hpp"
#include "core/shared_cache.hpp"
#include "head/cage.hpp"
#include "head/contact.hpp"
#include "head/design.hpp"
#include "head/nostrils.hpp"
#include "head/own_half.hpp"
#include "head/sculpt.hpp"
#include "head/shapes.hpp"
#include "head/solve.hpp"
#include "head/stock_things.hpp"
#include "head/surface.hpp"
#include "head/wrap.hpp"

namespace mien {

constexpr std::size_t kMostStarts = 64;  // kept at once, some 100 kB each
constexpr std::size_t kMostThings = 16;  // of share_any_thing, some megabytes each

struct StartStore {
  std::mutex mutex;
  std::map<std::string, std::size_t> numbers;  // of files as they are
  SharedCache<Wrap> starts{kMostStarts};
  std::mutex things_mutex;
  struct Thing {
    HeadDataPointer data;  // what it is made from: a copy of a stock may have other data
    std::string name;
    std::shared_ptr<const void> made;
  };
  std::list<Thing> things;  // the one used last comes first
};

std::shared_ptr<const void> share_any_thing(const HeadStock& stock, const std::string& name,
                                            const std::function<std::shared_ptr<const void>()>& build) {
  if (!stock.starts) return build();
  StartStore& store = *stock.starts;
  const auto find = [&]() -> std::shared_ptr<const void> {
    const auto found = std::ranges::find_if(store.things, [&](const StartStore::Thing& thing) {
      return thing.data == stock.data && thing.name == name;
    });
    if (found == store.things.end()) return nullptr;
    store.things.splice(store.things.begin(), store.things, found);
    return store.things.front().made;
  };
  {
    const std::lock_guard lock(store.things_mutex);
    if (auto known = find()) return known;
  }
  std::shared_ptr<const void> thing = build();
  const std::lock_guard lock(store.things_mutex);
  if (auto known = find()) return known;  // somebody else was quicker
  store.things.push_front({stock.data, name, thing});
  if (store.things.size() > kMostThings) store.things.pop_back();
  return thing;
}

namespace {

namespace fs = std::filesystem;

// What the mesh or the scan was made into, once, however many heads are made from it.
std::shared_ptr<const Wrap> find_start(const HeadStock& stock, const fs::path& file, bool is_half) {
  const auto build = [&] {
    return is_half ? build_own_half(stock, file) : wrap_scan(stock, load_scan_files(stock, file, false));
  };
  if (!stock.starts) return std::make_shared<const Wrap>(build());
  const std::string key = (is_half ? "mesh " : "scan ") + describe_mesh_state(file);
  std::size_t number = 0;
  {
    const std::lock_guard lock(stock.starts->mutex);
    number = stock.starts->numbers.try_emplace(key, stock.starts->numbers.size()).first->second;
  }
  return share_thing<Wrap>(stock.starts->starts, number, build);
}

void settle_contacts(const HeadStock& stock, const Eye& eye, Cage& cage) {
  seat_lids(*stock.surface, stock.data->parts.eye, eye, cage);
  part_lips(*stock.surface, cage);
}

HeadForm mix_forms(const HeadStock& stock, const std::vector<HeadShare>& shares) {
  HeadForm sum = make_empty_form(stock.adult);
  for (const auto& [head, weight] : shares) add_form(sum, build_form(stock, head), weight);
  return sum;
}

HeadForm build_start(const HeadStock& stock, const HeadSpec& spec) {
  if (spec.mesh) return find_start(stock, spec.mesh->path, true)->form;
  if (spec.scan) return find_start(stock, spec.scan->path, false)->form;
  if (!spec.mix.empty()) return mix_forms(stock, spec.mix);
  return {stock.adult.points, Eye{}};
}

// Gives the head its design.
void redraw(const HeadStock& stock, const HeadSpec& spec, const HeadForm& start, HeadForm& form) {
  if (spec.design == HeadSpec{}.design) return;
  const DesignNumbers design = compute_design(stock, spec);
  HeadForm average = start;
  if (design.difference != 1) {
    HeadSpec plain;
    plain.age = spec.age;
    shape_head(stock.data->shapes.heads, plain, stock.adult, average);
  }
  const std::uint32_t chin = find_point(stock.adult, "m12_D1");
  const double drop_mm = form.eye.centre.y - form.points[chin].y;
  const std::vector<glm::dvec3> before = form.points;
  apply_design(stock.adult, design, average, form);
  form.shortened_mm += drop_mm - (form.eye.centre.y - form.points[chin].y);
  keep_nostrils(stock.adult, before, form.points);
  Cage cage = stock.adult;
  cage.points = std::move(form.points);
  touch_ball(*stock.surface, stock.data->parts.eye, form.eye, cage);
  part_lips(*stock.surface, cage);
  form.points = std::move(cage.points);
}

// Parts what sums of changes have brought into each other's way. Sculpting comes after it: it is free.
void settle(const HeadStock& stock, const HeadForm& start, HeadForm& form) {
  if (form.points == stock.adult.points) return;  // settled when it was loaded
  keep_nostrils(stock.adult, start.points, form.points);
  Cage cage = stock.adult;
  cage.points = std::move(form.points);
  settle_contacts(stock, form.eye, cage);
  form.points = std::move(cage.points);
}

}  // namespace

HeadStock build_head_stock(HeadDataPointer data) {
  HeadStock stock;
  stock.starts = std::make_shared<StartStore>();
  stock.data = std::move(data);
  stock.adult = build_cage(stock.data->half);
  const Cage unsolved = stock.adult;  // the surface asks for its quads only
  const std::array<std::function<void()>, 2> works{
      [&] { solve_cage(stock.data->half, stock.adult); },
      [&] { stock.surface = std::make_shared<const Surface>(build_surface(unsolved)); }};
  for_each_index(works.size(), count_workers(), [&](std::size_t i, int) { works[i](); });
  settle_contacts(stock, Eye{}, stock.adult);
  return stock;
}

NeutralHead build_bare_head(const HeadStock& stock, const std::vector<glm::dvec3>& points) {
  NeutralHead head;
  head.data = stock.data;
  head.cage = stock.adult;
  head.cage.points = points;
  head.hairline = kAdultHairline;
  std::vector<Float4> packed;
  pack_points(points, packed);
  deform_surface(*stock.surface, packed, head.skin.positions);
  return head;
}

HeadForm build_form(const HeadStock& stock, const HeadSpec& spec) {
  const HeadForm start = build_start(stock, spec);
  HeadForm form = start;
  shape_head(stock.data->shapes.heads, spec, stock.adult, form);
  settle(stock, start, form);
  redraw(stock, spec, start, form);
  sculpt_form(stock, spec.sculpt, form);
  return form;
}

std::vector<StartNote> list_start_notes(const HeadStock& stock, const HeadSpec& spec) {
  if (spec.mesh || spec.scan) {
    const FileReference& file = spec.mesh ? *spec.mesh : *spec.scan;
    const auto start = find_start(stock, file.path, spec.mesh.has_value());
    return {{file, spec.scan ? start->kept : std::vector<std::string>{}, start->warnings}};
  }
  std::vector<StartNote> notes;
  for (const HeadShare& share : spec.mix)
    for (StartNote& note : list_start_notes(stock, share.head)) notes.push_back(std::move(note));
  return notes;
}

}  // namespace mien
