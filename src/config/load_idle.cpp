#include <algorithm>

#include "config/load_clip.hpp"

namespace mien {

namespace {

constexpr double kMaxPerMinute = 60;  // blinks; people come to 15 or 20
constexpr int kMaxSeed = 1'000'000'000;

void load_blink(const YamlValue& value, BlinkSpec& blink) {
  const YamlMapping entries = load_mapping(value, kBlinkKeys, "a mapping such as {per_minute: 15, seed: 7}");
  if (const YamlValue* rate = find_value(entries, "per_minute"))
    load_number(*rate, 0, kMaxPerMinute, blink.per_minute, "blinks a minute");
  int seed = 0;
  if (const YamlValue* number = find_value(entries, "seed");
      number != nullptr && load_whole(*number, 0, kMaxSeed, seed))
    blink.seed = static_cast<std::uint64_t>(seed);
}

}  // namespace

void load_idle(const YamlMapping& entries, const ClipClock& clock, ClipSpec& clip) {
  if (const YamlValue* blink = find_value(entries, "blink")) load_blink(*blink, clip.blink);
  if (const YamlValue* blinks = find_value(entries, "blinks"))
    for (const YamlValue& item : load_list(*blinks, "a list of times such as [1s, 2.5s]"))
      if (double at_s = 0; load_time(item, clock, at_s)) clip.blinks_s.push_back(at_s);
  std::ranges::sort(clip.blinks_s);
}

}  // namespace mien
