// `mien sheet contact`: the drawings of a clip in rows, each with its frame, its time and what is played
// then.
#pragma once

#include <filesystem>

#include "frames/resources.hpp"
#include "options.hpp"

namespace mien {

// One drawing in --every, else as many as are seen at a glance, of the frames that --frames asks for, into
// one picture: -o, else out/NAME/contact.png (of sketches contact_sketch.png); returns its path. --size is a
// picture's. What POV-Ray traces for it goes into the clip's store. Throws InputError before anything is
// written.
std::filesystem::path write_contact_sheet(const Options& options, const Resources& resources);

}  // namespace mien
