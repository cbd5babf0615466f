#include "clip/farm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "clip/pictures.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "render/picture.hpp"
#include "scene/povray.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

// The clip with these drawings alone, each the one frame that shows it.
Clip narrow_clip(const Clip& clip, std::vector<int> frames) {
  std::ranges::sort(frames);
  Clip narrow = clip;
  narrow.plan.frames = narrow.plan.drawn_as = narrow.plan.drawings = frames;
  return narrow;
}

bool has_picture_anywhere(const Clip& clip, int frame, const std::string& key) {
  return has_picture(find_store(clip), key) || read_picture_key(clip.files.picture(frame)) == key;
}

[[noreturn]] void tell_changed(const Clip& clip, int frame) {
  throw RunError(fmt::format(
      "frame {} of {} is another drawing than when the jobs were submitted: the file, or what it reads, has "
      "changed since; submit again",
      frame, clip.files.folder.string()));
}

}  // namespace

fs::path FarmFiles::log(int part) const { return folder / fmt::format("{}.log", part); }
fs::path FarmFiles::work(int part) const { return folder / fmt::format("part{}", part); }

bool is_farm_file(const std::string& name) {
  const FarmFiles files{fs::path()};
  for (const fs::path& file : {files.plan(), files.tasks_script(), files.clip_script(), files.clip_log(),
                               files.done(), files.cost()})
    if (file.filename() == name) return true;
  return name.ends_with(".log") && name.size() > 4 && name.find_first_not_of("0123456789") == name.size() - 4;
}

std::vector<FarmDrawing> list_farm_drawings(const std::vector<FarmClip>& clips, const Resources& resources,
                                            int jobs, const SceneWritten& computed) {
  std::vector<FarmDrawing> drawings;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const Clip& clip = *clips[i].clip;
    TraceRun run{{clip, *clips[i].cast, resources, jobs}, find_store(clip), {}, {}};
    run.keeps_scenes = false;
    compute_keys(run, jobs, computed);
    std::set<std::string> there;
    for (std::size_t k = 0; k < run.keys.size(); ++k)
      if (has_picture_anywhere(clip, clip.plan.drawings[k], run.keys[k])) there.insert(run.keys[k]);
    for (const std::size_t k : order_coarsely(clip.plan, find_poster_drawing(clip)).order)
      drawings.push_back(
          {{static_cast<int>(i), clip.plan.drawings[k], run.keys[k]}, there.contains(run.keys[k])});
  }
  return drawings;
}

PartPlan plan_parts_of(const std::vector<FarmDrawing>& drawings, std::size_t size, std::size_t most_parts,
                       const std::string& asked) {
  PartPlan plan;
  std::string all = asked;
  std::vector<PartDrawing> missing;
  std::set<std::pair<int, std::string>> seen;
  for (const FarmDrawing& each : drawings) {
    all += fmt::format("\n{} {} {}", each.drawing.clip, each.drawing.frame, each.drawing.key);
    if (!each.is_there && seen.insert({each.drawing.clip, each.drawing.key}).second)
      missing.push_back(each.drawing);
  }
  plan.identity = hash_hex(all);
  auto next = missing.begin();
  for (const std::size_t share : share_out(missing.size(), size, most_parts)) {
    const auto end = next + static_cast<std::ptrdiff_t>(share);
    plan.parts.emplace_back(next, end);
    next = end;
  }
  plan.size = std::max(size, plan.parts.empty() ? 1 : plan.parts.front().size());
  return plan;
}

std::string describe_drawing_kind(const RenderSpec& render) {
  std::string kind = fmt::format("{}x{}", render.width_px, render.height_px);
  for (const std::string& option : list_quality_options(render)) kind += " " + option;
  return kind;
}

double guess_drawing_s(const RenderSpec& render) {
  constexpr double kParsing_s = 0.5, kDraft_s_per_pixel = 8.5e-6, kGood = 2.7, kBest = 6.8;
  const double pixels = static_cast<double>(render.width_px) * render.height_px;
  const double times = render.quality == Quality::best ? kBest : render.quality == Quality::good ? kGood : 1;
  return kParsing_s + pixels * kDraft_s_per_pixel * times;
}

void trace_part(const std::vector<PartDrawing>& part, const std::vector<FarmClip>& clips,
                const Resources& resources, int jobs, const fs::path& work_parent, const FrameDone& done) {
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const Clip& clip = *clips[i].clip;
    const PictureStore store = find_store(clip);
    std::map<int, std::string> missing;  // by frame
    for (const PartDrawing& each : part) {
      if (each.clip != static_cast<int>(i)) continue;
      if (has_picture(store, each.key))
        done(each.frame, true);
      else
        missing[each.frame] = each.key;
    }
    if (missing.empty()) continue;
    std::vector<int> frames;
    for (const auto& [frame, key] : missing) {
      if (std::ranges::find(clip.plan.drawings, frame) == clip.plan.drawings.end()) tell_changed(clip, frame);
      frames.push_back(frame);
    }
    const Clip narrow = narrow_clip(clip, frames);
    TraceRun run{{narrow, *clips[i].cast, resources, jobs}, store, {}, {}};
    run.work_parent = work_parent;
    compute_keys(run, jobs, [](int) {});
    for (std::size_t k = 0; k < run.keys.size(); ++k)
      if (run.keys[k] != missing.at(narrow.plan.drawings[k])) tell_changed(clip, narrow.plan.drawings[k]);
    trace_into_store(run, jobs, done);
  }
}

}  // namespace mien
