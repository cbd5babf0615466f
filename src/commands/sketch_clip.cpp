#include "commands/sketch_clip.hpp"

#include "clip/beside.hpp"
#include "clip/outputs.hpp"
#include "clip/pictures.hpp"
#include "commands/report.hpp"
#include "core/text.hpp"

namespace mien {

ClipParts plan_parts(const Options& options, const Resources& resources) {
  ClipParts planned{plan_clip(options, *resources.stock.language), {}};
  for (const std::string& design : options.beside)
    planned.parts.push_back(redesign_clip(planned.clip, design, resources.stock.head->designs));
  return planned;
}

std::vector<Cast> build_casts(const ClipParts& planned, const HeadStock& stock, FigureStore* store) {
  std::vector<Cast> casts;
  if (planned.parts.empty()) casts.push_back(build_cast(planned.clip, stock, store));
  for (const Clip& part : planned.parts) casts.push_back(build_cast(part, stock, store));
  return casts;
}

void sketch_clip(const Options& options, const ClipParts& planned, const std::vector<Cast>& casts,
                 const Resources& resources, SketchStore* store) {
  std::vector<Staged> staged;
  for (std::size_t i = 0; i < casts.size(); ++i) {
    staged.push_back({planned.parts.empty() ? &planned.clip : &planned.parts[i], &casts[i]});
    report_starts(options, list_heads(*staged.back().clip), resources.heads);
    report_clip_held(options, *staged.back().clip, casts[i], resources.heads);
  }
  const Clip whole = widen_clip(planned.clip, staged.size());
  Progress progress = start_progress(options, "sketches", whole.plan.drawings.size());
  const Letters letters = find_letters(resources.stock.templates);
  SketchVideos videos = start_sketch_videos(whole, letters);
  sketch_drawings(staged, resources, count_jobs(options), store,
                  [&](std::size_t drawing, const Pixels& picture, bool was_kept) {
                    append_drawing(videos, drawing, picture);
                    progress.advance(was_kept, whole.plan.drawings[drawing]);
                  });
  progress.finish();
  finish_sketch_videos(videos);
  write_file(whole.files.folder / kSketchManifest, build_sketch_manifest(whole));
  for (const std::filesystem::path& video : list_video_paths(whole)) report_result(options, "clip", video);
}

}  // namespace mien
