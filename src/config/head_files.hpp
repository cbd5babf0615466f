// Files that a head's description names: meshes, scans with their landmarks, other heads.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <vector>

#include "config/head_spec.hpp"
#include "config/head_words.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

inline constexpr int kMaxMixDepth = 4;     // heads that mix heads that mix heads: no author needs more
inline constexpr int kMaxMixedHeads = 24;  // of one file, all depths together; each costs a tenth of a second
inline constexpr int kMaxScans = 3;        // of one file, different ones; each takes two seconds to wrap
inline constexpr int kMaxHeadKeys = 30;    // of one file; each is a head to build, a third of a second
inline constexpr int kMaxStrokes = 200;    // of one file; each moves a whole head, a millisecond

// What was read of a file so far that costs more than its words.
struct HeadCounts {
  int mixed = 0, keys = 0, strokes = 0;
  std::set<std::filesystem::path> scans;  // and meshes that are wrapped as scans are
};

// Where a head is being read: its file, and those that led to it.
struct HeadSource {
  const HeadWords* words = nullptr;
  std::vector<std::filesystem::path> chain;  // the files being read, the outermost first
  HeadCounts* counts = nullptr;
};

// The landmarks beside a mesh: NAME.landmarks.yaml, else NAME.yaml; empty if neither is there.
std::optional<std::filesystem::path> find_landmark_file(const std::filesystem::path& mesh);

// A mesh and its landmarks as they are now: other words once one of them has been written, or is another
// file.
std::string describe_mesh_state(const std::filesystem::path& mesh);

// `mesh: my_half.obj`, `scan: face.ply`. What the files hold is read by whoever builds the head.
void load_mesh(const YamlValue& value, const HeadSource& source, std::optional<FileReference>& into);
void load_scan(const YamlValue& value, const HeadSource& source, std::optional<FileReference>& into);

// `ann.yaml`: the head of that file.
bool load_head_file(const YamlValue& value, const HeadSource& source, HeadSpec& head);

// `mix: {a.yaml: 0.5, b.yaml: 0.5}`: the heads of the files, their limits mixed, and their colours as the
// look to begin with.
void load_head_mix(const YamlValue& value, const HeadSource& source, HeadSpec& head);

// `sculpt: [{at: chin, move: [0, -2mm, 3mm], radius: 25mm}]`. `at` loses its _l or _r.
void load_sculpt(const YamlValue& value, const HeadSource& source, std::vector<SculptStroke>& into);

}  // namespace mien
