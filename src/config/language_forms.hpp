// Short ways to write the rows of language.hpp: a form each, named by what stands there.
#pragma once

#include <utility>

#include "config/clip_spec.hpp"
#include "config/language.hpp"

namespace mien {

Form as_word(std::string noun, std::span<const Word> words);
Form as_data_word(std::string noun, std::string data);  // of the data's list `data`
Form as_yes_no();
Form as_number(double low, double high, std::string unit = {});
Form as_whole(int low, int high, std::string unit = {});
Form as_formula();
Form as_duration(double low_s = 0, double high_s = std::numeric_limits<double>::infinity());
Form as_seconds(double low_s, double high_s);
Form as_length(double low_mm, double high_mm);
Form as_angle(const Bounds& bounds_deg);
Form as_lengths(double most_mm);  // each way
Form as_two_lengths(double low_mm, double high_mm);
Form as_size(int low_px, int high_px);
Form as_colour();
Form as_line(std::size_t most_bytes);
Form as_tag(std::string pattern, std::string data = {});
Form as_file(Names endings);
Form as_curve(double low, double high);
Form as_list(Forms items, double low = 0, double high = std::numeric_limits<double>::infinity());
Form as_section(const Section& section);
Form as_map(std::string pattern, Forms items, double low = 0);

// A moment, or what counts from another key.
Forms as_waiting_time(const Section& wait);

// One of the words, or weights of several of them.
Forms as_mix(const std::string& noun, std::span<const Word> words);

// "^[A-Za-z]{1,40}$" and the like, of a name of the author's own.
std::string build_key_name_pattern();
std::string build_actor_name_pattern();
std::string build_expression_name_pattern();
std::string build_asked_expression_pattern();  // a name, or a notation of action units
std::string build_file_pattern(const Names& endings);

// Defaults as an author would write them.
std::string say(double value, std::string_view unit = "");
std::string say_colour(const glm::vec3& srgb);

// A meaning as a sentence: "The jaw turned open."
std::string begin_great(std::string_view text);

// Rows that mappings have in common.
Key build_name_key();
Key build_strength_key(std::string help, bool is_live);
Key build_exaggerate_key(std::string help);
Key build_seed_key();
Key build_express_key(bool is_live);
std::vector<Key> copy_keys(const Section& from, const Names& names);

// The first form of a key that the section has.
Form& find_first_form(Section& section, std::string_view name);

// The parts of Sections::Sections().
void fill_head_sections(Sections& all);
void fill_face_sections(Sections& all);
void fill_clip_sections(Sections& all);
void fill_layer_sections(Sections& all);
void fill_idle_sections(Sections& all);
void fill_file_sections(Sections& all);

}  // namespace mien
