#include "gui/window/status_bar.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/document/names.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/number_text.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::gui {
namespace {

namespace color = view::color;
using view::Rectangle;
using view::text_size;
using view::Ui;

std::string capitalised(std::string_view text) {
  std::string changed(text);
  if (!changed.empty() && changed[0] >= 'a' && changed[0] <= 'z') changed[0] = static_cast<char>(changed[0] - 32);
  return changed;
}

// "9 s left" in its two parts: a figure and small words.
view::Quantity time_left(double seconds) {
  if (seconds < 59.5) return {fmt::format("{:.0f}", std::max(1.0, std::round(seconds))), "s left"};
  return {fmt::format("{:.0f}", std::min(99.0, std::round(seconds / 60))), "min left"};
}

// What stands in the bar from left to right, and how wide each part is.
struct Layout {
  float job_text = 0;   // room of the job's words
  float time_left = 0;  // room of "59 min left"
  float cancel = 0;     // the button
  float job = 0;        // all of the job, the same whether or not one runs
  float value = 0;      // room of a figure: "1.07"
  float time = 0;       // one method's time with its unit, without its name
  bool names = true;    // of the methods
  bool frame = true;
  bool machine = true;
};

float name_width(const Ui& ui, PndfMethod method) {
  return std::ceil(text_size(ui.fonts.text, method_title(method)).x) + ui.px(7);
}

float frame_width(const Ui& ui, const Layout& layout) {
  return layout.value + ui.px(4) + std::ceil(text_size(ui.fonts.small, "ms a frame").x);
}

float width_of(const Ui& ui, const Layout& layout, const StatusInput& input) {
  const float separator = ui.px(25);
  float width = ui.px(10) + layout.job;
  if (!input.times.empty()) width += separator - ui.px(14);
  for (const StatusTime& time : input.times) {
    width += layout.time + ui.px(14) + (layout.names ? name_width(ui, time.method) : 0);
  }
  if (layout.frame) width += separator + frame_width(ui, layout);
  if (layout.machine) width += separator + text_size(ui.fonts.small, input.machine).x;
  return width;
}

Layout layout_for(const Ui& ui, const Rectangle& area, const StatusInput& input) {
  Layout layout;
  layout.job_text = ui.px(area.width() < ui.px(1500) ? 128 : 176);
  layout.time_left =
      std::ceil(text_size(ui.fonts.numbers, "59").x + text_size(ui.fonts.small, "min left").x) + ui.px(4);
  layout.cancel = view::button_width(ui, "Cancel");
  layout.job = layout.job_text + ui.px(120) + layout.time_left + layout.cancel + 3 * ui.px(10);
  layout.value = std::ceil(text_size(ui.fonts.numbers, "1.07").x);
  layout.time = ui.px(15) + layout.value + ui.px(4) + std::ceil(text_size(ui.fonts.small, "ms").x);
  layout.machine = !input.machine.empty();
  const float room = area.width() - ui.px(250);  // the note keeps so much
  if (width_of(ui, layout, input) > room) layout.names = false;
  if (width_of(ui, layout, input) > room) layout.machine = false;
  if (width_of(ui, layout, input) > room) layout.frame = false;
  return layout;
}

// Draws from left to right in the middle of the bar.
class Pen {
 public:
  Pen(const Ui& ui, const Rectangle& bar) : ui_(ui), list_(*ImGui::GetWindowDrawList()), bar_(bar) {
    x = bar.min.x + ui.px(10);
    middle = std::floor(0.5F * (bar.min.y + 1 + bar.max.y));
  }

  void text(const ImFont* font, ImU32 ink, std::string_view words) {
    view::draw_text(list_, font, {x, middle - 0.5F * font->FontSize}, ink, words);
    x += std::ceil(text_size(font, words).x);
  }
  /// Its unit follows.
  void figure(ImU32 ink, std::string_view words) {
    text(ui_.fonts.numbers, ink, words);
    x += ui_.px(4);
  }
  void separator() {
    x += ui_.px(12);
    list_.AddRectFilled({x, middle - ui_.px(6)}, {x + 1, middle + ui_.px(7)}, color::k_border_strong);
    x += ui_.px(13);
  }
  [[nodiscard]] Rectangle row(float left, float right) const { return {{left, bar_.min.y}, {right, bar_.max.y}}; }

  float x = 0;
  float middle = 0;

