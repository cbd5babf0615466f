// Heads as line drawings (Yen, "Animation of Human Faces", Tamkang University, 1990, section 5.6, where
// THREED shows them): `mien sheet wire` and `mien still --wire`.
#pragma once

#include <filesystem>
#include <vector>

#include "clip/cast.hpp"
#include "clip/staging.hpp"
#include "frames/resources.hpp"
#include "options.hpp"
#include "sheet/sheet.hpp"
#include "wire/drawing.hpp"

namespace mien {

// From the front, from between and from the side, at rest or with the face of --express or --at; to -o, which
// ends in .svg or .png, else to out/NAME/sheet_wire.svg and .png. --size is the size of one view. Throws
// InputError before anything is written.
SheetFiles write_wire_sheet(const Options& options, const Resources& resources);

// The files of a still's line drawing: -o, else out/NAME/still_wire.svg and .png. Throws InputError for those
// that may not be written.
std::vector<std::filesystem::path> list_wire_files(const Options& options, const Spec& spec,
                                                   const std::string& name);

// Through the still's camera, with perspective; the paper has the clip's size.
Paper draw_wire_still(const Options& options, const Clip& clip, const Cast& cast, const Still& still,
                      const HeadStock& stock);

// Each by its ending.
void write_papers(const Paper& paper, const std::vector<std::filesystem::path>& paths,
                  const Templates& templates);

}  // namespace mien
