#pragma once
// The Inspector: every parameter of the document, made from the declarations in core/document/parameter.h, what the
// reader reported of the map, and the values under the cursor.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "viewers/edit.h"
#include "viewers/pndf/pndf_results.h"
#include "viewers/pndf/pndf_view.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

/// What "fit" comes to now, where that is known: shown in the entries, and kept when a person takes over from there.
struct FittedRanges {
  std::optional<glm::dvec4> window;     ///< smin, smax, tmin, tmax of the pictures' grid
  std::optional<glm::dvec2> densities;  ///< at the ends of the colour bar
  std::optional<double> difference;
};

struct InspectorInput {
  const Document& document;
  const Document& saved;  ///< what "reset" and "modified" compare with
  bool is_saved = true;
  std::shared_ptr<const SurfaceInUse> surface = {};  ///< null before the first
  std::string surface_error = {};                    ///< why the document's map is not the one in use; empty: it is
  std::vector<std::string> presets = {};             ///< names to choose from
  const std::optional<PndfReading>* reading = nullptr;
  std::shared_ptr<const PndfResults> results = {};  ///< whose findings stand under their methods
  FittedRanges fitted = {};
  const std::map<std::string, bool>* open_sections = nullptr;  ///< remembered ones; what is missing has its default
  bool focused = false;
  bool maximised = false;
};

struct InspectorEvents {
  std::optional<Edit> edit;
  std::optional<std::string> preset;  ///< chosen by name
  bool browse_pressed = false;        ///< choose a file for the map; surface.source is to become "file" with it
  bool save_pressed = false;
  bool save_as_pressed = false;
  bool revert_pressed = false;
  bool reload_pressed = false;
  bool maximise_pressed = false;
  bool export_pressed = false;
  bool clicked = false;
  std::optional<std::pair<std::string, bool>> section;  ///< one was opened or closed
};

class Inspector {
 public:
  InspectorEvents draw(Ui& ui, const Rectangle& area, const InspectorInput& input);
  /// Makes the control of that name visible: the next frame opens its section and scrolls, the one after it shows it.
  /// False if there is none for the document of the last frame.
  bool bring_to_view(const std::string& name);

 private:
  [[nodiscard]] bool is_open(const std::string& section, const InspectorInput& input) const;
  // What fits into the panel is open, the most important sections first; decided once for a size, so that nothing
  // jumps.
  void decide_what_is_open(const Ui& ui, const Rectangle& content, bool compact, const InspectorInput& input);

  std::optional<Document> document_;  // of the last frame
  std::string wanted_;                // name of a control to bring to view
  int frames_for_wanted_ = 0;         // that are left for it to appear
  std::map<std::string, bool> open_by_default_;
  ImVec2 decided_for_{0, 0};
};

}  // namespace glint::view
