#include "clip/sound.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <mutex>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/process.hpp"
#include "render/work_folder.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr int kMixRate = 48000;  // that of films

// Its own sound and those of all lines.
std::vector<SpokenSound> list_heard(const ClipSpec& clip) {
  std::vector<SpokenSound> heard = clip.spoken;
  if (clip.sound) heard.push_back({clip.sound->at_s, clip.sound->file.path, {}});
  return heard;
}

std::string hash_heard(const std::vector<SpokenSound>& heard) {
  std::string all;
  for (const SpokenSound& sound : heard)
    all += fmt::format("{} {}\n", sound.at_s, hash_hex(sound.wav ? *sound.wav : read_file(sound.file)));
  return hash_hex(all);
}

// One track of 16 bit: each sound from its time on, to the sample.
void mix_sounds(const std::vector<SpokenSound>& heard, const fs::path& folder, const fs::path& into) {
  std::vector<std::string> command{"ffmpeg", "-v", "error", "-y"};
  std::string filter, names;
  for (std::size_t i = 0; i < heard.size(); ++i) {
    const fs::path file = heard[i].wav ? folder / fmt::format("line{}.wav", i) : fs::absolute(heard[i].file);
    if (heard[i].wav) write_file(file, *heard[i].wav);
    command.insert(command.end(), {"-i", file.string()});
    filter += fmt::format(
        "[{}:a]aresample={},aformat=sample_fmts=fltp:channel_layouts=stereo,adelay={}S:all=1[s{}];", i,
        kMixRate, std::llround(heard[i].at_s * kMixRate), i);
    names += fmt::format("[s{}]", i);
  }
  filter += fmt::format("{}amix=inputs={}:duration=longest:normalize=0", names, heard.size());
  command.insert(command.end(), {"-filter_complex", filter, "-c:a", "pcm_s16le", "-map_metadata", "-1",
                                 "-fflags", "+bitexact", "-flags", "+bitexact", into.string()});
  const ProcessResult result = run_process(command, folder);
  if (result.exit_code != 0)
    throw RunError(format_failure("cannot mix the clip's sound", quote_command(command), result.output));
}

fs::path find_mixed(const std::vector<SpokenSound>& heard) {
  static std::mutex mutex;
  static std::optional<WorkFolder> folder;
  static std::map<std::string, fs::path> mixed;
  const std::string key = hash_heard(heard);
  const std::lock_guard lock(mutex);
  if (const auto known = mixed.find(key); known != mixed.end()) return known->second;
  if (!folder) folder.emplace(fs::temp_directory_path());
  const fs::path file = folder->path / (key + ".wav");
  mix_sounds(heard, folder->path, file);
  return mixed[key] = file;
}

}  // namespace

void check_sound(const Clip& clip) {
  const std::optional<SoundSpec>& sound = clip.spec.clip.sound;
  if (!sound || is_sound(sound->file.path)) return;
  throw InputError(std::vector<Diagnostic>{
      {sound->file.place,
       fmt::format("'{}' has no sound that ffmpeg can read; expected a file such as voice.wav",
                   sound->file.path.filename().string()),
       {},
       false}});
}

std::optional<Sound> find_sound(const Clip& clip) {
  const double first_s = static_cast<double>(clip.plan.frames.front() - 1) / clip.spec.clip.fps;
  const std::optional<SoundSpec>& own = clip.spec.clip.sound;
  if (!clip.spec.clip.spoken.empty()) return Sound{find_mixed(list_heard(clip.spec.clip)), -first_s};
  if (!own) return std::nullopt;
  return Sound{fs::absolute(own->file.path), own->at_s - first_s};
}

}  // namespace mien
