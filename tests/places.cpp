#include "places.hpp"

namespace mien {

const char* source_folder() { return MIEN_SOURCE_DIR; }
const char* program_path() { return MIEN_BINARY; }

}  // namespace mien
