// A painted skin: a picture's colours instead of the skin's own.
#pragma once

#include "config/head_spec.hpp"
#include "core/atlas.hpp"
#include "core/model.hpp"

namespace mien {

// Gives each vertex of the skin the picture's colour at its place in the atlas; the gloss stays. Colours are
// shared in steps too small to see, fewer where there are very many, so that the palette stays within 4,096.
// The picture itself lies over the skin beside them, for those who can show it.
// Throws InputError for a file that is no picture, at the place where it is named.
void paint_skin(const std::shared_ptr<const Atlas>& atlas, const FileReference& texture, Part& skin);

}  // namespace mien
