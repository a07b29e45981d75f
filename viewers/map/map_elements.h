#pragma once
// Which elements of the mixture the map shows, and how bright: what makes up the P-NDF, or what lights up for one half
// vector. No drawing; texels throughout.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "core/pndf/mixture_elements.h"
#include "viewers/pndf/pndf_results.h"

namespace glint::view {

/// What is to be shown. The footprint's centre is where its rings are drawn.
struct ElementRequest {
  std::shared_ptr<const SurfaceInUse> surface;
  MixtureSettings mixture;
  double intrinsic_roughness = 0;
  Footprint footprint;
  std::optional<glm::dvec2> crosshair;  ///< the normal whose density is to be explained; none: weights are shown
  PlaneRectangle part;                  ///< of the map, in view
  double pixels_per_texel = 1;          ///< of the screen at scale 1

  friend bool operator==(const ElementRequest& a, const ElementRequest& b);
};

struct ShownElement {
  glm::dvec2 seed;  ///< texels
  float share;      ///< of the largest, 0 to 1
};

struct ShownElements {
  std::vector<ShownElement> elements = {};  ///< the brightest last; at most k_most
  std::vector<ElementPart> parts = {};      ///< of the brightest, in their order: where their density lies; may be none
  double largest = 0;                       ///< weight, or density at the crosshair, of the one with share 1
  bool by_density = false;                  ///< shares of the density at the crosshair, not of weight
  std::size_t left_out = 0;                 ///< in view beyond k_most: those with the least shares
  double radius = 0;                        ///< sigma_h, texels
  std::string_view instead = {};            ///< why there are none, for a person; empty: there are

  static constexpr std::size_t k_most = 20'000;
};

/// Keeps what it found until something else is asked for.
class MapElements {
 public:
  static constexpr double k_least_spacing = 3;     ///< pixels between elements: nearer ones cannot be told apart
  static constexpr double k_part_spacing = 9;      ///< pixels between elements from which on their parts are seen
  static constexpr double k_least_lit = 0.01;      ///< of the largest density: darker ones have no parts to show
  static constexpr double k_least_share = 1e-3;    ///< an element below that in weight and in density is left out
  static constexpr double k_most_kept = 50'000;    ///< a footprint of more elements keeps those in view only
  static constexpr double k_most_visited = 7.5e5;  ///< seeds, or texels between them: what a frame has time for

  const ShownElements& at(const ElementRequest& request);

 private:
  void gather(const ElementRequest& request);
  void choose(const ElementRequest& request);
  void divide(const ElementRequest& request);
  [[nodiscard]] double spacing(const ElementRequest& request) const;

  std::optional<ElementRequest> request_;
  std::optional<MixtureFrame> frame_;  // on the map of that
  bool whole_ = false;                 // all elements of the footprint are kept, not only those in view
  std::vector<MixtureElement> elements_;
  double heaviest_ = 0;
  std::vector<double> densities_;
  std::vector<std::pair<double, std::size_t>> order_;  // shares of those in view, ascending
  std::string_view instead_;
  ShownElements shown_;
};

/// Why a document has no elements to show, half a sentence for a person; empty: it has.
std::string reason_without_elements(const Document& document);

}  // namespace glint::view
