#include "clip/rig_take.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "clip/moment.hpp"
#include "core/pool.hpp"

namespace mien {

namespace {

constexpr int kMostHalvings = 4;             // of the time between two frames
constexpr double kBetweenTargets_mm = 0.25;  // of one move; corrections mend the rest
constexpr std::size_t kMostStudied = 600;    // times that corrections are found at; all are measured
constexpr int kMostRounds = 3;               // of studying what was still missing

using Places = std::vector<glm::vec3>;

struct TakeWork {
  const Figure& figure;
  const Performance& performance;
  const RigTakeRequest& request;
  FigureRig rig;
  std::vector<BentPart> bent;
  std::size_t moves = 0;  // how many targets are of moves or poses
  // Corrections: what each adds to the vertices that any of them moves, the longest first; orthogonal.
  std::vector<std::uint32_t> corrected;  // vertices of all bent parts in a row
  std::vector<Places> modes;
};

Moment sample_take(const TakeWork& work, double time_s) {
  return sample_performance(work.performance, work.request.from_s + time_s);
}

// What a bent vertex is before its joints carry it where the drawing has it.
Places free_of_joints(const TakeWork& work, const Drawing& drawing, const RigPose& pose) {
  const std::vector<glm::dmat4> worlds = compute_joint_worlds(work.rig.rig, pose);
  std::vector<glm::dmat4> rests;
  for (const glm::dmat4& world : worlds) rests.push_back(glm::inverse(world));
  Places places = list_bent_places(work.bent, work.figure.model, drawing);
  for (const BentPart& own : work.bent) {
    const std::vector<JointShare>& shares = work.rig.rig.parts[own.part].shares;
    for (std::size_t v = 0; v < own.count; ++v) {
      const JointShare& share = shares[v];
      const bool is_one = share.share == 0 || share.share == 1;
      const glm::dmat4 rest = is_one ? rests[share.share == 0 ? share.first : share.second]
                                     : glm::inverse(blend_joints(share, worlds));
      glm::vec3& place = places[own.first + v];
      place = glm::vec3(rest * glm::dvec4(place, 1));
    }
  }
  return places;
}

// The same as targets of moves or poses have it.
Places blend_targets(const TakeWork& work, const std::vector<float>& weights) {
  Places places;
  for (const BentPart& own : work.bent) {
    const Places& rest = work.figure.model.parts[own.part].rest.positions;
    places.insert(places.end(), rest.begin(), rest.end());
    for (const RigTarget& target : work.rig.rig.parts[own.part].targets) {
      if (target.name >= work.moves || weights[target.name] == 0) continue;
      for (std::size_t i = 0; i < target.places.vertices.size(); ++i)
        places[own.first + target.places.vertices[i]] += weights[target.name] * target.places.offsets[i];
    }
  }
  return places;
}

// What moves alone leave missing at a time, of all bent vertices; `pose` becomes joints and weights of moves.
Places compute_missing(const TakeWork& work, double time_s, RigPose& pose) {
  const Moment moment = sample_take(work, time_s);
  pose = {place_joints(work.rig, work.figure, moment.pose, moment.turn),
          compute_target_weights(work.rig, moment.pose)};
  Places missing = free_of_joints(work, draw_moment(work.figure, moment), pose);
  const Places told = blend_targets(work, pose.weights);
  for (std::size_t v = 0; v < missing.size(); ++v) missing[v] -= told[v];
  return missing;
}

double dot_places(const Places& a, const Places& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += glm::dot(glm::dvec3(a[v]), glm::dvec3(b[v]));
  return sum;
}

float measure_longest(const Places& places) {
  float longest = 0;
  for (const glm::vec3& place : places) longest = std::max(longest, glm::dot(place, place));
  return std::sqrt(longest);
}

Places take_vertices(const Places& places, const std::vector<std::uint32_t>& vertices) {
  Places taken;
  taken.reserve(vertices.size());
  for (const std::uint32_t v : vertices) taken.push_back(places[v]);
  return taken;
}

// Takes from `missing` what the mode has of it; how much that was.
double project_on(const Places& mode, Places& missing) {
  const double share = dot_places(mode, missing) / dot_places(mode, mode);
  for (std::size_t v = 0; v < missing.size(); ++v) missing[v] -= static_cast<float>(share) * mode[v];
  return share;
}

// The weights of corrections for what is missing.
std::vector<float> weigh_corrections(const TakeWork& work, const Places& missing) {
  Places left = take_vertices(missing, work.corrected);
  std::vector<float> weights;
  for (const Places& mode : work.modes) weights.push_back(static_cast<float>(project_on(mode, left)));
  return weights;
}

// The times and those half-way between them, for a blink is over in two frames. Not every one of a long take:
// the first, the last and as many between as may be.
std::vector<double> choose_studied(std::vector<double> times) {
  for (std::size_t i = times.size(); i-- > 1;)
    times.insert(times.begin() + static_cast<std::ptrdiff_t>(i), 0.5 * (times[i - 1] + times[i]));
  if (times.size() <= kMostStudied) return times;
  std::vector<double> chosen;
  for (std::size_t i = 0; i < kMostStudied; ++i)
    chosen.push_back(times[i * (times.size() - 1) / (kMostStudied - 1)]);
  return chosen;
}

// Which vertices are ever further off than a part of what is allowed.
std::vector<std::uint32_t> list_missed(const TakeWork& work, const std::vector<double>& times,
                                       double& worst_mm) {
  const std::size_t workers = count_workers();
  std::vector<std::vector<float>> longest(workers);
  for_each_index(times.size(), static_cast<int>(workers), [&](std::size_t i, int worker) {
    RigPose pose;
    const Places missing = compute_missing(work, times[i], pose);
    std::vector<float>& own = longest[worker];
    own.resize(missing.size(), 0);
    for (std::size_t v = 0; v < missing.size(); ++v) own[v] = std::max(own[v], glm::length(missing[v]));
  });
  std::vector<std::uint32_t> missed;
  const double slight = work.request.is_exact ? 0.001 : 0.25 * work.request.tolerance_mm;
  const std::size_t count = work.bent.back().first + work.bent.back().count;
  for (std::uint32_t v = 0; v < count; ++v) {
    float own = 0;
    for (const std::vector<float>& of : longest)
      if (!of.empty()) own = std::max(own, of[v]);
    worst_mm = std::max(worst_mm, double(own));
    if (own > slight) missed.push_back(v);
  }
  return missed;
}

// Modes of what is missing at the times, over those vertices that miss some.
void find_corrections(TakeWork& work, const std::vector<double>& studied, double& worst_mm) {
  work.modes.clear();
  work.corrected = list_missed(work, studied, worst_mm);
  if (work.corrected.empty()) return;
  std::vector<Places> missing(studied.size());
  for_each_index(studied.size(), count_workers(), [&](std::size_t i, int) {
    RigPose pose;
    missing[i] = take_vertices(compute_missing(work, studied[i], pose), work.corrected);
  });
  while (static_cast<int>(work.modes.size()) < work.request.most_corrections) {
    std::vector<float> longest(missing.size());
    for_each_index(missing.size(), count_workers(),
                   [&](std::size_t i, int) { longest[i] = measure_longest(missing[i]); });
    const std::size_t worst = std::ranges::max_element(longest) - longest.begin();
    if (longest[worst] <= work.request.tolerance_mm) return;
    const Places mode = missing[worst];
    for_each_index(missing.size(), count_workers(),
                   [&](std::size_t i, int) { project_on(mode, missing[i]); });
    work.modes.push_back(mode);
  }
}

// What is missing at each frame, all of it: a target a frame.
void take_frames(TakeWork& work, const std::vector<double>& times, double& worst_mm) {
  work.corrected = list_missed(work, times, worst_mm);
  work.modes.resize(times.size());
  for_each_index(times.size(), count_workers(), [&](std::size_t i, int) {
    RigPose pose;
    work.modes[i] = take_vertices(compute_missing(work, times[i], pose), work.corrected);
  });
}

// A target of each mode, behind those of moves.
void add_corrections(TakeWork& work, const std::vector<Places>& modes, const char* name) {
  constexpr float kSlight_mm = 0.008f;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    work.rig.rig.targets.push_back(fmt::format("{}.{}", name, m + 1));
    std::size_t i = 0;
    for (const BentPart& own : work.bent) {
      RigTarget target{work.rig.rig.targets.size() - 1, {}, {}};
      for (; i < work.corrected.size() && work.corrected[i] < own.first + own.count; ++i) {
        if (glm::length(modes[m][i]) <= kSlight_mm) continue;
        target.places.vertices.push_back(static_cast<std::uint32_t>(work.corrected[i] - own.first));
        target.places.offsets.push_back(modes[m][i]);
      }
      if (!target.places.vertices.empty()) work.rig.rig.parts[own.part].targets.push_back(std::move(target));
    }
  }
}

// The joints at a time, and the target of its frame.
RigPose pose_exactly(const TakeWork& work, double time_s) {
  const Moment moment = sample_take(work, time_s);
  RigPose pose{place_joints(work.rig, work.figure, moment.pose, moment.turn), {}};
  pose.weights.resize(work.rig.rig.targets.size(), 0);
  pose.weights.at(std::lround(time_s * work.request.fps)) = 1;
  return pose;
}

RigPose pose_take(const TakeWork& work, double time_s) {
  if (work.request.is_exact) return pose_exactly(work, time_s);
  RigPose pose;
  const Places missing = compute_missing(work, time_s, pose);
  const std::vector<float> weights = weigh_corrections(work, missing);
  pose.weights.resize(work.moves);
  pose.weights.insert(pose.weights.end(), weights.begin(), weights.end());
  return pose;
}

struct Distance {
  float worst_mm = 0;
  double sum_mm = 0;
  std::size_t part = 0, count = 0;
};

// How far the rig in a pose is from the face at a time.
Distance measure_pose(const TakeWork& work, double time_s, const RigPose& pose) {
  const Drawing drawing = draw_moment(work.figure, sample_take(work, time_s));
  const std::vector<glm::dmat4> worlds = compute_joint_worlds(work.rig.rig, pose);
  Distance found;
  for (std::size_t p = 0; p < drawing.parts.size(); ++p) {
    const Part& part = work.figure.model.parts[p];
    Places truth = drawing.parts[p].positions;
    if (is_carried(part, drawing.parts[p]))
      for (const glm::vec3& rest : part.rest.positions)
        truth.emplace_back(drawing.parts[p].world_from_rest * glm::vec4(rest, 1));
    const Places told = place_rig_part(work.rig.rig.parts[p], part.rest.positions, pose.weights, worlds);
    for (std::size_t v = 0; v < truth.size(); ++v) {
      const float off = glm::distance(truth[v], told[v]);
      if (off > found.worst_mm) found.part = p;
      found.worst_mm = std::max(found.worst_mm, off);
      found.sum_mm += off;
    }
    found.count += truth.size();
  }
  return found;
}

struct Instant {
  double time_s = 0;
  RigPose pose;
};

// Adds instants between two until straight ways between neighbours are near enough; the worst that is left.
double fill_between(const TakeWork& work, const Instant& from, const Instant& to, int depth,
                    std::vector<Instant>& filled) {
  const double middle_s = 0.5 * (from.time_s + to.time_s);
  const double off = measure_pose(work, middle_s, blend_poses(from.pose, to.pose, 0.5)).worst_mm;
  if (depth == 0 || off <= work.request.between_mm || work.request.is_exact) return off;
  const Instant middle{middle_s, pose_take(work, middle_s)};
  const double before = fill_between(work, from, middle, depth - 1, filled);
  filled.push_back(middle);
  return std::max(before, fill_between(work, middle, to, depth - 1, filled));
}

std::vector<double> list_frame_times(const RigTakeRequest& request) {
  std::vector<double> times;
  for (int frame = 0; frame < request.frames; ++frame) times.push_back(frame / request.fps);
  // The last frame is shown for as long as the others.
  if (request.frames > 1) times.push_back(request.frames / request.fps);
  return times;
}

RigTake sample_poses(const TakeWork& work, const std::vector<double>& times, RigError& error) {
  std::vector<Instant> frames(times.size());
  for_each_index(times.size(), count_workers(), [&](std::size_t i, int) {
    frames[i] = {times[i], pose_take(work, times[i])};
  });
  std::vector<std::vector<Instant>> between(times.size());
  std::vector<double> off(times.size(), 0);
  for_each_index(times.size() - 1, count_workers(), [&](std::size_t i, int) {
    off[i] = fill_between(work, frames[i], frames[i + 1], kMostHalvings, between[i]);
  });
  RigTake take;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    error.between_mm = std::max(error.between_mm, off[i]);
    between[i].insert(between[i].begin(), std::move(frames[i]));
    for (Instant& instant : between[i]) {
      take.times_s.push_back(instant.time_s);
      take.poses.push_back(std::move(instant.pose));
    }
  }
  return take;
}

