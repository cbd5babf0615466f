#pragma once
#include "live/json.hpp"
#include "live/session.hpp"
namespace mien {
LiveAnswer answer_edit(LiveSession& session, const Json& asked);
}
