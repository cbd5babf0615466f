// tinygltf without readers and writers of pictures, which are not asked of it: the same words for all who use
// it.
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>
