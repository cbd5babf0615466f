#include "config/ledger.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <tuple>

#include "config/spec.hpp"

namespace mien {

namespace {

auto key_of(const Held& held) {
  return std::tie(held.place.file, held.place.line, held.place.column, held.move, held.asked, held.held,
                  held.by);
}

std::string describe(const Held& held, const std::string& name) {
  const double sign = held.asked < 0 ? -1 : 1;
  const std::string_view stop = find_stop(held.move, sign);
  const std::string start = fmt::format("{} asked for {:.4g}{}", name, held.asked,
                                        held.by.empty() ? "" : fmt::format(" ({})", held.by));
  if (!stop.empty()) return fmt::format("{}; held at {:.4g}: {}", start, held.held, stop);
  return fmt::format("{}; held at its limit, {:.4g}", start, held.held);
}

// Of a clip's keys and cues, and of the scripts that it plays.
void append_held(const ClipSpec& clip, std::vector<Held>& ledger) {
  const auto append = [&](const PoseKey& key) {
    ledger.insert(ledger.end(), key.held.begin(), key.held.end());
  };
  for (const PoseKey& key : clip.keys) append(key);
  for (const CueSpec& cue : clip.cues) {
    append(cue.what);
    if (cue.script) append_held(*cue.script, ledger);
  }
}

}  // namespace

bool Held::operator==(const Held& other) const { return key_of(*this) == key_of(other); }

std::string_view find_stop(std::size_t move, double sign) {
  return sign > 0 ? kChannels[move].plus.stop : kChannels[move].minus.stop;
}

void sort_ledger(std::vector<Held>& ledger) {
  std::ranges::sort(ledger, [](const Held& a, const Held& b) { return key_of(a) < key_of(b); });
  ledger.erase(std::unique(ledger.begin(), ledger.end()), ledger.end());
}

std::vector<Held> list_held(const Spec& spec) {
  std::vector<Held> ledger;
  const auto append = [&](const std::vector<Held>& held) {
    ledger.insert(ledger.end(), held.begin(), held.end());
  };
  for (const Expression& expression : spec.expressions)
    if (expression.library.empty()) append(expression.held);
  for (const ActorSpec& actor : list_actors(spec)) append_held(actor.clip, ledger);
  for (const BustSpec& bust : spec.busts) append(bust.expression.held);
  sort_ledger(ledger);
  return ledger;
}

std::string name_move(std::size_t move, bool is_both) {
  const MoveInfo& info = kChannels[move];
  if (!is_area_move(move))
    return fmt::format("{}.{}{}", info.area, info.move,
                       is_both || info.side == Side::none ? ""
                       : info.side == Side::left          ? ".left"
                                                          : ".right");
  const bool is_plural = is_both && info.side != Side::none;
  return fmt::format("{}.{}", is_plural ? find_area(info.of).plural : find_area_key(info), info.move);
}

std::string name_way(std::size_t move, double value) {
  const MoveInfo& info = kMoves[move];
  return fmt::format("{}.{}", find_area_key(info), (value > 0 ? info.plus : info.minus).name);
}

std::vector<HeldNote> build_notes(const std::vector<Held>& ledger) {
  std::vector<HeldNote> notes;
  std::vector<bool> is_reported(ledger.size(), false);
  for (std::size_t i = 0; i < ledger.size(); ++i) {
    if (is_reported[i]) continue;
    const MoveInfo& info = kChannels[ledger[i].move];
    bool is_both = false;
    if (info.side == Side::left) {
      Held other = ledger[i];
      other.move = find_twin(ledger[i].move);
      const auto twin = std::ranges::find(ledger, other);
      is_both = twin != ledger.end();
      if (is_both) is_reported[static_cast<std::size_t>(twin - ledger.begin())] = true;
    }
    const std::string name = name_move(ledger[i].move, is_both);
    notes.push_back({ledger[i], name, describe(ledger[i], name)});
  }
  return notes;
}

std::string format_note(const HeldNote& note) {
  const Place& at = note.held.place;
  return fmt::format("{}:{}:{}: note: {}", at.file, at.line, at.column, note.text);
}

}  // namespace mien
