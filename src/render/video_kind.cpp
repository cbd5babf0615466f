// ffmpeg 5.1: libx264, libvpx-vp9, prores_ks, gif, libwebp_anim and apng (ffmpeg-codecs(1)); animated WebP is
// written by it and not read, so its chunks are read here (developers.google.com/speed/webp, "WebP Container
// Specification").
#include "render/video_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/process.hpp"

namespace mien {

namespace {

// Constant quality: at 18 flat backgrounds begin to show bands, below 14 files grow with nothing to see for
// it.
constexpr int kQuality_crf = 16;
constexpr int kSketchQuality_crf = 20;  // of what is looked at once
constexpr int kWebmQuality_crf = 20;    // VP9's own scale
constexpr int kWebpQuality = 90;        // of 100
constexpr int kTimeDecimals = 6;

// The encoder's bytes depend on the number of its threads, so it never is the machine's. More than 4 gain
// little on pictures of this height.
constexpr int kThreads = 4;

// By bt709's matrix, the same on every processor.
constexpr const char* kScale =
    "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int+bitexact,";

// Odd sides get their last row or column twice, since yuv420p halves both.
std::string build_halved_filters(const PictureSize& size, const char* pixels) {
  const int right = size.width_px % 2, bottom = size.height_px % 2;
  std::string filters;
  if (right != 0 || bottom != 0)
    filters = fmt::format("pad={}:{},fillborders=right={}:bottom={}:mode=smear,", size.width_px + right,
                          size.height_px + bottom, right, bottom);
  return filters + kScale + "format=" + pixels;
}

// H.264 knows no transparency: its pictures lie on white.
std::string build_white_ground(const VideoForm& form) {
  if (!form.has_alpha) return "";
  return fmt::format("color=c=white:s={}x{}:r={}[ground];[ground][in]overlay=shortest=1:format=gbrp,",
                     form.size.width_px, form.size.height_px, form.fps);
}

PictureSize find_video_size(const std::string& ending, const PictureSize& size) {
  if (ending != ".mp4" && ending != ".webm") return size;
  return {size.width_px + size.width_px % 2, size.height_px + size.height_px % 2};
}

using Words = std::vector<std::string>;

Words join(Words first, const Words& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Words list_webm(const VideoForm& form) {
  Words options{"-vf",       build_halved_filters(form.size, form.has_alpha ? "yuva420p" : "yuv420p"),
                "-c:v",      "libvpx-vp9",
                "-b:v",      "0",
                "-crf",      std::to_string(kWebmQuality_crf),
                "-deadline", "good",
                "-cpu-used", form.is_sketch ? "6" : "2",
                "-g",        std::to_string(form.fps),
                "-threads",  std::to_string(kThreads)};
  // VP9 has its alpha in a stream beside the other, which knows no such frames.
  return form.has_alpha ? join(options, {"-auto-alt-ref", "0"}) : options;
}

Words list_mov(const VideoForm& form) {
  const char* const pixels = form.has_alpha ? "yuva444p10le" : "yuv444p10le";
  Words options{"-vf",
                fmt::format("{}format={},setparams=range=tv:color_primaries=bt709:color_trc=bt709:"
                            "colorspace=bt709",
                            kScale, pixels),
                "-c:v",
                "prores_ks",
                "-profile:v",
                "4444",
                "-vendor",
                "apl0",
                "-threads",
                std::to_string(kThreads)};
  return form.has_alpha ? join(options, {"-alpha_bits", "16"}) : options;
}

Words list_kind(const std::string& ending, const VideoForm& form) {
  const Words tags{"-colorspace", "bt709", "-color_primaries", "bt709",
                   "-color_trc",  "bt709", "-color_range",     "tv"};
  if (ending == ".mp4")
    return join(
        {"-vf", build_white_ground(form) + build_halved_filters(form.size, "yuv420p"),
         // One key frame a second, so that players step and seek fast.
         "-c:v", "libx264", "-preset", form.is_sketch ? "veryfast" : "slow", "-crf",
         std::to_string(form.is_sketch ? kSketchQuality_crf : kQuality_crf), "-g", std::to_string(form.fps),
         // cpu-independent: the same bytes whatever vector instructions the processor has.
         "-x264-params", "cpu-independent=1", "-threads", std::to_string(kThreads)},
        join(tags, {"-movflags", "+faststart"}));
  if (ending == ".webm") return join(list_webm(form), tags);
  if (ending == ".mov") return join(list_mov(form), join(tags, {"-movflags", "+write_colr"}));
  // One palette for the whole clip, so that a still background stays still; an ordered dither does too. A GIF
  // counts how often it begins again, -1 being never.
  if (ending == ".gif")
    return {"-vf", "split[a][b];[a]palettegen=stats_mode=full[p];[b][p]paletteuse=dither=bayer:bayer_scale=4",
            "-loop",
            std::to_string(form.plays == 0   ? 0
                           : form.plays == 1 ? -1
                                             : form.plays - 1)};
  if (ending == ".webp")
    return {"-c:v",     "libwebp_anim",
            "-pix_fmt", "bgra",
            "-quality", std::to_string(kWebpQuality),
            "-loop",    std::to_string(form.plays)};
  if (ending == ".apng")
    return {
        "-c:v", "apng", "-pix_fmt", form.has_alpha ? "rgba" : "rgb24", "-plays", std::to_string(form.plays)};
  throw RunError(fmt::format("internal: no clip ends in '{}'", ending));
}

std::uint32_t read_number(const std::string& bytes, std::size_t at, int count) {
  std::uint32_t number = 0;
  for (int i = count; i-- > 0;)
    number = number << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return number;
}

constexpr const char* kNoAlpha = "ffmpeg made a clip without transparency";

// What the chunks of a WebP file say.
struct WebpFacts {
  PictureSize size;
  bool has_alpha = false;
  std::size_t frames = 0;  // 0: a still picture
  std::uint32_t length_ms = 0;
};

PictureSize read_webp_size(const std::string& bytes, std::size_t at, int count) {
  return {static_cast<int>(read_number(bytes, at, count)) + 1,
          static_cast<int>(read_number(bytes, at + static_cast<std::size_t>(count), count)) + 1};
}

WebpFacts read_webp_facts(const std::string& bytes) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8, kLargest = 16;
  constexpr std::uint32_t kAlphaFlag = 0x10, kSide = 0x3FFF, kLosslessAlpha = 1u << 28;
  WebpFacts facts;
  for (std::size_t at = kHeader; at + kChunkHeader + kLargest <= bytes.size();) {
    const std::string_view name(bytes.data() + at, 4);
    const std::size_t count = read_number(bytes, at + 4, 4), content = at + kChunkHeader;
    if (name == "VP8X") {
      facts.has_alpha = (read_number(bytes, content, 1) & kAlphaFlag) != 0;
      facts.size = read_webp_size(bytes, content + 4, 3);
    } else if (name == "VP8L" && facts.size.width_px == 0) {
      const std::uint32_t header = read_number(bytes, content + 1, 4);
      facts.has_alpha = (header & kLosslessAlpha) != 0;
      facts.size = {static_cast<int>(header & kSide) + 1, static_cast<int>(header >> 14 & kSide) + 1};
    } else if (name == "VP8 " && facts.size.width_px == 0) {
      facts.size = {static_cast<int>(read_number(bytes, content + 6, 2) & kSide),
                    static_cast<int>(read_number(bytes, content + 8, 2) & kSide)};
    } else if (name == "ANMF") {
      const PictureSize drawn = read_webp_size(bytes, content + 6, 3);  // nothing lies around it
      if (facts.frames == 0 &&
          (drawn.width_px < facts.size.width_px || drawn.height_px < facts.size.height_px))
        facts.has_alpha = true;
      facts.length_ms += read_number(bytes, content + 12, 3);
      ++facts.frames;
    }
    at = content + count + count % 2;
  }
  return facts;
}

// A picture that is held is one frame of the file, which lasts longer; a clip that holds one to its end is a
// still picture.
std::string find_webp_fault(const std::string& bytes, const VideoForm& form, std::size_t frame_count) {
  const WebpFacts facts = read_webp_facts(bytes);
  if (facts.size.width_px != form.size.width_px || facts.size.height_px != form.size.height_px)
    return fmt::format("ffmpeg made a clip of {}x{} pixels, not {}x{}", facts.size.width_px,
                       facts.size.height_px, form.size.width_px, form.size.height_px);
  if (form.has_alpha && !facts.has_alpha) return kNoAlpha;
  const double expected_ms = 1000.0 * static_cast<double>(frame_count) / form.fps;
  if (facts.frames == 0 || std::abs(facts.length_ms - expected_ms) <= 1000.0 / form.fps / 2) return {};
  return fmt::format("ffmpeg made a clip of {} ms, not {:.0f}", facts.length_ms, expected_ms);
}

// "key=value" lines.
std::string find_value_of(const std::string& facts, const std::string& key) {
  std::istringstream lines(facts);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(key + "=")) return line.substr(key.size() + 1);
  return "";
}

// What ffprobe says of the clip's pictures, or of another stream.
std::string probe(const std::filesystem::path& folder, const std::string& file, const Words& asked,
                  const char* stream = "v:0") {
  const Words command = join(join({"ffprobe", "-v", "error", "-select_streams", stream}, asked), {file});
  const ProcessResult result = run_process(command, folder);
  if (result.exit_code != 0)
    throw RunError(format_failure(describe_end("ffprobe", result), quote_command(command), result.output));
  return result.output;
}

// Its packets are counted, since not every kind says how long a stream is.
std::string find_sound_fault(const std::filesystem::path& folder, const std::string& file, double length_s) {
  const std::string times =
      probe(folder, file, {"-show_entries", "packet=pts_time,duration_time", "-of", "csv=p=0"}, "a:0");
  if (times.empty()) return "ffmpeg made a clip without sound";
  double end_s = 0;
  std::istringstream lines(times);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t comma = line.find(',');
    if (comma == line.npos) continue;
    end_s = std::max(end_s, std::atof(line.c_str()) + std::atof(line.c_str() + comma + 1));
  }
  constexpr double kPacket_s = 0.05;  // an encoder ends with a whole packet
  if (std::abs(end_s - length_s) <= kPacket_s) return {};
  return fmt::format("ffmpeg made a clip whose sound is {:.2f} s long, not {:.2f}", end_s, length_s);
}

