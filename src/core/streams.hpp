// Standard input, output and error as they may be: closed, full, or read by nobody.
#pragma once

#include <cstdio>
#include <string_view>

namespace mien {

// Puts something in the place of each of the descriptors 0, 1 and 2 that is closed, so that no file which is
// opened later takes its number and is written over by what is printed: an empty input, and outputs that fail
// to be written. For main.cpp, before anything is opened.
void open_missing_streams();

// Writes `text` at once, as far as the stream takes it; never throws. What it did not take is remembered by
// the stream (has_lost_text).
void write_stream(std::FILE* stream, std::string_view text);

// What the stream still holds goes out now; throws std::system_error, as fmt::print does, if it cannot.
void flush_stream(std::FILE* stream);

// Whether anything written to the stream was lost, what it still held included.
bool has_lost_text(std::FILE* stream);

}  // namespace mien
