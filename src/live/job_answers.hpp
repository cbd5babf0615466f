// What a page has made and looks at.
#pragma once

#include "live/json.hpp"
#include "live/session.hpp"

namespace mien {

// {kind, at_s, or express or values (of areas' moves) with strength and actor}: {id}. The kinds are sketch,
// render, still, still_sketch, bust and stl.
LiveAnswer answer_job(LiveSession& session, const Json& asked);
LiveAnswer answer_stop_job(LiveSession& session, const Json& asked);  // {id}

// The jobs, as soon as something has happened since `version`.
LiveAnswer answer_jobs(LiveSession& session, const LiveRequest& request);

// A file that a job has made: "made/3/hello.mp4". 404 if it has not.
LiveAnswer answer_made(LiveSession& session, const std::string& path);

}  // namespace mien
