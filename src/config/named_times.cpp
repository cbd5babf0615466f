#include "config/named_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "config/constants.hpp"
#include "config/load_clip.hpp"

namespace mien {

namespace {

constexpr std::size_t kMaxNodes = 2000;  // they are followed one from another; more are no director's note

// One key or cue with a name or with a time that waits for one.
struct Node {
  std::string name;  // "ann.hello"; empty: none
  std::string actor;
  std::optional<YamlValue> at;
  std::optional<double> time_s;
  bool is_open = false;  // being resolved
  bool is_done = false;
};

struct Graph {
  std::vector<Node> nodes;
  std::map<std::string, std::size_t> index;  // by name
  ClipClock clock;
};

std::string build_full_name(const std::string& actor, const std::string& name) {
  return actor.empty() ? name : actor + "." + name;
}

bool is_word(const std::string& name) {
  return !name.empty() && name.size() <= kMaxKeyName && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

void add_node(const YamlValue& item, const std::string& actor, Graph& graph) {
  if (find_node(item).kind != NodeKind::mapping) return;
  const YamlMapping entries = load_free_mapping(item, "");
  Node node;
  node.actor = actor;
  for (const char* key : {"at", "from"})
    if (const YamlValue* at = find_value(entries, key)) node.at = *at;
  if (const YamlValue* name = find_value(entries, "name")) {
    std::string word;
    if (!load_text(*name, "a name such as hello", word)) return;
    if (!is_word(word)) return add_unexpected(*name, "a name of letters, digits, '_' and '-'");
    node.name = build_full_name(actor, word);
  }
  const bool waits = node.at && find_node(*node.at).kind == NodeKind::mapping;
  if (node.name.empty() && !waits) return;
  if (graph.nodes.size() == kMaxNodes)
    return add_mistake(
        item, fmt::format("more than {} keys have names or wait for others; expected fewer", kMaxNodes));
  if (!node.name.empty() && !graph.index.emplace(node.name, graph.nodes.size()).second)
    return add_mistake(*find_value(entries, "name"),
                       fmt::format("the name '{}' stands twice; expected another one", node.name));
  graph.nodes.push_back(std::move(node));
}

// The node that `after` names for `actor`: one of its own, or of another.
std::optional<std::size_t> find_named(const Graph& graph, const std::string& actor, const std::string& name) {
  for (const std::string& full : {build_full_name(actor, name), name})
    if (const auto found = graph.index.find(full); found != graph.index.end()) return found->second;
  return std::nullopt;
}

void add_unknown_name(const YamlValue& value, const std::string& name, const Names& names) {
  if (names.empty())
    add_mistake(value, fmt::format("unknown name '{}'; expected a key with 'name: {}'", show_word(name),
                                   is_word(name) ? name : "hello"));
  else
    add_mistake(value, describe_unknown("name", name, names));
}

// What a time waits for, and how long after it.
struct Wait {
  YamlValue after;
  std::string name;
  double delay_s = 0;
};

std::optional<Wait> load_wait(const YamlValue& value, const ClipClock& clock) {
  const YamlMapping entries = load_section(value, find_sections().wait);
  const YamlValue* after = find_required(entries, "after", value, "the name of a key such as ann.hello");
  Wait wait;
  if (after == nullptr || !load_text(*after, "the name of a key such as ann.hello", wait.name)) return {};
  wait.after = *after;
  if (const YamlValue* delay = find_value(entries, "delay"))
    if (!load_quantity(*delay, clock.measure, -clock.end_s, clock.end_s, wait.delay_s)) return {};
  return wait;
}

std::string describe_circle(const Graph& graph, const std::vector<std::size_t>& chain, std::size_t again) {
  std::string circle;
  for (auto at = std::ranges::find(chain, again); at != chain.end(); ++at)
    circle += graph.nodes[*at].name + " waits for ";
  return circle + graph.nodes[again].name;
}

// The time of a node; empty if it is wrong. `chain` holds those that wait for it.
std::optional<double> resolve(Graph& graph, std::size_t number, std::vector<std::size_t>& chain) {
  Node& node = graph.nodes[number];
  if (node.is_done || !node.at) return node.time_s;
  node.is_done = true;
  Findings silent;  // whoever reads the key tells them
  YamlValue at = *node.at;
  at.findings = &silent;
  if (find_node(at).kind != NodeKind::mapping) {
    double at_s = 0;
    if (load_time(at, graph.clock, at_s)) node.time_s = at_s;
    return node.time_s;
  }
  std::optional<Wait> wait = load_wait(at, graph.clock);
  const auto other = wait ? find_named(graph, node.actor, wait->name) : std::nullopt;
  if (!other) return {};
  node.is_open = true;
  chain.push_back(number);
  std::optional<double> time_s;
  wait->after.findings = node.at->findings;
  if (graph.nodes[*other].is_open)
    add_mistake(wait->after, fmt::format("keys wait for each other in a circle: {}; expected none",
                                         describe_circle(graph, chain, *other)));
  else
    time_s = resolve(graph, *other, chain);
  chain.pop_back();
  node.is_open = false;
  if (time_s) node.time_s = *time_s + wait->delay_s;
  return node.time_s;
}

void add_time(const Node& node, const std::string& name, NamedTimes& named) {
  named.times_s[name] = node.time_s;
  if (!node.time_s && node.at && is_constant(*node.at)) named.formulas.insert(name);
}

}  // namespace

std::vector<NamedTimes> load_named_times(const std::vector<NamedClip>& clips, int fps) {
  Graph graph;
  graph.clock = build_clip_clock(fps);
  for (const NamedClip& clip : clips)
    for (const YamlEntry& track : clip.entries)
      if (find_node(track.value).kind == NodeKind::list)
        for (const YamlValue& item : load_list(track.value, "")) add_node(item, clip.actor, graph);
  std::vector<std::size_t> chain;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) resolve(graph, i, chain);
  std::vector<NamedTimes> all;
  for (const NamedClip& clip : clips) {
    NamedTimes& named = all.emplace_back();
    for (const auto& [full, number] : graph.index) {
      named.names.push_back(full);
      add_time(graph.nodes[number], full, named);
    }
    for (const Node& node : graph.nodes)
      if (node.actor == clip.actor && !node.name.empty() && !clip.actor.empty())
        add_time(node, node.name.substr(clip.actor.size() + 1), named);
  }
  return all;
}

std::optional<double> load_named_time(const YamlValue& value, const ClipClock& clock) {
  const std::optional<Wait> wait = load_wait(value, clock);
  if (!wait) return {};
  const auto found = clock.times->times_s.find(wait->name);
  if (found == clock.times->times_s.end()) {
    add_unknown_name(wait->after, wait->name, clock.times->names);
    return {};
  }
  if (!found->second && clock.times->formulas.contains(wait->name))
    add_mistake(
        wait->after,
        fmt::format("the time of '{}' is a formula that is not known here; expected one of the file's "
                    "own inputs",
                    show_word(wait->name)));
  if (!found->second) return {};
  return *found->second + wait->delay_s;
}

}  // namespace mien
