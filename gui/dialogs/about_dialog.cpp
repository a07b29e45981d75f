#include "gui/dialogs/about_dialog.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"

namespace glint::gui {

namespace color = view::color;
namespace size = view::size;

std::string about_text(const AboutFacts& facts) {
  return fmt::format("Glintscope {}\nMachine: {}\nGraphics: {}\n", facts.version, facts.machine, facts.renderer);
}

void AboutDialog::draw(view::Ui& ui, const AboutFacts& facts) {
  if (!is_open()) return;
  const view::Rectangle room = frame_.begin(ui, {"about", "About Glintscope", {480, 232}, "about.accept"});
  const float pad = ui.px(size::k_padding);
  const view::Rectangle in{{room.min.x + pad, room.min.y + pad}, {room.max.x - pad, room.max.y - pad}};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  view::draw_text(list, ui.fonts.title, in.min, color::k_text, "Glintscope " + facts.version);
  float y = draw_sentences(ui, {in.min.x, in.min.y + ui.px(22)}, in.width(), color::k_hint,
                           "Shows the density of normals of a map inside a footprint: exactly, and by the methods "
                           "that approximate it.");
  y += ui.px(10);
  const std::array<std::pair<const char*, const std::string*>, 3> rows{
      {{"Licence", &facts.licence}, {"Machine", &facts.machine}, {"Graphics", &facts.renderer}}};
  for (const auto& [caption, value] : rows) {
    view::draw_text(list, ui.fonts.small, {in.min.x, y}, color::k_hint, caption);
    y = draw_sentences(ui, {in.min.x + ui.px(74), y}, in.width() - ui.px(74), color::k_text_2, *value) + ui.px(3);
  }
  const view::Rectangle bottom{{in.min.x, in.max.y - ui.px(size::k_row)}, in.max};
  const std::array buttons{
      DialogButton{"copy", "Copy", {"Copy", "Puts version, machine and graphics on the clipboard.", {}}},
      DialogButton{"accept", "Close", {"Close", {}, {}}, true},
  };
  const std::optional<int> pressed = dialog_buttons(ui, "about", bottom, buttons);
  if (pressed == 0) ImGui::SetClipboardText(about_text(facts).c_str());
  if (pressed == 1) frame_.close(ui);
  frame_.end(ui);
}

}  // namespace glint::gui
