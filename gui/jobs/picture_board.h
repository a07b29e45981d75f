#pragma once
// The pictures of the newest P-NDF request as they come in, between the job that computes them and the frame loop that
// shows them.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/pndf/pndf_grid.h"
#include "core/study/error_metrics.h"
#include "core/surface/surface.h"
#include "viewers/pndf/pndf_results.h"

namespace glint::gui {

/// All that determines the full picture of one method: equal identities have equal pictures.
struct PictureIdentity {
  std::shared_ptr<const NormalMap> map;  ///< held, so that its address stays its own
  std::string recipe;                    ///< of the document with this method alone, on the surface in use
  PndfGrid grid;

  friend bool operator==(const PictureIdentity&, const PictureIdentity&) = default;
};

/// Members may be called from any thread; the job alone calls begin(), the set functions and end().
class PictureBoard {
 public:
  /// What a request is called: its number never changes, the document's revision and name may.
  struct Label {
    std::uint64_t request = 0;
    std::uint64_t revision = 0;
    Document document;
  };
  /// What begins with a request: everything but its pictures.
  struct Request {
    Label label;
    std::shared_ptr<const view::SurfaceInUse> surface;
    PndfGrid grid;
    std::vector<PictureIdentity> identities;     ///< of the document's methods, in their order
    std::shared_ptr<const PndfImage> reference;  ///< if it is known already
  };

  /// The newest request, or a new label for it. Results that are those of the request so far take the label over.
  void announce(Label label);
  /// Takes over the pictures that are still right, and for the other methods keeps the old ones where they are of the
  /// same map and the same wish for a window. Published at once if any picture is right.
  void begin(Request request);

  /// The picture of a method; its revision is set here.
  void set_picture(std::size_t index, view::MethodPicture picture);
  void set_reference(std::shared_ptr<const PndfImage> reference);
  void set_errors(std::size_t index, const std::optional<PndfErrors>& errors, double reference_error,
                  std::shared_ptr<const PndfImage> reference);
  /// Of the better picture of `method`, if one is expected.
  void set_progress(PndfMethod method, double progress);
  /// No better pictures are to be expected.
  void end();

  /// What there is of the picture of the current request: none, coarse or full.
  [[nodiscard]] bool has_picture(std::size_t index) const;
  [[nodiscard]] bool has_full_picture(std::size_t index) const;
  [[nodiscard]] view::MethodPicture picture(std::size_t index) const;

  /// The newest that was published; null at first.
  [[nodiscard]] std::shared_ptr<const view::PndfResults> results() const;

 private:
  struct Slot {
    PictureIdentity identity;  // of the picture it should hold
    PictureIdentity held;      // of the picture it holds; a coarse one has that of the full one it stands for
    view::MethodPicture picture;

    [[nodiscard]] bool is_right() const { return picture.image && held == identity; }
  };

  [[nodiscard]] Slot slot_for(PictureIdentity identity, PndfMethod method, const Request& request) const;
  void publish();

  mutable std::mutex mutex_;
  Label newest_;
  Request current_;
  std::vector<Slot> slots_;
  bool has_published_ = false;  // anything of the current request
  std::shared_ptr<const view::PndfResults> published_;
};

}  // namespace glint::gui
