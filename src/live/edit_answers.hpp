// What a page's sliders and drags make of a text.
#pragma once

#include "live/json.hpp"
#include "live/session.hpp"

namespace mien {

// {text, do, ...} -> {text}: `do` is set, remove, write_key, write_expression or move.
LiveAnswer answer_edit(LiveSession& session, const Json& asked);

}  // namespace mien
