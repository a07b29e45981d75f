#include "core/surface/normal_map.h"

#include <cassert>
#include <utility>

namespace glint {

NormalMap::NormalMap(int width, int height, std::vector<glm::vec2> normals, Wrap wrap, bool piecewise_constant)
    : width_(width),
      height_(height),
      wrap_(wrap),
      piecewise_constant_(piecewise_constant),
      normals_(std::move(normals)) {
  assert(width >= 1 && height >= 1);
  assert(normals_.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

}  // namespace glint
