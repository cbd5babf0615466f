#include "sheet/subject.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "clip/clip.hpp"
#include "config/findings.hpp"
#include "core/error.hpp"
#include "sheet/plans.hpp"
#include "timeline/drawings.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& word) {
  std::error_code ignored;
  const fs::file_status status = fs::status(word, ignored);
  return word.extension() == ".yaml" || word.extension() == ".yml" ||
         (fs::exists(status) && !fs::is_directory(status));
}

constexpr const char* kPlainHair = "crop";  // bald heads look startled and unfinished

// What stands for a file where none was named.
Spec build_plain_spec(const std::string& word, const Options& options, const Stock& stock) {
  Spec spec;
  std::string stem = word;
  std::ranges::replace(stem, '/', '_');
  spec.name = build_name(stem);
  spec.head.hair = kPlainHair;
  spec.expressions = stock.language->libraries.expressions;
  if (options.quality) spec.render.quality = *options.quality;
  return spec;
}

void check_library(const std::string& word, const std::map<std::string, std::string>& sources) {
  if (sources.contains(word)) return;
  std::vector<std::string> names;
  for (const auto& [name, source] : sources) names.push_back(name);
  const std::string nearest = suggest_name(word, names);
  throw InputError(nearest.empty() ? fmt::format("'{}' is no FILE and no library; known libraries: {}",
                                                 show_word(word), join_names(names))
                                   : fmt::format("'{}' is no FILE and no library; did you mean '{}'?",
                                                 show_word(word), nearest));
}

// The face of the clip's poster.
Expression find_poster_face(const Spec& spec) {
  const double at_s = static_cast<double>(find_poster_frame(spec.clip)) / spec.clip.fps;
  return {spec.title.empty() ? spec.name : spec.title, "",
          sample_performance(build_performance(spec.clip), at_s).pose};
}

}  // namespace

SheetSubject load_sheet_subject(const Options& options, const Stock& stock) {
  const std::string& kind = options.kind;
  const bool is_of_heads = kind == "heads";
  const std::string word = options.file.string();
  SheetSubject subject;
  subject.sources = stock.library_sources;
  subject.speech = stock.language->speech;
  subject.seed = options.seed.value_or(subject.seed);
  if (kind == kPeopleSheet && word.empty()) {
    subject.spec = build_plain_spec(word, options, stock);
    subject.spec.name = kind;
    subject.spec.head.hair = HeadSpec{}.hair;  // each has a cut of their own
    return subject;
  }
  if (is_file(options.file) || (kind != "expressions" && !is_of_heads)) {
    subject.spec = load_actor_request(options, *stock.language);
    if (is_of_heads)
      subject.expression =
          options.express ? take_expression(subject.spec, *options.express) : find_poster_face(subject.spec);
    return subject;
  }
  subject.spec = build_plain_spec(word, options, stock);
  if (is_of_heads) {
    if (options.express)
      throw InputError(fmt::format(
          "--express says another expression than '{}'; expected one of the two, or a FILE", word));
    try {
      subject.expression = take_expression(subject.spec, word);
    } catch (const InputError& e) {
      throw InputError(fmt::format("'{}' is no FILE; {}", show_word(word), e.what()));
    }
    subject.spec.title = word;
    return subject;
  }
  check_library(word, subject.sources);
  subject.spec.library = word;
  subject.spec.title = "The faces of " + word;
  subject.spec.head.follows_thesis =
      std::ranges::any_of(subject.spec.expressions,
                          [&](const Expression& one) { return one.library == word && one.follows_thesis; });
  return subject;
}

}  // namespace mien
