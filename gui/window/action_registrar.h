#pragma once
// What the registry's entries are written with.

#include <functional>
#include <optional>
#include <utility>

#include "gui/window/application.h"

namespace glint::gui {

constexpr Chord plain(Key key) {
  return {key, false, false, false};
}
constexpr Chord shift(Key key) {
  return {key, false, true, false};
}
constexpr Chord ctrl(Key key) {
  return {key, true, false, false};
}
constexpr Chord ctrl_shift(Key key) {
  return {key, true, true, false};
}

/// Adds entries one after another: add() gives one, done() enters it with what was set on it.
class ActionRegistrar {
 public:
  ActionRegistrar(Actions& actions, Application& application) : actions_(actions), app_(application) {}

 protected:
  Action& add(const char* menu, const char* name, const char* title, std::optional<Chord> chord, const char* tooltip,
              std::function<void()> run) {
    pending_ = {name, menu, title, chord, {}, tooltip};
    pending_.run = std::move(run);
    return pending_;
  }
  void done() { actions_.add(std::exchange(pending_, {})); }

  [[nodiscard]] Workbench& bench() const { return app_.workbench(); }

  Actions& actions_;
  Application& app_;

 private:
  Action pending_;
};

/// Those of the View menu; add_actions() calls it in their place.
void add_view_actions(Actions& actions, Application& application);

}  // namespace glint::gui
