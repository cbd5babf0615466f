#include "core/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/streams.hpp"

namespace mien {

namespace {

std::string build_json_line(const Diagnostic& diagnostic) {
  nlohmann::ordered_json object{{"kind", diagnostic.is_warning ? "warning" : "error"}};
  if (!diagnostic.place.file.empty()) object["file"] = diagnostic.place.file;
  if (diagnostic.place.line > 0) {
    object["line"] = diagnostic.place.line;
    if (diagnostic.place.column > 0) object["column"] = diagnostic.place.column;
  }
  object["message"] = diagnostic.message;
  return object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

void write_diagnostics(const std::vector<Diagnostic>& diagnostics, bool is_json) {
  for (const Diagnostic& diagnostic : diagnostics)
    write_stream(stderr, (is_json ? build_json_line(diagnostic) : format_diagnostic(diagnostic)) + "\n");
  const auto errors = std::count_if(diagnostics.begin(), diagnostics.end(),
                                    [](const Diagnostic& diagnostic) { return !diagnostic.is_warning; });
  if (errors > 1 && !is_json) write_stream(stderr, fmt::format("{} errors\n", errors));
}

}  // namespace mien
