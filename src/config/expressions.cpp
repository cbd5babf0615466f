#include "config/expressions.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "config/facs_notation.hpp"
#include "config/load_areas.hpp"

namespace mien {

namespace {

constexpr std::size_t kMaxSuggestions = 100;  // names compared with an unknown one

bool is_plain_word(const std::string& name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_inner = [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !name.empty() && name.size() <= kMaxExpressionName && is_letter(name[0]) &&
         std::ranges::all_of(name, is_inner);
}

// The libraries a plain name is looked up in, in order; "" are the file's own expressions.
Names list_scopes(const ExpressionBook& book, const std::string& of_library) {
  Names scopes = of_library.empty() ? Names{"", book.library} : Names{of_library};
  for (const std::string& library : kEverydayLibraries)
    if (std::ranges::find(scopes, library) == scopes.end()) scopes.push_back(library);
  return scopes;
}

void add_unknown_expression(const YamlValue& value, Spot spot, const std::string& name,
                            const ExpressionBook& book, const std::string& of_library = "") {
  std::string message;
  if (!is_full(*value.findings)) message = describe_unknown_expression(book, name, of_library);
  add_mistake(*value.findings, value.document->source, spot, std::move(message));
}

// The index in the book of a draft's base, or empty with a mistake told.
std::optional<std::size_t> find_base(const ExpressionDraft& draft, const ExpressionBook& book) {
  if (!draft.from) return std::nullopt;
  const std::string& name = find_node(*draft.from).text;
  const std::string& library = book.expressions[draft.expression].library;
  if (!draft.doctrine.empty() && name.find('/') == std::string::npos) {
    const std::string of = draft.doctrine == kDoctrines.front() ? ExpressionBook{}.library : draft.doctrine;
    const auto own = find_expression(book, of + "/" + name);
    if (!own) add_unknown_expression(*draft.from, draft.from->spot, of + "/" + name, book);
    return own;
  }
  const auto base = find_expression(book, name, library);
  if (!base) add_unknown_expression(*draft.from, draft.from->spot, name, book, library);
  return base;
}

// What a draft says of its manner, over that of what it starts from.
std::shared_ptr<const Manner> build_manner(const ExpressionDraft& draft,
                                           const std::shared_ptr<const Manner>& base) {
  Manner manner = base ? *base : Manner{};
  bool is_plain = base == nullptr;
  for (std::size_t i = 0; i < kChannelCount; ++i) {
    is_plain = is_plain && !draft.dominance[i] && !draft.growth[i];
    manner.dominance[i] = draft.dominance[i].value_or(manner.dominance[i]);
    manner.growth[i] = draft.growth[i].value_or(manner.growth[i]);
  }
  return is_plain ? nullptr : std::make_shared<const Manner>(manner);
}

// The weights and expressions of a mix.
std::vector<ExpressShare> load_mix(const YamlValue& value, const ExpressionBook& book,
                                   const FormulaReader* formulas) {
  std::vector<ExpressShare> mix;
  const YamlMapping entries = load_free_mapping(value, "");
  if (entries.empty())
    add_mistake(value, describe_subject(value) + " names no expression; expected one at least");
  for (const YamlEntry& entry : entries) {
    const auto index = find_expression(book, entry.key);
    if (!index) add_unknown_expression(value, entry.spot, entry.key, book);
    if (formulas != nullptr && is_formula(entry.value)) {
      const FormulaPointer formula = load_formula(entry.value, *formulas);
      if (formula && index) mix.push_back({0, *index, entry.spot, formula});
      continue;
    }
    double weight = 0;
    if (load_number(entry.value, weight) && index) mix.push_back({weight, *index, entry.spot, {}});
  }
  return mix;
}

}  // namespace

void append_expressions(ExpressionBook& book, std::vector<Expression> expressions) {
  for (Expression& expression : expressions) {
    book.index[expression.library + "/" + expression.name] = book.expressions.size();
    book.expressions.push_back(std::move(expression));
  }
}

std::optional<std::size_t> find_expression(const ExpressionBook& book, const std::string& name,
                                           const std::string& of_library) {
  const auto find = [&](const std::string& path) -> std::optional<std::size_t> {
    const auto found = book.index.find(path);
    return found == book.index.end() ? std::nullopt : std::optional(found->second);
  };
  if (name.find('/') != std::string::npos) return name[0] == '/' ? std::nullopt : find(name);
  for (const std::string& scope : list_scopes(book, of_library))
    if (const auto found = find(scope + "/" + name)) return found;
  return is_facs_notation(name) ? find("facs/" + name) : std::nullopt;
}

std::string describe_unknown_expression(const ExpressionBook& book, const std::string& name,
                                        const std::string& of_library) {
  const std::size_t slash = name.find('/');
  const bool is_plain = slash == std::string::npos;
  const std::string library = is_plain ? "" : name.substr(0, slash);
  if (!is_plain && std::ranges::find(book.libraries, library) == book.libraries.end())
    return describe_unknown("library", library, book.libraries);

  if (std::string fault; book.mappings && is_facs_notation(name)) {
    find_notation_pose(*book.mappings, name, fault);
    if (!fault.empty()) return fault;
  }
  const std::string word = is_plain ? name : name.substr(slash + 1);
  const std::string start = fmt::format("unknown expression '{}'; ", show_word(name));
  for (const std::string& other : book.libraries)
    if (is_plain && book.index.contains(other + "/" + word))
      return start + fmt::format("did you mean '{}/{}'?", other, word);

  Names words;
  for (const std::string& scope : is_plain ? list_scopes(book, of_library) : Names{library})
    for (const Expression& expression : book.expressions) {
      if (words.size() >= kMaxSuggestions) break;
      if (expression.library == scope && std::ranges::find(words, expression.name) == words.end())
        words.push_back(expression.name);
    }
  const std::string nearest = suggest_name(word, words);
  if (nearest.empty())
    return start + fmt::format("known{}: {}", is_plain ? "" : " in " + library, join_names(words));
  return start + fmt::format("did you mean '{}'?", is_plain ? nearest : library + "/" + nearest);
}

void load_drafts(const YamlValue& value, const std::string& library, ExpressionBook& book,
                 std::vector<ExpressionDraft>& drafts) {
  for (const YamlEntry& entry : load_free_mapping(value, "a mapping of names to areas")) {
    if (!is_plain_word(entry.key)) {
      const std::string message = fmt::format(
          "'{}' cannot name an expression; expected a letter, then letters, digits, '_' or '-', {} at most",
          show_word(entry.key), kMaxExpressionName);
      add_mistake(*value.findings, value.document->source, entry.spot, message);
      continue;
    }
    const YamlMapping body = load_section(entry.value);
    ExpressionDraft draft;
    draft.expression = book.expressions.size();
    append_expressions(book, {{entry.key, library, {}}});
    std::string base;
    if (const YamlValue* from = find_value(body, "from"))
      if (load_text(*from, "an expression's name", base)) draft.from = *from;
    if (const YamlValue* strength = find_value(body, "strength")) {
      load_number(*strength, draft.strength);
      if (find_value(body, "from") == nullptr)
        add_mistake(*strength, "'strength' weakens nothing here; expected 'from' beside it");
    }
    if (const YamlValue* doctrine = find_value(body, "doctrine")) {
      load_name(*doctrine, "doctrine", kDoctrines, draft.doctrine);
      if (find_value(body, "from") == nullptr)
        add_mistake(*doctrine, "'doctrine' chooses nothing here; expected 'from' beside it");
    }
    load_exaggerate(body, draft.exaggerate);
    if (const YamlValue* attack = find_value(body, "attack"))
      if (double attack_s = 0; load_seconds(*attack, attack_s)) draft.attack_s = attack_s;
    if (const YamlValue* dominance = find_value(body, "dominance"))
      draft.dominance = load_area_numbers(*dominance);
    if (const YamlValue* growth = find_value(body, "growth")) draft.growth = load_area_numbers(*growth);
    draft.areas = load_areas(body);
    draft.numbers = count_area_numbers(body);
    drafts.push_back(std::move(draft));
  }
}

void build_drafts(const std::vector<ExpressionDraft>& drafts, ExpressionBook& book) {
  enum class State { waiting, begun, done };
  std::vector<State> states(drafts.size(), State::waiting);
  std::map<std::size_t, std::size_t> draft_of;  // expression -> draft
  for (std::size_t i = 0; i < drafts.size(); ++i) draft_of[drafts[i].expression] = i;

  for (std::size_t first = 0; first < drafts.size(); ++first) {
    // Down the chain to what is known (a chain may be long: no recursion), then back up.
    struct Link {
      std::size_t draft = 0;
      Expression base = {};  // what it starts from
    };
    std::vector<Link> chain;
    for (std::size_t at = first; states[at] == State::waiting;) {
      states[at] = State::begun;
      chain.push_back({at});
      const auto base = find_base(drafts[at], book);
      if (!base) break;
      const auto next = draft_of.find(*base);
      if (next != draft_of.end() && states[next->second] == State::begun) {
        const Expression& found = book.expressions[*base];
        add_mistake(*drafts[at].from,
                    fmt::format("expression '{}' comes from itself; expected one of another name, or "
                                "of a library as in 'mien/smile'",
                                found.name));
        break;
      }
      chain.back().base = book.expressions[*base];
      if (next != draft_of.end()) at = next->second;
    }
    for (std::size_t i = chain.size(); i-- > 0;) {
      const Link& link = chain[i];
      const ExpressionDraft& draft = drafts[link.draft];
      Expression& expression = book.expressions[draft.expression];
      const Pose base = mix_poses({{1, link.base.pose, link.base.manner}}, draft.strength);
      HeldPose held = hold_pose({base, link.base.reach, draft.strength, draft.areas, draft.exaggerate});
      expression.pose = held.pose;
      expression.reach = held.reach;
      expression.held = std::move(held.held);
      expression.numbers = link.base.numbers + draft.numbers;
      expression.attack_s = draft.attack_s.value_or(link.base.attack_s);
      expression.manner = build_manner(draft, link.base.manner);
      states[link.draft] = State::done;
      if (i == 0) break;
      chain[i - 1].base = expression;
    }
  }
}

std::vector<PoseShare> list_shares(const std::vector<ExpressShare>& mix, const ExpressionBook& book) {
  std::vector<PoseShare> shares;
  for (const ExpressShare& share : mix) {
    const Expression& expression = book.expressions[share.expression];
    shares.push_back({share.weight, expression.pose, expression.manner});
  }
  return shares;
}

Express load_express(const YamlValue& value, const ExpressionBook& book, const FormulaReader* formulas) {
  Express express;
  std::vector<ExpressShare>& mix = express.shares;
  if (find_node(value).kind == NodeKind::mapping) {
    mix = load_mix(value, book, formulas);
  } else if (std::string name;
             load_text(value, "an expression's name or a mix such as {smile: 0.4, fear: 0.6}", name)) {
    if (const auto index = find_expression(book, name))
      mix.push_back({1.0, *index, value.spot, {}});
    else
      add_unknown_expression(value, value.spot, name, book);
  }
  double most = -1;
  for (const auto& [weight, index, spot, formula] : mix) {
    const Expression& expression = book.expressions[index];
    if (most < 0) express.library = expression.library;
    if (weight > most) express.attack_s = expression.attack_s;
    most = std::max(most, weight);
    if (!express.name.empty()) express.label.append(" + "), express.name.append("_");
    express.label += expression.name;
    if (find_node(value).kind == NodeKind::mapping)
      express.label += formula ? " live" : fmt::format(" {:.3g}", weight);
    express.name += expression.name;
    std::ranges::replace(express.name, '+', '_');  // of a notation; names become file names
    if (weight > 0 || formula) express.reach = std::max(express.reach, expression.reach);
    express.held.insert(express.held.end(), expression.held.begin(), expression.held.end());
  }
  express.name.resize(std::min(express.name.size(), kMaxExpressionName));
  express.pose = mix_poses(list_shares(mix, book));
  return express;
}

void load_exaggerate(const YamlMapping& entries, double& into) {
  if (const YamlValue* value = find_value(entries, "exaggerate")) load_number(*value, into);
}

}  // namespace mien
