// What a face did when, as programs that watch faces write it: Live Link Face, ARKit, MediaPipe and OpenFace.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

// Rows times channels: three hours of Live Link Face. A number takes four bytes.
inline constexpr std::size_t kMaxTakeValues = 40'000'000;
inline constexpr std::size_t kMaxTakeChannels = 160;  // the vocabularies have 60 units at most
inline constexpr double kMaxTakeTime_s = 24 * 3600;

// A channel of this and the name of a move's way ("mien.lid.left.shut") is our own, 1 at the move's end.
inline constexpr std::string_view kOwnUnit = "mien.";

//   live_link  CSV of Live Link Face: Timecode, BlendShapeCount, ARKit's units, angles of head and eyes
//   arkit      JSON: frames with ARKit's units, as MediaPipe's face landmarker and recorders write them
//   openface   CSV of OpenFace 2: action units of FACS, angles of head and gaze
//   tracks     JSON of OpenFaceFX: keys for each of ARKit's units
//   vrma       VRM animation (binary glTF): expressions of VRM or by ARKit's names, head and neck
//   gltf       glTF 2.0 of a head whose targets have our names, ARKit's or VRM's
enum class TakeKind { live_link, arkit, openface, tracks, vrma, gltf };

// One of a take's units, by the name that its mapping has (configs/mappings), and where the file names it.
struct TakeChannel {
  std::string name;  // "jawOpen", "AU12"
  int line = 0, column = 0;
};

// Rows in which a face was seen, and the time since the file's first row.
struct Take {
  std::string file;
  std::string_view mapping;  // whose units the channels are: "arkit", "facs", "vrm"
  std::vector<TakeChannel> channels;
  std::vector<double> at_s;   // rising; one row at least
  std::vector<float> values;  // row by row; 0 rest, 1 the unit in full
  // Row by row, or none: the head's turn to the character's left, nod (chin down) and tilt (crown to the
  // left), and where both eyes look within the head, to the character's left and up.
  std::vector<std::array<float, 3>> turn_deg;
  std::vector<std::array<float, 2>> gaze_deg;
  std::string start;       // the timecode of the first row, where there is one
  int row_count = 0;       // of the file
  int unseen_count = 0;    // rows in which the program saw no face
  int repeated_count = 0;  // rows at the time of the one before, which are passed
  double end_s = 0;        // of the last row, seen or not
  // Rows are keys of an animation: none is missing between two, and it has channels for other things than a
  // face's units.
  bool is_animation = false;
};

// Reads a take, row after row, so that of a long file no more than its numbers is held. `fps` is the rate of
// the frames that a timecode counts, or of rows without times; 0: as the file lets see, else 60 of Live Link
// Face and 30 of JSON. Throws InputError "FILE:LINE:COL: error: what was found; what was expected".
Take load_take(const std::filesystem::path& file, TakeKind kind, double fps = 0);

// The kind that a file's name and first words have, for `mien import`; empty: another kind of file. Throws
// nothing: what cannot be read is no take.
enum class TakeGuess { none, live_link, arkit, openface, tracks, vrma, gltf };
TakeGuess guess_take_kind(const std::filesystem::path& file);

}  // namespace mien
