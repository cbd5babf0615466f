// Measured on POV-Ray 3.7.0.10, whose texts are in its source/frontend/defaultrenderfrontend.cpp and console.
#include "render/povray_output.hpp"

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace mien {

namespace {

constexpr std::size_t kFold = 80;  // POV-Ray's widest line

// The lines of `text` that hold one of `words`, each with its end.
std::string find_lines(const std::string& text, const std::vector<std::string>& words) {
  std::string found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (std::any_of(words.begin(), words.end(),
                    [&](const std::string& word) { return line.find(word) != std::string::npos; }))
      found += line + '\n';
  return found;
}

}  // namespace

std::string unwrap_povray_output(const std::string& output) {
  std::string text;
  std::size_t column = 0;  // in the last line as POV-Ray printed it
  for (std::size_t at = 0; at < output.size();) {
    const std::size_t end = std::min(output.find('\n', at), output.size());
    const std::string line = output.substr(at, end - at);
    // A folded line goes on with the blank that it was folded at, and with a word that had no room before it;
    // a word wider than a line is cut in the middle.
    const std::size_t word = std::min(line.find(' ', 1), line.size());
    const bool goes_on = line.size() > 1 && line[0] == ' ' && line[1] != ' ' && column + word > kFold;
    const bool is_cut = column == kFold && !line.empty() && line[0] != ' ';
    if (at > 0 && !goes_on && !is_cut) text += '\n';
    text += line;
    column = line.size();
    at = end + 1;
  }
  return text;
}

std::string find_povray_reason(const ProcessResult& result) {
  const std::string text = unwrap_povray_output(result.output);
  if (result.exit_code == 0) return find_lines(text, {"Warning:", "Error:"});
  // POV-Ray prints its headings and its messages from two queues: an error may come before its heading.
  const std::size_t heading = text.rfind("\n==== [");
  if (heading == std::string::npos) return text;
  return find_lines(text.substr(0, heading), {"Error:"}) +
         text.substr(std::min(text.find('\n', heading + 1), text.size()));
}

bool is_empty_scene(const std::string& output) {
  static const std::regex kNoObjects("\\nFinite Objects: +0\\nInfinite Objects: +0\\n");
  return std::regex_search(output, kNoObjects) || output.find("No objects in scene") != std::string::npos;
}

bool is_late_start(const std::string& output) {
  return output.find("Timed out waiting for worker thread startup") != std::string::npos;
}

}  // namespace mien
