#include "live/disk_answers.hpp"

#include <fmt/format.h>

#include "config/named_file.hpp"
#include "core/text.hpp"
#include "live/news.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

struct DiskText {
  std::string text, hash;
  bool is_there = false;
};

DiskText read_disk(const fs::path& file) {
  try {
    std::string text = read_file(file);
    std::string hash = hash_hex(text);
    return {std::move(text), std::move(hash), true};
  } catch (const RunError&) {
    return {};
  }
}

Json describe_disk(const DiskText& disk, int version) {
  return {{"version", version}, {"hash", disk.hash}, {"text", disk.text}, {"exists", disk.is_there}};
}

// With the rights that the file has.
void replace_file(const fs::path& file, const std::string& text) {
  const fs::path real = find_canonical(file);  // a link stays one
  std::error_code error;
  const fs::file_status before = fs::status(real, error);
  write_file(real, text);
  if (fs::is_regular_file(before)) fs::permissions(real, before.permissions(), error);
}

}  // namespace

void look_at_disk(LiveSession& session, bool is_included) {
  const DiskText disk = read_disk(session.shelf.file);
  const std::lock_guard lock(session.disk.mutex);
  if (disk.hash == session.disk.hash && !is_included) return;
  if (is_included) forget_documents(session.shelf);
  session.disk.hash = disk.hash;
  ++session.disk.version;
  session.disk.changed.notify_all();
}

LiveAnswer answer_session(LiveSession& session) {
  const DiskText disk = read_disk(session.shelf.file);
  const std::lock_guard lock(session.disk.mutex);
  Json value = describe_disk(disk, session.disk.version);
  value["disk"] = session.disk.version;
  value["file"] = session.shelf.file.string();
  value["name"] = session.shelf.file.filename().string();
  value["mien"] = MIEN_VERSION;
  value["read_only"] = session.is_read_only;
  return build_answer(value);
}

LiveAnswer answer_disk(LiveSession& session, const LiveRequest& request) {
  DiskState& disk = session.disk;
  const int known = take_version(request);
  std::unique_lock lock(disk.mutex);
  wait_for_news(lock, disk.changed, disk.waiting, [&] { return disk.is_ending || disk.version != known; });
  return build_answer(describe_disk(read_disk(session.shelf.file), disk.version));
}

LiveAnswer answer_save(LiveSession& session, const Json& asked) {
  if (session.is_read_only) return build_refusal(403, "the file is not written with --read-only");
  const std::string text = take_text(asked, "text"), hash = take_text(asked, "hash");
  const std::lock_guard lock(session.disk.mutex);
  const DiskText disk = read_disk(session.shelf.file);
  if (disk.hash != hash) {
    LiveAnswer answer = build_answer({{"error", "the file has changed on the disk"},
                                      {"hash", disk.hash},
                                      {"text", disk.text},
                                      {"version", session.disk.version}});
    answer.status = 409;
    return answer;
  }
  replace_file(session.shelf.file, text);
  session.disk.hash = hash_hex(text);
  ++session.disk.version;
  session.disk.changed.notify_all();
  return build_answer({{"hash", session.disk.hash}, {"version", session.disk.version}});
}

}  // namespace mien
