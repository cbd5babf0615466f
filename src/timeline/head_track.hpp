// A head that changes in time: what it is between two keys.
#pragma once

#include <string>
#include <vector>

#include "config/clip_spec.hpp"

namespace mien {

// The head `share` of the way from one to another. Ages, skulls, character, features and colours are mixed;
// a guide line or a colour of the lips that only one of the two sets is reached from the head's own one, so
// that nothing jumps. At 0 and 1 exactly the one and the other. All else is `from`'s: keys of one track share
// it.
HeadSpec mix_heads(const HeadSpec& from, const HeadSpec& to, double share);

// The head at a time. `keys` are by time, and at least one; at a key's time it is exactly the key's.
HeadSpec sample_head(const std::vector<HeadKey>& keys, double time_s);

// 16 hexadecimal digits that differ for heads of one track that differ.
std::string compute_head_key(const HeadSpec& head);

}  // namespace mien
