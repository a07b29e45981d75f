#pragma once
// The one interface behind which every method stands. A surface *is* a position-normal distribution N(u, s); each
// method is a model of it, and BRDFs, the renderer, studies and panels are written once against this header.
//
// To add a method: one file pair here that derives both classes, one line in model_factory.cpp, one row in the tests'
// table of oracles.

#include <cstddef>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <glm/vec2.hpp>

#include "core/math/parallel.h"
#include "core/math/random.h"
#include "core/pndf/footprint.h"
#include "core/pndf/pndf_grid.h"
#include "core/surface/surface.h"

namespace glint {

/// D_P(s) of one footprint, with what was worth preparing once. It lives in the workspace of the thread that made it;
/// its const members may be called from several threads at once.
class FootprintPndf {
 public:
  FootprintPndf() = default;
  FootprintPndf(const FootprintPndf&) = delete;
  FootprintPndf& operator=(const FootprintPndf&) = delete;
  virtual ~FootprintPndf() = default;

  /// density[k] = D_P(s[k]), per unit of disk area; the spans have equal sizes. Never negative, NaN or infinite.
  virtual void evaluate(std::span<const glm::dvec2> s, std::span<double> density) const = 0;

  /// Says that about so many normals will be asked, before any is: what pays for them is prepared once and for all, and
  /// values then do not depend on who asks first. Without it, a footprint that several threads share may answer by
  /// other means from some query on, and values differ in their last digits from run to run: who promises equal bytes
  /// calls it.
  virtual void expect_queries(std::size_t /*count*/) const {}

  /// A projected normal drawn with density pdf(). Outside the unit disk it is an invalid normal, which contributes
  /// nothing.
  [[nodiscard]] virtual glm::dvec2 sample(RandomStream& random) const = 0;

  /// The density of sample() at s: D_P(s), unless a method says otherwise.
  [[nodiscard]] virtual double pdf(glm::dvec2 s) const {
    double density = 0;
    evaluate({&s, 1}, {&density, 1});
    return density;
  }

  /// The error this method knows of in evaluate(), without a reference.
  [[nodiscard]] virtual PndfError error() const = 0;
};

/// Memory of one thread in which models prepare footprints, reused from footprint to footprint.
class PndfWorkspace {
 public:
  PndfWorkspace() = default;
  PndfWorkspace(const PndfWorkspace&) = delete;
  PndfWorkspace& operator=(const PndfWorkspace&) = delete;
  ~PndfWorkspace() { clear(); }

  /// Constructs a prepared footprint in place of the one that was here before.
  template <class T, class... Arguments>
  T& emplace(Arguments&&... arguments) {
    static_assert(alignof(T) <= alignof(std::max_align_t));
    clear();
    if (capacity_ < sizeof(T)) {
      storage_ = std::make_unique<std::byte[]>(sizeof(T));
      capacity_ = sizeof(T);
    }
    T* made = ::new (storage_.get()) T(std::forward<Arguments>(arguments)...);
    current_ = made;
    return *made;
  }

 private:
  void clear() {
    if (current_ != nullptr) current_->~FootprintPndf();
    current_ = nullptr;
  }

  std::unique_ptr<std::byte[]> storage_;
  std::size_t capacity_ = 0;
  FootprintPndf* current_ = nullptr;
};

/// What a model says of itself.
struct PndfModelInfo {
  std::string name;       ///< of the method, as on the command line
  Interpolation surface;  ///< the surface it evaluates: errors are only compared on the same one
  std::string guarantee;  ///< one phrase for a person: how far its values can be trusted
  std::size_t bytes = 0;  ///< held beyond the normal map itself
};

/// Immutable after construction; one instance serves all threads.
class PndfModel {
 public:
  PndfModel() = default;
  PndfModel(const PndfModel&) = delete;
  PndfModel& operator=(const PndfModel&) = delete;
  virtual ~PndfModel() = default;

  [[nodiscard]] virtual PndfModelInfo info() const = 0;

  /// Prepares one footprint, which must be free of faults (footprint_fault). The result lives in `workspace` until the
  /// workspace's next use or end, and must not outlive the model. Thread-safe for different workspaces.
  virtual FootprintPndf& at(const Footprint& footprint, PndfWorkspace& workspace) const = 0;

  /// The whole P-NDF image over a grid free of faults (grid_fault), on all threads; the same bytes for any number of
  /// them. Nothing if `control` was cancelled meanwhile.
  [[nodiscard]] virtual std::optional<PndfImage> image(const Footprint& footprint, const PndfGrid& grid,
                                                       JobControl& control) const = 0;
};

/// density[k] = D_P(s[k]) on all threads; false if cancelled (then `density` is not to be used).
bool evaluate_all(const PndfModel& model, const Footprint& footprint, std::span<const glm::dvec2> s,
                  std::span<double> density, JobControl& control);

}  // namespace glint
