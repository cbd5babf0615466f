#include "timeline/head_track.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "timeline/bytes.hpp"
#include "timeline/key_span.hpp"

namespace mien {

namespace {

using Values = std::map<std::string, double>;

// What one of the two does not name counts as 0 there.
Values mix_values(const Values& from, const Values& to, double share) {
  Values mixed;
  const auto find = [](const Values& values, const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() ? 0.0 : found->second;
  };
  for (const Values* values : {&from, &to})
    for (const auto& [name, value] : *values)
      mixed[name] = std::lerp(find(from, name), find(to, name), share);
  return mixed;
}

double compute_guide_share(const HeadSpec& head, const std::string& line) {
  if (!head.guides.contains(line)) return 0;
  const auto share = head.guide_shares.find(line);
  return share == head.guide_shares.end() ? 1 : share->second;
}

// A line that only one of the two moves has its place, and goes the other's way to it.
void mix_guides(const HeadSpec& from, const HeadSpec& to, double share, HeadSpec& mixed) {
  mixed.guide_shares.clear();
  for (const HeadSpec* head : {&from, &to})
    for (const auto& [line, height] : head->guides) {
      const HeadSpec& other = head == &from ? to : from;
      const bool is_both = other.guides.contains(line);
      mixed.guides[line] = is_both ? std::lerp(from.guides.at(line), to.guides.at(line), share) : height;
      mixed.guide_shares[line] =
          std::lerp(compute_guide_share(from, line), compute_guide_share(to, line), share);
    }
}

glm::vec3 mix_colours(const glm::vec3& from, const glm::vec3& to, double share) {
  return glm::mix(from, to, static_cast<float>(share));
}

Look mix_looks(const Look& from, const Look& to, double share) {
  Look mixed = from;
  mixed.skin = mix_colours(from.skin, to.skin, share);
  mixed.iris = mix_colours(from.iris, to.iris, share);
  mixed.brow = mix_colours(from.brow, to.brow, share);
  mixed.hair = mix_colours(from.hair, to.hair, share);
  mixed.brow_old = mix_colours(from.brow_old.value_or(from.brow), to.brow_old.value_or(to.brow), share);
  mixed.hair_old = mix_colours(from.hair_old.value_or(from.hair), to.hair_old.value_or(to.hair), share);
  mixed.freckles = std::lerp(from.freckles, to.freckles, share);
  mixed.age_spots = std::lerp(from.age_spots, to.age_spots, share);
  mixed.age_spots_old =
      std::lerp(from.age_spots_old.value_or(from.age_spots), to.age_spots_old.value_or(to.age_spots), share);
  mixed.beard = share < 0.5 ? from.beard : to.beard;
  if (!from.lips && !to.lips) return mixed;
  mixed.lips = mix_colours(from.lips ? *from.lips : *to.lips, to.lips ? *to.lips : *from.lips, share);
  mixed.lips_share = std::lerp(from.lips ? from.lips_share : 0, to.lips ? to.lips_share : 0, share);
  return mixed;
}

std::string get_path(const std::optional<FileReference>& file) { return file ? file->path.string() : ""; }

// Whether one becomes the other by growing alone.
bool has_same_start(const HeadSpec& one, const HeadSpec& other) {
  return get_path(one.mesh) == get_path(other.mesh) && get_path(one.scan) == get_path(other.scan) &&
         std::ranges::equal(one.sculpt, other.sculpt) &&
         std::ranges::equal(one.mix, other.mix, [](const HeadShare& a, const HeadShare& b) {
           return a.weight == b.weight && compute_head_key(a.head) == compute_head_key(b.head);
         });
}

// Two persons on the way from one to the other: their forms are mixed as those of `mix` are, and their looks.
HeadSpec mix_starts(const HeadSpec& from, const HeadSpec& to, double share) {
  HeadSpec mixed;
  mixed.hair = from.hair;
  mixed.limits = from.limits;
  mixed.limit_lengths = from.limit_lengths;
  mixed.match_level = from.match_level;
  mixed.follows_thesis = from.follows_thesis;
  mixed.said = from.said;
  mixed.look = mix_looks(compute_aged_look(from.look, from.age), compute_aged_look(to.look, to.age), share);
  mixed.look.brow_old = mixed.look.hair_old = std::nullopt;
  mixed.look.age_spots_old = std::nullopt;
  if (share >= 0.5) mixed.look.texture = to.look.texture;
  mixed.mix = {{from, 1 - share}, {to, share}};
  return mixed;
}

void append_file(std::string& bytes, const std::optional<FileReference>& file) {
  bytes += get_path(file) + ';';
}

void append_values(std::string& bytes, const Values& values) {
  for (const auto& [name, value] : values) {
    bytes += name;
    bytes += '=';
    append_bytes(bytes, value);
  }
  bytes += ';';
}

}  // namespace

HeadSpec mix_heads(const HeadSpec& from, const HeadSpec& to, double share) {
  if (share == 0) return from;
  if (share == 1) return to;
  if (!has_same_start(from, to)) return mix_starts(from, to, share);
  HeadSpec mixed = from;
  mixed.age = mix_values(from.age, to.age, share);
  mixed.skull = mix_values(from.skull, to.skull, share);
  mixed.design = mix_values(from.design, to.design, share);
  mixed.character = std::lerp(from.character, to.character, share);
  mixed.features = mix_values(from.features, to.features, share);
  mix_guides(from, to, share, mixed);
  mixed.look = mix_looks(from.look, to.look, share);
  return mixed;
}

HeadSpec sample_head(const std::vector<HeadKey>& keys, double time_s) {
  const KeySpan<HeadKey> span = find_span(keys, time_s);
  return mix_heads(span.from->head, span.to->head, span.share);
}

std::string compute_head_key(const HeadSpec& head) {
  std::string bytes;
  for (const Values* values :
       {&head.age, &head.skull, &head.design, &head.guides, &head.guide_shares, &head.features})
    append_values(bytes, *values);
  append_bytes(bytes, head.character);
  const Look& look = head.look;
  for (const glm::vec3& colour : {look.skin, look.iris, look.brow, look.hair,
                                  look.brow_old.value_or(look.brow), look.hair_old.value_or(look.hair)})
    append_bytes(bytes, colour);
  bytes += look.beard + ';';
  if (look.texture) bytes += look.texture->path.string() + ';';
  append_bytes(bytes, look.lips ? 1.0 : 0.0);
  append_bytes(bytes, look.lips.value_or(glm::vec3(0)));
  for (const double value :
       {look.lips_share, look.freckles, look.age_spots, look.age_spots_old.value_or(look.age_spots)})
    append_bytes(bytes, value);
  append_file(bytes, head.mesh);
  append_file(bytes, head.scan);
  for (const SculptStroke& stroke : head.sculpt) {
    bytes += stroke.at + stroke.about;
    append_bytes(bytes, stroke.move_mm);
    for (const double value : {stroke.radius_mm, stroke.scale, stroke.turn_deg}) append_bytes(bytes, value);
  }
  for (const HeadShare& share : head.mix) {
    append_bytes(bytes, share.weight);
    bytes += compute_head_key(share.head);
  }
  return hash_hex(bytes);
}

}  // namespace mien