// Whether ffprobe says that the pictures are transparent; a kind that cannot be is as it should.
bool says_transparent(const std::string& ending, const std::string& facts) {
  const std::string pixels = find_value_of(facts, "pix_fmt");
  if (ending == ".webm") return find_value_of(facts, "TAG:alpha_mode") == "1";
  if (ending == ".mov") return pixels.starts_with("yuva");
  if (ending == ".apng") return pixels == "rgba";
  return true;
}

// "24/1", or as near as a kind that counts in its own ticks comes: "100000/4167".
bool is_rate(const std::string& rate, int fps) {
  constexpr double kNear = 1e-3;
  const std::size_t slash = rate.find('/');
  if (slash == rate.npos) return false;
  const double above = std::atof(rate.c_str()), below = std::atof(rate.c_str() + slash + 1);
  return below > 0 && std::abs(above / below - fps) < kNear * fps;
}

// Of a kind whose rate ffprobe guesses, wrongly of two frames: by how long the first one stays.
std::string find_rate(const std::filesystem::path& folder, const std::string& file) {
  return "1/" + probe(folder, file,
                      {"-show_entries", "packet=duration_time", "-read_intervals", "%+#1", "-of", "csv=p=0"});
}

}  // namespace

const std::vector<std::string>& list_video_endings() {
  static const std::vector<std::string> kEndings{".mp4", ".webm", ".mov", ".gif", ".webp", ".apng"};
  return kEndings;
}

