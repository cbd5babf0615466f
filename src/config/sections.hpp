// The sections of the file, each from its value in the tree to its struct of spec.hpp.
#pragma once

#include "config/expressions.hpp"
#include "config/spec.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

// `features` are the known features' names.
HeadSpec load_head(const YamlValue& value, const Names& features);

// A clip without keys on a track gets one at 0 s. `value` is empty if the file has no clip.
ClipSpec load_clip(const YamlValue* value, const ExpressionBook& book);

RenderSpec load_render(const YamlValue& value);

std::vector<BustSpec> load_busts(const YamlValue& value, const ExpressionBook& book);

}  // namespace mien
