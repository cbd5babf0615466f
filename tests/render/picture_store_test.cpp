// Pictures are kept by what they show, under as many names as frames have.
#include "render/picture_store.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/picture.hpp"
#include "render/scratch.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

// A small picture whose pixels follow from its key.
std::string make_picture(const std::string& key) {
  Pixels pixels{{4, 3}, std::vector<std::uint8_t>(36)};
  for (std::size_t i = 0; i < pixels.rgb.size(); ++i)
    pixels.rgb[i] = static_cast<std::uint8_t>(i * 7 + static_cast<std::size_t>(key.back()));
  return mark_picture(build_png(pixels), key);
}

std::string make_key(int number) { return hash_hex(std::to_string(number)); }

PictureStore make_store(const Scratch& scratch, int count) {
  const PictureStore store{scratch.path / "store"};
  for (int i = 0; i < count; ++i) {
    write_file(store.picture(make_key(i)), make_picture(make_key(i)));
    fs::last_write_time(store.picture(make_key(i)),
                        fs::file_time_type::clock::now() - std::chrono::hours(count - i));
  }
  return store;
}

TEST(picture_store, knows_what_is_whole_and_what_it_shows) {
  const Scratch scratch;
  const PictureStore store = make_store(scratch, 3);
  EXPECT_TRUE(has_picture(store, make_key(1)));
  EXPECT_FALSE(has_picture(store, make_key(7)));
  EXPECT_FALSE(has_picture(store, ""));
  fs::resize_file(store.picture(make_key(1)), 40);
  EXPECT_FALSE(has_picture(store, make_key(1))) << "it is cut";
  write_file(store.picture(make_key(2)), make_picture(make_key(0)));
  EXPECT_FALSE(has_picture(store, make_key(2))) << "it is another's";
}

TEST(picture_store, shows_a_picture_under_another_name_without_a_second_copy) {
  const Scratch scratch;
  const PictureStore store = make_store(scratch, 2);
  const fs::path shown = scratch.path / "frames/f0001.png", stored = store.picture(make_key(0));
  show_picture(stored, shown);
  EXPECT_TRUE(fs::equivalent(stored, shown));
  show_picture(stored, shown);
  EXPECT_TRUE(fs::equivalent(stored, shown)) << "as before";
  show_picture(store.picture(make_key(1)), shown);
  EXPECT_EQ(read_picture_key(shown), make_key(1));
  EXPECT_EQ(read_picture_key(stored), make_key(0)) << "what it showed before is as it was";
  EXPECT_EQ(count_files(scratch.path / "frames"), 1);
  write_file(scratch.path / "blocked", "a file");
  EXPECT_EQ(find_message<RunError>([&] { show_picture(stored, scratch.path / "blocked/f0001.png"); }),
            "cannot write " + (scratch.path / "blocked/f0001.png").string() + ": Not a directory");
}

TEST(picture_store, is_trimmed_of_what_was_used_longest_ago) {
  const Scratch scratch;
  PictureStore store = make_store(scratch, 6);
  const std::uintmax_t one = fs::file_size(store.picture(make_key(0)));
  show_picture(store.picture(make_key(2)), scratch.path / "f0001.png");  // used now
  write_file(store.folder / "holiday.png", "somebody's own");
  store.most_bytes = 3 * one;
  trim_store(store, {make_key(0)});
  for (const auto& [number, is_there] :
       {std::pair{0, true}, {1, false}, {2, true}, {3, false}, {4, false}, {5, true}})
    EXPECT_EQ(has_picture(store, make_key(number)), is_there) << number;
  store.most_bytes = 0;
  trim_store(store, {make_key(0)});
  EXPECT_TRUE(has_picture(store, make_key(0))) << "in use";
  EXPECT_FALSE(has_picture(store, make_key(2)));
  EXPECT_TRUE(fs::exists(store.folder / "holiday.png"));
}

TEST(picture_store, is_emptied_and_tells_what_the_disk_got_back) {
  const Scratch scratch;
  const PictureStore store = make_store(scratch, 3);
  const std::uintmax_t shown = fs::file_size(store.picture(make_key(0))),
                       others = fs::file_size(store.picture(make_key(1))) +
                                fs::file_size(store.picture(make_key(2)));
  show_picture(store.picture(make_key(0)), scratch.path / "f0001.png");
  Cleaned cleaned;
  clean_store(store, cleaned);
  EXPECT_EQ(cleaned.files, 3u);
  EXPECT_EQ(cleaned.bytes, others) << "one of them has another name still";
  EXPECT_FALSE(fs::exists(store.folder));
  clean_file(scratch.path / "f0001.png", cleaned);
  EXPECT_EQ(cleaned.files, 4u);
  EXPECT_EQ(cleaned.bytes, others + shown);
  clean_store(store, cleaned);
  EXPECT_EQ(cleaned.files, 4u);
}

TEST(picture_store, tells_its_own_files_by_their_names) {
  EXPECT_TRUE(is_stored_file("0123456789abcdef.png"));
  for (const char* name : {"0123456789abcde.png", "0123456789abcdeg.png", "0123456789ABCDEF.png",
                           "0123456789abcdef.jpg", "f0001.png", ".png", ""})
    EXPECT_FALSE(is_stored_file(name)) << name;
}

}  // namespace
}  // namespace mien
