// The sections of the file, each from its value in the tree to its struct of spec.hpp.
#pragma once

#include "config/expressions.hpp"
#include "config/head_files.hpp"
#include "config/spec.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

HeadSpec load_head(const YamlValue& value, const HeadSource& source);

// `mien: 1` in a file's entries.
void check_version(const YamlValue& root, const YamlMapping& entries);

// A clip without keys on a track gets one at 0 s. `value` is empty if the file has no clip.
ClipSpec load_clip(const YamlValue* value, const ExpressionBook& book);

RenderSpec load_render(const YamlValue& value);

std::vector<BustSpec> load_busts(const YamlValue& value, const ExpressionBook& book);

}  // namespace mien
