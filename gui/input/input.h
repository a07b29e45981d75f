#pragma once
// What a person or a script does with mouse and keyboard, on its way to Dear ImGui 1.86. That version sees only the
// state at the start of a frame, so a press and its release in one frame would be lost: the queue spreads them over
// frames, in the order in which they came. It is the only writer of mouse and keyboard in ImGuiIO. Main thread.

#include <array>
#include <cfloat>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <imgui.h>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "gui/input/chord.h"

namespace glint::gui {

struct Modifiers {
  bool ctrl = false;
  bool shift = false;
  bool alt = false;
  bool super = false;

  friend bool operator==(const Modifiers&, const Modifiers&) = default;
};

/// To a position in pixels of the window; (-FLT_MAX, -FLT_MAX) where the mouse has left it.
struct MouseMove {
  ImVec2 position{0, 0};
};

struct MouseButton {
  int button = 0;  ///< 0 left, 1 right, 2 middle; others are passed over
  bool is_down = false;
  Modifiers modifiers = {};
  bool never_double = false;  ///< this press is not the second of a double click, however soon it comes
};

/// In notches: y > 0 is away from the person (scrolls up), x > 0 to the left, as in ImGui.
struct MouseWheel {
  ImVec2 notches{0, 0};
};

/// A press of a key that is down is its repetition. `modifiers` are those held with it; whether a modifier key counts
/// as its own (platforms differ) makes no difference.
struct KeyChange {
  Key key = Key::none;
  bool is_down = false;
  Modifiers modifiers = {};
};

struct Character {
  char32_t code = 0;
};

/// The window lost the keyboard: releases everything, without a click.
struct FocusLost {};

struct FileDrop {
  std::vector<std::filesystem::path> files;
};

using InputEvent = std::variant<MouseMove, MouseButton, MouseWheel, KeyChange, Character, FocusLost, FileDrop>;

class InputQueue {
 public:
  void push(InputEvent event) { events_.push_back(std::move(event)); }

  /// Once a frame, before ImGui::NewFrame: applies what one frame can show of the events and writes mouse and keyboard
  /// to `io`. True if events are left for the next frame, which should follow at once.
  bool feed(ImGuiIO& io);

  [[nodiscard]] bool is_empty() const { return events_.empty(); }
  /// The chords pressed in this frame, in order, for shortcuts. None while Super is held: those are the desktop's.
  [[nodiscard]] std::span<const Chord> key_presses() const { return presses_; }
  /// Those that a held key repeated in this frame, for what may be repeated (moving by a texel).
  [[nodiscard]] std::span<const Chord> key_repeats() const { return repeats_; }
  /// As of this frame.
  [[nodiscard]] bool is_down(Key key) const;
  [[nodiscard]] const Modifiers& modifiers() const { return modifiers_; }
  /// The files dropped up to this frame and not taken before.
  std::vector<std::filesystem::path> take_drops();
  /// Forgets what waits; the next frame releases everything, without a click.
  void clear();

 private:
  static constexpr std::size_t k_buttons = 3;
  static constexpr std::size_t k_keys = 512;  // of ImGuiIO::KeysDown

  // What has been applied in this frame, and therefore makes later events wait.
  struct Applied {
    std::vector<Key> keys;
    std::array<bool, k_buttons> buttons{};
    bool any_button = false;
    bool any_wheel = false;
    bool any_character = false;
    bool any_editing_key = false;
    bool any_with_modifiers = false;
    bool everything_released = false;
  };

  // Each applies the event, or returns false where it has to wait for the next frame.
  bool take(const MouseMove& event);
  bool take(const MouseButton& event);
  bool take(const MouseWheel& event);
  bool take(const KeyChange& event);
  bool take(const Character& event);
  bool take(const FocusLost& event);
  bool take(const FileDrop& event);
  bool take_modifiers(const Modifiers& modifiers);
  void write(ImGuiIO& io) const;

  std::deque<InputEvent> events_;
  std::vector<Chord> presses_;
  std::vector<Chord> repeats_;
  std::vector<std::filesystem::path> drops_;
  Modifiers modifiers_;
  ImVec2 position_{-FLT_MAX, -FLT_MAX};
  ImVec2 wheel_{0, 0};                // of this frame
  std::vector<char32_t> characters_;  // of this frame
  std::array<bool, k_buttons> buttons_{};
  std::array<bool, k_buttons> never_double_{};  // of this frame
  std::array<bool, k_keys> keys_{};
  bool is_mouse_hidden_ = false;  // in this frame, so that released buttons are not clicks
  Applied applied_;
};

/// Tells ImGui which of our key codes are its keys. Once a context.
void setup_key_map(ImGuiIO& io);

}  // namespace glint::gui
