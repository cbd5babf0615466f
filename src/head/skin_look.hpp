// The look of the skin: which colour and gloss each place of it has.
#pragma once

#include "config/head_spec.hpp"
#include "head/head.hpp"

namespace mien {

// How light a skin is, from 0 (black) to 1 (fair and lighter): the lighter, the more blood shows through, the
// darker, the more of its light is sheen.
float compute_lightness(const glm::vec3& skin_srgb);

// The inside of a lip that one looks at over teeth, in its own shade.
glm::vec3 compute_inner_lip_srgb(const Look& look);

// The skin as a part that a writer draws: name and material "skin", the neutral mesh, and a shade a vertex.
// Lips, lids, cheeks, sockets, nostrils and mouth are masks on named rings and spots of the cage; hollows are
// darkened once, on the neutral head (head/occlusion). Pores and patches are the same on every head. All
// colours are made of `look.skin`, from very light to very dark, and lips of `look.lips` where it is given.
// Old skin is uneven, its lips pale, and it is worn as it is old. Mirror images get the same shade. About 0.1
// s.
Part build_skin_part(const NeutralHead& head, const Look& look);

// The same of one colour, that of `look.skin`, without grain.
Part build_plain_skin_part(const NeutralHead& head, const Look& look);

}  // namespace mien
