#include "frames/pose_sweep.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <random>

#include "config/ledger.hpp"
#include "config/load_spec.hpp"
#include "config/pose_mix.hpp"
#include "core/data.hpp"
#include "core/pool.hpp"
#include "head/cage.hpp"
#include "head/form.hpp"
#include "head/random_heads.hpp"
#include "head/soundness.hpp"
#include "shipped.hpp"

namespace mien {

std::vector<SweepHead> list_sweep_heads() {
  const HeadShapes shapes = shipped().stock.head->shapes.heads;
  std::vector<SweepHead> heads;
  for (const std::string skull : {"average", "square", "round", "narrow"})
    for (const std::string& age : kAges) {
      const auto index = static_cast<unsigned>(heads.size());
      HeadSpec spec;
      if (index % 2 == 1) spec = build_random_spec(index, shapes);
      spec.age = {{age, 1.0}};
      spec.skull = {{skull, 1.0}};
      heads.push_back({fmt::format("{} {}{}", age, skull, index % 2 == 1 ? ", features" : ""), spec});
    }
  for (const std::string design : {"comic", "manga", "caricature"})
    for (const std::string& age : kAges) {
      const auto index = static_cast<unsigned>(heads.size());
      if (design != "comic" && index % 3 != 0) continue;
      HeadSpec spec;
      if (index % 2 == 1) spec = build_random_spec(index, shapes);
      spec.age = {{age, 1.0}};
      spec.design = {{design, 1.0}};
      heads.push_back({fmt::format("{} {}{}", design, age, index % 2 == 1 ? ", features" : ""), spec});
    }
  return heads;
}

namespace {

bool is_drawn(const HeadSpec& spec) { return spec.design != HeadSpec{}.design; }

}  // namespace

std::vector<std::size_t> list_sweep_indices(bool wants_drawn) {
  const std::vector<SweepHead> heads = list_sweep_heads();
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < heads.size(); ++i)
    if (is_drawn(heads[i].spec) == wants_drawn) indices.push_back(i);
  return indices;
}

Pose build_sweep_pose(unsigned seed, bool is_exaggerated) {
  std::mt19937_64 random(seed);
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  Pose pose;
  const auto throw_moves = [&](bool is_beyond) {
    for (std::size_t i = 0; i < kMoveCount; ++i) {
      if (kMoves[i].is_beyond != is_beyond) continue;
      const auto [low, high] = std::pair{kMoves[i].low, kMoves[i].high};
      const double value = low + (high - low) * share(), dice = share();
      if (seed % 3 == 0)
        pose.values[i] = dice < 0.65 ? 0 : value;
      else if (seed % 3 == 1)
        pose.values[i] = dice < 0.4 ? 0 : dice < 0.7 ? value : dice < 0.85 ? low : high;
      else
        pose.values[i] = value;
    }
  };
  throw_moves(false);
  for (const Side side : {Side::left, Side::right})
    if (share() < 1.0 / 3) pose.values[*find_move(Area::lid, side, "upper")] = -1;
  PoseAsk ask;
  ask.exaggerate = 1 + share();
  // One pose in five has nothing but the nine areas.
  if (seed % 5 != 0) throw_moves(true);
  if (!is_exaggerated) return pose;
  ask.pose = pose;
  return hold_pose(ask).pose;
}

