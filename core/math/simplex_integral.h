#pragma once
// The integral of a standard 2D Gaussian over a triangle, the heart of exact evaluation. Double precision; all terms
// are positive, so nothing cancels however thin, small, large or far away the triangle is.

#include <functional>

#include <glm/vec2.hpp>

namespace glint {

/// A triangle in whitened coordinates, as a QR factorisation leaves it: w(x, y) = w0 + x (r11, 0) + y (r12, r22) over
/// the unit simplex x >= 0, y >= 0, x + y <= 1. May be degenerate.
struct WhitenedTriangle {
  glm::dvec2 w0;
  double r11;
  double r12;
  double r22;
};

/// The integral over the unit simplex (of area 1/2) of exp(-|w|^2 / 2). What lies at |w| >= cut may be left out; within
/// the cut the relative error is below 1e-10 while the triangle is within 35 of the origin; beyond that it underflows
/// to zero. Never negative or NaN.
double gaussian_over_simplex(const WhitenedTriangle& triangle, double cut = 40);

/// The same with a weight inside the integral: a function of the simplex coordinates so smooth that a polynomial of
/// degree 4 stands for it along any line of the triangle. Slower.
double weighted_gaussian_over_simplex(const WhitenedTriangle& triangle, double cut,
                                      const std::function<double(glm::dvec2)>& weight);

/// How many Gauss points an interval of this length (in standard deviations) needs so that exp(-x^2 / 2) over it is
/// integrated to 1e-12 of its value; `reach` is the largest |x| on it. Zero where no tabulated rule is enough.
int gauss_points(double length, double reach);

}  // namespace glint
