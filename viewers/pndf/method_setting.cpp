#include "viewers/pndf/method_setting.h"

#include <algorithm>

#include "core/document/names.h"
#include "viewers/widgets/number_text.h"

namespace glint::view {
namespace {

std::string answer_of(const MethodPicture* picture) {
  return picture != nullptr && picture->image ? picture->image->answer.text : "";
}

std::string surface_name(const PndfResults* results) {
  if (results == nullptr || !results->surface) return "document's";
  switch (results->surface->loaded.surface.interpolation()) {
    case Interpolation::linear:
      return "linear";
    case Interpolation::constant:
      return "constant";
    case Interpolation::smooth:
      break;
  }
  return "smooth";
}

}  // namespace

const MethodPicture* picture_of(const PndfResults* results, PndfMethod method) {
  if (results == nullptr) return nullptr;
  const auto same = [&](const MethodPicture& picture) { return picture.method == method; };
  const auto found = std::find_if(results->methods.begin(), results->methods.end(), same);
  return found == results->methods.end() ? nullptr : &*found;
}

std::string setting_text(const Document& document, const PndfResults* results, PndfMethod method, bool compact) {
  if (method == PndfMethod::binning) return count_text(document.binning_samples) + (compact ? "" : " samples");
  if (method == PndfMethod::mixture) {
    const MixtureSettings& mixture = document.mixture;
    const std::string step = "h " + short_number_text(mixture.step, 3);
    const bool plain = mixture.elements == MixtureElements::corrected || compact;
    const std::string answer = answer_of(picture_of(results, method));  // the atlas, where it was looked up
    return step + (plain ? "" : ", " + std::string(choice_name(mixture.elements))) +
           (answer.empty() ? "" : ", " + answer);
  }
  if (method == PndfMethod::automatic) {
    std::string answer = answer_of(picture_of(results, method));
    if (!answer.empty()) return answer;
    return "within " + short_number_text(100 * document.automatic.tolerance, 3) + " %";
  }
  if (method == PndfMethod::lean) return compact ? "" : "one Gaussian over slopes";
  const std::string surface = surface_name(results);
  const bool in_double = document.exact_precision == ExactPrecision::double_precision;
  const std::string more = in_double && !compact ? ", double" : "";
  if (surface == "linear") return "2 triangles" + more;
  if (surface == "constant") return "constant" + more;
  return (document.exact_vertex_shift ? "32 triangles, shifted" : "32 triangles") + more;
}

}  // namespace glint::view
