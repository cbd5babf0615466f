// tinygltf's own code, compiled once.
#define TINYGLTF_IMPLEMENTATION
#include "scene/tiny_gltf.hpp"
