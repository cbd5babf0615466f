// What is written on the frames of a clip for those who work on it: number, time, and what is played then.
#pragma once

#include <string>

#include "clip/clip.hpp"
#include "render/picture.hpp"
#include "sketch/lettering.hpp"

namespace mien {

struct Slate {
  std::string frame;  // "0037/0096"
  std::string time;   // "1.500 s"
  std::string keys;   // "smile 0.8", on the way "smile 0.8 to anger"; of actors "ann: smile, otto: anger"
};

// `frame` counts from 1.
Slate build_slate(const Clip& clip, int frame);

// On a dark strip along the picture's lower edge.
void draw_slate(Pixels& picture, const Slate& slate, const Letters& letters);

}  // namespace mien