// The offsets of a target times `scale`, as another one.
RigTarget scale_target(const RigTarget& target, std::size_t name, float scale) {
  RigTarget scaled = target;
  scaled.name = name;
  for (glm::vec3& offset : scaled.places.offsets) offset *= scale;
  return scaled;
}

// Weights of corrections from 0 to 1, as Blender's sliders want them: where one goes below, a target of the
// opposite ("correct.4.back") takes that.
void settle_corrections(TakeWork& work, RigTake& take) {
  Rig& rig = work.rig.rig;
  const std::size_t count = rig.targets.size();
  for (std::size_t t = work.moves; t < count; ++t) {
    float low = 0, high = 1e-6f;
    for (const RigPose& pose : take.poses) {
      low = std::min(low, pose.weights[t]);
      high = std::max(high, pose.weights[t]);
    }
    const bool has_back = low < 0;
    const std::size_t back = rig.targets.size();
    if (has_back) rig.targets.push_back(rig.targets[t] + ".back");
    for (RigPart& part : rig.parts) {
      const auto own = std::ranges::find(part.targets, t, &RigTarget::name);
      if (own == part.targets.end()) continue;
      RigTarget opposite = scale_target(*own, back, low);
      *own = scale_target(*own, t, high);
      if (has_back) part.targets.push_back(std::move(opposite));
    }
    for (RigPose& pose : take.poses) {
      const float weight = pose.weights[t];
      pose.weights[t] = std::max(weight, 0.0f) / high;
      if (has_back) pose.weights.push_back(weight < 0 ? weight / low : 0);
    }
  }
}

