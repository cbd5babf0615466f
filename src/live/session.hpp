// What one run of `mien live` has: the file, what was read of it, what is made from it.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <string>

#include "live/documents.hpp"
#include "live/files.hpp"
#include "live/jobs.hpp"
#include "live/server.hpp"
#include "live/view_store.hpp"

namespace mien {

// The file as the disk has it, and a number that counts its changes and those of the files that it includes.
struct DiskState {
  std::mutex mutex;
  std::condition_variable changed;
  std::string hash;  // of its bytes; empty: it cannot be read
  int version = 1;
  bool is_ending = false;
  int waiting = 0;  // pages that wait for a change
};

struct LiveSession {
  LiveShelf shelf;
  ViewStore views;
  DiskState disk;
  Jobs jobs;
  LiveFiles files;
  std::string schema;             // of the language: the text of `mien schema`
  std::filesystem::path program;  // this one: what makes clips and busts
  bool is_read_only = false;
};

// Looks at the disk again and tells the pages if something has changed; `is_included`: one of the files that
// the file reads has.
void look_at_disk(LiveSession& session, bool is_included);

// Wakes all who wait: the server ends.
void end_session(LiveSession& session);

// Every answer of the server. Throws what cannot be answered.
LiveAnswer answer_request(LiveSession& session, const LiveRequest& request);

}  // namespace mien
