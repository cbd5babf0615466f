// Intensities as fifths: E is the unit's most (FACS's A to E are trace, slight, marked, severe and maximum).
#include "config/facs_notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "config/expressions.hpp"
#include "config/mapping_data.hpp"

namespace mien {

namespace {

constexpr std::size_t kMostUnits = 24;  // a face shows no more at once

struct NotedUnit {
  Side side = Side::none;  // both
  int number = 0;
  double weight = 1;
};

// The unit that `word` is as a whole; `is_marked` if more than its number is there.
std::optional<NotedUnit> parse_unit(std::string_view word, bool& is_marked) {
  NotedUnit unit;
  if (word.starts_with('L') || word.starts_with('R')) {
    unit.side = word.front() == 'L' ? Side::left : Side::right;
    word.remove_prefix(1);
    is_marked = true;
  }
  if (word.starts_with("AU")) {
    word.remove_prefix(2);
    is_marked = true;
  }
  if (!word.empty() && word.back() >= 'A' && word.back() <= 'E') {
    unit.weight = (word.back() - 'A' + 1) / 5.0;
    word.remove_suffix(1);
    is_marked = true;
  }
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), unit.number);
  constexpr std::size_t kDigits = 2;
  if (error != std::errc() || end != word.data() + word.size() || word.size() > kDigits || word[0] == '-')
    return std::nullopt;
  return unit;
}

// Empty if it is no notation.
std::vector<NotedUnit> parse_notation(std::string_view word) {
  std::vector<NotedUnit> units;
  bool is_marked = word.find('+') != word.npos;
  for (std::size_t begin = 0; begin <= word.size();) {
    const std::size_t end = std::min(word.find('+', begin), word.size());
    const auto unit = parse_unit(word.substr(begin, end - begin), is_marked);
    if (!unit || units.size() >= kMostUnits) return {};
    units.push_back(*unit);
    begin = end + 1;
  }
  return is_marked ? units : std::vector<NotedUnit>{};
}

// For each side the weight of each unit.
struct NotedWeights {
  std::vector<double> left, right;
};

std::string name_unit(int number) { return fmt::format("AU{}", number); }

std::optional<NotedWeights> weigh_units(const Mapping& facs, const std::vector<NotedUnit>& units,
                                        std::string& fault) {
  NotedWeights weights{std::vector<double>(facs.units.size()), std::vector<double>(facs.units.size())};
  for (const NotedUnit& noted : units) {
    const std::string name = name_unit(noted.number);
    const auto unit = find_unit(facs, name);
    if (!unit) {
      Names names;
      for (const MappedUnit& known : facs.units) names.push_back(known.name);
      fault = fmt::format("unknown action unit '{}'; known: {}", name, join_names(names));
      return std::nullopt;
    }
    for (const auto& [side, of_side] :
         {std::pair{Side::left, &weights.left}, {Side::right, &weights.right}}) {
      if (noted.side != Side::none && noted.side != side) continue;
      if ((*of_side)[*unit] > 0) {
        fault = fmt::format("action unit '{}' is there twice; expected it once", name);
        return std::nullopt;
      }
      (*of_side)[*unit] = noted.weight;
    }
  }
  return weights;
}

bool has_same_units(const NotedWeights& a, const NotedWeights& b) {
  const auto is_same = [](const std::vector<double>& x, const std::vector<double>& y) {
    return std::ranges::equal(x, y, [](double p, double q) { return (p > 0) == (q > 0); });
  };
  return is_same(a.left, b.left) && is_same(a.right, b.right);
}

// How much of a known emotion the notation has, which is taken off its units.
double take_share(NotedWeights& weights, const NotedWeights& known) {
  double share = std::numeric_limits<double>::infinity();
  for (const auto& [mine, its] : {std::pair{&weights.left, &known.left}, {&weights.right, &known.right}})
    for (std::size_t i = 0; i < mine->size(); ++i)
      if ((*its)[i] > 0) share = std::min(share, (*mine)[i] / (*its)[i]);
  share = std::min(share, 1.0);
  for (const auto& [mine, its] : {std::pair{&weights.left, &known.left}, {&weights.right, &known.right}})
    for (std::size_t i = 0; i < mine->size(); ++i) (*mine)[i] = std::max(0.0, (*mine)[i] - share * (*its)[i]);
  return share;
}

// Of a side's units what lies on that side, and half of what has no sides.
void add_side(const Mapping& facs, std::vector<double> weights, Side side,
              std::array<double, kMoveCount>& into) {
  std::array<double, kMoveCount> moves{};
  add_mapped_moves(facs, weights, moves);
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (kMoves[i].side == side)
      into[i] += moves[i];
    else if (kMoves[i].side == Side::none)
      into[i] += moves[i] / 2;
}

}  // namespace

bool is_facs_notation(std::string_view word) { return !parse_notation(word).empty(); }

std::string build_facs_pattern() {
  const std::string unit = "[LR]?(AU)?[0-9]{1,2}[A-E]?";
  return fmt::format("^{0}(\\+{0})*$", unit);
}

std::optional<Pose> find_notation_pose(const MappingData& data, std::string_view word, std::string& fault) {
  const auto facs = data.mappings.find("facs");
  const std::vector<NotedUnit> units = parse_notation(word);
  if (facs == data.mappings.end() || units.empty()) return std::nullopt;
  auto weights = weigh_units(facs->second, units, fault);
  if (!weights) return std::nullopt;
  std::array<double, kMoveCount> moves{};
  for (const KnownNotation& known : data.known) {
    std::string ignored;
    const auto its = weigh_units(facs->second, parse_notation(known.notation), ignored);
    if (!its || !has_same_units(*weights, *its)) continue;
    const double share = take_share(*weights, *its);
    for (std::size_t i = 0; i < kMoveCount; ++i) moves[i] += share * known.pose.values[i];
    break;
  }
  add_side(facs->second, weights->left, Side::left, moves);
  add_side(facs->second, weights->right, Side::right, moves);
  Pose pose;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    pose.values[i] = std::clamp(moves[i], kMoves[i].low, kMoves[i].high);
  return pose;
}

void append_notations(const YamlDocument& document, ExpressionBook& book) {
  if (book.mappings == nullptr) return;
  for (const YamlNode& node : document.nodes) {
    if (node.kind != NodeKind::text || node.text.size() > kMaxExpressionName ||
        !is_facs_notation(node.text) || book.index.contains("facs/" + node.text))
      continue;
    std::string fault;
    if (const auto pose = find_notation_pose(*book.mappings, node.text, fault))
      append_expressions(book, {{node.text, "facs", *pose}});
  }
}

}  // namespace mien
