#pragma once
// The normal map panel: where on the surface the pixel looks. Pan, zoom down to texels, values at the cursor, and the
// footprint as an ellipse with handles.

#include <memory>
#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "viewers/edit.h"
#include "viewers/pndf/pndf_results.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

/// What the panel shows in one frame.
struct NormalMapInput {
  const Document& document;
  std::shared_ptr<const SurfaceInUse> surface;  ///< null before the first map is there
  std::string surface_error = {};               ///< why the document's map is not the one that is shown; empty: it is
  bool loading = false;
  double progress = 0;
  bool focused = false;
  bool maximised = false;
  std::optional<glm::dvec2> crosshair = {};  ///< the normal under it in the P-NDF panel
};

struct NormalMapEvents {
  std::optional<Edit> edit;
  bool export_pressed = false;
  bool maximise_pressed = false;
  bool clicked = false;
  bool open_pressed = false;  ///< the button of the empty panel
};

class NormalMapView {
 public:
  NormalMapView();
  NormalMapView(const NormalMapView&) = delete;
  NormalMapView& operator=(const NormalMapView&) = delete;
  ~NormalMapView();

  NormalMapEvents draw(Ui& ui, const Rectangle& area, const NormalMapInput& input);

  /// Screen position of a texel position in the last frame, whether or not it is visible; and the picture's area.
  [[nodiscard]] std::optional<ImVec2> screen_of(glm::dvec2 u) const;
  [[nodiscard]] const Rectangle& picture() const;
  /// Screen pixels a texel.
  [[nodiscard]] double zoom() const;
  /// Whether parts of the map are still shown coarsely: another frame will show more of it.
  [[nodiscard]] bool incomplete() const;
  void zoom_by(double factor);
  void show_all();        ///< the whole map
  void show_footprint();  ///< the footprint, 5 sigma and a margin
  void show_texels();     ///< so near that single texels are seen
  /// The texel under the mouse and its values as text for the clipboard; empty where there is none.
  [[nodiscard]] std::string values_at_cursor() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace glint::view
