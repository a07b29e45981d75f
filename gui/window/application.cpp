#include "gui/window/application.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/document/names.h"
#include "core/document/preset.h"
#include "core/math/instruction_set.h"
#include "core/study/study.h"
#include "gui/input/keyboard.h"
#include "gui/window/menu_bar.h"
#include "gui/window/status_bar.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::gui {
namespace {

using Clock = std::chrono::steady_clock;

// "avx512" as people write it.
std::string instruction_set_title() {
  const std::string name(instruction_set_name(instruction_set()));
  return name == "avx512" ? "AVX-512" : name == "avx2" ? "AVX2" : name == "sse4" ? "SSE4" : name;
}

// Its key is held, not pressed: draw() looks at it.
constexpr std::string_view k_held_action = "view.reference";

bool is_arrow(Key key) {
  return key == Key::left || key == Key::right || key == Key::up || key == Key::down;
}

}  // namespace

Result<std::unique_ptr<Application>> Application::create(view::GlContext& context, ApplicationSetup setup) {
  std::unique_ptr<Application> made(new Application(std::move(setup)));
  const double asked = made->workbench_.settings().ui_scale;
  Result<std::unique_ptr<view::Screen>> screen =
      view::Screen::create(context, asked > 0 ? static_cast<float>(asked) : made->setup_.scale);
  if (!screen) return screen.error();
  made->screen_ = std::move(*screen);
  setup_key_map(ImGui::GetIO());
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = made.get();
  io.SetClipboardTextFn = [](void* self, const char* text) {
    static_cast<Application*>(self)->setup_.set_clipboard(text);
  };
  io.GetClipboardTextFn = [](void* self) -> const char* {
    static std::string text;  // ImGui reads it before the next call
    text = static_cast<Application*>(self)->setup_.clipboard();
    return text.c_str();
  };
  add_actions(made->actions_, *made);
  const auto gl_text = [&](GLenum what) {
    return std::string(reinterpret_cast<const char*>(context.gl().GetString(what)));
  };
  made->about_ = {GLINTSCOPE_VERSION, "Apache License 2.0",
                  fmt::format("{}, {}", machine_name(), instruction_set_title()),
                  gl_text(GL_RENDERER) + ", OpenGL " + gl_text(GL_VERSION)};
  return made;
}

Application::Application(ApplicationSetup setup)
    : setup_(std::move(setup)), workbench_(setup_.places, setup_.wake), overlays_(workbench_, setup_.wake) {}

Application::~Application() = default;

void Application::start_script(Script script) {
  script_.emplace(std::move(script), *this);
  script_progress_ = ScriptProgress{};
}

void Application::frame(glm::ivec2 size, double seconds, float step) {
  const Clock::time_point begin = Clock::now();
  size_ = size;
  seconds_ = seconds;
  if (script_ && script_progress_->state == ScriptProgress::State::running) script_progress_ = script_->step();
  input_left_ = input_.feed(ImGui::GetIO());
  for (const std::filesystem::path& file : input_.take_drops()) workbench_.open(file);
  feed_keys();
  workbench_.update(seconds);
  if (wanted_scale_) screen_->set_scale(*std::exchange(wanted_scale_, std::nullopt));
  screen_->draw(size, {seconds, step, setup_.headless, overlays_.is_open()}, [&](view::Ui& ui) { draw(ui); });
  after_drawing();
  const double spent = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  frame_ms_ = frame_ms_ > 0 ? 0.9 * frame_ms_ + 0.1 * spent : spent;
}

void Application::feed_keys() {
  view::UiState& state = screen_->state();
  for (const Chord& chord : input_.key_presses()) feed_chord(chord);
  for (const Chord& chord : input_.key_repeats()) {
    if (is_arrow(chord.key) || chord.key == Key::tab) feed_chord(chord);
  }
  const bool arrow_down =
      input_.is_down(Key::left) || input_.is_down(Key::right) || input_.is_down(Key::up) || input_.is_down(Key::down);
  if (arrows_move_footprint_ && !arrow_down) {
    workbench_.editor().finish_gesture();
    arrows_move_footprint_ = false;
  }
  // What is dragged without a mouse button has lost it: the window was left, or a dialog came.
  if (!state.dragging.empty() && !ImGui::GetIO().MouseDown[0] && !ImGui::GetIO().MouseDown[1] &&
      !ImGui::GetIO().MouseDown[2] && screen_->widgets().find(state.dragging) == nullptr) {
    state.dragging.clear();
    workbench_.editor().finish_gesture();
  }
}

