#pragma once
// What this program is and what it runs on. Main thread.

#include <string>

#include "gui/dialogs/dialog_frame.h"

namespace glint::gui {

struct AboutFacts {
  std::string version;   ///< "1.0.0"
  std::string licence;   ///< "Apache License 2.0"
  std::string machine;   ///< processor, threads, instruction set
  std::string renderer;  ///< GL_RENDERER and version
};

/// All of it in lines, for a report of a fault.
std::string about_text(const AboutFacts& facts);

/// Recorded as about, about.copy, about.accept.
class AboutDialog {
 public:
  void open() { frame_.open(); }
  [[nodiscard]] bool is_open() const { return frame_.is_open(); }
  /// Once a frame.
  void draw(view::Ui& ui, const AboutFacts& facts);

 private:
  DialogFrame frame_;
};

}  // namespace glint::gui
