#include "gui/memory/session.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/document/preset.h"
#include "core/document/text.h"
#include "core/image/atomic_file.h"
#include "gui/memory/user_folders.h"

namespace glint::gui {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int k_slots = 64;

fs::path slot_file(const fs::path& folder, int slot, const char* extension) {
  return folder / fmt::format("session-{}.{}", slot, extension);
}

// The lock of a slot as a file descriptor; nothing if another process holds it.
Result<std::optional<int>> lock_slot(const fs::path& file) {
  const int lock = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);  // NOLINT: variadic by POSIX
  if (lock < 0) return content_error(file.string(), "cannot be opened: " + std::generic_category().message(errno));
  while (::flock(lock, LOCK_EX | LOCK_NB) != 0) {
    const int fault = errno;
    if (fault == EINTR) continue;
    ::close(lock);
    if (fault == EWOULDBLOCK) return std::optional<int>();
    return content_error(file.string(), "cannot be locked: " + std::generic_category().message(fault));
  }
  return std::optional(lock);
}

Result<RecoveredSession> parse_session(const std::string& text, const std::string& subject) {
  const Json object = Json::parse(text, nullptr, false);
  if (!object.is_object()) return content_error(subject, "is not JSON that holds a session");
  for (const char* flag : {"saved", "ended"}) {
    if (!object.contains(flag) || !object[flag].is_boolean()) {
      return content_error(subject, fmt::format("does not say whether it was '{}'", flag));
    }
  }
  if (!object.contains("preset") || !(object["preset"].is_null() || object["preset"].is_string())) {
    return content_error(subject, "does not say which 'preset' it came from");
  }
  if (!object.contains("document")) return content_error(subject, "holds no 'document'");
  Result<Document> document = parse_preset(object["document"].dump(), subject);
  if (!document) return document.error();
  RecoveredSession session;
  session.document = std::move(*document);
  if (object["preset"].is_string()) session.preset_file = object["preset"].get<std::string>();
  session.was_saved = object["saved"].get<bool>();
  session.crashed = !object["ended"].get<bool>();
  return session;
}

fs::path absolute_path(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = path.empty() ? path : fs::absolute(path, error);
  return error ? path : absolute;
}

}  // namespace

Result<Session> Session::begin(const fs::path& folder) {
  if (const Status made = make_folder(folder); !made) return made.error();
  std::optional<Session> first;
  for (int slot = 1; slot <= k_slots; ++slot) {
    const fs::path file = slot_file(folder, slot, "json");
    std::error_code unreadable;
    if (first && !fs::exists(file, unreadable)) continue;
    const Result<std::optional<int>> lock = lock_slot(slot_file(folder, slot, "lock"));
    if (!lock && !first) return lock.error();
    if (!lock || !*lock) continue;
    Session session(file, slot, **lock);
    session.read_slot();
    const bool is_wanted = session.lost_something();
    if (is_wanted || !first) first = std::move(session);
    if (is_wanted) break;
  }
  if (!first) {
    return content_error(folder.string(), fmt::format("{} programs hold their sessions there, no more can", k_slots));
  }
  if (first->fault_) first->set_aside();
  return std::move(*first);
}

Session::Session(Session&& other) noexcept
    : file_(std::move(other.file_)),
      slot_(other.slot_),
      lock_(std::exchange(other.lock_, -1)),
      recovered_(std::move(other.recovered_)),
      fault_(std::move(other.fault_)),
      newest_(std::move(other.newest_)),
      is_saved_(other.is_saved_) {}

Session& Session::operator=(Session&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(slot_, other.slot_);
  std::swap(lock_, other.lock_);
  std::swap(recovered_, other.recovered_);
  std::swap(fault_, other.fault_);
  std::swap(newest_, other.newest_);
  std::swap(is_saved_, other.is_saved_);
  return *this;
}

Session::~Session() {
  if (lock_ >= 0) ::close(lock_);  // and with it the lock; its file stays, or another program could lock a ghost
}

void Session::read_slot() {
  std::error_code error;
  if (!fs::exists(file_, error)) return;
  const Result<std::string> text = read_small_file(file_);
  Result<RecoveredSession> session = text ? parse_session(*text, file_.filename().string()) : text.error();
  if (session) {
    recovered_ = std::move(*session);
    return;
  }
  fault_ = content_error(file_.string(), "the last session cannot be recovered, " + session.error().sentence);
}

void Session::set_aside() {
  fs::path aside = file_;
  aside += ".unreadable";
  std::error_code error;
  fs::rename(file_, aside, error);
  if (!error) fault_->sentence += fmt::format("; it was kept as {}", aside.filename().string());
}

bool Session::lost_something() const {
  return recovered_ && recovered_->crashed && !recovered_->was_saved;
}

Status Session::save(const Document& document, const fs::path& preset_file, bool is_saved) {
  Document stored = document;
  stored.surface.path = absolute_path(document.surface.path);
  const std::string preset = absolute_path(preset_file).string();
  const bool has_preset = !preset.empty() && !first_invalid_utf8(preset);
  newest_ =
      fmt::format("\"preset\": {},\n\"document\": {}", has_preset ? Json(preset).dump() : "null", preset_text(stored));
  is_saved_ = is_saved;
  return write(false);
}

Status Session::end() {
  return newest_.empty() ? success() : write(true);
}

Status Session::write(bool ended) {
  return write_file(file_, fmt::format("{{\"saved\": {}, \"ended\": {},\n{}}}\n", is_saved_, ended, newest_));
}

}  // namespace glint::gui
