// The doctrines beside each other by number: what docs/doctrines.md tells.
#pragma once

namespace mien {

// Prints for six feelings by each doctrine its numbers, how far it moves each region of the skin, how alike
// it is to the areas, how far its lips cross if nothing keeps them apart, and what a frame costs; then the
// worst of posed faces by muscles and by units.
void measure_doctrines();

}  // namespace mien
