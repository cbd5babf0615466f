// What a page is told of a text: its mistakes, what plays when, what limits hold back, and how the face
// stands.
#pragma once

#include "live/json.hpp"
#include "live/session.hpp"

namespace mien {

LiveAnswer answer_check(LiveSession& session, const Json& asked);       // {text}
LiveAnswer answer_chart(LiveSession& session, const Json& asked);       // {doc}
LiveAnswer answer_pose_at(LiveSession& session, const Json& asked);     // {doc, frame, actor}
LiveAnswer answer_expression(LiveSession& session, const Json& asked);  // {doc, name, strength}
LiveAnswer answer_language(LiveSession& session);

// The actor that a request names; the first if it names none. Throws InputError.
std::size_t find_asked_actor(const Clip& clip, const Json& asked);

// The moment of a request, s: that of its frame's drawing.
double find_asked_time_s(const Clip& clip, const Json& asked);

}  // namespace mien
