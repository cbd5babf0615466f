// The kinds of sheets as plans: plain data that says which heads are seen from where, with what drawn over
// them. What makes pictures of a plan is the same for all kinds.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/spec.hpp"
#include "scene/plate.hpp"
#include "sheet/subject.hpp"

namespace mien {

// What a cell's camera, which sees without perspective, takes in.
struct SheetFraming {
  // Landmarks, or points of the cage, in whose middle it looks; none: the head from chin to crown.
  std::vector<std::string> around;
  // With landmarks: the frame's side is `spread` times the longest way between two of them, and `margin`
  // heights of the head more.
  double spread = 1, margin = 0;
  bool has_crown = false;    // as high as a drawn head stretches, too, if that is more
  double wide = 1;           // without: the frame's width in heights of the head
  std::size_t scale_of = 0;  // the head that decides; one before the cell's own, or that itself
};

enum class MarkShape {
  line,   // smooth, through the places
  level,  // across the picture at the places' mean height
  box,    // around the places in all poses
  arrow   // of each place, from its first pose to its second
};

// What is drawn over a face, from places of its head (landmarks, or points of the cage) in poses.
struct SheetMark {
  MarkShape shape = MarkShape::line;
  std::vector<std::string> places;
  std::vector<Pose> poses{Pose{}};
  bool is_rest = false;            // in the blue pencil: what is at rest; else in the red one
  std::vector<std::string> words;  // of a level: on it; of a box: above, below, left and right of it
};

struct SheetCell {
  std::string caption;
  std::size_t head = 0;  // of SheetPlan::heads
  Pose pose{};
  double angle_deg = 0, height_deg = 0;  // of the camera, as in CameraKey
  SheetFraming framing{};
  bool has_guides = false;         // the guide lines are drawn over
  bool has_frame = false;          // and Loomis' frame of units around the head
  bool shows_height = false;       // behind the caption: ", 228 mm", from chin to crown
  std::vector<SheetMark> marks{};  // with arrows, the skin's way stands behind the caption: ", 12.7 mm"
};

// One field of a table: words, and strokes above them.
struct SheetField {
  std::string words;
  std::vector<PlateLine> strokes{};  // in half heights of the row from the field's middle, y up
};

struct SheetTable {
  // Of each column: its width as a share of the whole, and where its words stand in it: 0 left, 0.5 in the
  // middle, 1 right.
  std::vector<std::pair<double, double>> columns;
  std::vector<std::vector<SheetField>> rows;
  bool has_header = false;  // the first row says what the columns are
  bool is_tall = false;     // rows with strokes
  // Each row begins with the name of a limit; the last two fields are its value and its millimetres, which
  // are filled in when the head is built.
  bool shows_limits = false;
  // Of each row the face whose ways on the first head fill its last fields, and the one that it is held
  // against; none: a row of words. See sheet/motion_table.hpp.
  std::vector<std::optional<std::pair<Pose, Pose>>> motions = {};
};

// Cells in rows under a heading, and a table under the cells.
struct SheetBlock {
  std::string heading, note;  // may be empty
  std::vector<SheetCell> cells;
  std::size_t columns = 0;  // cells in a row; 0: all of them
  std::size_t skipped = 0;  // places left empty before the first cell
  SheetTable table{};
};

struct SheetPlan {
  std::string subject;                    // "Views": under the title
  std::pair<int, int> cell_px{400, 500};  // a cell's size unless --size says another
  std::size_t across = 1;                 // blocks side by side
  std::vector<HeadSpec> heads;
  std::vector<Style> styles{};  // of each head; none: as the file has it
  std::vector<SheetBlock> blocks;
};

// "young_adult" and "nose_length" as a caption has them.
std::string build_caption(std::string word);

// The plan of one kind of sheet. Throws InputError "unknown kind 'vews'; did you mean 'views'?".
SheetPlan build_sheet_plan(const std::string& kind, const SheetSubject& subject, const HeadData& data);

// Kinds that are made elsewhere (clip_sheets.hpp): suggested like the others.
inline constexpr std::array<std::string_view, 3> kClipSheets{"strip", "exposure", "contact"};

// Lines instead of pictures (wire_sheet.hpp), two faces (compare_sheet.hpp), a page that is read
// (proofs_sheet.hpp).
inline constexpr std::string_view kWireSheet = "wire", kCompareSheet = "compare", kProofsSheet = "proofs";

// The one that needs no file.
inline constexpr std::string_view kPeopleSheet = "people";

// All kinds, those of the clip too.
std::vector<std::string> list_sheet_kinds();

// Whether it shows one face, which --express and --at may ask for.
bool is_of_face(const std::string& kind);

// Throws InputError as build_sheet_plan does for a word that is no kind, wherever it is made.
void check_sheet_kind(const std::string& kind);

}  // namespace mien
