#include "gui/input/script_runner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "gui/input/actions.h"

namespace glint::gui {
namespace {

constexpr int k_patience = 30;  // frames until what is not there counts as missing
constexpr int k_settle = 2;     // frames after an event: ImGui acts in the first, the application shows it in the next
constexpr int k_settle_picture = 3;  // frames until what changed is also drawn: a new window is blank in its first
constexpr int k_drag_steps = 8;
constexpr std::size_t k_characters_a_frame = 8;
constexpr double k_longest_wait = 120;  // seconds

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The error of a step without its place, which step() adds.
Error fault(std::string sentence) {
  return content_error("", std::move(sentence));
}

bool same(ImVec2 a, ImVec2 b) {
  return a.x == b.x && a.y == b.y;
}

bool is_near(double a, double b, double tolerance) {
  return a == b || std::abs(a - b) <= tolerance;
}

std::optional<double> number_in(const ParameterValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* number = std::get_if<std::uint64_t>(&value)) return static_cast<double>(*number);
  return std::nullopt;
}

bool is_near(const ParameterValue& a, const ParameterValue& b, double tolerance) {
  if (a == b || tolerance == 0) return a == b;
  if (number_in(a) && number_in(b)) return is_near(*number_in(a), *number_in(b), tolerance);
  const auto* numbers_a = std::get_if<std::vector<double>>(&a);
  const auto* numbers_b = std::get_if<std::vector<double>>(&b);
  return numbers_a && numbers_b &&
         std::equal(numbers_a->begin(), numbers_a->end(), numbers_b->begin(), numbers_b->end(),
                    [&](double x, double y) { return is_near(x, y, tolerance); });
}

/// A modifier as a member of chords and of events, and its left and right key.
struct ModifierKeys {
  bool Chord::*in_chord;
  bool Modifiers::*in_event;
  Key left;
  Key right;
};

constexpr ModifierKeys k_modifiers[] = {
    {&Chord::ctrl, &Modifiers::ctrl, Key::left_ctrl, Key::right_ctrl},
    {&Chord::shift, &Modifiers::shift, Key::left_shift, Key::right_shift},
    {&Chord::alt, &Modifiers::alt, Key::left_alt, Key::right_alt},
};

}  // namespace

ScriptRunner::ScriptRunner(Script script, ScriptTarget& target, std::function<double()> seconds)
    : script_(std::move(script)), target_(target), seconds_(seconds ? std::move(seconds) : steady_seconds) {}

ScriptProgress ScriptRunner::step() {
  while (progress_.state == ScriptProgress::State::running) {
    if (plan_.empty() && next_ == script_.steps.size()) {
      release_everything();
      progress_.state = ScriptProgress::State::finished;
      break;
    }
    if (plan_.empty()) {
      const ScriptStep& next = script_.steps[next_++];
      line_ = next.line;
      std::visit([this](const auto& action) { plan(action); }, next.action);
    }
    const Result<Rest> rest = plan_.front()();
    if (!rest) {
      release_everything();
      const std::string place = fmt::format("{}:{}", script_.subject, line_);
      progress_ = {ScriptProgress::State::failed, Error{rest.error().kind, place, rest.error().message()}};
      break;
    }
    if (*rest == Rest::again) break;
    plan_.pop_front();
    if (*rest == Rest::frame) break;
  }
  return progress_;
}

void ScriptRunner::then_do(std::function<Status()> work) {
  then([work = std::move(work)]() -> Result<Rest> {
    Status done = work();
    if (!done) return done.error();
    return Rest::frame;
  });
}

void ScriptRunner::then_click(int button, bool never_double) {
  for (const bool is_down : {true, false}) then_button(button, is_down, never_double);
}

void ScriptRunner::then_button(int button, bool is_down, bool never_double) {
  then_do([this, button, is_down, never_double] {
    target_.input().push(MouseButton{button, is_down, modifiers(), never_double});
    return success();
  });
}

void ScriptRunner::then_settle(int frames) {
  then([frames]() mutable -> Result<Rest> { return frames-- > 0 ? Rest::again : Rest::nothing; });
}