 private:
  const Ui& ui_;
  ImDrawList& list_;
  Rectangle bar_;
};

bool draw_job(Ui& ui, Pen& pen, const Layout& layout, const StatusInput& input) {
  const float left = pen.x;
  const std::string words = input.job.busy ? capitalised(input.job.text) : input.cancelled ? "Cancelled" : "Ready";
  const float room = input.job.busy ? layout.job_text : layout.job;
  const std::string shown = view::fitted_text(ui.fonts.text, words, room);
  pen.text(ui.fonts.text, input.job.busy ? color::k_text : color::k_text_2, shown);
  const Rectangle whole = pen.row(left, left + layout.job);
  ui.widgets.record("status.job", {whole, {}, false, true});
  bool cancel = false;
  if (input.job.busy) {
    if (shown != words) view::explain(ui, "status.job.text", pen.row(left, left + room), {words, {}, {}});
    pen.x = left + layout.job_text + ui.px(10);
    const float half = ui.px(3);
    view::progress_bar(ui, {{pen.x, pen.middle - half}, {pen.x + ui.px(120), pen.middle + half}}, input.job.progress);
    pen.x += ui.px(130);
    if (input.job.seconds_left) {
      const view::Quantity time = time_left(*input.job.seconds_left);
      pen.figure(color::k_text, time.value);
      pen.text(ui.fonts.small, color::k_text_2, time.unit);
    }
    const float button = left + layout.job - layout.cancel;
    cancel = view::button(ui, "status.cancel",
                          {{button, pen.middle - ui.px(10)}, {button + layout.cancel, pen.middle + ui.px(10)}},
                          "Cancel", {"Cancel", "Ends what is being computed. Pictures that are finished stay.", {}});
  }
  pen.x = left + layout.job;
  return cancel;
}

void draw_time(Ui& ui, Pen& pen, const Layout& layout, const StatusTime& time) {
  const float left = pen.x;
  view::draw_mark(*ImGui::GetWindowDrawList(), time.method, {pen.x + ui.px(5), pen.middle}, ui.px(4));
  pen.x += ui.px(15);
  const std::string name(method_title(time.method));
  if (layout.names) {
    pen.text(ui.fonts.text, color::k_text_2, name);
    pen.x = left + ui.px(15) + name_width(ui, time.method);
  }
  const float end = pen.x + layout.time - ui.px(15);
  std::string read = "no picture yet";
  if (time.ms) {
    const view::Quantity quantity = view::time_text(*time.ms);
    pen.figure(color::k_text, quantity.value);
    pen.text(ui.fonts.small, color::k_text_2, quantity.unit);
    read = "the picture took " + quantity.value + " " + quantity.unit;
  } else {
    pen.text(ui.fonts.numbers, color::k_hint, "…");
  }
  pen.x = std::max(pen.x, end);
  const std::string record = fmt::format("status.time.{}", choice_name(time.method));
  ui.widgets.record(record, {pen.row(left, pen.x), {}, false, true});
  view::explain(ui, record, pen.row(left, pen.x), {name, capitalised(read) + ".", {}});
  pen.x += ui.px(14);
}

void draw_frame_time(Ui& ui, Pen& pen, const Layout& layout, double frame_ms) {
  const float left = pen.x;
  const float end = left + frame_width(ui, layout);
  const std::string figure = frame_ms <= 0 ? "…" : fmt::format("{:.0f}", std::clamp(frame_ms, 1.0, 9999.0));
  pen.figure(frame_ms <= 0 ? color::k_hint : color::k_text, figure);
  pen.text(ui.fonts.small, color::k_text_2, "ms a frame");
  pen.x = end;
  ui.widgets.record("status.frame", {pen.row(left, end), {}, false, true});
  view::explain(ui, "status.frame", pen.row(left, end), {"Time of one frame", "What drawing the window takes.", {}});
}

void draw_note(Ui& ui, Pen& pen, const Rectangle& bar, const std::string& note) {
  const ImFont* font = ui.fonts.small;
  const float right = bar.max.x - ui.px(10);
  const float left = pen.x + ui.px(24);
  if (note.empty() || right - left < ui.px(40)) return;
  const std::string shown = view::fitted_text(font, note, right - left);
  pen.x = right - text_size(font, shown).x;
  const Rectangle area = pen.row(pen.x, right);
  pen.text(font, color::k_text_2, shown);
  ui.widgets.record("status.note", {area, {}, false, false});
  if (shown != note) view::explain(ui, "status.note", area, {{}, note, {}});
}

}  // namespace

StatusEvents draw_status_bar(Ui& ui, const Rectangle& area, const StatusInput& input) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(area.min, area.max, color::k_bar);
  list.AddRectFilled(area.min, {area.max.x, area.min.y + 1}, color::k_border);
  const Layout layout = layout_for(ui, area, input);
  Pen pen(ui, area);
  StatusEvents events;
  events.cancel = draw_job(ui, pen, layout, input);
  if (!input.times.empty()) {
    pen.separator();
    for (const StatusTime& time : input.times) draw_time(ui, pen, layout, time);
    pen.x -= ui.px(14);
  }
  if (layout.frame) {
    pen.separator();
    draw_frame_time(ui, pen, layout, input.frame_ms);
  }
  if (layout.machine) {
    pen.separator();
    const float left = pen.x;
    pen.text(ui.fonts.small, color::k_text_2, input.machine);
    ui.widgets.record("status.machine", {pen.row(left, pen.x), {}, false, true});
    view::explain(ui, "status.machine", pen.row(left, pen.x),
                  {"This computer", "What the times were measured with: threads and instruction set.", {}});
  }
  draw_note(ui, pen, area, input.note);
  return events;
}

}  // namespace glint::gui
