#pragma once
// The P-NDF panel: the density of normals inside the footprint by every method, side by side on one range, with their
// difference, time and error, and one crosshair through all.

#include <memory>
#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "viewers/edit.h"
#include "viewers/pndf/pndf_results.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

struct PndfInput {
  const Document& document;
  std::uint64_t revision = 0;                       ///< of the document
  std::shared_ptr<const PndfResults> results = {};  ///< null before the first
  std::string nothing_because =
      {};                  ///< why there is no picture and none is coming ("cancelled", "no map"); empty: one is
  bool cancelled = false;  ///< that reason is a person's: a button offers to compute again
  bool busy = false;       ///< something is under way that ends in pictures of the document
  std::optional<PndfMethod> computing = {};  ///< whose picture is being computed
  double progress = 0;                       ///< of that
  bool flipped = false;                      ///< the key that shows the reference everywhere is held
  std::string flip_chord = {};               ///< its name, for the hint: "R"
  bool focused = false;
  bool maximised = false;
};

struct PndfEvents {
  std::optional<Edit> edit;
  bool export_pressed = false;
  bool maximise_pressed = false;
  bool clicked = false;
  bool restart_pressed = false;  ///< the button shown where a job was cancelled
};

/// What every method says at one normal.
struct PndfReading {
  glm::dvec2 s{0, 0};
  struct Value {
    PndfMethod method;
    std::optional<double> density;  ///< none: outside the picture, or not computed yet
    std::optional<double> standard_error;
  };
  std::vector<Value> values;
  std::optional<double> reference;
};

/// What the pictures of the last frame spanned, fitted or set.
struct PndfShown {
  glm::dvec4 window{-1, 1, -1, 1};  ///< smin, smax, tmin, tmax
  glm::dvec2 densities{0, 1};       ///< at the ends of the colour bar
  double difference = 1;            ///< at the ends of its bar
};

class PndfView {
 public:
  PndfView();
  PndfView(const PndfView&) = delete;
  PndfView& operator=(const PndfView&) = delete;
  ~PndfView();

  PndfEvents draw(Ui& ui, const Rectangle& area, const PndfInput& input);

  /// At the mouse while it is over a picture, else at the normal pinned by the last click; none before that.
  [[nodiscard]] const std::optional<PndfReading>& reading() const;
  /// None before the first pictures.
  [[nodiscard]] const std::optional<PndfShown>& shown() const;
  /// The reading as lines for the clipboard: full precision, ASCII minus.
  [[nodiscard]] std::string reading_text() const;
  /// Zooms about the normal under the crosshair, else about the middle of the window: for the keyboard. One step of
  /// undo, as one notch of the wheel.
  [[nodiscard]] Edit zoomed(const Document& document, double notches) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace glint::view
