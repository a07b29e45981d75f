#pragma once
// Private to the generators: the discrete Fourier transform of a square periodic field, by kissfft, line by line so
// that it runs on all threads and can be cancelled.

#include <span>

#include <glm/vec2.hpp>

#include "core/math/parallel.h"

namespace glint {

enum class TransformDirection {
  forward,  ///< exponent -2 pi i (k x) / size
  inverse,  ///< exponent +2 pi i (k x) / size
};

/// Transforms size x size complex numbers (x real, y imaginary part; rows from the top) in place, without normalising:
/// forward and then inverse multiplies by size^2. The same bytes for any number of threads. False if cancelled.
/// A real part h_u and an imaginary part h_v make one inverse transform carry two real fields.
bool transform_in_place(std::span<glm::vec2> field, int size, TransformDirection direction, JobControl& control);

/// Radians per texel of line `index` of a spectrum, in (-pi, pi]; line size / 2 is the Nyquist line.
double wave_number(int index, int size);

}  // namespace glint
