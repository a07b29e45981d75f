#pragma once
// The memory of exact queries: the triangles that each normal of a batch found, by field, and their rays.

#include <array>
#include <cstddef>
#include <vector>

#include "core/pndf/exact_query.h"

namespace glint {

/// A normal as the sum of two floats: normals near it are subtracted without loss.
struct QueryNormal {
  std::array<float, 2> high{};
  std::array<float, 2> low{};

  QueryNormal() = default;
  explicit QueryNormal(glm::dvec2 s)
      : high{static_cast<float>(s.x), static_cast<float>(s.y)},
        low{static_cast<float>(s.x - high[0]), static_cast<float>(s.y - high[1])} {}
};

/// Things by field, for vectors of them.
template <std::size_t fields_each>
struct FieldList {
  static constexpr std::size_t k_fields = fields_each;
  std::array<std::vector<float>, k_fields> fields;
  std::size_t count = 0;

  /// Room for so many more.
  void reserve(std::size_t more) {
    if (fields[0].size() >= count + more) return;
    for (std::vector<float>& field : fields) field.resize(2 * (count + more));
  }
};

/// Triangles with their right angle first and both legs positive: those whose legs are negative are mirrored at the
/// footprint's centre, which changes no integral. Offset of the right angle from the centre, then the normals at the
/// right angle and at the ends of the legs along u and v, less QueryNormal::high.
using TriangleList = FieldList<8>;
/// Whitened triangles: r11, r12, r22, the right angle, the residual.
using WhiteList = FieldList<6>;
/// Rays of whitened triangles: apex, start of the edge, the edge, residual, factor, nodes wanted.
using RayList = FieldList<9>;

/// Of triangles that are too long for single precision: their part of D_P at the normal that they are relative to, of
/// which `low` is still to be taken.
double sum_in_double(const QueryFrame& frame, const TriangleList& triangles, float leg,
                     const std::array<float, 2>& low);

struct QueryScratch::Arrays {
  std::array<TriangleList, k_query_batch> triangles;
  TriangleList long_triangles;  ///< for double precision
  WhiteList short_triangles;
  RayList few_rays;  ///< of triangles that need few
  RayList many_rays;
};

}  // namespace glint
