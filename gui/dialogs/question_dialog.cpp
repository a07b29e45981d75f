#include "gui/dialogs/question_dialog.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "gui/dialogs/file_listing.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"

namespace glint::gui {
namespace {

namespace color = view::color;
namespace size = view::size;

constexpr float k_width = 440;
constexpr float k_padding = 10;

}  // namespace

void QuestionDialog::open(Question question) {
  question_ = std::move(question);
  frame_.open();
}

std::optional<Answer> QuestionDialog::draw(view::Ui& ui) {
  if (!is_open()) return std::nullopt;
  const float pad = ui.px(k_padding);
  const float width = ui.px(k_width) - 2 * pad;
  const auto lines = view::wrapped_text(ui.fonts.text, question_.text, width);
  const float pitch = std::ceil(ui.fonts.text->FontSize) + ui.px(4);
  const float text_height = pitch * static_cast<float>(lines.size());
  const float height = ui.px(size::k_panel_header) + pad + text_height + ui.px(16) + ui.px(size::k_row) + pad;
  const std::string focus = question_.name + "." + question_.answers.back().key;
  const view::Rectangle room =
      frame_.begin(ui, {question_.name, question_.title, {k_width, std::ceil(height / ui.scale)}, focus});
  ImVec2 at{room.min.x + pad, room.min.y + pad};
  for (const std::string& line : lines) {
    view::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.text, at, color::k_text, line);
    at.y += pitch;
  }
  const view::Rectangle row{{room.min.x + pad, room.max.y - pad - ui.px(size::k_row)}, {room.max.x - pad, room.max.y}};
  const std::optional<int> pressed = dialog_buttons(ui, question_.name, row, question_.answers);
  std::optional<Answer> answer;
  if (pressed) {
    answer = Answer{question_.name, question_.answers[static_cast<std::size_t>(*pressed)].key};
    frame_.close(ui);
  }
  frame_.end(ui);
  return answer;
}

Question unsaved_changes_question(const std::string& document, const std::string& before_what,
                                  const std::string& cannot_save) {
  return {"unsaved",
          "Save the changes?",
          fmt::format("“{}” has changes that are not saved. Without saving they are lost {}.", document, before_what),
          {{"cancel", "Cancel", {"Cancel", "Goes back to the document.", {}}},
           {"discard", "Discard", {"Discard the changes", "They cannot be brought back.", {}}},
           {"save", "Save", {"Save", "Saves the preset and goes on.", cannot_save}, true}}};
}

Question delete_preset_question(const std::string& preset, const std::filesystem::path& file) {
  return {"delete_preset",
          "Delete the preset?",
          fmt::format("This removes “{}” and its file “{}” for good. The document in the window stays as it is.",
                      preset, shown_path(file.filename())),
          {{"delete", "Delete", {"Delete", "The file cannot be brought back.", {}}},
           {"cancel", "Cancel", {"Cancel", "Keeps the preset.", {}}}}};
}

}  // namespace glint::gui