Pose build_speech_pose(unsigned seed) {
  constexpr double kKept = 1.0 / 3;  // of the corners
  std::mt19937_64 random(seed);
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const std::vector<Viseme>& visemes = shipped().stock.language->speech->visemes;
  const auto pick = [&](std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(share() * static_cast<double>(count)));
  };
  Pose pose;
  double sum = 0;
  for (std::size_t i = 0, count = 1 + pick(3); i < count; ++i) {
    const Viseme& viseme = visemes[pick(visemes.size())];
    const double weight = 0.2 + 0.8 * share();
    for (std::size_t m = 0; m < kMoveCount; ++m) pose.values[m] += weight * viseme.pose.values[m];
    sum += weight;
  }
  for (double& value : pose.values) value /= sum;
  if (share() < 0.5) return pose;
  std::vector<const Expression*> feelings;
  for (const Expression& expression : shipped().stock.language->libraries.expressions)
    if (expression.library == "mien") feelings.push_back(&expression);
  const Pose& feeling = feelings[pick(feelings.size())]->pose;
  for (std::size_t m = 0; m < kMoveCount; ++m) switch (kMoves[m].of) {
      case Area::brow:
      case Area::lid:
      case Area::eye:
        pose.values[m] = feeling.values[m];
        break;
      case Area::corner:
        pose.values[m] = kKept * feeling.values[m] + (1 - kKept) * pose.values[m];
        break;
      default:
        break;
    }
  return pose;
}

Pose build_doctrine_pose(std::string_view doctrine, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  Pose pose;
  for (std::size_t i = kMoveCount; i < kChannelCount; ++i) {
    if (kChannels[i].area != doctrine) continue;
    const auto [low, high] = std::pair{kChannels[i].low, kChannels[i].high};
    const double value = low + (high - low) * share(), dice = share();
    if (seed % 3 == 0)
      pose.values[i] = dice < 0.65 ? 0 : value;
    else if (seed % 3 == 1)
      pose.values[i] = dice < 0.4 ? 0 : dice < 0.7 ? value : dice < 0.85 ? low : high;
    else
      pose.values[i] = value;
  }
  return pose;
}

std::string describe_pose(const Pose& pose) {
  std::string text;
  for (std::size_t i = 0; i < kChannelCount; ++i)
    if (std::abs(pose.values[i]) > 0.5)
      text += fmt::format("{}{} {:.2f}", text.empty() ? "" : ", ", name_move(i), pose.values[i]);
  return text;
}

namespace {

// The shipped stock, but no design has a lens, nor stretch.
const HeadStock& plain_stock() {
  static const HeadStock stock = [] {
    HeadData data = *shipped().stock.head;
    for (Design& design : data.designs)
      for (auto& [age, numbers] : design.ages) {
        numbers.lens_height = 1;
        numbers.lens_flat = numbers.jaw_stretch = numbers.brow_stretch = 0;
      }
    HeadStock copy = shipped().heads;
    copy.data = std::make_shared<const HeadData>(std::move(data));
    return copy;
  }();
  return stock;
}

// What a drawn head's findings are divided by: its eyes and its mouth against the real head's.
struct DrawnSizes {
  double eye = 1, mouth = 1;
};

DrawnSizes measure_sizes(const HeadSpec& spec) {
  HeadSpec real = spec;
  real.design = HeadSpec{}.design;
  const auto measure = [](const HeadSpec& one) {
    const HeadForm form = build_form(plain_stock(), one);
    return DrawnSizes{form.eye.radius_mm, form.points[find_point(plain_stock().adult, "M1_6")].x};
  };
  const DrawnSizes drawn = measure(spec), undrawn = measure(real);
  return {drawn.eye / undrawn.eye, drawn.mouth / undrawn.mouth};
}

void scale_findings(const DrawnSizes& sizes, PoseFindings& findings) {
  for (std::size_t check = 0; check < kPoseCheckCount; ++check) {
    const std::string_view name = kPoseChecks[check].name;
    if (name.find("lid") != name.npos || name.find("eye") != name.npos) findings[check].value /= sizes.eye;
    if (name.find("lips") != name.npos) findings[check].value /= sizes.mouth;
  }
}

void keep_worst(SweepTable& table, const PoseFindings& findings, std::size_t head, unsigned seed,
                const NeutralHead& neutral) {
  for (std::size_t check = 0; check < kPoseCheckCount; ++check) {
    const Finding& finding = findings[check];
    SweepWorst& worst = table[check];
    worst.count += finding.value > kPoseChecks[check].bound;
    if (finding.value <= worst.finding.value) continue;
    worst = {finding, head, seed, find_nearest_name(neutral, finding.vertex), worst.count};
  }
}

}  // namespace

