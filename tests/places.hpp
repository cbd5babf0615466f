// Where the tests' own checkout and the program they run are.
#pragma once

namespace mien {

const char* source_folder();  // of the checkout, absolute
const char* program_path();   // of the mien that was built with these tests

}  // namespace mien
