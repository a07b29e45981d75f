#pragma once
// How a texture is turned into colours, for every picture of one frame. An ImTextureID of this program points at one of
// these; they live until the frame was drawn.

#include <deque>
#include <imgui.h>

#include "viewers/gl/texture.h"

namespace glint::view {

/// How the values of a texture become colours on screen.
struct Shading {
  enum class Kind {
    color,       ///< red, green, blue, alpha as they are
    coverage,    ///< one channel: the alpha of the vertex colour (letters)
    density,     ///< one channel of densities: viridis over [lo, hi], under- and overflow in colours of their own
    difference,  ///< one channel, signed: the difference map over [-hi, hi], symmetric-logarithmic above `lo` if
                 ///< `logarithmic`, else linear
  };
  Kind kind = Kind::color;
  float lo = 0;
  float hi = 1;
  bool logarithmic = false;
  bool nearest = false;  ///< cells as squares; else linear filtering of the values, before they become colours
};

struct FramePicture {
  const Texture* texture = nullptr;
  Shading shading;
};

/// The pictures of one frame; addresses stay valid until clear().
class FramePictures {
 public:
  ImTextureID add(const Texture& texture, const Shading& shading) {
    pictures_.push_back({&texture, shading});
    return &pictures_.back();
  }
  void clear() { pictures_.clear(); }

 private:
  std::deque<FramePicture> pictures_;
};

}  // namespace glint::view
