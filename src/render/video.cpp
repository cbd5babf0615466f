// ffmpeg 5.1: image2 and rawvideo demuxers (ffmpeg-formats(1)). Its exit status is no
// proof: a gap in the numbers or an empty picture shortens the clip silently, so pictures are judged before
// and the clip's frames are counted after.
#include "render/video.hpp"

#include <fmt/format.h>

#include <string>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/video_kind.hpp"

namespace mien {

namespace {

// What ffmpeg may still have wanted to write when it failed; enough to notice a full disk.
constexpr std::size_t kDiskProbe = 1 << 20;  // bytes

// All pictures have one size; returns it.
PictureSize check_pictures(const std::vector<std::filesystem::path>& pictures) {
  if (pictures.empty()) throw RunError("a clip needs one picture at least");
  PictureSize first;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (i > 0 && pictures[i] == pictures[i - 1]) continue;  // a held drawing
    const PictureSize size = read_picture_size(pictures[i]);
    if (i == 0) first = size;
    if (size.width_px != first.width_px || size.height_px != first.height_px)
      throw RunError(fmt::format("{} is {}x{} pixels, but {} is {}x{}; a clip needs one size",
                                 pictures[i].string(), size.width_px, size.height_px, pictures[0].string(),
                                 first.width_px, first.height_px));
  }
  return first;
}

// Numbered names for ffmpeg, whatever the pictures are called. A copy where the disk has no links.
void link_pictures(const std::vector<std::filesystem::path>& pictures, const std::filesystem::path& folder) {
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::filesystem::path name = folder / fmt::format("{:06}.png", i + 1),
                                picture = absolute(pictures[i]);
    std::error_code error;
    std::filesystem::create_symlink(picture, name, error);
    if (error) std::filesystem::copy_file(picture, name, error);
    if (error)
      throw RunError(fmt::format("cannot write in {}: {}", folder.parent_path().string(), error.message()));
  }
}

// In the work folder, whatever the clip is called: ffmpeg reads patterns in names.
std::string name_made(const std::filesystem::path& clip) { return "clip" + find_ending(clip); }

// What ffmpeg reads.
struct VideoSource {
  std::vector<std::string> input;
  std::optional<Sound> sound = {};
  double length_s = 0;  // of the sound
};

std::vector<std::string> build_command(const VideoSource& source, const VideoForm& form,
                                       const std::filesystem::path& clip) {
  std::vector<std::string> command{"ffmpeg", "-nostdin", "-hide_banner", "-v", "error", "-y"};
  const auto append = [&command](const std::vector<std::string>& words) {
    command.insert(command.end(), words.begin(), words.end());
  };
  append(source.input);
  if (source.sound) append(list_sound_input(*source.sound));
  append(list_encoder_options(clip, form));
  if (source.sound) append(list_sound_options(*source.sound, clip, source.length_s));
  command.push_back(name_made(clip));
  return command;
}

std::optional<Sound> find_heard(const std::optional<Sound>& sound, const std::filesystem::path& clip) {
  return sound && is_film(clip) ? sound : std::nullopt;
}

void check_encoder(const ProcessResult& result, const std::vector<std::string>& command,
                   const std::filesystem::path& folder, const std::filesystem::path& clip) {
  if (result.exit_code == 0) return;
  require_space(folder, kDiskProbe, clip);
  throw RunError(format_failure(fmt::format("{}: {}", clip.string(), describe_end("ffmpeg", result)),
                                quote_command(command), result.output));
}

void place_clip(const std::filesystem::path& folder, const VideoForm& form, std::size_t frame_count,
                bool has_sound, const std::filesystem::path& clip) {
  const std::string fault = find_video_fault(folder, name_made(clip), form, frame_count, has_sound);
  if (!fault.empty()) throw RunError(fmt::format("{}: {}", fault, clip.string()));
  std::error_code error;
  std::filesystem::rename(folder / name_made(clip), clip, error);
  if (error) throw RunError(fmt::format("cannot write {}: {}", clip.string(), error.message()));
}

// Where a half-made clip lies: beside its place.
std::filesystem::path find_parent(const std::filesystem::path& clip) {
  return clip.has_parent_path() ? clip.parent_path() : ".";
}

}  // namespace

void write_video(const std::vector<std::filesystem::path>& pictures, int fps,
                 const std::filesystem::path& clip, const std::optional<Sound>& sound, int plays) {
  VideoForm form{check_pictures(pictures), fps};
  form.has_alpha = has_alpha(pictures.front());
  form.plays = plays;
  const WorkFolder work(find_parent(clip));
  link_pictures(pictures, work.path);
  const std::optional<Sound> heard = find_heard(sound, clip);
  const VideoSource source{{"-framerate", std::to_string(fps), "-start_number", "1", "-i", "%06d.png"},
                           heard,
                           static_cast<double>(pictures.size()) / fps};
  const std::vector<std::string> command = build_command(source, form, clip);
  check_encoder(run_process(command, work.path), command, work.path, clip);
  place_clip(work.path, form, pictures.size(), heard.has_value(), clip);
}

VideoStream start_video(const VideoForm& asked, const std::filesystem::path& clip,
                        const std::optional<Sound>& sound, std::size_t frame_count) {
  VideoForm form = asked;
  form.is_sketch = true;
  const std::optional<Sound> heard = find_heard(sound, clip);
  VideoStream video{clip, form, 0, heard.has_value(), {}, std::make_unique<WorkFolder>(find_parent(clip)),
                    {}};
  const VideoSource source{{"-f", "rawvideo", "-pixel_format", form.has_alpha ? "rgba" : "rgb24",
                            "-video_size", fmt::format("{}x{}", form.size.width_px, form.size.height_px),
                            "-framerate", std::to_string(form.fps), "-i", "-"},
                           heard,
                           static_cast<double>(frame_count) / form.fps};
  video.command = build_command(source, form, clip);
  std::erase(video.command, "-nostdin");
  video.encoder = start_fed_process(video.command, video.work->path);
  return video;
}

namespace {

bool feed_picture(VideoStream& video, const Pixels& picture) {
  if (!video.form.has_alpha) return feed_process(video.encoder, picture.rgb.data(), picture.rgb.size());
  Pixels clear = picture;
  if (clear.alpha.empty()) clear.alpha.assign(clear.rgb.size() / 3, 255);
  const std::vector<std::uint8_t> bytes = join_bytes(clear);
  return feed_process(video.encoder, bytes.data(), bytes.size());
}

}  // namespace

void append_frame(VideoStream& video, const Pixels& picture) {
  const PictureSize& size = video.form.size;
  if (picture.size.width_px != size.width_px || picture.size.height_px != size.height_px)
    throw RunError(fmt::format("a picture of {}x{} pixels for a clip of {}x{}", picture.size.width_px,
                               picture.size.height_px, size.width_px, size.height_px));
  ++video.frame_count;
  if (feed_picture(video, picture)) return;
  close_input(video.encoder);
  if (video.encoder.id != 0) wait_for_any({&video.encoder});
  check_encoder(video.encoder.result, video.command, video.work->path, video.clip);
  throw RunError(fmt::format("{}: ffmpeg ended before its last frame", video.clip.string()));
}

void finish_video(VideoStream& video) {
  if (video.frame_count == 0) throw RunError("a clip needs one picture at least");
  close_input(video.encoder);
  wait_for_any({&video.encoder});
  check_encoder(video.encoder.result, video.command, video.work->path, video.clip);
  place_clip(video.work->path, video.form, video.frame_count, video.has_sound, video.clip);
}

}  // namespace mien
