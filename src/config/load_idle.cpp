#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <tuple>

#include "config/constants.hpp"
#include "config/load_clip.hpp"

namespace mien {

namespace {

// `look:` in one word. The angles are those of a plain look away: less reads as a slip, more as a stare.
struct LookWord {
  std::string_view word;
  LookAt look;
  double side_deg, up_deg;
};
constexpr std::array kLookWords{
    LookWord{"ahead", LookAt::ahead, 0, 0},     LookWord{"camera", LookAt::camera, 0, 0},
    LookWord{"left", LookAt::direction, 20, 0}, LookWord{"right", LookAt::direction, -20, 0},
    LookWord{"up", LookAt::direction, 0, 12},   LookWord{"down", LookAt::direction, 0, -16},
};

bool is_text(const YamlValue& value) { return find_node(value).kind == NodeKind::text; }

void load_seed(const YamlMapping& entries, std::uint64_t& into) {
  int seed = 0;
  if (const YamlValue* number = find_value(entries, "seed"); number != nullptr && load_whole(*number, seed))
    into = static_cast<std::uint64_t>(seed);
}

void load_share(const YamlMapping& entries, std::string_view key, double& into) {
  if (const YamlValue* number = find_value(entries, key)) load_number(*number, into);
}

void load_blink_style(const YamlValue& value, BlinkSpec& blink) {
  std::string name;
  if (load_name(value, name)) blink = name == "natural" ? kNaturalBlink : BlinkSpec{};
}

void load_blink(const YamlValue& value, BlinkSpec& blink) {
  if (is_text(value)) return load_blink_style(value, blink);
  const YamlMapping entries = load_section(value);
  if (const YamlValue* style = find_value(entries, "style")) load_blink_style(*style, blink);
  if (const YamlValue* rate = find_value(entries, "per_minute")) load_number(*rate, blink.per_minute);
  load_seed(entries, blink.seed);
  load_share(entries, "doubles", blink.doubles);
  load_share(entries, "partial", blink.partial);
  load_share(entries, "shifts", blink.shifts);
}

void load_direction(const YamlValue& value, GazeKey& key) {
  const YamlMapping entries = load_section(value);
  key.look = LookAt::direction;
  if (const YamlValue* side = find_value(entries, "side")) load_angle(*side, key.side_deg);
  if (const YamlValue* up = find_value(entries, "up")) load_angle(*up, key.up_deg);
}

void load_point(const YamlValue& value, GazeKey& key) {
  constexpr const char* kExpected =
      "a point of three lengths such as [200mm, 50mm, 600mm]: left, up, forward";
  const std::vector<YamlValue> items = load_list(value, kExpected);
  if (items.size() != 3) return add_unexpected(value, kExpected);
  key.look = LookAt::point;
  const Form& form = find_form(value, FormKind::lengths);
  for (int i = 0; i < 3; ++i)
    load_quantity(items[static_cast<std::size_t>(i)], build_length_measure(), form.low, form.high,
                  key.point_mm[i]);
}

void load_look(const YamlValue& value, const ClipClock& clock, GazeKey& key) {
  if (find_node(value).kind == NodeKind::list) return load_point(value, key);
  if (!is_text(value)) return load_direction(value, key);
  std::string name;
  Names looks = kLooks;
  looks.insert(looks.end(), clock.others.begin(), clock.others.end());
  if (!load_name(value, "look", looks, name)) return;
  if (std::ranges::find(kLooks, name) == kLooks.end()) {
    key.look = LookAt::point;  // known when everybody has a place
    key.actor = name;
    return;
  }
  const LookWord& word = *std::ranges::find(kLookWords, name, &LookWord::word);
  std::tie(key.look, key.side_deg, key.up_deg) = std::tie(word.look, word.side_deg, word.up_deg);
}

std::vector<GazeKey> load_gaze_keys(const YamlValue& value, const ClipClock& clock) {
  std::vector<GazeKey> keys;
  std::optional<double> before_s;
  for (const YamlValue& item : load_list(value, "a list of keys such as [{at: 1s, look: left}]")) {
    const YamlMapping entries = load_section(item);
    GazeKey key;
    key.place = find_place(item.document->source, item.spot);
    load_key_time(entries, item, clock, before_s, key.at_s);
    if (const YamlValue* look =
            find_required(entries, "look", item, "ahead, camera, left, right, up, down, angles or a point"))
      load_look(*look, clock, key);
    keys.push_back(key);
  }
  return keys;
}

void load_gaze(const YamlValue& value, const ClipClock& clock, GazeSpec& gaze) {
  if (is_text(value)) {
    std::string name;
    if (!load_name(value, name)) return;
    if (name == "wander") gaze.wander = 1;
    if (name == "camera")
      gaze.keys = {{.look = LookAt::camera, .place = find_place(value.document->source, value.spot)}};
    return;
  }
  if (find_node(value).kind == NodeKind::list) {
    gaze.keys = load_gaze_keys(value, clock);
    return;
  }
  const YamlMapping entries = load_section(value);
  const YamlValue *keys = find_value(entries, "keys"), *look = find_value(entries, "look");
  if (keys != nullptr) gaze.keys = load_gaze_keys(*keys, clock);
  if (look != nullptr && keys == nullptr) {
    load_look(*look, clock, gaze.keys.emplace_back());
    gaze.keys.back().place = find_place(look->document->source, look->spot);
  }
  if (look != nullptr && keys != nullptr)
    add_mistake(*look, "'clip.gaze' has 'keys' and 'look'; expected one of them");
  load_share(entries, "wander", gaze.wander);
  load_seed(entries, gaze.seed);
}

// `drift` and `asymmetry`: a number, or a mapping of it and a seed.
template <typename Dial>
void load_dial(const YamlValue& value, Dial& dial) {
  if (is_text(value)) {
    load_number(value, dial.amount);
    return;
  }
  const YamlMapping entries = load_section(value);
  const YamlValue *amount = find_value(entries, "amount"), *stillness = find_value(entries, "stillness");
  if (amount != nullptr) load_number(*amount, dial.amount);
  if (double still = 0; stillness != nullptr && load_number(*stillness, still)) dial.amount = 1 - still;
  if (amount != nullptr && stillness != nullptr)
    add_mistake(*stillness,
                fmt::format("{} stands beside 'amount', which is its opposite; expected one of them",
                            describe_subject(*stillness)));
  load_seed(entries, dial.seed);
  if constexpr (requires { dial.breaths_per_minute; })
    if (const YamlValue* breath = find_value(entries, "breath"))
      load_number(*breath, dial.breaths_per_minute);
}

// A word, a number, or a mapping; a seed alone asks for the natural amount.
void load_asymmetry(const YamlValue& value, AsymmetrySpec& asymmetry) {
  if (is_word(value)) {
    const std::string& name = find_node(value).text;
    if (std::ranges::find(kAsymmetryWords, name, &Word::name) == kAsymmetryWords.end())
      return add_unexpected(value, fmt::format("natural, none or a number from 0 to {}",
                                               find_form(value, FormKind::number).high));
    asymmetry.amount = name == "natural" ? kNaturalAsymmetry : 0;
    return;
  }
  asymmetry.amount = kNaturalAsymmetry;
  load_dial(value, asymmetry);
}

}  // namespace

void load_idle(const YamlMapping& entries, const ClipClock& clock, ClipSpec& clip) {
  if (const YamlValue* blink = find_value(entries, "blink")) load_blink(*blink, clip.blink);
  if (const YamlValue* blinks = find_value(entries, "blinks"))
    for (const YamlValue& item : load_list(*blinks, "a list of times such as [1s, 2.5s]"))
      if (double at_s = 0; load_time(item, clock, at_s)) clip.blinks_s.push_back(at_s);
  std::ranges::sort(clip.blinks_s);
  if (const YamlValue* gaze = find_value(entries, "gaze")) load_gaze(*gaze, clock, clip.gaze);
  if (const YamlValue* drift = find_value(entries, "drift")) load_dial(*drift, clip.drift);
  if (const YamlValue* asymmetry = find_value(entries, "asymmetry"))
    load_asymmetry(*asymmetry, clip.asymmetry);
}

}  // namespace mien
