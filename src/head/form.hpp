// What a head is before it has a skin: its control points and its eye, made from the shipped half, the
// user's own half, a scan or other heads.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "head/cage.hpp"
#include "head/shapes.hpp"

namespace mien {

struct StartStore;

// All that every head is made from, solved once; shared by all threads.
struct HeadStock {
  HeadDataPointer data;
  Cage adult;                              // the shipped one, solved
  std::shared_ptr<const Surface> surface;  // of every head
  std::shared_ptr<StartStore> starts;      // what meshes and scans were made into, each once (form.cpp)
};

// About 0.1 s. Throws RunError for data that cannot be solved.
HeadStock build_head_stock(HeadDataPointer data);

// These control points with the skin's positions and nothing else: for finding places on it.
NeutralHead build_bare_head(const HeadStock& stock, const std::vector<glm::dvec3>& points);

// The head of `spec`: mesh, scan or mix as the start (else the shipped adult), then age, skull, character,
// features, guide lines, and sculpting last. Throws InputError for broken geometry files, at their lines.
HeadForm build_form(const HeadStock& stock, const HeadSpec& spec);

// What is to be said of a mesh or a scan that a head is made from.
struct StartNote {
  FileReference file;
  std::vector<std::string> kept;     // a scan has none of these, they are the shipped head's: "ears"
  std::vector<Diagnostic> warnings;  // why it may be no good head
};

// Of the head's own, or of each that it mixes; at no cost once the head was built. Throws as build_form does.
std::vector<StartNote> list_start_notes(const HeadStock& stock, const HeadSpec& spec);

}  // namespace mien
