// What a page's graphics are given, as bytes (json.hpp's build_bytes) that the object before them tells of.
#pragma once

#include "live/json.hpp"
#include "live/session.hpp"
#include "live/view_store.hpp"

namespace mien {

// All of them: {doc, frame}, and where it is said a `camera` {angle, height, distance} instead of the clip's.

// {known, camera} also {actor, values}: that one stands so instead of what it does, {} is at rest; `known`
// are the models that the page has. {model, stage, outlines: [[vertices, triangles]]}, then for each part
// what append_shape says. Of a model that the page has not there is also `fresh`, {model, step_mm, actors:
// [{name, parts: [{name, vertices, triangles, pieces, finish ...}]}]}, and what append_model says comes
// first.
LiveAnswer answer_shapes(LiveSession& session, const Json& asked);

// {model, triangles: [[number]]}: for each part its triangles in the coarse (coarse.hpp), three 32-bit
// numbers each.
LiveAnswer answer_coarse(LiveSession& session, const Json& asked);

// {camera, width, height}: what lies behind everybody, 3 bytes a pixel from the upper left.
LiveAnswer answer_sky(LiveSession& session, const Json& asked);

// The moment of a request.
ViewMoment find_asked_moment(LiveSession& session, LiveDocument& document, const Json& asked);

}  // namespace mien
