// What the tables of areas and moves (areas.hpp) say of an area and of a move.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace mien {

enum class Side { none, left, right };

// In the order of kAreas: Tezuka's nine (brows, lids, eyes and corners are two each), then those beyond them.
enum class Area { brow, lid, eye, lips, corner, chin, tongue, cheek, jaw, mouth, nose };

// Places of the head in one line of text, apart by blanks: landmarks ("en_l", of
// templates/head/landmarks.yaml) and points of the cage ("M3_0"; "R:M3_3" is the one on the character's
// right). "E1_0..8" are the points from E1_0 to E1_8, "M3_6..1" those from M3_6 down to M3_1. Of the cage:
// E1_0..15 an eye's rim (0 inner corner, 1..7 upper lid, 8 outer corner, 9..15 lower lid), E5_2..6 the brow,
// M1 and M3 the lips' contact and border (0 the upper lip's middle, 6 corner, 12 the lower's), M6 the jaw's
// edge.
using PlaceText = std::string_view;

// The parts of the face that `lead` and `release` set apart, in the order of their keys, and the head.
enum class LeadPart { eyes, lids, brows, lips, corners, chin, tongue, cheeks, jaw, mouth, nose, head };

// How long after the first of them an area sets out, s; a frame of 24 is 0.042 s.
struct AreaLead {
  LeadPart part;
  // Eyes, then lids and brows a frame or two later, then the mouth, then jaw and head, at 24 frames a second
  // (face-facts: animators' overlap, 1-2, 2-4 and 3-6 frames).
  double natural_s;
  // On the ways of timeline/lead.hpp: to a round open mouth; from one; from an open smile down, where the
  // corners come three to four frames after the jaw and the brows as many after them.
  double rounds_s, unrounds_s, falls_s;
};

// How the two sides of an area differ under `asymmetry`.
struct LeanInfo {
  double weakness = 0;   // how much less the weak side does, as a share of what others lack; 0: both alike
  bool is_late = false;  // one side also comes later
};

// What a camera takes in on a sheet: `spread` times the longest way between two of the places.
struct AreaFraming {
  PlaceText around;
  double spread;
};

// What is drawn for an area's value in a table of expressions.
enum class AreaSign {
  way,         // an arrow, up or down and aside
  turned_way,  // an arrow, and a stick that turns
  pair,        // an arrow for what is above and one for what is below
  lift,        // an arrow, up or down
  words        // nothing: words alone
};

// What is drawn on a face for the limits of an area, at rest or where its move has a value.
enum class LimitShape {
  line,   // through the places
  lines,  // through them and through those of the other side
  box,    // around them at the limits of "up" and of the move, on both sides
  level   // across the picture at their height
};
struct LimitMark {
  LimitShape shape;
  PlaceText places;
  std::string_view move = "";  // none: at rest
  double value = 0;
  std::string_view word = "";  // on a level
};

// One area on the sheet of limits.
struct AreaLimits {
  int order;  // where it stands on the sheet
  std::string_view heading, caption;
  AreaFraming framing;
  std::span<const LimitMark> marks;
};

// All that is said of an area.
struct AreaInfo {
  Area area;
  std::string_view name;                         // the key's stem: "brow"
  std::string_view plural, left_key, right_key;  // "brows", "brow.left", "brow.right"; empty without sides
  std::string_view title;                        // its column in a table of expressions: "lids"
  std::string_view in_words;                     // in a sentence: "the eyelids"
  bool is_one_column;                            // there, with both sides
  AreaSign sign;                                 // there
  std::string_view aside;                        // its move across the face; empty if it has none
  bool is_quick;                                 // by nature: no leap of it is a mistake
  AreaLead lead;
  LeanInfo lean;
  AreaFraming framing;                // of the sheet of its moves
  std::array<PlaceText, 2> outlines;  // there, at rest
  AreaLimits limits;
  double open = 0;  // of chin.down in the pictures of its moves, if a shut mouth shows nothing of them

  constexpr bool has_sides() const { return !plural.empty(); }
};

// One way of a move, up or down.
struct MoveWay {
  // The last part of its limit's name: "up", "in". Empty: it has no such way.
  std::string_view name = "";
  // What the thesis calls the limit, 5.3; empty where it names none. @ stands for the viewer's side of the
  // area and ~ for its other side: outward and inward are left and right there.
  std::string_view thesis = "";
  std::string_view stop = "";  // why no style lifts it, if it is an end of the body's own
  // What ends it in place of a limit of the head. Two poses that both go there do not go there twice.
  std::string_view meets = "";

  constexpr bool is_limit() const { return !name.empty() && meets.empty(); }
};

// One number of a pose. Values are fractions of the area's limit on the head: 0 rest, 1 (or -1) the limit.
struct MoveInfo {
  std::string_view
      area;   // the key's stem: "brow", "lid", "eye", "lips", "corner", "chin", "tongue", "cheek", "jaw", ...
  Side side;  // none for an area without sides
  std::string_view move;     // "up", "out", "turn", "upper", "lower", "side", "press", "down"
  double low, high;          // the limits of the value
  std::string_view meaning;  // one line for `mien list areas`
  Area of;                   // `area`'s row in kAreas
  MoveWay plus, minus;
  std::string_view landmark;  // where it is measured, without its side: "brow_mid"
  PlaceText arrows;           // whose ways are drawn on the sheet of moves
  bool is_outward = false;    // + is away from the middle of the face; else the same way on both sides
  bool is_beyond = false;     // not one of Tezuka's: `head: {areas: nine}` does without
  double open = 0;            // as its area's `open`, for it alone
};

}  // namespace mien
