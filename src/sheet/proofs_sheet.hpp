// `mien sheet proofs`: the figures of the thesis's chapter 6 on one page, each with what it shows, measured.
#pragma once

#include "frames/resources.hpp"
#include "options.hpp"
#include "sheet/sheet.hpp"

namespace mien {

// A page that opens without a network: -o, which ends in .html, else out/proofs/index.html. Throws InputError
// before anything is written.
SheetFiles write_proofs(const Options& options, const Resources& resources);

}  // namespace mien