void measure_take(const TakeWork& work, const RigTake& take, RigError& error) {
  std::vector<Distance> distances(take.poses.size());
  for_each_index(distances.size(), count_workers(), [&](std::size_t i, int) {
    distances[i] = measure_pose(work, take.times_s[i], take.poses[i]);
  });
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    sum += distances[i].sum_mm;
    count += double(distances[i].count);
    if (distances[i].worst_mm <= error.worst_mm) continue;
    error.worst_mm = distances[i].worst_mm;
    error.worst_s = take.times_s[i];
    error.worst_part = work.figure.model.parts[distances[i].part].name;
  }
  error.mean_mm = count > 0 ? sum / count : 0;
}

// The targets of corrections taken out again.
void drop_corrections(TakeWork& work) {
  Rig& rig = work.rig.rig;
  rig.targets.resize(work.moves);
  for (RigPart& part : rig.parts)
    std::erase_if(part.targets, [&](const RigTarget& target) { return target.name >= work.moves; });
}

// Times at which a vertex is further off than it may be. (Joints are exact there, and carry what is missing
// along.)
std::vector<double> list_wrong_times(const TakeWork& work, const RigTake& take) {
  std::vector<float> off(take.poses.size());
  for_each_index(off.size(), count_workers(), [&](std::size_t i, int) {
    off[i] = measure_pose(work, take.times_s[i], take.poses[i]).worst_mm;
  });
  std::vector<double> wrong;
  for (std::size_t i = 0; i < off.size(); ++i)
    if (off[i] > 1.5 * work.request.tolerance_mm) wrong.push_back(take.times_s[i]);
  return wrong;
}

