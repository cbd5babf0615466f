// ffmpeg 5.1: image2 demuxer, libx264, mov muxer (ffmpeg-formats(1), ffmpeg-codecs(1)). Its exit status is no
// proof: a gap in the numbers or an empty picture shortens the clip silently, so pictures are judged before
// and the clip's frames are counted after.
#include "render/video.hpp"

#include <fmt/format.h>

#include <map>
#include <string>

#include "core/error.hpp"

namespace mien {

namespace {

constexpr const char* kClipName = "clip.mp4";

// Constant quality: at 18 flat backgrounds begin to show bands, below 14 files grow with nothing to see for
// it.
constexpr int kQuality_crf = 16;
constexpr int kSketchQuality_crf = 20;  // of what is looked at once

// The encoder's bytes depend on the number of its threads, so it never is the machine's. More than 4 gain
// little on pictures of this height.
constexpr int kThreads = 4;

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

// RGB to YUV by bt709's matrix, the same on every processor; odd sides get their last row or column twice,
// since yuv420p halves both.
std::string build_filters(const PictureSize& size) {
  const int right = size.width_px % 2, bottom = size.height_px % 2;
  std::string filters;
  if (right != 0 || bottom != 0)
    filters = fmt::format("pad={}:{},fillborders=right={}:bottom={}:mode=smear,", size.width_px + right,
                          size.height_px + bottom, right, bottom);
  return filters +
         "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int+bitexact,"
         "format=yuv420p";
}

// What ffmpeg reads, and how long it may think about a picture.
struct VideoSource {
  std::vector<std::string> input;
  std::string preset;
  int quality_crf = kQuality_crf;
};

std::vector<std::string> build_command(const VideoSource& source, const PictureSize& size, int fps) {
  std::vector<std::string> command{"ffmpeg", "-nostdin", "-hide_banner", "-v", "error", "-y"};
  command.insert(command.end(), source.input.begin(), source.input.end());
  const std::vector<std::string> output{
      "-vf", build_filters(size), "-map_metadata", "-1",
      // One key frame a second, so that players step and seek fast.
      "-c:v", "libx264", "-preset", source.preset, "-crf", std::to_string(source.quality_crf), "-g",
      std::to_string(fps),
      // cpu-independent: the same bytes whatever vector instructions the processor has.
      "-x264-params", "cpu-independent=1", "-threads", std::to_string(kThreads), "-colorspace", "bt709",
      "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv", "-movflags", "+faststart",
      "-fflags", "+bitexact", "-flags:v", "+bitexact", kClipName};
  command.insert(command.end(), output.begin(), output.end());
  return command;
}

void check_frame_count(const std::filesystem::path& folder, std::size_t expected,
                       const std::filesystem::path& clip) {
  const std::vector<std::string> command{"ffprobe",       "-v",
                                         "error",         "-select_streams",
                                         "v:0",           "-count_frames",
                                         "-show_entries", "stream=nb_read_frames",
                                         "-of",           "csv=p=0",
                                         kClipName};
  const ProcessResult result = run_process(command, folder);
  if (result.exit_code != 0)
    throw RunError(format_failure(describe_end("ffprobe", result), quote_command(command), result.output));
  const std::string found = result.output.substr(0, result.output.find('\n'));
  if (found != std::to_string(expected))
    throw RunError(
        fmt::format("ffmpeg made a clip of {} frames, not {}: {}", found, expected, clip.string()));
}

void check_encoder(const ProcessResult& result, const std::vector<std::string>& command,
                   const std::filesystem::path& folder, const std::filesystem::path& clip) {
  if (result.exit_code == 0) return;
  require_space(folder, kDiskProbe, clip);
  throw RunError(format_failure(fmt::format("{}: {}", clip.string(), describe_end("ffmpeg", result)),
                                quote_command(command), result.output));
}

void place_clip(const std::filesystem::path& folder, std::size_t frame_count,
                const std::filesystem::path& clip) {
  check_frame_count(folder, frame_count, clip);
  std::error_code error;
  std::filesystem::rename(folder / kClipName, clip, error);
  if (error) throw RunError(fmt::format("cannot write {}: {}", clip.string(), error.message()));
}

}  // namespace

void write_video(const std::vector<std::filesystem::path>& pictures, int fps,
                 const std::filesystem::path& clip) {
  const PictureSize size = check_pictures(pictures);
  const WorkFolder work(clip.parent_path());
  link_pictures(pictures, work.path);
  const std::vector<std::string> command = build_command(
      {{"-framerate", std::to_string(fps), "-start_number", "1", "-i", "%06d.png"}, "slow", kQuality_crf},
      size, fps);
  check_encoder(run_process(command, work.path), command, work.path, clip);
  place_clip(work.path, pictures.size(), clip);
}

VideoStream start_video(const PictureSize& size, int fps, const std::filesystem::path& clip) {
  VideoStream video{clip, size, 0, {}, std::make_unique<WorkFolder>(clip.parent_path()), {}};
  video.command = build_command(
      {{"-f", "rawvideo", "-pixel_format", "rgb24", "-video_size",
        fmt::format("{}x{}", size.width_px, size.height_px), "-framerate", std::to_string(fps), "-i", "-"},
       "veryfast",
       kSketchQuality_crf},
      size, fps);
  std::erase(video.command, "-nostdin");
  video.encoder = start_fed_process(video.command, video.work->path);
  return video;
}

void append_frame(VideoStream& video, const Pixels& picture) {
  if (picture.size.width_px != video.size.width_px || picture.size.height_px != video.size.height_px)
    throw RunError(fmt::format("a picture of {}x{} pixels for a clip of {}x{}", picture.size.width_px,
                               picture.size.height_px, video.size.width_px, video.size.height_px));
  ++video.frame_count;
  if (feed_process(video.encoder, picture.rgb.data(), picture.rgb.size())) return;
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
  place_clip(video.work->path, video.frame_count, video.clip);
}

}  // namespace mien
