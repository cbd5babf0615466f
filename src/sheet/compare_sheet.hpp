// `mien sheet compare A B`: two faces beside and over each other, after the checking tool of Yen, "Animation
// of Human Faces", Tamkang University, 1990, section 5.7.
#pragma once

#include "frames/resources.hpp"
#include "options.hpp"
#include "sheet/sheet.hpp"

namespace mien {

// `options.file` and `options.other` are words as sheet/face_word.hpp has them. Both faces from the front and
// the side; their outlines over each other; how far each place of the skin is from the same place of the
// other; and a table of landmarks. To -o, else to out/NAME/sheet_compare.png, NAME being the first file's.
// Throws InputError before anything is written.
SheetFiles write_compare_sheet(const Options& options, const Resources& resources);

}  // namespace mien
