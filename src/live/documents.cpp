#include "live/documents.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "voice/speech.hpp"

namespace mien {

namespace {

constexpr std::size_t kMostDocuments =
    12;  // a page asks for the newest and, for a moment, for the one before

DocumentPointer build_document(const LiveShelf& shelf, const std::string& text, std::string key) {
  auto document = std::make_shared<LiveDocument>();
  document->key = std::move(key);
  try {
    const Language& language = *shelf.resources->stock.language;
    Spec spec = load_spec(shelf.file, text, language);
    add_speech(spec, *language.speech);
    Clip clip = build_clip(std::move(spec));
    plan_drawings(clip);
    document->is_growing = std::ranges::any_of(
        clip.actors, [](const Actor& actor) { return !actor.performance.clip.head.empty(); });
    document->clip = std::move(clip);
  } catch (const InputError& error) {
    document->mistakes = error.diagnostics;
  }
  return document;
}

}  // namespace

DocumentPointer read_document(LiveShelf& shelf, const std::string& text) {
  const std::string key = hash_hex(text);
  {
    const std::lock_guard lock(shelf.mutex);
    for (const DocumentPointer& kept : shelf.documents)
      if (kept->key == key) return kept;
  }
  DocumentPointer document = build_document(shelf, text, key);
  const std::lock_guard lock(shelf.mutex);
  shelf.documents.push_front(document);
  if (shelf.documents.size() > kMostDocuments) shelf.documents.pop_back();
  if (document->clip) shelf.files = document->clip->spec.files;
  return document;
}

void forget_documents(LiveShelf& shelf) {
  const std::lock_guard lock(shelf.mutex);
  shelf.documents.clear();
}

DocumentPointer find_document(LiveShelf& shelf, const std::string& key) {
  const std::lock_guard lock(shelf.mutex);
  for (const DocumentPointer& kept : shelf.documents)
    if (kept->key == key) {
      if (!kept->clip) throw InputError(kept->mistakes);
      return kept;
    }
  throw InputError("the text is not known any more; expected it to be checked again");
}

std::shared_ptr<const Cast> find_cast(LiveShelf& shelf, LiveDocument& document) {
  const std::lock_guard lock(document.mutex);
  if (!document.cast)
    document.cast =
        std::make_shared<const Cast>(build_cast(*document.clip, shelf.resources->heads, &shelf.figures));
  return document.cast;
}

std::shared_ptr<const Heads> find_heads(LiveShelf& shelf, LiveDocument& document, double time_s) {
  const std::shared_ptr<const Cast> cast = find_cast(shelf, document);
  const auto build = [&](double at_s) {
    return std::make_shared<const Heads>(build_heads(*document.clip, *cast, at_s, shelf.resources->heads));
  };
  if (document.is_growing) return build(time_s);
  const std::lock_guard lock(document.mutex);
  if (!document.heads) document.heads = build(0);
  return document.heads;
}

}  // namespace mien
