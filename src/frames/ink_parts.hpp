// What the parts of a real head become in ink, and the parts that only a drawn one has.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/model.hpp"
#include "frames/ink.hpp"

namespace mien {

// A part of one colour that is not printed, without points.
Part make_flat_part(std::string name, const char* material, const glm::vec3& srgb);

// The index of a part; throws RunError where there is none of that name.
std::size_t find_model_part(const Model& model, std::string_view name);

// Gives all parts of ink.model but the skin the materials and colours of ink. To be called before a part is
// added, as all of the following are.
void set_materials(const Look& look, const InkColours& colours, Ink& ink);

// Takes triangles away: ears below hair that covers them, whose strips and crumbs would show beside it, and
// hair in the bowl of an ear.
void hide_ears(const Figure& figure, Ink& ink);
void clear_ears(const Figure& figure, Ink& ink);

// Points of the bowls of both ears of the head at rest, and whether a place is in one.
std::vector<glm::vec3> list_ear_bowls(const NeutralHead& head);
bool is_in_ear(const std::vector<glm::vec3>& bowls, const glm::vec3& place, float eye_size);

// The upper teeth and their gum end the less deep the farther out they are and the farther back: the row
// comes to a point at both ends, which would be fangs where it turns back seen from below. They go `over_mm`
// above its top, behind the lip, or two edges of them would be seen from there as frayed ends. `axes` are the
// skull's: aside, up and forward, of length 1.
void taper_row(const glm::mat3& axes, float over_mm, std::vector<glm::vec3>& positions);

// Seen from the side, one looks through an open mouth from corner to corner: a sheet in the middle of it,
// from the lips to the throat, in so many rows from the upper lip to the lower one, and a line before it. And
// teeth are a strip there. All take their points from the skin (Ink).
inline constexpr std::uint32_t kSheetRows = 9;
Part make_mouth_sheet(const Figure& figure, const InkColours& colours, Ink& ink);
Part make_mouth_edge(const InkColours& colours);
Part make_tooth_strip(const Figure& figure, const InkColours& colours, Ink& ink);

}  // namespace mien
