// Pictures that were traced, by what their pixels depend on: whatever frames show them now, none is traced
// twice.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

namespace mien {

// FOLDER/KEY.png, each with its key inside (mark_picture).
struct PictureStore {
  std::filesystem::path folder;
  std::uintmax_t most_bytes = kStoreBytes;

  static constexpr std::uintmax_t kStoreBytes = 2'000'000'000;

  std::filesystem::path picture(const std::string& key) const { return folder / (key + ".png"); }
};

// Beside its pictures, of those who know them without computing them: lines of an origin and a key.
inline constexpr const char* kKnownDrawings = "drawings.txt";

// Whether FOLDER may hold a picture of this name: "0123456789abcdef.png".
bool is_stored_file(const std::string& name);

// Whether the picture is there, whole, and the one of its name.
bool has_picture(const PictureStore& store, const std::string& key);

// Gives a picture of the store a second name, which takes no second place on the disk; a copy where the disk
// knows no such names. What stood there is replaced in one step. The picture counts as used now, unless a
// frame shows it. Throws RunError "cannot write SHOWN: reason".
void show_picture(const std::filesystem::path& stored, const std::filesystem::path& shown);

// Takes pictures out, those first that were used longest ago, until no more than `most_bytes` are left;
// those of `in_use` stay.
void trim_store(const PictureStore& store, const std::set<std::string>& in_use);

// What was taken away.
struct Cleaned {
  std::size_t files = 0;
  std::uintmax_t bytes = 0;  // that the disk has got back
};

// Removes the file; its bytes count if no other name is left of it.
void clean_file(const std::filesystem::path& file, Cleaned& cleaned);

// Removes all pictures of the store, and its folder if nothing else is in it.
void clean_store(const PictureStore& store, Cleaned& cleaned);

}  // namespace mien
