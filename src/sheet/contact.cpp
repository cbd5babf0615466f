#include "sheet/contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "clip/outputs.hpp"
#include "clip/sketches.hpp"
#include "clip/slate.hpp"
#include "clip/trace.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "render/process.hpp"
#include "render/progress.hpp"
#include "render/work_folder.hpp"
#include "scene/plate.hpp"
#include "sketch/lettering.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostContacts = 48;  // unless --every asks for more
constexpr int kContactWidth_px = 200;
constexpr int kMostSide_px = 20000;  // of a page
constexpr std::array<std::uint8_t, 3> kPaper{226, 222, 213}, kInk{42, 38, 36}, kPencil{150, 60, 50};

// Where things lie on the page, px.
struct ContactLayout {
  int columns = 1, rows = 1;
  int gap = 8, capital = 8, caption = 30, title = 40;
  PictureSize cell, page;
};

ContactLayout lay_out(std::size_t count, const PictureSize& cell) {
  constexpr double kWide = 1.5;  // a page's width for its height
  ContactLayout layout;
  layout.cell = cell;
  layout.gap = std::max(4, cell.width_px / 25);
  layout.capital = std::max(7, cell.width_px / 22);
  layout.caption = 4 * layout.capital;
  layout.title = 5 * layout.capital;
  const double row_px = cell.height_px + layout.caption, column_px = cell.width_px + layout.gap;
  const double square = kWide * static_cast<double>(count) * row_px / column_px;
  layout.columns = std::clamp(static_cast<int>(std::lround(std::sqrt(square))), 1, static_cast<int>(count));
  layout.rows = (static_cast<int>(count) + layout.columns - 1) / layout.columns;
  layout.page = {layout.gap + layout.columns * (cell.width_px + layout.gap),
                 layout.title + layout.rows * (cell.height_px + layout.caption) + layout.gap};
  if (std::max(layout.page.width_px, layout.page.height_px) > kMostSide_px)
    throw InputError(
        fmt::format("--size: the sheet would have {}x{} pixels; expected pictures so small or so "
                    "few that no side has more than {}",
                    layout.page.width_px, layout.page.height_px, kMostSide_px));
  return layout;
}

// The clip with some of its drawings, each of which one frame shows.
Clip choose_drawings(const Clip& clip, const Options& options) {
  const std::vector<int>& all = clip.plan.drawings;
  const std::size_t every = options.every ? static_cast<std::size_t>(*options.every)
                                          : (all.size() + kMostContacts - 1) / kMostContacts;
  Clip some = clip;
  some.plan.drawings.clear();
  for (std::size_t i = 0; i < all.size(); i += every) some.plan.drawings.push_back(all[i]);
  some.plan.frames = some.plan.drawn_as = some.plan.drawings;
  return some;
}

void lay_picture(Pixels& page, const Pixels& picture, int left_px, int top_px) {
  if (picture.alpha.empty()) return paste_pixels(page, picture, left_px, top_px);
  const auto width = static_cast<std::size_t>(picture.size.width_px);
  for (std::size_t i = 0; i < picture.alpha.size(); ++i) {
    const std::size_t x = static_cast<std::size_t>(left_px) + i % width,
                      y = static_cast<std::size_t>(top_px) + i / width;
    cover_pixel(page, y * static_cast<std::size_t>(page.size.width_px) + x,
                {picture.rgb[3 * i], picture.rgb[3 * i + 1], picture.rgb[3 * i + 2]},
                picture.alpha[i] / 255.0);
  }
}

struct ContactPage {
  const Clip& clip;
  ContactLayout layout;
  Letters letters;
  Pixels pixels;
};

ContactPage start_page(const Clip& clip, const ContactLayout& layout, const Templates& templates) {
  ContactPage page{clip, layout, find_letters(templates), make_pixels(layout.page)};
  cover_box(page.pixels, 0, 0, layout.page, kPaper, 1);
  WrittenLine line;
  line.words = fmt::format("{}, {} frames at {} a second, {} of its drawings",
                           simplify_letters(clip.spec.title.empty() ? clip.spec.name : clip.spec.title),
                           clip.frame_count, clip.spec.clip.fps, clip.plan.drawings.size());
  line.left_px = layout.gap;
  line.capital_px = 1.5 * layout.capital;
  line.base_px = 0.6 * layout.title;
  line.width_px = layout.page.width_px - 2 * layout.gap;
  line.srgb = kInk;
  write_line(page.pixels, line, page.letters);
  return page;
}