// Corrections by the frames, then by the times between them that are still wrong.
void correct_take(TakeWork& work, const std::vector<double>& times, RiggedClip& clip) {
  std::vector<double> studied = choose_studied(times);
  for (int round = 1;; ++round) {
    drop_corrections(work);
    find_corrections(work, studied, clip.error.uncorrected_mm);
    add_corrections(work, work.modes, "correct");
    clip.error.between_mm = 0;
    clip.take = sample_poses(work, times, clip.error);
    if (round == kMostRounds || static_cast<int>(work.modes.size()) >= work.request.most_corrections) return;
    const std::vector<double> wrong = list_wrong_times(work, clip.take);
    if (wrong.empty()) return;
    studied.insert(studied.end(), wrong.begin(), wrong.end());
    std::ranges::sort(studied);
    studied.erase(std::unique(studied.begin(), studied.end()), studied.end());
  }
}

}  // namespace

RiggedClip build_rigged_clip(const Figure& figure, const Performance& performance,
                             const RigTakeRequest& request) {
  FigureRigRequest rig{.shapes = {}, .has_moves = !request.is_exact, .poses = request.poses};
  rig.shapes.tolerance_mm = kBetweenTargets_mm;
  if (request.neck_steps > 0) rig.neck_steps = request.neck_steps;
  TakeWork work{figure, performance, request, build_figure_rig(figure, rig), {}, 0, {}, {}};
  work.bent = list_rig_bent_parts(work.rig, figure.model);
  work.moves = work.rig.rig.targets.size();
  const std::vector<double> times = list_frame_times(request);
  RiggedClip clip;
  if (request.is_exact) {
    take_frames(work, times, clip.error.uncorrected_mm);
    add_corrections(work, work.modes, "frame");
    clip.take = sample_poses(work, times, clip.error);
  } else {
    correct_take(work, times, clip);
  }
  if (!request.is_exact) settle_corrections(work, clip.take);
  measure_take(work, clip.take, clip.error);
  if (!request.is_exact) clip.corrections = static_cast<int>(work.rig.rig.targets.size() - work.moves);
  clip.rig = std::move(work.rig.rig);
  return clip;
}

}  // namespace mien
