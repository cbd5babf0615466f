#include "voice/speaker.hpp"

#include <fmt/format.h>

#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/process.hpp"
#include "render/work_folder.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr const char* kSpeaker = "mien-speak";
constexpr std::size_t kMostKept = 200;  // texts

// Beside this program, else on the PATH; empty: nowhere.
fs::path find_speaker() {
  std::error_code error;
  const fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path() / kSpeaker;
  if (!error && fs::is_regular_file(beside, error)) return beside;
  return find_program(kSpeaker);
}

std::string read_error(const std::string& output) {
  constexpr std::string_view kError = "error: ";
  const std::size_t at = output.rfind(kError);
  if (at == std::string::npos) return output.empty() ? "it says nothing" : output;
  return output.substr(at + kError.size(), output.find('\n', at) - at - kError.size());
}

SpokenText read_spoken(const std::string& told) {
  const nlohmann::json json = nlohmann::json::parse(told);
  SpokenText spoken;
  spoken.length_s = json.at("samples").get<double>() / json.at("rate").get<double>();
  for (const auto& each : json.at("phonemes"))
    spoken.sounds.push_back({each.at("at").get<double>(), each.at("to").get<double>(),
                             each.at("ipa").get<std::string>(), each.at("stress").get<int>()});
  for (const auto& each : json.at("words"))
    spoken.words.push_back(
        {each.at("at").get<double>(), each.at("from").get<int>(), each.at("length").get<int>()});
  return spoken;
}

SpokenText speak_anew(const std::string& text, const std::string& voice, double pace) {
  const fs::path speaker = find_speaker();
  const WorkFolder work(fs::temp_directory_path());
  const fs::path wav = work.path / "voice.wav";
  const ProcessResult result = run_process(
      {speaker.string(), "--voice", voice, "--pace", fmt::format("{:g}", pace), "--wav", wav.string(), text},
      work.path);
  if (result.exit_code != 0) throw RunError(read_error(result.output));
  try {
    SpokenText spoken = read_spoken(result.output);
    spoken.wav = std::make_shared<const std::string>(read_file(wav));
    return spoken;
  } catch (const nlohmann::json::exception&) {
    throw RunError(
        fmt::format("mien-speak tells nothing that can be read: {}", result.output.substr(0, 200)));
  }
}

}  // namespace

bool has_speaker() { return !find_speaker().empty(); }

SpokenText speak_text(const std::string& text, const std::string& voice, double pace) {
  static std::mutex mutex;
  static std::map<std::string, SpokenText> known;
  const std::string key = fmt::format("{}\n{}\n{}", voice, pace, text);
  const std::lock_guard lock(mutex);
  if (const auto found = known.find(key); found != known.end()) return found->second;
  SpokenText spoken = speak_anew(text, voice, pace);
  if (known.size() >= kMostKept) known.clear();
  return known[key] = std::move(spoken);
}

}  // namespace mien