void place_drawing(ContactPage& page, std::size_t drawing, const Pixels& picture) {
  const ContactLayout& layout = page.layout;
  const int column = static_cast<int>(drawing) % layout.columns,
            row = static_cast<int>(drawing) / layout.columns;
  const int left = layout.gap + column * (layout.cell.width_px + layout.gap),
            top = layout.title + row * (layout.cell.height_px + layout.caption);
  lay_picture(page.pixels, picture, left, top);
  const Slate slate = build_slate(page.clip, page.clip.plan.drawings[drawing]);
  WrittenLine line;
  line.capital_px = layout.capital;
  line.base_px = top + layout.cell.height_px + 1.5 * layout.capital;
  const auto write = [&](const std::string& words, double from, double to, double align,
                         const std::array<std::uint8_t, 3>& srgb) {
    line.words = words;
    line.left_px = left + from * layout.cell.width_px;
    line.width_px = (to - from) * layout.cell.width_px;
    line.align = align;
    line.srgb = srgb;
    write_line(page.pixels, line, page.letters);
  };
  write(slate.frame.substr(0, slate.frame.find('/')), 0, 0.4, 0, kInk);
  write(slate.time, 0.4, 1, 1, kInk);
  line.base_px += 1.5 * layout.capital;
  write(slate.keys, 0, 1, 0, kPencil);
}

Progress start_drawings(const Options& options, std::size_t count) {
  return {stderr, compute_progress_style(stderr, options.is_quiet, options.is_json), "drawings",
          static_cast<int>(count)};
}

void sketch_page(const Options& options, const Cast& cast, const Resources& resources, ContactPage& page) {
  Progress progress = start_drawings(options, page.clip.plan.drawings.size());
  sketch_drawings({{&page.clip, &cast}}, resources, count_jobs(options), nullptr,
                  [&](std::size_t drawing, const Pixels& picture, bool was_kept) {
                    place_drawing(page, drawing, picture);
                    progress.advance(was_kept, page.clip.plan.drawings[drawing]);
                  });
  progress.finish();
}

void trace_page(const Options& options, const Cast& cast, const Resources& resources, ContactPage& page) {
  const int jobs = count_jobs(options);
  TraceRun run{{page.clip, cast, resources, jobs}, find_store(page.clip), {}, {}};
  compute_keys(run, jobs, [](int) {});
  Progress progress = start_drawings(options, page.clip.plan.drawings.size());
  trace_into_store(run, jobs, [&](int frame, bool was_kept) { progress.advance(was_kept, frame); });
  progress.finish();
  for (std::size_t i = 0; i < run.keys.size(); ++i)
    place_drawing(page, i, read_pixels(run.store.picture(run.keys[i])));
}

}  // namespace

fs::path write_contact_sheet(const Options& options, const Resources& resources) {
  Options of_clip = options;
  of_clip.output.reset();
  Clip clip = plan_clip(of_clip, *resources.stock.language);
  RenderSpec& render = clip.spec.render;
  const OutputFile file = find_output_file(
      options, fs::path("out") / clip.spec.name / (is_sketch(render) ? "contact_sketch.png" : "contact.png"));
  check_ending(file, "sheet", {".png"});
  check_output_files({file}, clip.spec);
  if (!options.size_px) {
    render.height_px = std::clamp(kContactWidth_px * render.height_px / render.width_px, kContactWidth_px / 4,
                                  kContactWidth_px * 4);
    render.width_px = kContactWidth_px;
  }
  clip = choose_drawings(clip, options);
  const ContactLayout layout = lay_out(clip.plan.drawings.size(), {render.width_px, render.height_px});
  if (!is_sketch(render)) require_programs({{"povray", "povray"}});
  const Cast cast = build_cast(clip, resources.heads);
  ContactPage page = start_page(clip, layout, resources.stock.templates);
  if (is_sketch(render))
    sketch_page(options, cast, resources, page);
  else
    trace_page(options, cast, resources, page);
  remove_left_parts_of(file.path);
  write_file(file.path, build_png(page.pixels));
  return file.path;
}

}  // namespace mien
