// A clip that many machines trace: which of its pictures are missing, how they are shared out, and one share
// of them. All meet in the clip's store, in a folder that all of them see.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "clip/trace.hpp"
#include "render/parts.hpp"

namespace mien {

// Of a clip's folder: the plan, the scripts, what the tasks said and what they have to do with each other.
inline constexpr const char* kFarmFolder = "slurm";

// The files in it.
struct FarmFiles {
  explicit FarmFiles(const std::filesystem::path& clip_folder) : folder(clip_folder / kFarmFolder) {}
  std::filesystem::path folder;
  std::filesystem::path plan() const { return folder / "plan.json"; }
  std::filesystem::path tasks_script() const { return folder / "tasks.sh"; }
  std::filesystem::path clip_script() const { return folder / "clip.sh"; }
  std::filesystem::path clip_log() const { return folder / "clip.log"; }
  std::filesystem::path log(int part) const;
  std::filesystem::path done() const {
    return folder / "done";
  }  // the identity of the plan that has ended well
  std::filesystem::path cost() const { return folder / "cost.json"; }
  std::filesystem::path work(int part) const;  // of one part alone
};

// Whether FOLDER/slurm may hold a file of this name.
bool is_farm_file(const std::string& name);

// A clip and the people in it. What it points to must outlive it.
struct FarmClip {
  const Clip* clip;
  const Cast* cast;
};

// One drawing of those that a farm is to make.
struct FarmDrawing {
  PartDrawing drawing;
  bool is_there = false;  // the store or a frame has its picture
};

// Every drawing of these clips in the order in which a clip can be judged earliest, of each clip in turn.
// Writes nothing. Told the frame of each as it is computed, from any thread.
std::vector<FarmDrawing> list_farm_drawings(const std::vector<FarmClip>& clips, const Resources& resources,
                                            int jobs, const SceneWritten& computed);

// Those that are missing, each picture once, in parts of `size` drawings, no more than `most_parts`. `asked`
// is what else makes two plans different.
PartPlan plan_parts_of(const std::vector<FarmDrawing>& drawings, std::size_t size, std::size_t most_parts,
                       const std::string& asked);

// How long a drawing takes a core, and what that depends on most. Guessed for pictures of POV-Ray with hair,
// on a core of 2020; within a factor of three on most machines.
std::string describe_drawing_kind(const RenderSpec& render);
double guess_drawing_s(const RenderSpec& render);

// Traces into the stores of `clips` what is missing of a part, told as it goes. Throws RunError "frame 12 is
// another drawing than when the plan was made; ..." before anything of that clip is traced, and as
// render_frames does.
void trace_part(const std::vector<PartDrawing>& part, const std::vector<FarmClip>& clips,
                const Resources& resources, int jobs, const std::filesystem::path& work_parent,
                const FrameDone& done);

}  // namespace mien
