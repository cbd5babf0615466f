#include "core/error.hpp"

#include <fmt/format.h>

namespace mien {

InputError::InputError(std::vector<Diagnostic> found)
    : std::runtime_error(found.empty() ? "wrong input" : format_diagnostic(found.front())),
      diagnostics(std::move(found)) {}

InputError::InputError(const std::string& message) : std::runtime_error(message), diagnostics(1) {
  diagnostics.front().message = message;
}

std::string format_diagnostic(const Diagnostic& diagnostic) {
  const Place& at = diagnostic.place;
  const char* kind = diagnostic.is_warning ? "warning" : "error";
  std::string text;
  if (at.file.empty())
    text = fmt::format("{}: {}", kind, diagnostic.message);
  else if (at.line == 0)
    text = fmt::format("{}: {}: {}", at.file, kind, diagnostic.message);
  else if (at.column == 0)
    text = fmt::format("{}:{}: {}: {}", at.file, at.line, kind, diagnostic.message);
  else
    text = fmt::format("{}:{}:{}: {}: {}", at.file, at.line, at.column, kind, diagnostic.message);
  if (at.line == 0 || at.column == 0 || diagnostic.source_line.empty()) return text;

  std::string blank;  // tabs stay tabs, so that the caret stands under its letter
  for (int i = 0; i + 1 < at.column && i < static_cast<int>(diagnostic.source_line.size()); ++i)
    blank += diagnostic.source_line[i] == '\t' ? '\t' : ' ';
  return text + fmt::format("\n  {}\n  {}^", diagnostic.source_line, blank);
}

}  // namespace mien
