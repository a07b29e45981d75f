#include "core/pndf/folded_footprint.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/math/gaussian.h"

namespace glint {
namespace {

constexpr double k_least_deviation = 20;  // texels
constexpr double k_least_exponent = 45;
constexpr std::size_t k_samples = 10;  // corners per axis from which a cell's polynomial is made: -4 … 5
constexpr std::int64_t k_samples_before = 4;

using StencilRow = std::array<double, k_samples>;
using Stencil = std::array<StencilRow, CellPolynomial::k_terms>;

// Rows of weights that turn samples at -4 … 5 into the coefficients of powers of x - 1/2: Lagrange's polynomial of
// degree 9 evaluated at six Chebyshev points of the cell, then the monomials through those.
Stencil make_stencil() {
  constexpr std::size_t terms = CellPolynomial::k_terms;
  std::array<double, terms> points{};
  for (std::size_t k = 0; k < terms; ++k) {
    points[k] = 0.5 * std::cos(std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(terms));
  }
  Stencil values{};  // values[k][m]: weight of sample m in the value at point k
  for (std::size_t k = 0; k < terms; ++k) {
    for (std::size_t m = 0; m < k_samples; ++m) {
      double weight = 1;
      for (std::size_t other = 0; other < k_samples; ++other) {
        if (other == m) continue;
        const double at = points[k] + 0.5 + static_cast<double>(k_samples_before) - static_cast<double>(other);
        weight *= at / (static_cast<double>(m) - static_cast<double>(other));
      }
      values[k][m] = weight;
    }
  }
  // Newton's divided differences of the value rows, then expansion into powers.
  for (std::size_t order = 1; order < terms; ++order) {
    for (std::size_t k = terms - 1; k >= order; --k) {
      for (std::size_t m = 0; m < k_samples; ++m) {
        values[k][m] = (values[k][m] - values[k - 1][m]) / (points[k] - points[k - order]);
      }
    }
  }
  Stencil powers{};
  for (std::size_t k = terms; k-- > 0;) {  // powers = powers * (x - points[k]) + values[k]
    Stencil next{};
    for (std::size_t m = 0; m < k_samples; ++m) {
      for (std::size_t power = 0; power < terms; ++power) {
        if (power + 1 < terms) next[power + 1][m] += powers[power][m];
        next[power][m] -= points[k] * powers[power][m];
      }
      next[0][m] += values[k][m];
    }
    powers = next;
  }
  return powers;
}

const Stencil& stencil() {
  static const Stencil k_stencil = make_stencil();
  return k_stencil;
}

std::int64_t wrapped(std::int64_t k, std::int64_t size) {
  const std::int64_t remainder = k % size;
  return remainder < 0 ? remainder + size : remainder;
}

// exp(2 pi i k x) for x = (first + 0 … count - 1) / period, each from its own angle: no drift along the line.
std::vector<std::complex<double>> wave(std::int64_t k, double first, std::int64_t count) {
  std::vector<std::complex<double>> values(static_cast<std::size_t>(count));
  for (std::int64_t n = 0; n < count; ++n) {
    const double turns = static_cast<double>(k) * (first + static_cast<double>(n)) / static_cast<double>(count);
    values[static_cast<std::size_t>(n)] = std::polar(1.0, 2 * std::numbers::pi * (turns - std::round(turns)));
  }
  return values;
}

}  // namespace

double CellPolynomial::operator()(glm::dvec2 position) const {
  const double x = position.x - 0.5;
  const double y = position.y - 0.5;
  double sum = 0;
  for (std::size_t row = k_terms; row-- > 0;) {
    double line = 0;
    for (std::size_t column = k_terms; column-- > 0;) line = line * x + coefficients_[row][column];
    sum = sum * y + line;
  }
  return std::max(sum, 0.0);
}

bool FoldedFootprint::pays(const NormalMap& map, const SymmetricMatrix2& covariance, double cut) {
  if (map.wrap() == Wrap::clamp) return false;
  if (std::sqrt(eigenvalues(covariance).y) < k_least_deviation) return false;
  const double ellipse = std::numbers::pi * cut * cut * std::sqrt(determinant(covariance));
  return ellipse > 4.0 * map.width() * map.height();
}

// F(u) = 1 / (W H) sum over m of exp(-2 pi^2 k^T Sigma k) exp(2 pi i k (u - centre)), k = (m_x / W, m_y / H). The sum
// over m_y is done once per row, that over m_x once per corner; m and -m are one real term.
FoldedFootprint::FoldedFootprint(const NormalMap& map, const Footprint& footprint, double border)
    : width_(map.width()), height_(map.height()) {
  const auto w = static_cast<double>(width_);
  const auto h = static_cast<double>(height_);
  const SymmetricMatrix2& c = footprint.covariance;
  const double scale = 2 * std::numbers::pi * std::numbers::pi;
  // k^T Sigma k <= e / scale is an ellipse whose extents are those of the inverse matrix.
  const double det = determinant(c);
  const auto largest_x = static_cast<std::int64_t>(w * std::sqrt(k_least_exponent / scale * c.yy / det));
  const auto largest_y = static_cast<std::int64_t>(h * std::sqrt(k_least_exponent / scale * c.xx / det));
  corners_.assign(static_cast<std::size_t>(width_ * height_), 0.0);
  const double first_x = border - footprint.center.x;
  const double first_y = border - footprint.center.y;
  std::vector<std::vector<std::complex<double>>> waves_y;
  for (std::int64_t my = -largest_y; my <= largest_y; ++my) waves_y.push_back(wave(my, first_y, height_));
  std::vector<std::complex<double>> rows(static_cast<std::size_t>(height_));
  for (std::int64_t mx = 0; mx <= largest_x; ++mx) {
    std::fill(rows.begin(), rows.end(), 0.0);
    for (std::int64_t my = -largest_y; my <= largest_y; ++my) {
      const double kx = static_cast<double>(mx) / w;
      const double ky = static_cast<double>(my) / h;
      const double exponent = scale * (c.xx * kx * kx + 2 * c.xy * kx * ky + c.yy * ky * ky);
      if (exponent > k_least_exponent) continue;
      const double amplitude = (mx == 0 ? 1.0 : 2.0) * std::exp(-exponent) / (w * h);
      const auto& wave_y = waves_y[static_cast<std::size_t>(my + largest_y)];
      for (std::size_t j = 0; j < rows.size(); ++j) rows[j] += amplitude * wave_y[j];
    }
    const std::vector<std::complex<double>> wave_x = wave(mx, first_x, width_);
    for (std::size_t j = 0; j < rows.size(); ++j) {
      double* line = corners_.data() + j * wave_x.size();
      for (std::size_t i = 0; i < wave_x.size(); ++i) {
        line[i] += wave_x[i].real() * rows[j].real() - wave_x[i].imag() * rows[j].imag();
      }
    }
  }
  for (double& value : corners_) value = std::max(value, 0.0);  // rounding of the series where F all but vanishes
}

CellPolynomial FoldedFootprint::over_cell(std::int64_t i, std::int64_t j) const {
  const Stencil& weights = stencil();
  std::array<std::array<double, CellPolynomial::k_terms>, k_samples> lines{};
  for (std::size_t row = 0; row < k_samples; ++row) {
    const std::int64_t y = wrapped(j - k_samples_before + static_cast<std::int64_t>(row), height_);
    for (std::size_t column = 0; column < k_samples; ++column) {
      const std::int64_t x = wrapped(i - k_samples_before + static_cast<std::int64_t>(column), width_);
      const double sample = corners_[static_cast<std::size_t>(y * width_ + x)];
      for (std::size_t term = 0; term < CellPolynomial::k_terms; ++term) {
        lines[row][term] += weights[term][column] * sample;
      }
    }
  }
  CellPolynomial::Coefficients coefficients{};
  for (std::size_t row = 0; row < k_samples; ++row) {
    for (std::size_t v = 0; v < CellPolynomial::k_terms; ++v) {
      for (std::size_t u = 0; u < CellPolynomial::k_terms; ++u) coefficients[v][u] += weights[v][row] * lines[row][u];
    }
  }
  return CellPolynomial(coefficients);
}

}  // namespace glint
