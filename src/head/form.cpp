#include "head/form.hpp"

#include <array>
#include <functional>

#include "config/part_numbers.hpp"
#include "core/pool.hpp"
#include "head/contact.hpp"
#include "head/nostrils.hpp"
#include "head/own_half.hpp"
#include "head/sculpt.hpp"
#include "head/shapes.hpp"
#include "head/solve.hpp"
#include "head/surface.hpp"
#include "head/wrap.hpp"

namespace mien {

namespace {

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
  if (spec.mesh) return build_own_half(stock, spec.mesh->path);
  if (spec.scan) return wrap_head(stock, load_scan_files(stock, spec.scan->path, false));
  if (!spec.mix.empty()) return mix_forms(stock, spec.mix);
  return {stock.adult.points, Eye{}};
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
  sculpt_form(stock, spec.sculpt, form);
  return form;
}

}  // namespace mien
