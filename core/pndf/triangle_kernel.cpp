#include "core/pndf/triangle_kernel.h"

#include <cmath>
#include <numbers>
#include <numeric>

namespace glint {
namespace {

template <std::size_t N>
double dot(const std::array<double, N>& a, const std::array<double, N>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// The reflector v with (I - v v^T) x = (alpha, 0, …): alpha is returned, its sign opposite to x's first entry, so that
// nothing cancels. v = 0 for x = 0.
template <std::size_t N>
double reflector(const std::array<double, N>& x, std::array<double, N>& v) {
  const double norm = std::sqrt(dot(x, x));
  v = x;
  if (norm == 0) return 0;
  const double alpha = x[0] >= 0 ? -norm : norm;
  v[0] -= alpha;
  const double scale = std::sqrt(2 / dot(v, v));
  for (double& entry : v) entry *= scale;
  return alpha;
}

template <std::size_t N>
void reflect(const std::array<double, N>& v, std::array<double, N>& x) {
  const double projection = dot(v, x);
  for (std::size_t k = 0; k < N; ++k) x[k] -= projection * v[k];
}

}  // namespace

TriangleKernel::TriangleKernel(const SurfaceTriangle& triangle, const Whitening& whitening, glm::dvec2 roughness)
    : roughness_(roughness), corner_normal_(triangle.normals[0]), whitened_corner_(whitening.apply(triangle.corner)) {
  const auto column = [&](glm::dvec2 leg, glm::dvec2 normal) {
    const glm::dvec2 white = whitening.apply(leg);
    const glm::dvec2 change = (normal - corner_normal_) / roughness;
    return std::array<double, 4>{white.x, white.y, change.x, change.y};
  };
  const std::array<double, 4> along_u = column({triangle.du, 0}, triangle.normals[1]);
  std::array<double, 4> along_v = column({0, triangle.dv}, triangle.normals[2]);
  shape_.r11 = reflector(along_u, first_);
  reflect(first_, along_v);
  shape_.r12 = along_v[0];
  shape_.r22 = reflector(std::array<double, 3>{along_v[1], along_v[2], along_v[3]}, second_);
  factor_ = std::abs(triangle.du * triangle.dv) * whitening.determinant() /
            (4 * std::numbers::pi * std::numbers::pi * roughness.x * roughness.y);
}

double TriangleKernel::density(glm::dvec2 s, double cut) const {
  const glm::dvec2 change = (corner_normal_ - s) / roughness_;
  std::array<double, 4> offset{whitened_corner_.x, whitened_corner_.y, change.x, change.y};
  reflect(first_, offset);
  std::array<double, 3> rest{offset[1], offset[2], offset[3]};
  reflect(second_, rest);
  const double residual = rest[1] * rest[1] + rest[2] * rest[2];
  const double room = cut * cut - residual;
  if (room <= 0) return 0;
  WhitenedTriangle placed = shape_;
  placed.w0 = {offset[0], rest[0]};
  return factor_ * std::exp(-0.5 * residual) * gaussian_over_simplex(placed, std::sqrt(room));
}

double weighted_density(const SurfaceTriangle& triangle, glm::dvec2 s, glm::dvec2 roughness, double cut,
                        const std::function<double(glm::dvec2)>& weight) {
  // Only the normals are whitened: a rotation that turns the first leg's change along the x axis.
  const glm::dvec2 a = (triangle.normals[1] - triangle.normals[0]) / roughness;
  const glm::dvec2 b = (triangle.normals[2] - triangle.normals[0]) / roughness;
  const glm::dvec2 offset = (triangle.normals[0] - s) / roughness;
  const double length = std::hypot(a.x, a.y);
  const glm::dvec2 axis = length > 0 ? a / length : glm::dvec2(1, 0);
  const auto turned = [&](glm::dvec2 v) {
    return glm::dvec2{axis.x * v.x + axis.y * v.y, axis.x * v.y - axis.y * v.x};
  };
  const glm::dvec2 second = turned(b);
  const double factor = std::abs(triangle.du * triangle.dv) / (2 * std::numbers::pi * roughness.x * roughness.y);
  const double integral =
      weighted_gaussian_over_simplex({turned(offset), length, second.x, second.y}, cut, [&](glm::dvec2 simplex) {
        return weight(triangle.corner + glm::dvec2(triangle.du * simplex.x, triangle.dv * simplex.y));
      });
  return factor * integral;
}

}  // namespace glint
