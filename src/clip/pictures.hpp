// From a clip's scenes to its pictures, its video and what is said of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clip/clip.hpp"
#include "clip/scenes.hpp"
#include "render/driver.hpp"
#include "render/video_kind.hpp"
#include "sketch/lettering.hpp"

namespace mien {

// How POV-Ray is to render pictures of this size and quality; `libraries` are where it finds what scenes
// include.
RenderSettings list_settings(const RenderSpec& render, std::vector<std::filesystem::path> libraries,
                             int jobs);

// Gives every frame that repeats a drawing the picture of that drawing.
void repeat_pictures(const Clip& clip);

// The frame that draws what the poster shows, of the frames asked for the nearest to it.
int find_poster_drawing(const Clip& clip);

// What was made, for other programs: the text of manifest.json, with the key of each drawing's picture.
std::string build_manifest(const Clip& clip, const std::vector<std::string>& keys);

// The files that end a clip: those that -o names, else NAME.mp4, of all frames, or NAME_A-B.mp4 of those
// asked for; of sketches NAME_sketch.mp4. What shows the frames otherwise says so: NAME_boomerang_slate.mp4.
std::vector<std::filesystem::path> list_video_paths(const Clip& clip);

// NAME_preview.mp4: what there is of a clip while it is rendered.
std::filesystem::path find_preview_path(const Clip& clip);

// The whole clip, of which `is_there` says what drawings have their pictures: one at least. Each is held
// until the next that is there.
void write_preview(const Clip& clip, const std::vector<bool>& is_there);

// Which of the plan's frames (from 0) a clip of that name shows, one after the other: all; forth and back;
// and in a film, which cannot say how often it is to be seen, so many rounds of them.
std::vector<std::size_t> list_shown_frames(const Clip& clip, const std::filesystem::path& video);

// The sound of the frames so shown: each round anew, forth only.
std::optional<Sound> find_shown_sound(const Clip& clip, const std::filesystem::path& video);

// Joins the frames asked for into each of list_video_paths, and copies the one nearest to the poster's.
void write_clip_videos(const Clip& clip, const Letters& letters);
void write_poster(const Clip& clip, const std::filesystem::path& path);

}  // namespace mien
