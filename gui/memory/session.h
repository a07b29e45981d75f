#pragma once
// Autosave and recovery: a crash loses nothing.
//
// Every running program owns one slot N of a folder: session-N.lock, held with flock for the life of the process, and
// session-N.json, the newest document:
//
//   {"saved": true, "ended": false, "preset": "/path/of/its/file.json", "document": {"glintscope": "preset", …}}
//
// `ended` becomes true at a clean end; a slot that is free and has not ended belonged to a program that crashed. A new
// program takes the first free slot that lost something, else the first free one, so two crashes are recovered by two
// starts. Main thread.

#include <filesystem>
#include <optional>
#include <string>

#include "core/document/document.h"
#include "core/math/result.h"

namespace glint::gui {

/// What the previous owner of a slot left.
struct RecoveredSession {
  Document document;
  std::filesystem::path preset_file;  ///< the preset it came from or was saved to; empty: none
  bool was_saved = false;             ///< the document stood in preset_file as it is here
  bool crashed = false;               ///< its owner did not come to end()
};

/// The slot that this process owns. Move-only; its end frees the slot, with or without end().
class Session {
 public:
  /// Claims a slot of the folder, which is created. An error where the folder cannot be written or 64 programs run: the
  /// program goes on without autosave and says so.
  static Result<Session> begin(const std::filesystem::path& folder);

  Session(Session&& other) noexcept;
  Session& operator=(Session&& other) noexcept;
  ~Session();

  /// From 1.
  [[nodiscard]] int slot() const { return slot_; }
  /// As it was at begin(); it stays in its file until the first save().
  [[nodiscard]] const std::optional<RecoveredSession>& recovered() const { return recovered_; }
  /// To be shown: the slot's file could not be understood. It was set aside under the name that the sentence says.
  [[nodiscard]] const std::optional<Error>& fault() const { return fault_; }

  /// Writes the document, all or nothing. The caller sees to it that this happens at most every 2 s. Paths are made
  /// absolute.
  Status save(const Document& document, const std::filesystem::path& preset_file, bool is_saved);

  /// Marks what was saved last as left by a clean end. Without a save() the slot stays as it was found.
  Status end();

 private:
  Session(std::filesystem::path file, int slot, int lock) : file_(std::move(file)), slot_(slot), lock_(lock) {}
  void read_slot();
  void set_aside();
  [[nodiscard]] bool lost_something() const;
  Status write(bool ended);

  std::filesystem::path file_;
  int slot_ = 0;
  int lock_ = -1;  // file descriptor
  std::optional<RecoveredSession> recovered_;
  std::optional<Error> fault_;
  std::string newest_;  // the members of the file after "ended"; empty: nothing saved yet
  bool is_saved_ = false;
};

}  // namespace glint::gui
