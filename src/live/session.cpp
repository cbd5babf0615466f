#include "live/session.hpp"

#include <array>
#include <functional>
#include <string_view>

#include "live/clip_answers.hpp"
#include "live/disk_answers.hpp"
#include "live/edit_answers.hpp"
#include "live/job_answers.hpp"
#include "live/marks.hpp"
#include "live/view_answers.hpp"

namespace mien {

namespace {

struct Question {
  std::string_view path;
  LiveAnswer (*answer)(LiveSession& session, const Json& asked);
};

constexpr auto kQuestions = std::to_array<Question>({{"api/check", answer_check},
                                                     {"api/chart", answer_chart},
                                                     {"api/pose_at", answer_pose_at},
                                                     {"api/expression", answer_expression},
                                                     {"api/edit", answer_edit},
                                                     {"api/save", answer_save},
                                                     {"api/shapes", answer_shapes},
                                                     {"api/coarse", answer_coarse},
                                                     {"api/sky", answer_sky},
                                                     {"api/marks", answer_marks},
                                                     {"api/areas", answer_areas},
                                                     {"api/job", answer_job},
                                                     {"api/stop_job", answer_stop_job}});

LiveAnswer refuse_mistakes(const InputError& error) {
  Json findings = Json::array();
  for (const Diagnostic& mistake : error.diagnostics) findings.push_back(describe_finding(mistake));
  LiveAnswer answer = build_answer({{"error", error.diagnostics.front().message}, {"findings", findings}});
  answer.status = 400;
  return answer;
}

LiveAnswer answer_post(LiveSession& session, const LiveRequest& request) {
  for (const Question& question : kQuestions)
    if (question.path == request.path) return question.answer(session, parse_body(request));
  return build_refusal(404, "nothing is answered there");
}

LiveAnswer answer_get(LiveSession& session, const LiveRequest& request) {
  if (request.path == "api/session") return answer_session(session);
  if (request.path == "api/language") return answer_language(session);
  if (request.path == "api/disk") return answer_disk(session, request);
  if (request.path == "api/jobs") return answer_jobs(session, request);
  if (request.path.starts_with("made/")) return answer_made(session, request.path);
  return answer_file(session.files, request.path);
}

}  // namespace

void end_session(LiveSession& session) {
  end_jobs(session.jobs);
  const std::lock_guard lock(session.disk.mutex);
  session.disk.is_ending = true;
  session.disk.changed.notify_all();
}

LiveAnswer answer_request(LiveSession& session, const LiveRequest& request) {
  try {
    return request.is_post ? answer_post(session, request) : answer_get(session, request);
  } catch (const InputError& error) {
    return refuse_mistakes(error);
  }
}

}  // namespace mien
