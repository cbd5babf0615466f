// Reading templates/head/muscles.yaml and candide.yaml.
#include <fmt/format.h>

#include <algorithm>

#include "config/data_table.hpp"
#include "config/doctrine_data.hpp"

namespace mien {

namespace {

// The channels of a muscle or unit: two of a pair, the left one first; none with a mistake told.
std::vector<std::size_t> find_channels(std::string_view doctrine, const YamlEntry& entry) {
  Names names;
  std::vector<std::size_t> channels;
  for (std::size_t i = kMoveCount; i < kChannelCount; ++i) {
    if (kChannels[i].area != doctrine) continue;
    if (kChannels[i].side != Side::right) names.emplace_back(kChannels[i].move);
    if (kChannels[i].move == entry.key) channels.push_back(i);
  }
  check_name(entry, doctrine == kMusclesKey ? "muscle" : "unit", names);
  return channels;
}

// The mapping `key`: each entry with its left channel.
template <typename Read>
void read_channels(const DataTable& root, const char* key, std::string_view doctrine, const Read& read) {
  for (const YamlEntry& entry : root.list(key)) {
    const std::vector<std::size_t> channels = find_channels(doctrine, entry);
    if (!channels.empty()) read(channels.front(), DataTable(entry.value));
  }
}

void read_point(const DataTable& table, const char* key, const PointNames& points, std::string& into) {
  if (table.read(key, into)) check_point(*table.find(key), into, points);
}

LinearMuscle read_linear(std::size_t channel, const DataTable& table, const PointNames& points) {
  LinearMuscle muscle;
  muscle.channel = channel;
  read_point(table, "from", points, muscle.from);
  read_point(table, "to", points, muscle.to);
  table.read_if("off", muscle.off_mm);
  table.read("angle", muscle.half_deg);
  table.read("start", muscle.start);
  table.read("end", muscle.end);
  table.read("mm", muscle.most_mm);
  if (muscle.start <= 0 || muscle.end <= muscle.start)
    table.fail("'start' and 'end' do not rise from 0; expected shares of the length such as 0.85 and 1.5");
  if (std::string lips; table.find("lips") != nullptr &&
                        load_name(*table.find("lips"), "lip", {"both", "upper", "lower"}, lips))
    muscle.lips = lips == "upper" ? LipsOf::upper : lips == "lower" ? LipsOf::lower : LipsOf::both;
  return muscle;
}

RingMuscle read_ring(std::size_t channel, const DataTable& table, const PointNames& points) {
  RingMuscle muscle;
  muscle.channel = channel;
  if (table.read("around", muscle.around) && muscle.around.empty())
    table.fail("'around' has no point; expected one at least");
  if (table.find("around") != nullptr)
    for (const std::string& point : muscle.around)
      if (point != "eye") check_point(*table.find("around"), point, points);
  table.read("half", muscle.half_mm);
  table.read("deep", muscle.deep_mm);
  table.read("pull", muscle.pull);
  table.read("forward", muscle.forward_mm);
  return muscle;
}

PointUnit read_unit(std::size_t channel, const DataTable& table, const PointNames& points) {
  PointUnit unit;
  unit.channel = channel;
  table.read("unit", unit.units);
  unit.points = load_handles(table.list("points"), points);
  table.read("still", unit.still);
  return unit;
}

// {lid.upper: 1}: of the channel's own side, where the move has sides; of a channel without sides both.
void read_moves(const DataTable& root, const char* key, std::string_view doctrine,
                std::vector<ChannelToMove>& into) {
  for (const YamlEntry& entry : root.list(key))
    for (const std::size_t channel : find_channels(doctrine, entry))
      for (const YamlEntry& moved : load_free_mapping(entry.value, "moves such as {lid.upper: 1}")) {
        double value = 0;
        if (!check_move(moved) || !load_datum(moved.value, value)) continue;
        for (std::size_t move = 0; move < kMoveCount; ++move) {
          const Side side = kChannels[channel].side;
          const bool is_own =
              kMoves[move].side == Side::none || side == Side::none || kMoves[move].side == side;
          // Both of a pair say it of a move without sides: half each.
          const double share = side != Side::none && kMoves[move].side == Side::none ? 0.5 : 1;
          if (is_own && moved.key == fmt::format("{}.{}", kMoves[move].area, kMoves[move].move))
            into.push_back({channel, move, share * value});
        }
      }
}

Pose add_moves(const std::vector<ChannelToMove>& moves, const Pose& pose) {
  Pose sum = pose;
  std::array<double, kMoveCount> added{};
  for (const auto& [channel, move, value] : moves) added[move] += value * pose.values[channel];
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    if (added[i] == 0) continue;
    // What is past its limit already stays there; muscles and units take nothing past it.
    const double low = std::min(kMoves[i].low, pose.values[i]),
                 high = std::max(kMoves[i].high, pose.values[i]);
    sum.values[i] = std::clamp(pose.values[i] + added[i], low, high);
  }
  return sum;
}

}  // namespace

DoctrineData load_doctrine_data(const std::filesystem::path& folder, const PointNames& points,
                                Findings& findings) {
  DoctrineData data;
  if (const auto document = load_document(folder / "muscles.yaml", findings)) {
    const DataTable root(find_root(*document, findings));
    read_channels(root, "linear", kMusclesKey, [&](std::size_t channel, const DataTable& table) {
      data.linear.push_back(read_linear(channel, table, points));
    });
    read_channels(root, "rings", kMusclesKey, [&](std::size_t channel, const DataTable& table) {
      data.rings.push_back(read_ring(channel, table, points));
    });
    read_moves(root, "moves", kMusclesKey, data.moves);
    read_moves(root, "folds", kMusclesKey, data.folds);
    for (const YamlEntry& entry : root.list("rows"))
      if (check_point(entry.value, entry.key + "_0", points)) load_datum(entry.value, data.rows[entry.key]);
    root.read("zero", data.zero);
  }
  if (const auto document = load_document(folder / "candide.yaml", findings)) {
    const DataTable root(find_root(*document, findings));
    read_channels(root, "units", kCandideKey, [&](std::size_t channel, const DataTable& table) {
      data.units.push_back(read_unit(channel, table, points));
    });
    read_moves(root, "moves", kCandideKey, data.moves);
    read_moves(root, "folds", kCandideKey, data.folds);
  }
  return data;
}

Pose resolve_channels(const DoctrineData& data, const Pose& pose) {
  return has_doctrine(pose) ? add_moves(data.moves, pose) : pose;
}

Pose resolve_folds(const DoctrineData& data, const Pose& resolved) {
  return has_doctrine(resolved) ? add_moves(data.folds, resolved) : resolved;
}

}  // namespace mien
