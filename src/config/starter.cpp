#include "config/starter.hpp"

#include <fmt/format.h>

#include <cmath>

#include "config/findings.hpp"
#include "config/head_parts.hpp"
#include "config/load_spec.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

std::string format_colour(const glm::vec3& colour) {
  const auto byte = [&](int i) { return std::lround(colour[i] * 255.0f); };
  return fmt::format("\"#{:02x}{:02x}{:02x}\"", byte(0), byte(1), byte(2));
}

std::string format_mix(const Mix& mix) {
  std::string text;
  for (const auto& [name, weight] : mix)
    text += fmt::format("{}{}: {:.2f}", text.empty() ? "" : ", ", name, weight);
  return mix.size() == 1 ? mix.begin()->first : "{" + text + "}";
}

std::string format_look(const Look& given, const Mix& age) {
  const Look look = compute_aged_look(given, age);
  std::string text = "skin: " + format_colour(look.skin);
  if (look.lips) text += ", lips: " + format_colour(*look.lips);
  text += fmt::format(", iris: {}, brow: {}, hair: {}", format_colour(look.iris), format_colour(look.brow),
                      format_colour(look.hair));
  if (look.beard != "none") text += ", beard: " + look.beard;
  if (look.freckles > 0) text += fmt::format(", freckles: {:.2f}", look.freckles);
  return "{" + text + "}";
}

// A line of a mapping, and its comment behind all other comments.
std::string build_line(int indent, const std::string& words, const std::string& comment) {
  constexpr int kColumn = 29;  // the longest feature's name has its value before it
  return fmt::format("{:{}}{:<{}} # {}\n", "", indent, words, kColumn - indent, comment);
}

// `head:` in the words of the language, which the reader makes into the same head.
std::string build_head_text(const HeadSpec& head, const std::vector<FeatureInfo>& features) {
  std::string text =
      build_line(0, "head:", fmt::format("the same as {{random: {}}}; go on from it", *head.random));
  text += build_line(2, "age: " + head.age.begin()->first, join_names(kAges) + ", or a mix of them");
  text += build_line(2, "skull: " + format_mix(head.skull), join_names(kSkulls) + ", or a mix");
  text += build_line(2, fmt::format("character: {:.2f}", head.character), "from -1 (female) to 1 (male)");
  text += build_line(2, "features:", "each from -1 to 1; behind it what 1 does, and -1 backwards");
  for (const FeatureInfo& feature : features)
    if (const auto value = head.features.find(feature.name); value != head.features.end())
      text += build_line(4, fmt::format("{}: {:.2f}", feature.name, value->second), feature.meaning);
  text += build_line(2, "hair: " + head.hair, join_names(kHairs));
  return text + fmt::format("  look: {}\n", format_look(head.look, head.age));
}

HeadSpec draw_head(int seed, const People& people) {
  HeadSpec head;
  head.random = seed;
  draw_person(people, static_cast<std::uint64_t>(seed), head);
  return head;
}

// The template's own head, from `head:` to the next empty line, gives way.
std::string replace_head(std::string text, const std::string& head, const std::string& origin) {
  const std::size_t begin = text.find("\nhead:"), end = text.find("\n\n", begin + 1);
  if (begin == text.npos || end == text.npos)
    throw RunError(fmt::format("{} has no 'head:' with an empty line behind it", origin));
  return text.replace(begin + 1, end - begin, head);
}

}  // namespace

std::string load_starter(const std::filesystem::path& data_folder, const std::string& name,
                         std::optional<int> random_head) {
  const std::filesystem::path file = data_folder / "templates/new.yaml";
  std::string text = fill_template(read_file(file), {{"name", name}}, file.string());
  if (!random_head) return text;
  const HeadSpec head = draw_head(*random_head, load_language(data_folder)->words.people);
  return replace_head(std::move(text), build_head_text(head, load_shapes_alone(data_folder).features),
                      file.string());
}

}  // namespace mien