void Application::feed_chord(const Chord& chord) {
  view::UiState& state = screen_->state();
  const Action* action = actions_.for_chord(chord);
  if (action != nullptr && action->name == k_held_action) action = nullptr;
  const bool typing = !state.editing.empty() || ImGui::GetIO().WantTextInput;
  if (typing) {
    if (action != nullptr && action->works_while_typing) wanted_action_ = action->name;
    if (overlays_.is_open()) feed_focus(state.focus, chord);  // a list under the text that is typed
    return;
  }
  const bool in_list = overlays_.is_open() || !state.open_popup.empty();
  if (chord.key == Key::escape || chord.key == Key::tab) {
    if (action != nullptr) wanted_action_ = action->name;
  } else if (!state.focus.name.empty() || in_list) {
    if (feed_focus(state.focus, chord)) return;
    if (action != nullptr && !in_list) wanted_action_ = action->name;
  } else if (action != nullptr) {
    wanted_action_ = action->name;
  }
  if (!wanted_action_.empty()) {
    // At once, so that several keys of one frame count.
    const std::string reason = actions_.run(std::exchange(wanted_action_, {}));
    if (!reason.empty()) workbench_.messages().post({Messages::Kind::info, reason, {}});
  }
}

void Application::draw(view::Ui& ui) {
  const ImVec2 window{static_cast<float>(size_.x), static_cast<float>(size_.y)};
  const float width = std::max(window.x, k_least_width * ui.scale);
  layout_ = compute_layout(window, ui.scale, workbench_.messages().height(ui, width), workbench_.settings().splitters,
                           workbench_.settings().maximised_panel);
  mouse_shape_ = MouseShape::arrow;
  const std::string chosen = draw_menu_bar(ui, layout_.menu_bar, {actions_, workbench_.title()});
  if (!chosen.empty()) wanted_action_ = chosen;
  const std::string answered = workbench_.messages().draw(ui, layout_.messages, actions_);
  if (!answered.empty()) wanted_action_ = answered;
  const bool typing = !screen_->state().editing.empty() || ImGui::GetIO().WantTextInput;
  const bool held = input_.is_down(Key::r) && input_.modifiers() == Modifiers{} && !typing && !overlays_.is_open();
  grant(panels_.draw(ui, layout_, workbench_, flip_switch_ != held));
  draw_splitters(ui, layout_);
  draw_status(ui, layout_);
  first_overlay_widget_ = ui.widgets.order().size();
  grant(overlays_.draw(ui, actions_, about_, [this](ExportWhat what) { return export_reason(what, export_source()); }));
}

void Application::draw_splitters(view::Ui& ui, const Layout& layout) {
  for (int k = 0; k < layout.splitter_count; ++k) {
    const Splitter& splitter = layout.splitters[static_cast<std::size_t>(k)];
    const view::Press press = view::pressable(ui, splitter.name, splitter.area,
                                              {"Drag to share the room between the panels",
                                               "Arrow keys move it too; View, Reset the layout takes it back.",
                                               {}});
    view::UiState& state = ui.state;
    if (press.hovered || press.held) mouse_shape_ = MouseShape::resize_horizontal;
    const double width = layout.panels[static_cast<std::size_t>(Panel::inspector)].max.x - layout.panels[0].min.x;
    const double room = k == 0 ? layout.splitters[1].area.min.x - layout.panels[0].min.x : width;
    double moved = 0;
    if (press.held && ImGui::GetIO().MouseDelta.x != 0) moved = ImGui::GetIO().MouseDelta.x / room;
    if (press.focused && state.focus.right != 0) moved = std::exchange(state.focus.right, 0) * 8.0 * ui.scale / room;
    if (moved != 0) {
      workbench_.settings().splitters[splitter.name] =
          std::clamp(splitter.ratio + moved, splitter.lowest, std::max(splitter.lowest, splitter.highest));
    }
    if (!press.hovered && !press.held && !press.focused) continue;
    const ImU32 ink = press.held || press.focused ? view::color::k_accent : view::rgb(0xF2953C, 153);
    const float x = splitter.area.center().x;
    ImGui::GetWindowDrawList()->AddRectFilled({x - ui.px(1), splitter.area.min.y}, {x + ui.px(1), splitter.area.max.y},
                                              ink);
  }
}

void Application::draw_status(view::Ui& ui, const Layout& layout) {
  StatusInput status;
  status.job = workbench_.jobs().status();
  status.cancelled = workbench_.jobs().cancelled();
  if (const auto results = workbench_.jobs().results()) {
    for (const view::MethodPicture& picture : results->methods) {
      const bool known = picture.image && !picture.coarse;
      status.times.push_back({picture.method, known ? std::optional(picture.milliseconds) : std::nullopt});
    }
  }
  status.frame_ms = frame_ms_;
  status.machine = fmt::format("{} threads, {}", thread_count(), instruction_set_title());
  if (const Message* newest = workbench_.messages().newest()) status.note = newest->text;
  if (draw_status_bar(ui, layout.status_bar, status).cancel) workbench_.jobs().cancel();
}

