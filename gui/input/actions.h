#pragma once
// Everything a person can tell the program to do, in one registry that feeds menus, shortcuts, the list of shortcuts,
// the palette and scripts. Main thread.

#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gui/input/chord.h"

namespace glint::gui {

struct Action {
  std::string name = {};                              ///< "file.open": what scripts call it; unique
  std::string menu = {};                              ///< "File"; empty: in no menu
  std::string title = {};                             ///< "Open…"
  std::optional<Chord> chord = {};                    ///< the one that is shown
  std::vector<Chord> more_chords = {};                ///< others that do the same
  std::string tooltip = {};                           ///< one sentence: what it does
  std::function<std::string()> reason_disabled = {};  ///< empty, or giving nothing: enabled
  std::function<bool()> checked = {};                 ///< empty: no check mark
  std::function<void()> run = {};
  bool separator_before = false;
  bool works_while_typing = false;  ///< its chord counts also while a text field has the keyboard

  [[nodiscard]] std::string disabled_because() const { return reason_disabled ? reason_disabled() : std::string(); }
  [[nodiscard]] bool is_enabled() const { return disabled_because().empty(); }
  [[nodiscard]] bool is_checked() const { return checked && checked(); }
};

class Actions {
 public:
  /// Asserts that the name is new and that there is something to run; faults() tells the rest.
  void add(Action action);

  /// In the order in which they were added; pointers to them stay valid.
  [[nodiscard]] const std::deque<Action>& all() const { return actions_; }
  /// Null for an unknown name.
  [[nodiscard]] const Action* find(std::string_view name) const;
  /// The action, enabled or not, with that chord; null for none.
  [[nodiscard]] const Action* for_chord(Chord chord) const;
  /// Runs it. Empty, or why it did not run: unknown (the nearest name is given) or disabled.
  [[nodiscard]] std::string run(std::string_view name) const;

  /// For the palette: the actions that match every word, best first, those that are disabled after the others. A word
  /// matches the title, the menu or the name by a part, the tooltip by the beginning of a word, or the title by its
  /// letters in order; upper and lower case are alike. No words: all.
  [[nodiscard]] std::vector<const Action*> matching(std::string_view words) const;

  /// What is wrong with the registry, one sentence each: an action without title or tooltip, a chord that cannot be
  /// written, two actions with one chord. A test holds this empty.
  [[nodiscard]] std::vector<std::string> faults() const;

 private:
  std::deque<Action> actions_;
};

/// Of `names`, the one that is spelled most like `wanted`; empty if there are none.
std::string nearest_name(std::string_view wanted, std::span<const std::string_view> names);

}  // namespace glint::gui
