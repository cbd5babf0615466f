// The file on the disk, as pages read, await and save it.
#pragma once

#include "live/json.hpp"
#include "live/session.hpp"

namespace mien {

LiveAnswer answer_session(LiveSession& session);

// The file, as soon as it has changed since `version`.
LiveAnswer answer_disk(LiveSession& session, const LiveRequest& request);

// {text, hash}: written beside and renamed, if the disk still has what `hash` is of; else 409 with what it
// has.
LiveAnswer answer_save(LiveSession& session, const Json& asked);

}  // namespace mien
