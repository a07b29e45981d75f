#include "gui/jobs/precision_check.h"

#include <algorithm>
#include <utility>

#include "core/document/workspace.h"

namespace glint::gui {
namespace {

const view::MethodPicture* exact_picture(const view::PndfResults* results) {
  if (results == nullptr) return nullptr;
  const auto found = std::find_if(results->methods.begin(), results->methods.end(), [](const view::MethodPicture& p) {
    return p.method == PndfMethod::exact && p.image != nullptr;
  });
  return found == results->methods.end() ? nullptr : &*found;
}

// A picture of that cell alone, so that both average over it alike; and its value.
struct Cell {
  PndfGrid grid;
  double density;
};

std::optional<Cell> cell_of(const PndfImage& image, glm::dvec2 s) {
  const PndfGrid& grid = image.grid;
  const std::optional<glm::ivec2> at = grid.cell_at(s);
  if (!at) return std::nullopt;
  const glm::dvec2 center = grid.center(at->x, at->y);
  const glm::dvec2 half = 0.5 * grid.pitch();
  return Cell{{center.x - half.x, center.x + half.x, center.y - half.y, center.y + half.y, 1, 1},
              image.density[grid.index(at->x, at->y)]};
}

}  // namespace

const char* PrecisionCheck::reason_against(const view::PndfResults* results, glm::dvec2 s) {
  const view::MethodPicture* picture = exact_picture(results);
  if (picture == nullptr) return "There is no exact picture";
  if (results->document.exact_precision == ExactPrecision::double_precision) {
    return "The exact picture is in double precision already";
  }
  if (picture->coarse || picture->revision < results->revision) return "The exact picture is not complete";
  return picture->image->grid.cell_at(s) ? "" : "The crosshair lies outside the picture";
}

void PrecisionCheck::request(std::shared_ptr<const view::PndfResults> results, glm::dvec2 s) {
  cancel();
  job_.start([this, results = std::move(results), s](JobSteps& steps) {
    const PndfImage& image = *exact_picture(results.get())->image;
    const std::optional<Cell> cell = cell_of(image, s);
    if (!cell) return;
    Document document = results->document;
    document.exact_precision = ExactPrecision::double_precision;
    const std::unique_ptr<PndfModel> model =
        make_document_model(document, PndfMethod::exact, results->surface->loaded.surface);
    const std::optional<PndfImage> exact =
        model->image(document.footprint, cell->grid, steps.begin("Exact in double precision"));
    if (!exact) return;
    const double largest = *std::max_element(image.density.begin(), image.density.end());
    const std::lock_guard lock(mutex_);
    if (steps.cancelled()) return;
    reading_ = {cell->grid.center(0, 0), cell->density, exact->density[0], largest};
  });
}

void PrecisionCheck::cancel() {
  job_.cancel();
  const std::lock_guard lock(mutex_);
  reading_.reset();
}

std::optional<PrecisionReading> PrecisionCheck::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(reading_, std::nullopt);
}

}  // namespace glint::gui