void ScriptRunner::then_wait(std::string what, std::function<Result<bool>()> is_done) {
  then([this, what = std::move(what), is_done = std::move(is_done),
        begin = std::optional<double>()]() mutable -> Result<Rest> {
    if (!begin) begin = seconds_();
    const Result<bool> done = is_done();
    if (!done) return done.error();
    if (*done) return Rest::nothing;
    if (seconds_() - *begin < k_longest_wait) return Rest::again;
    return fault(fmt::format("{} did not end within {} s", what, k_longest_wait));
  });
}

// Moves the mouse to the widget's centre and is done in the first frame in which the widget still stands there.
void ScriptRunner::then_aim(const std::string& widget, bool must_be_enabled) {
  then([this, widget, must_be_enabled, frames = 0, is_aimed = false]() mutable -> Result<Rest> {
    const bool is_late = ++frames > k_patience;
    const view::WidgetRecord::Entry* entry = target_.widgets().find(widget);
    if (!entry) return is_late ? Result<Rest>(fault(no_such_widget(widget))) : Rest::again;
    if (must_be_enabled && !entry->reason.empty()) {
      return is_late ? Result<Rest>(fault(fmt::format("'{}' is disabled: {}", widget, entry->reason))) : Rest::again;
    }
    const ImVec2 center = entry->area.center();
    const Result<bool> scrolled = target_.bring_to_view(widget);
    if (scrolled && !*scrolled && is_aimed && same(aim_, center)) return Rest::nothing;
    if (is_late) {
      return fault(scrolled ? fmt::format("'{}' does not come to rest", widget) : scrolled.error().message());
    }
    is_aimed = scrolled && !*scrolled;
    if (is_aimed) {
      aim_ = center;
      target_.input().push(MouseMove{center});
    }
    return Rest::again;
  });
}

std::string ScriptRunner::no_such_widget(const std::string& widget) const {
  std::vector<std::string_view> names;
  for (const auto& entry : target_.widgets().entries()) names.emplace_back(entry.first);
  const std::string nearest = nearest_name(widget, names);
  return fmt::format("there is no widget '{}'; {}", widget,
                     names.empty() ? "the window shows none" : "the nearest is '" + nearest + "'");
}

void ScriptRunner::plan(const step::Open& action) {
  then_do([this, path = action.path] { return target_.open(path); });
  then_wait_until_open();
}

void ScriptRunner::plan(const step::OpenPreset& action) {
  then_do([this, name = action.name] { return target_.open_preset(name); });
  then_wait_until_open();
}

void ScriptRunner::then_wait_until_open() {
  then_wait("opening", [this]() -> Result<bool> {
    Result<bool> opening = target_.opening();
    if (!opening) return opening;
    return !*opening;
  });
}

void ScriptRunner::plan(const step::Set& action) {
  then_do([this, action] { return target_.set(*action.parameter, action.value); });
}

void ScriptRunner::plan(const step::Point& action) {
  then_aim(action.widget, action.gesture != step::Gesture::hover);
  if (action.gesture != step::Gesture::hover) then_click(action.gesture == step::Gesture::right_click ? 1 : 0);
  if (action.gesture == step::Gesture::double_click) then_click(0, false);
  then_settle(k_settle);
}

void ScriptRunner::plan(const step::ClickMap& action) {
  then([this, texel = action.texel, frames = 0]() mutable -> Result<Rest> {
    const std::optional<ImVec2> position = target_.map_position(texel);
    if (!position && ++frames <= k_patience) return Rest::again;
    if (!position) return fault(fmt::format("texel {},{} is not in view", texel.x, texel.y));
    aim_ = *position;
    target_.input().push(MouseMove{*position});
    return Rest::frame;
  });
  then_click(0);
  then_settle(k_settle);
}

void ScriptRunner::plan(const step::Drag& action) {
  then_aim(action.widget, true);
  then_button(0, true);
  for (int k = 1; k <= k_drag_steps; ++k) {
    then([this, by = action.by, k]() -> Result<Rest> {
      const double part = static_cast<double>(k) / k_drag_steps;
      const ImVec2 moved(static_cast<float>(part * by.x), static_cast<float>(part * by.y));
      target_.input().push(MouseMove{{aim_.x + moved.x, aim_.y + moved.y}});
      return Rest::frame;
    });
  }
  then_button(0, false);
  then_settle(k_settle);
}

