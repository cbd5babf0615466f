// What a page may draw over a face: guide lines and landmarks that move with the skin, and what each area
// moves with its limits.
#pragma once

#include "live/json.hpp"
#include "live/session.hpp"

namespace mien {

// {doc, frame, actor, model}: {guides: [{name, lines: [[a, b, t, a, b, t] ...]}], landmarks: [{name,
// vertices, shares}]}. Numbers of vertices are those of the page's part "skin"; a place on an edge is that of
// a and so much (t) of the way to b.
LiveAnswer answer_marks(LiveSession& session, const Json& asked);

// {doc, frame, actor, camera}: {areas: [{name, colour, mm}], limits: {lines: [{colour, segments}]}}, then for
// each vertex of the page's "skin" the colour of the area that moves it most and how much, 4 bytes.
LiveAnswer answer_areas(LiveSession& session, const Json& asked);

}  // namespace mien