bool is_video_name(const std::filesystem::path& path) {
  return std::ranges::find(list_video_endings(), find_ending(path)) != list_video_endings().end();
}

std::vector<std::string> list_encoder_options(const std::filesystem::path& clip, const VideoForm& form) {
  return join(list_kind(find_ending(clip), form),
              {"-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact"});
}

bool is_film(const std::filesystem::path& clip) {
  const std::string ending = find_ending(clip);
  return ending == ".mp4" || ending == ".webm" || ending == ".mov";
}

bool is_sound(const std::filesystem::path& file) {
  const ProcessResult result =
      run_process({"ffprobe", "-v", "error", "-select_streams", "a:0", "-show_entries", "stream=codec_type",
                   "-of", "csv=p=0", std::filesystem::absolute(file).string()},
                  ".");
  return result.exit_code == 0 && result.output.starts_with("audio");
}

std::vector<std::string> list_sound_input(const Sound& sound) {
  if (sound.at_s < 0) return {"-ss", format_number(-sound.at_s, kTimeDecimals), "-i", sound.file.string()};
  return {"-i", sound.file.string()};
}

namespace {

// Silence before a sound and after it; of a round that begins again all of it does.
std::string build_sound_filters(const Sound& sound) {
  constexpr int kRate_hz = 48000;
  const std::string delay =
      fmt::format("adelay=delays={}:all=1", format_number(1000 * std::max(0.0, sound.at_s), 3));
  if (sound.round_s <= 0) return delay + ",apad";
  return fmt::format("aresample={0},{1},apad,atrim=end={2},apad,atrim=end={3},aloop=loop={4}:size={5},apad",
                     kRate_hz, delay, format_number(sound.heard_s, kTimeDecimals),
                     format_number(sound.round_s, kTimeDecimals), sound.rounds - 1,
                     std::lround(sound.round_s * kRate_hz));
}

}  // namespace

