// Hair in ink: how it is toned, how near it is drawn, and the lines on it.
#pragma once

#include <vector>

#include "core/mesh.hpp"
#include "frames/ink_profile.hpp"
#include "frames/ink_strokes.hpp"

namespace mien {

// Of each vertex of hair at rest: what hangs before the face, 1, and what lies beside, behind and above it,
// 0.
std::vector<float> measure_before(const std::vector<glm::vec3>& hair);

// Normals of hair, of length 1, which tell its tones, from where its vertices stand: hair is toned as the
// `ball` that it covers, its locks only a little as themselves, and looks toward the camera everywhere.
void round_hair(const Box& ball, const glm::vec3& camera, const std::vector<glm::vec3>& positions,
                std::vector<glm::vec3>& normals);

// What hangs lower than the mouth on the far side of a head that is turned lies farther back: a scrap of it
// would show beyond the chin. `hair` is that of the drawing.
void tuck_far_lock(const Ink& ink, const InkSight& sight, const Drawing& drawing,
                   std::vector<glm::vec3>& hair);

// The few lines on the hair of a figure, whose mass is this one; none without any.
std::vector<InkStroke> list_hair_strokes(const NeutralHead& head, const std::string& cut, const Mesh& mass);

inline constexpr int kHairLineSteps = 20;

// Triangles of the strip that such a line is, its vertices from `first` on: two a step.
std::vector<Triangle> list_hair_line_triangles(std::uint32_t first);

// Appends the vertices of its strip: on hair as `ground` has it, as broad as lines are seen from the camera.
// Where the ball about `middle` that hair covers turns away it runs out.
void append_hair_line(const InkStroke& stroke, const StrokeGround& ground, const glm::vec3& middle,
                      std::vector<glm::vec3>& vertices);

}  // namespace mien