void Application::grant(PanelWishes wishes) {
  if (wishes.maximise) toggle_maximised(*wishes.maximise);
  if (wishes.export_of) export_panel(*wishes.export_of);
  if (wishes.preset) {
    if (const Status opened = workbench_.open_preset(*wishes.preset); !opened) {
      workbench_.messages().post_error(opened.error());
    }
  }
  if (wishes.open) wanted_action_ = "file.open";
  if (wishes.browse_map) wanted_action_ = "file.open";
  if (wishes.save) wanted_action_ = "file.save";
  if (wishes.save_as) wanted_action_ = "file.save_as";
  if (wishes.revert) wanted_action_ = "edit.revert";
  if (wishes.reload) wanted_action_ = "file.reload";
  if (wishes.restart) wanted_action_ = "compute.restart";
}

void Application::grant(OverlayWishes wishes) {
  if (!wishes.action.empty()) wanted_action_ = wishes.action;
  if (!wishes.field.empty()) go_to_field(wishes.field);
  if (wishes.export_order) exports_.push_back(*std::move(wishes.export_order));
  if (wishes.end) ended_ = true;
}

void Application::after_drawing() {
  const bool exports_due = !exports_.empty() && !overlays_.is_open();
  if (script_ || exports_due) pixels_ = screen_->pixels();
  if (exports_due) {
    for (const ExportOrder& order : std::exchange(exports_, {})) {
      workbench_.report(write_export(order, export_source()), "Wrote " + order.path.string() + ".");
    }
  }
  if (!wanted_action_.empty()) {
    const std::string reason = actions_.run(std::exchange(wanted_action_, {}));
    if (!reason.empty()) workbench_.messages().post({Messages::Kind::info, reason, {}});
  }
  if (!end_requested_) return;
  end_requested_ = false;
  if (workbench_.editor().is_saved() || setup_.headless) {
    ended_ = true;
  } else {
    overlays_.ask_unsaved();
  }
}

Application::Pace Application::pace() const {
  const view::UiState& state = screen_->state();
  const bool script = script_progress_ && script_progress_->state == ScriptProgress::State::running;
  const bool tooltip_due = !state.hovered.empty() && seconds_ - state.hovered_since < 0.7;
  if (input_left_ || script || panels_.incomplete(document()) || !state.dragging.empty() || !state.editing.empty() ||
      !exports_.empty() || tooltip_due) {
    return Pace::at_once;
  }
  const bool quiet = workbench_.jobs().idle() && overlays_.idle() && !workbench_.autosave_waits();
  return quiet ? Pace::on_event : Pace::soon;
}

void Application::request_end() {
  end_requested_ = true;
}

Status Application::open(const std::filesystem::path& path) {
  workbench_.open(path);
  return success();
}

Status Application::open_preset(const std::string& name) {
  return workbench_.open_preset(name);
}

Status Application::set(const Parameter& parameter, const ParameterValue& value) {
  Document changed = document();
  if (Status done = parameter.set(changed, value); !done) return done;
  return workbench_.editor().apply(
      {std::move(changed), fmt::format("{} to {}", parameter.label, value_text(value)), true});
}

Result<bool> Application::bring_to_view(const std::string& widget) {
  const view::WidgetRecord::Entry* entry = widgets().find(widget);
  const view::Rectangle& room = layout_.panels[static_cast<std::size_t>(Panel::inspector)];
  // Only the Inspector scrolls.
  if (entry == nullptr || room.width() <= 0) return false;
  const ImVec2 center = entry->area.center();
  const float below_header = room.min.y + view::size::k_panel_header * screen_->scale();
  const bool in_column = center.x >= room.min.x && center.x < room.max.x;
  if (!in_column || (center.y > below_header && center.y < room.max.y)) return false;
  return panels_.inspector().bring_to_view(widget);
}

std::optional<ImVec2> Application::map_position(glm::dvec2 texel) const {
  const std::optional<ImVec2> at = panels_.map().screen_of(texel);
  return at && panels_.map().picture().contains(*at) ? at : std::nullopt;
}

Status Application::shot(const std::filesystem::path& path) {
  return export_to("window", path);
}

ExportSource Application::export_source() const {
  return {workbench_, layout_, pixels_, size_, panels_.pndf().reading()};
}

Status Application::export_to(const std::string& what, const std::filesystem::path& path) {
  if (what == "document") return save_preset(path, document());
  const Result<ExportWhat> kind = export_named(what);
  if (!kind) return kind.error();
  if (pixels_.empty()) pixels_ = screen_->pixels();
  return write_export({*kind, path}, export_source());
}

std::string Application::run_action(const std::string& name) {
  return actions_.run(name);
}

}  // namespace glint::gui