std::vector<std::string> list_sound_options(const Sound& sound, const std::filesystem::path& clip,
                                            double length_s) {
  const std::string ending = find_ending(clip);
  Words options{"-map", "0:v:0",
                "-map", "1:a:0",
                "-af",  build_sound_filters(sound),
                "-t",   format_number(length_s, kTimeDecimals)};
  if (ending == ".mp4") return join(options, {"-c:a", "aac", "-b:a", "192k"});
  if (ending == ".webm") return join(options, {"-c:a", "libopus", "-b:a", "128k"});
  return join(options, {"-c:a", "pcm_s16le"});
}

std::string find_video_fault(const std::filesystem::path& folder, const std::string& file,
                             const VideoForm& form, std::size_t frame_count, bool has_sound) {
  const std::string ending = find_ending(file);
  if (ending == ".webp") return find_webp_fault(read_file(folder / file), form, frame_count);
  const std::string counted =
      probe(folder, file, {"-count_frames", "-show_entries", "stream=nb_read_frames", "-of", "csv=p=0"});
  const std::string count = counted.substr(0, counted.find('\n'));
  if (count != std::to_string(frame_count))
    return fmt::format("ffmpeg made a clip of {} frames, not {}", count, frame_count);
  const std::string facts = probe(
      folder, file,
      {"-show_entries",
       "stream=width,height,r_frame_rate,color_space,color_transfer,color_primaries,pix_fmt:stream_tags",
       "-of", "default=noprint_wrappers=1"});
  const PictureSize wanted = find_video_size(ending, form.size);
  const std::string width = find_value_of(facts, "width"), height = find_value_of(facts, "height");
  if (width != std::to_string(wanted.width_px) || height != std::to_string(wanted.height_px))
    return fmt::format("ffmpeg made a clip of {}x{} pixels, not {}x{}", width, height, wanted.width_px,
                       wanted.height_px);
  const std::string rate = ending == ".apng" ? find_rate(folder, file) : find_value_of(facts, "r_frame_rate");
  // A GIF counts in hundredths of a second; of one frame no rate is known.
  if (ending != ".gif" && frame_count > 1 && !is_rate(rate, form.fps))
    return fmt::format("ffmpeg made a clip of {} frames a second, not {}", rate, form.fps);
  for (const char* tag : {"color_space", "color_transfer", "color_primaries"})
    if (const std::string colours = find_value_of(facts, tag); is_film(file) && colours != "bt709")
      return fmt::format("ffmpeg made a clip with the colours of '{}', not bt709", colours);
  if (form.has_alpha && !says_transparent(ending, facts)) return kNoAlpha;
  return has_sound ? find_sound_fault(folder, file, static_cast<double>(frame_count) / form.fps) : "";
}

}  // namespace mien