void ScriptRunner::plan(const step::Scroll& action) {
  then_aim(action.widget, false);
  then_do([this, notches = static_cast<float>(action.notches)] {
    target_.input().push(MouseWheel{{0, notches}});
    return success();
  });
  then_settle(k_settle);
}

void ScriptRunner::plan(const step::PressKey& action) {
  if (action.gesture != step::KeyGesture::release) {
    then([this, chord = action.chord]() -> Result<Rest> {
      press(chord);
      return Rest::frame;
    });
  }
  if (action.gesture != step::KeyGesture::hold) {
    then([this, chord = action.chord]() -> Result<Rest> {
      if (std::find(held_.begin(), held_.end(), chord) == held_.end()) {
        return fault(fmt::format("{} is not held", chord_text(chord)));
      }
      release(chord);
      return Rest::frame;
    });
  }
  then_settle(k_settle);
}

void ScriptRunner::plan(const step::Type& action) {
  for (std::size_t at = 0; at < action.text.size(); at += k_characters_a_frame) {
    then([this, some = action.text.substr(at, k_characters_a_frame)]() -> Result<Rest> {
      for (const char32_t character : some) target_.input().push(Character{character});
      return Rest::frame;
    });
  }
  then_settle(k_settle);
}

// Jobs that follow from the step before begin a frame or two later, and one job may start the next.
void ScriptRunner::plan(const step::WaitForJobs& /*action*/) {
  then_settle(k_settle);
  then_wait("what is computed", [this, idle_frames = 0]() mutable -> Result<bool> {
    idle_frames = target_.jobs_idle() ? idle_frames + 1 : 0;
    return idle_frames >= k_settle;
  });
}

void ScriptRunner::plan(const step::WaitFrames& action) {
  then_settle(action.count);
}

void ScriptRunner::plan(const step::Shot& action) {
  then_settle(k_settle_picture);
  then_do([this, path = action.path] { return target_.shot(path); });
}

void ScriptRunner::plan(const step::Export& action) {
  then_settle(k_settle_picture);
  then_do([this, action] { return target_.export_to(action.what, action.path); });
}

void ScriptRunner::plan(const step::Expect& action) {
  then([this, action]() -> Result<Rest> {
    const ParameterValue value = action.parameter->get(target_.document());
    if (is_near(value, action.value, action.tolerance)) return Rest::nothing;
    return fault(fmt::format("field '{}': expected {}, is {}", action.parameter->path, value_text(action.value),
                             value_text(value)));
  });
}

void ScriptRunner::plan(const step::RunAction& action) {
  then([this, name = action.name]() -> Result<Rest> {
    const std::string reason = target_.run_action(name);
    if (!reason.empty()) return fault(fmt::format("action '{}' did not run: {}", name, reason));
    return Rest::frame;
  });
  then_settle(k_settle);
}

Modifiers ScriptRunner::modifiers() const {
  Modifiers held;
  for (const Chord& chord : held_) {
    for (const ModifierKeys& keys : k_modifiers) {
      if (chord.*keys.in_chord || chord.key == keys.left || chord.key == keys.right) held.*keys.in_event = true;
    }
    if (chord.key == Key::left_super || chord.key == Key::right_super) held.super = true;
  }
  return held;
}

// A modifier's own key goes down with the first chord that has it and up with the last.
void ScriptRunner::press(Chord chord) {
  const Modifiers before = modifiers();
  held_.push_back(chord);
  const Modifiers after = modifiers();
  for (const ModifierKeys& keys : k_modifiers) {
    if (!(chord.*keys.in_chord) || before.*keys.in_event) continue;
    target_.input().push(KeyChange{keys.left, true, after});
  }
  target_.input().push(KeyChange{chord.key, true, after});
}

void ScriptRunner::release(Chord chord) {
  const Modifiers before = modifiers();
  held_.erase(std::find(held_.begin(), held_.end(), chord));
  const Modifiers after = modifiers();
  target_.input().push(KeyChange{chord.key, false, before});
  for (const ModifierKeys& keys : k_modifiers) {
    if (!(chord.*keys.in_chord) || after.*keys.in_event) continue;
    target_.input().push(KeyChange{keys.left, false, after});
  }
}

void ScriptRunner::release_everything() {
  plan_.clear();
  while (!held_.empty()) release(held_.back());
}

}  // namespace glint::gui
