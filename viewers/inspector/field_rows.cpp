#include "viewers/inspector/field_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "viewers/inspector/field_edits.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/number_text.h"
#include "viewers/widgets/theme.h"

namespace glint::view {
namespace {

constexpr std::size_t k_longest_switch = 12;  // letters of all choices, which is what a narrow column has room for
constexpr std::string_view k_no_number = "–";
constexpr float k_part_gap = 6;
constexpr float k_box = 16;

std::string named(const Parameter& parameter, std::string_view control) {
  return fmt::format("{}.{}", parameter.path, control);
}

bool is_switch(const Parameter& parameter) {
  std::size_t letters = 0;
  for (const std::string_view choice : parameter.choices) letters += choice.size();
  return parameter.choices.size() <= 4 && letters <= k_longest_switch;
}

// The box of a field that may do without its own numbers: `is_fit` where it is checked while it does.
struct WithoutBox {
  std::string_view name;
  bool is_fit;
};
std::optional<WithoutBox> without_box(const Parameter& parameter) {
  if (!parameter.instead.empty()) return WithoutBox{parameter.instead, true};
  if (!parameter.may_be_none) return std::nullopt;
  const bool is_fit = parameter.path.starts_with("view.");  // none: as the pictures need
  return WithoutBox{is_fit ? "fit" : "set", is_fit};
}

std::string_view unit_text(std::string_view unit) {
  if (unit == "degrees") return "°";
  if (unit == "texels") return "tx";
  return unit == "cells" ? unit : std::string_view();
}

std::string without_last_zeros(std::string text) {
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

// Four digits, and one behind the point at least: 0.02135, 250.5, 1024.5.
int most_digits(double value) {
  const double size = std::abs(value);
  return size >= 1e3 && size < 1e5 ? static_cast<int>(std::log10(size)) + 2 : 4;
}

// As many digits as there is room for; three where the others are zero: 0.0200, 12.0. Never rounded to fewer than
// three, nor than stand before the point: where there is no room the entry writes smaller, then cuts visibly.
std::string fitted_number(const Ui& ui, double value, float room) {
  const auto fits = [&](const std::string& text) { return text_size(ui.fonts.numbers, text).x <= room; };
  const double size = std::abs(value);
  std::string text = short_number_text(value, most_digits(value));
  if (size >= 1e-3 && size < 100 && text == short_number_text(value, 3)) {
    text = number_text(value, 3);
    if (!fits(text)) text = without_last_zeros(text);
  }
  const int least = std::max(3, size >= 1 ? static_cast<int>(std::log10(size)) + 1 : 1);
  for (int digits = most_digits(value); digits >= least && !fits(text); --digits)
    text = short_number_text(value, digits);
  return text;
}

std::string fitted_count(const Ui& ui, const Parameter& parameter, std::uint64_t count, float room) {
  constexpr std::uint64_t k_large = 10'000;
  std::string digits = fmt::format("{}", count);
  if (parameter.slider.logarithmic && count >= k_large) return count_text(count);
  if (text_size(ui.fonts.numbers, digits).x <= room) return digits;
  return fitted_number(ui, static_cast<double>(count), room);
}

float entry_room(const Ui& ui, const Rectangle& area, std::string_view unit) {
  const float unit_width = unit.empty() ? 0 : text_size(ui.fonts.small, unit).x + ui.px(4);
  return area.width() - ui.px(14) - unit_width;
}

void take_slide(FieldPage& page, const Parameter& parameter, const Slide& slide, double now) {
  Edit edit{page.document, std::string(narrow_label(parameter)), slide.finished};
  if (slide.value != now) {
    const auto value = slid_value(page.document, parameter, slide.value, slide.finished);
    if (!value || *value == parameter.get(page.document)) return;
    if (!parameter.set(edit.document, *value)) return;
  }
  page.edit = std::move(edit);
}

void take(FieldPage& page, Result<Edit> edit) {
  if (edit) page.edit = std::move(*edit);
}

// An entry that was opened where no number is and left as it was.
bool is_blank(std::string_view typed) {
  return typed.empty() || typed == k_no_number;
}

void value_entry(FieldPage& page, const Parameter& parameter, const Rectangle& area, const FieldLook& look) {
  const ParameterValue value = parameter.get(page.document);
  const Explained explained = explain_parameter(parameter, look.reason);
  const std::string name(parameter.path);
  std::optional<std::string> typed;
  if (const auto* count = std::get_if<std::uint64_t>(&value)) {
    std::string_view unit = unit_text(parameter.unit);
    if (text_size(page.ui.fonts.numbers, "1024").x > entry_room(page.ui, area, unit)) unit = {};
    const std::string shown = fitted_count(page.ui, parameter, *count, entry_room(page.ui, area, unit));
    typed = entry(page.ui, name, area, shown, unit, explained, fmt::format("{}", *count));
  } else if (const std::optional<double> number = slider_number(value)) {
    typed = number_entry(page, name, area, *number, unit_text(parameter.unit), explained);
  } else if (!look.meanwhile.empty()) {
    typed = number_entry(page, name, area, look.meanwhile.front(), unit_text(parameter.unit), explained);
  } else {
    typed = entry(page.ui, name, area, k_no_number, {}, explained);
  }
  if (typed && !is_blank(*typed)) take_typed(page, name, *typed, typed_edit(page.document, parameter, {}, 0, *typed));
}

// The box in front of the numbers; what is left of `area`.
Rectangle without_control(FieldPage& page, const Parameter& parameter, const Rectangle& area, const FieldLook& look) {
  const std::optional<WithoutBox> box = without_box(parameter);
  if (!box) return area;
  Ui& ui = page.ui;
  const ParameterValue value = parameter.get(page.document);
  const ParameterValue none =
      parameter.instead.empty() ? ParameterValue(std::monostate()) : ParameterValue(std::string(parameter.instead));
  const std::string_view label = box->is_fit ? box->name : "";
  const float label_width = label.empty() ? 0 : ui.px(8) + std::ceil(text_size(ui.fonts.text, label).x);
  const Rectangle pressed{area.min, {area.min.x + ui.px(k_box) + label_width, area.max.y}};
  const Explained explained = explain_parameter(parameter, look.reason);
  if (checkbox(ui, named(parameter, box->name), pressed, label, (value == none) == box->is_fit, explained)) {
    ParameterValue numbers = parameter.get(page.saved);
    if (numbers == none) {
      const std::vector<double>& known = look.meanwhile.empty() ? look.begin_with : look.meanwhile;
      numbers = parameter.kind == ParameterKind::numbers ? ParameterValue(known)
                                                         : ParameterValue(known.empty() ? 1.0 : known.front());
    }
    take(page, proposed(page.document, parameter, value == none ? numbers : none));
  }
  return {{pressed.max.x + ui.px(10), area.min.y}, area.max};
}

void list_entries(FieldPage& page, const Parameter& parameter, const Rectangle& area, const FieldLook& look,
                  std::size_t first, std::size_t count) {
  const ParameterValue value = parameter.get(page.document);
  const auto* own = std::get_if<std::vector<double>>(&value);
  const std::vector<double>& shown = own ? *own : look.meanwhile;
  const std::vector<double>& kept = shown.empty() ? look.begin_with : shown;  // by the entries nobody types in
  const Explained explained = explain_parameter(parameter, look.reason);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t component = first + k;
    const std::string name = named(parameter, parameter.components[component]);
    const Rectangle part = part_of(page.ui, area, k, count);
    const std::string_view unit = component < look.units.size() ? look.units[component] : unit_text(parameter.unit);
    Explained of_this = explained;
    of_this.title += fmt::format(": {}", parameter.components[component]);
    const auto typed = component < shown.size() ? number_entry(page, name, part, shown[component], unit, of_this)
                                                : entry(page.ui, name, part, k_no_number, unit, of_this);
    if (!typed || is_blank(*typed)) continue;
    take_typed(page, name, *typed, typed_edit(page.document, parameter, kept, component, *typed));
  }
}

// Entries side by side, or in pairs where they are many; behind the box "fit" where there is one and room beside it.
void list_controls(FieldPage& page, const Parameter& parameter, const Rectangle& area, const FieldLook& look) {
  const std::size_t count = parameter.components.size();
  Rectangle room = without_control(page, parameter, area, look);
  const bool has_box = room.min.x != area.min.x;
  if (count <= 3 && !(has_box && page.compact)) {
    list_entries(page, parameter, room, look, 0, count);
    return;
  }
  for (std::size_t first = 0; first < count; first += 2) {
    const Rectangle row = has_box || first > 0 ? control_area(page, take_row(page)) : area;
    list_entries(page, parameter, row, look, first, std::min<std::size_t>(2, count - first));
  }
}

void text_control(FieldPage& page, const Parameter& parameter, const Rectangle& area, const FieldLook& look) {
  const ParameterValue value = parameter.get(page.document);
  const auto& text = std::get<std::string>(value);
  const bool is_path = parameter.kind == ParameterKind::path;
  const std::string shown = is_path ? std::filesystem::path(text).filename().string() : text;
  Explained explained = explain_parameter(parameter, look.reason);
  if (is_path && !text.empty()) explained.text = text + "\n" + explained.text;
  const std::string name(parameter.path);
  const auto typed = entry(page.ui, name, area, shown, {}, explained, text, true);
  if (typed) take_typed(page, name, *typed, typed_edit(page.document, parameter, {}, 0, *typed));
}

}  // namespace

Rectangle take_row(FieldPage& page, float height, float pitch) {
  const Rectangle row{{page.left, page.y}, {page.right, page.y + page.ui.px(height)}};
  page.y += page.ui.px(pitch);
  return row;
}

void row_label(const FieldPage& page, const Rectangle& row, std::string_view label, bool enabled) {
  const ImFont* font = page.ui.fonts.text;
  const std::string shown = fitted_text(font, label, page.controls - page.left - page.ui.px(4));
  draw_text(*ImGui::GetWindowDrawList(), font, {row.min.x, row.center().y - 0.5F * font->FontSize},
            enabled ? color::k_text_2 : color::k_disabled, shown);
}

Rectangle control_area(const FieldPage& page, const Rectangle& row) {
  return {{page.controls, row.min.y}, row.max};
}

Rectangle part_of(const Ui& ui, const Rectangle& area, std::size_t k, std::size_t count) {
  const auto parts = static_cast<float>(count);
  const float width = std::floor((area.width() - (parts - 1) * ui.px(k_part_gap)) / parts);
  const float begin =
      std::round(area.min.x + static_cast<float>(k) * (area.width() - width) / std::max(1.0F, parts - 1));
  return {{begin, area.min.y}, {begin + width, area.max.y}};
}

float entry_width(const FieldPage& page) {
  return page.ui.px(page.compact ? 60.0F : 74.0F);
}

Explained explain_parameter(const Parameter& parameter, const std::string& reason) {
  Explained explained{full_label(parameter), std::string(parameter.help), reason};
  std::string allowed = parameter.allowed();
  if (const std::size_t null = allowed.find(", or null"); null != std::string::npos)
    allowed.replace(null, 9, ", or none");
  if (!parameter.unit.empty()) allowed += fmt::format(", in {}", parameter.unit);
  if (parameter.kind != ParameterKind::flag) explained.text += fmt::format("\nAllowed: {}.", allowed);
  const std::string usual = edit_text(parameter.default_value());
  if (!usual.empty()) explained.text += fmt::format(" Default: {}.", usual);
  explained.text += "\n" + sentence_text(parameter.source);
  return explained;
}

void field_row(FieldPage& page, const Parameter& parameter, const FieldLook& look) {
  const Rectangle row = take_row(page);
  const bool enabled = look.reason.empty();
  row_label(page, row, look.label.empty() ? narrow_label(parameter) : look.label, enabled);
  reset_control(page, parameter, row);
  const Rectangle area = control_area(page, row);
  switch (parameter.kind) {
    case ParameterKind::number:
    case ParameterKind::integer:
      number_controls(page, parameter, area, look);
      break;
    case ParameterKind::flag: {
      const bool on = parameter.get(page.document) == ParameterValue(true);
      if (checkbox(page.ui, parameter.path, area, on ? "on" : "off", on, explain_parameter(parameter, look.reason))) {
        take(page, proposed(page.document, parameter, !on));
      }
      break;
    }
    case ParameterKind::text:
    case ParameterKind::path:
      text_control(page, parameter, area, look);
      break;
    case ParameterKind::choice:
      choice_control(page, parameter, area, look);
      break;
    case ParameterKind::numbers:
      list_controls(page, parameter, area, look);
      break;
    case ParameterKind::choices:
      for (std::size_t k = 0; k < parameter.choices.size(); ++k) {
        const Rectangle of_choice = k == 0 ? area : control_area(page, take_row(page));
        choice_box(page, parameter, parameter.choices[k], of_choice, parameter.choices[k]);
      }
      break;
  }
}

void number_controls(FieldPage& page, const Parameter& parameter, const Rectangle& area, const FieldLook& look) {
  Ui& ui = page.ui;
  const Rectangle room = without_control(page, parameter, area, look);
  if (parameter.slider.empty()) {
    value_entry(page, parameter, room, look);
    return;
  }
  const Rectangle typed{{room.max.x - entry_width(page), room.min.y}, room.max};
  const Rectangle track{room.min, {typed.min.x - ui.px(12), room.max.y}};
  if (const std::optional<double> now = slider_number(parameter.get(page.document))) {
    const SliderRange& range = parameter.slider;
    const auto slide = slider(ui, named(parameter, "slider"), track, *now, range.lowest, range.highest,
                              range.logarithmic, explain_parameter(parameter, look.reason));
    if (slide) take_slide(page, parameter, *slide, *now);
  }
  value_entry(page, parameter, typed, look);
}

void choice_control(FieldPage& page, const Parameter& parameter, const Rectangle& area, const FieldLook& look) {
  const ParameterValue value = parameter.get(page.document);
  const auto& now = std::get<std::string>(value);
  const std::span<const std::string_view> choices = parameter.choices;
  const int chosen = static_cast<int>(std::find(choices.begin(), choices.end(), now) - choices.begin());
  const Explained explained = explain_parameter(parameter, look.reason);
  const auto picked = is_switch(parameter)
                          ? switch_of(page.ui, parameter.path, area.min, choices, choices, chosen, explained)
                          : combo(page.ui, parameter.path, area, choices, chosen, explained);
  if (!picked) return;
  take(page, proposed_choice(page.document, parameter, std::string(choices[static_cast<std::size_t>(*picked)])));
}

void choice_box(FieldPage& page, const Parameter& parameter, std::string_view choice, const Rectangle& area,
                std::string_view label) {
  const ParameterValue value = parameter.get(page.document);
  std::vector<std::string> chosen = std::get<std::vector<std::string>>(value);
  const auto at = std::find(chosen.begin(), chosen.end(), choice);
  const bool on = at != chosen.end();
  const std::string reason = on && chosen.size() == 1 ? "At least one has to stay on." : "";
  Explained explained = explain_parameter(parameter, reason);
  explained.title += fmt::format(": {}", choice);
  if (!checkbox(page.ui, named(parameter, choice), area, label, on, explained)) return;
  if (on) {
    chosen.erase(at);
  } else {
    chosen.emplace_back(choice);
  }
  take(page, proposed(page.document, parameter, chosen));
}

void reset_control(FieldPage& page, const Parameter& parameter, const Rectangle& row) {
  const ParameterValue before = parameter.get(page.saved);
  if (parameter.get(page.document) == before) return;
  const Result<Edit> edit = proposed(page.document, parameter, before);
  const Explained explained{fmt::format("Back to {}", edit_text(before)), "As it was saved.",
                            edit ? std::string() : edit.error().sentence};
  const ImVec2 center{page.right + page.ui.px(7), row.center().y};
  if (reset_arrow(page.ui, named(parameter, "reset"), center, true, explained)) take(page, edit);
}

std::optional<std::string> number_entry(FieldPage& page, std::string_view name, const Rectangle& area, double value,
                                        std::string_view unit, const Explained& explained) {
  Ui& ui = page.ui;
  const std::string whole = fitted_number(ui, value, entry_room(ui, area, {}));
  const bool has_room = text_size(ui.fonts.numbers, whole).x <= entry_room(ui, area, unit);
  if (unit != "°" && !has_room) unit = {};  // rather than digits: label and tooltip say it too
  const std::string shown = fitted_number(ui, value, entry_room(ui, area, unit));
  const std::string all_digits = copy_text(value);
  if (parsed_number(shown) == value) return entry(ui, name, area, shown, unit, explained, all_digits);
  Explained exact = explained;
  exact.text = fmt::format("Now {}.\n{}", all_digits, explained.text);
  return entry(ui, name, area, shown, unit, exact, all_digits);
}

void take_typed(FieldPage& page, std::string_view entry_name, std::string_view text, Result<Edit> edit) {
  if (!edit) {
    refuse_entry(page.ui, entry_name, text, edit.error().sentence);
  } else if (!(edit->document == page.document)) {
    page.edit = std::move(*edit);
  }
}

std::vector<std::string> controls_of(const Parameter& parameter) {
  const std::string path(parameter.path);
  std::vector<std::string> names;
  switch (parameter.kind) {
    case ParameterKind::number:
    case ParameterKind::integer:
      names.push_back(path);
      if (!parameter.slider.empty() && !parameter.may_be_none) names.push_back(named(parameter, "slider"));
      break;
    case ParameterKind::flag:
    case ParameterKind::text:
    case ParameterKind::path:
      names.push_back(path);
      break;
    case ParameterKind::choice:
      if (!is_switch(parameter)) return {path};
      [[fallthrough]];
    case ParameterKind::choices:
      for (const std::string_view choice : parameter.choices) names.push_back(named(parameter, choice));
      break;
    case ParameterKind::numbers:
      for (const std::string_view component : parameter.components) names.push_back(named(parameter, component));
      break;
  }
  if (const std::optional<WithoutBox> box = without_box(parameter)) names.push_back(named(parameter, box->name));
  return names;
}

}  // namespace glint::view
