// Texts that a page has sent, read once each: pages then name them by their hash.
#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "clip/cast.hpp"
#include "frames/resources.hpp"

namespace mien {

// A text as mien reads it. What is costly is made when it is first asked for; any number of threads may ask.
struct LiveDocument {
  std::string key;  // the hash of the text
  std::vector<Diagnostic> mistakes;
  std::optional<Clip> clip;  // planned; none if there are mistakes

  std::mutex mutex;  // of what follows
  std::shared_ptr<const Cast> cast;
  std::shared_ptr<const Heads> heads;  // those of the time 0, and of every time unless heads change
  bool is_growing = false;
};
using DocumentPointer = std::shared_ptr<LiveDocument>;

// What all pages share.
struct LiveShelf {
  const Resources* resources = nullptr;
  std::filesystem::path file;  // whose text it is, or will be
  FigureStore figures;
  std::mutex mutex;                          // of what follows
  std::list<DocumentPointer> documents;      // the newest first
  std::vector<std::filesystem::path> files;  // that the newest good text is read from
};

// Reads a text, or finds it as it was read before.
DocumentPointer read_document(LiveShelf& shelf, const std::string& text);

// Reads all texts anew from now on: a file that they include has changed.
void forget_documents(LiveShelf& shelf);

// The one of this key. Throws InputError if it is not kept any more, or has mistakes.
DocumentPointer find_document(LiveShelf& shelf, const std::string& key);

// Everybody's heads at a time, as clip/ builds them. Throw InputError with what is wrong with them.
std::shared_ptr<const Cast> find_cast(LiveShelf& shelf, LiveDocument& document);
std::shared_ptr<const Heads> find_heads(LiveShelf& shelf, LiveDocument& document, double time_s);

}  // namespace mien
