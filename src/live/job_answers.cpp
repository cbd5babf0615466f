#include "live/job_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "config/edit.hpp"
#include "config/findings.hpp"
#include "core/text.hpp"
#include "live/files.hpp"
#include "live/news.hpp"

namespace mien {

namespace {

// A kind of job: the command and its own options. `of` says what of the page's moment it takes.
struct JobKind {
  std::string_view name, title, command;
  std::vector<std::string> options;
  bool has_moment = false;
};

const std::array<JobKind, 6>& list_kinds() {
  static const std::array<JobKind, 6> kinds{
      {{"sketch", "Sketched clip", "render", {"--quality", "sketch"}},
       {"render", "Clip", "render", {}},
       {"still", "Picture", "still", {}, true},
       {"still_sketch", "Sketch", "still", {"--quality", "sketch"}, true},
       {"bust", "Bust for OpenSCAD", "bust", {"--no-stl"}, true},
       {"stl", "Bust as STL", "bust", {}, true}}};
  return kinds;
}

constexpr std::array<std::string_view, 5> kStateNames{"waiting", "running", "done", "failed", "stopped"};

Json describe_job(const Job& job) {
  Json results = Json::array();
  for (const auto& path : job.results)
    results.push_back({{"name", path.filename().string()},
                       {"path", path.string()},
                       {"href", fmt::format("made/{}/{}", job.id, encode_name(path.filename().string()))}});
  return {{"id", job.id},       {"kind", job.kind},
          {"title", job.title}, {"state", kStateNames[static_cast<std::size_t>(job.state)]},
          {"stage", job.stage}, {"done", job.finished},
          {"total", job.all},   {"lines", job.lines},
          {"results", results}};
}

// A face of somebody's own instead of the clip's.
void add_face(const Json& asked, const std::string& expression, std::vector<std::string>& command) {
  // Beside its option's name in one word, so that none of its letters is taken for another option.
  command.push_back("--express=" + expression);
  const std::string actor = asked.contains("actor") ? take_text(asked, "actor") : "";
  if (!actor.empty()) command.push_back("--actor=" + actor);
}

}  // namespace

LiveAnswer answer_job(LiveSession& session, const Json& asked) {
  if (session.is_read_only) return build_refusal(403, "nothing is made with --read-only");
  const std::string name = take_text(asked, "kind");
  const auto kind = std::ranges::find(list_kinds(), name, &JobKind::name);
  if (kind == list_kinds().end()) throw InputError(fmt::format("unknown kind '{}'", show_word(name)));
  std::vector<std::string> command{session.program.string(), std::string(kind->command),
                                   session.shelf.file.string(), "--json"};
  command.insert(command.end(), kind->options.begin(), kind->options.end());
  std::string title(kind->title);
  if (kind->has_moment && asked.contains("values")) {
    const double strength = take_number(asked, "strength", 0, 1, 1);
    Pose pose = read_pose(asked["values"]);
    for (double& value : pose.values) value *= strength;
    add_face(asked, format_expression(pose), command);
    title += ", posed by hand";
  } else if (kind->has_moment && asked.contains("express")) {
    const std::string expression = take_text(asked, "express");
    add_face(asked, expression, command);
    title += ": " + expression;
  } else if (kind->has_moment) {
    const std::string time = format_number(take_number(asked, "at_s", 0, 1e6, 0), 4) + "s";
    command.push_back("--at=" + time);
    title += " at " + time;
  }
  return build_answer({{"id", add_job(session.jobs, name, title, command)}});
}

LiveAnswer answer_stop_job(LiveSession& session, const Json& asked) {
  if (session.is_read_only) return build_refusal(403, "nothing is made with --read-only");
  stop_job(session.jobs, static_cast<int>(take_number(asked, "id", 0, 1e9)));
  return build_answer(Json::object());
}

LiveAnswer answer_jobs(LiveSession& session, const LiveRequest& request) {
  Jobs& jobs = session.jobs;
  const int known = take_version(request);
  std::unique_lock lock(jobs.mutex);
  wait_for_news(lock, jobs.changed, jobs.waiting, [&] { return jobs.is_ending || jobs.version != known; });
  Json all = Json::array();
  for (const Job& job : jobs.jobs) all.push_back(describe_job(job));
  return build_answer({{"version", jobs.version}, {"jobs", all}});
}

LiveAnswer answer_made(LiveSession& session, const std::string& path) {
  const std::size_t slash = path.find('/', std::string_view("made/").size());
  std::filesystem::path found;
  {
    const std::lock_guard lock(session.jobs.mutex);
    for (const Job& job : session.jobs.jobs)
      for (const auto& result : job.results)
        if (slash != std::string::npos &&
            path == fmt::format("made/{}/{}", job.id, result.filename().string()))
          found = result;
  }
  std::error_code error;
  if (found.empty() || !std::filesystem::is_regular_file(found, error))
    return build_refusal(404, "there is no such file");
  return {200, find_type(found.filename().string()), read_file(found)};
}

}  // namespace mien
