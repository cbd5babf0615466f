// What a head is before it has a skin: its control points and its eye, made from the shipped half, the
// user's own half, a scan or other heads.
#pragma once

#include <memory>

#include "head/cage.hpp"
#include "head/shapes.hpp"

namespace mien {

// All that every head is made from; read and solved once.
struct HeadStock {
  std::filesystem::path folder;            // templates/head
  HalfHead half;                           // the shipped one
  Cage adult;                              // solved
  std::shared_ptr<const Surface> surface;  // of every head
  HeadShapes shapes;
};

HeadStock load_head_stock(const std::filesystem::path& data_folder);

// These control points with the skin's positions and nothing else: for finding places on it.
NeutralHead build_bare_head(const HeadStock& stock, const std::vector<glm::dvec3>& points);

// The head of `spec`: mesh, scan or mix as the start (else the shipped adult), then age, skull, character,
// features, guide lines, and sculpting last. Throws InputError for broken geometry files, at their lines.
HeadForm build_form(const HeadStock& stock, const HeadSpec& spec);

}  // namespace mien