std::array<SweepTable, 2> run_sweep(const std::vector<std::size_t>& heads, unsigned first,
                                    const SweepSize& size) {
  const std::vector<SweepHead> all = list_sweep_heads();
  const auto jobs = static_cast<std::size_t>(count_workers());
  std::vector<DeformBuffers> buffers(jobs);
  std::vector<Drawing> drawings(jobs);
  std::vector<PoseFindings> findings(size.within + size.exaggerated);
  std::array<SweepTable, 2> tables;
  for (const std::size_t head : heads) {
    const HeadSpec& spec = all[head].spec;
    const Figure figure = build_figure(is_drawn(spec) ? plain_stock() : shipped().heads, spec);
    const DrawnSizes sizes = is_drawn(spec) ? measure_sizes(spec) : DrawnSizes{};
    const PoseProbe probe = build_pose_probe(figure);
    const auto pose_of = [&](std::size_t i) {
      return std::pair(first + static_cast<unsigned>(i < size.within ? i : i - size.within),
                       i >= size.within);
    };
    for_each_index(findings.size(), count_workers(), [&](std::size_t i, int worker) {
      const auto [seed, is_exaggerated] = pose_of(i);
      findings[i] =
          measure_pose(probe, build_sweep_pose(seed, is_exaggerated), buffers[worker], drawings[worker]);
      scale_findings(sizes, findings[i]);
    });
    for (std::size_t i = 0; i < findings.size(); ++i) {
      const auto [seed, is_exaggerated] = pose_of(i);
      keep_worst(tables[is_exaggerated ? 1 : 0], findings[i], head, seed, figure.head);
    }
  }
  return tables;
}

std::vector<SweepHead> list_speech_heads() {
  HeadSpec child;
  child.age = {{"child", 1.0}};
  const std::filesystem::path scan = find_data_folder() / "configs/scan.yaml";
  return {{"adult", HeadSpec{}}, {"child", child}, {"scan", load_spec(scan, *shipped().stock.language).head}};
}

namespace {

SweepTable run_builder_sweep(const std::vector<SweepHead>& heads, unsigned first, unsigned count,
                             const std::function<Pose(unsigned)>& build_pose) {
  const auto jobs = static_cast<std::size_t>(count_workers());
  std::vector<DeformBuffers> buffers(jobs);
  std::vector<Drawing> drawings(jobs);
  std::vector<PoseFindings> findings(count);
  SweepTable table;
  for (std::size_t head = 0; head < heads.size(); ++head) {
    const Figure figure = build_figure(shipped().heads, heads[head].spec);
    const PoseProbe probe = build_pose_probe(figure);
    for_each_index(count, count_workers(), [&](std::size_t i, int worker) {
      findings[i] = measure_pose(probe, build_pose(first + static_cast<unsigned>(i)), buffers[worker],
                                 drawings[worker]);
    });
    for (unsigned i = 0; i < count; ++i) keep_worst(table, findings[i], head, first + i, figure.head);
  }
  return table;
}

}  // namespace

SweepTable run_speech_sweep(unsigned first, unsigned count) {
  return run_builder_sweep(list_speech_heads(), first, count, build_speech_pose);
}

std::vector<SweepHead> list_doctrine_heads() {
  std::vector<SweepHead> heads;
  for (const std::string age : {"infant", "child", "adult", "old"}) {
    HeadSpec spec;
    spec.age = {{age, 1.0}};
    heads.push_back({age, spec});
  }
  heads.push_back(list_speech_heads().back());
  return heads;
}

SweepTable run_doctrine_sweep(std::string_view doctrine, unsigned first, unsigned count) {
  return run_builder_sweep(list_doctrine_heads(), first, count,
                           [&](unsigned seed) { return build_doctrine_pose(doctrine, seed); });
}

}  // namespace mien
