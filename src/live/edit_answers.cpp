#include "live/edit_answers.hpp"

#include <fmt/format.h>

#include "config/edit.hpp"
#include "config/findings.hpp"
#include "config/load_spec.hpp"

namespace mien {

namespace {

constexpr int kMostFps = 1000;  // far more than the language has

YamlPath take_path(const Json& asked) {
  const auto found = asked.find("path");
  if (found == asked.end() || !found->is_array())
    throw InputError("'path' is missing; expected a list of keys and numbers of items");
  YamlPath path;
  for (const Json& step : *found)
    if (step.is_string())
      path.emplace_back(step.get<std::string>());
    else if (step.is_number_unsigned())
      path.emplace_back(step.get<std::size_t>());
    else
      throw InputError(
          "'path' holds what is neither a text nor a number; expected keys and numbers of items");
  return path;
}

Pose take_pose(const Json& asked) {
  const auto found = asked.find("values");
  if (found == asked.end()) throw InputError("'values' is missing; expected areas with their moves");
  return read_pose(*found);
}

int take_fps(const Json& asked) { return static_cast<int>(take_number(asked, "fps", 1, kMostFps)); }

// Whatever the time, edits say themselves where it cannot be.
double take_time_s(const Json& asked, const char* name) { return take_number(asked, name, -1e9, 1e9); }

std::string edit_text(const LiveSession& session, const Json& asked) {
  const std::string text = take_text(asked, "text"), what = take_text(asked, "do");
  if (what == "set") return set_value(text, take_path(asked), take_text(asked, "value"));
  if (what == "remove") return remove_value(text, take_path(asked));
  if (what == "write_expression") return write_expression(text, take_text(asked, "name"), take_pose(asked));
  if (what == "write_key") {
    const std::string actor = asked.contains("actor") ? take_text(asked, "actor") : "";
    const KeyEdit key{actor, take_time_s(asked, "at_s"), take_fps(asked), take_pose(asked)};
    return write_key(text, key, *session.shelf.resources->stock.language);
  }
  if (what == "move") {
    const auto take_whole = [&](const char* name) {
      return static_cast<int>(take_number(asked, name, 0, 1e8));
    };
    return move_time(text, {take_whole("line"), take_whole("column"), take_text(asked, "member"),
                            take_time_s(asked, "to_s"), take_fps(asked)});
  }
  throw InputError(
      describe_unknown("edit", what, {"set", "remove", "write_key", "write_expression", "move"}));
}

}  // namespace

LiveAnswer answer_edit(LiveSession& session, const Json& asked) {
  return build_answer({{"text", edit_text(session, asked)}});
}

}  // namespace mien
