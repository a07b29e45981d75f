#include "core/math/random.h"

#include <bit>
#include <cmath>
#include <numbers>

#include <pcg_random.hpp>

namespace glint {
namespace {

using State = std::array<std::uint64_t, 2>;
static_assert(sizeof(pcg32) == sizeof(State));

double uniform_of(pcg32& generator) {
  const std::uint64_t high = generator();
  const std::uint64_t bits = (high << 32U) | generator();
  return (static_cast<double>(bits >> 12U) + 0.5) * 0x1p-52;  // 52 bits and a half: never 0, never 1
}

// The finaliser of SplitMix64. Fed as they are, neighbouring seeds or streams give PCG states that differ by a known
// amount, and the first numbers of many streams then form a lattice: seen in tests as far too even a histogram.
std::uint64_t scrambled(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15U;
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
  return bits ^ (bits >> 31U);
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream)
    : state_(std::bit_cast<State>(pcg32(scrambled(seed ^ scrambled(stream)), scrambled(~stream)))) {}

std::uint32_t RandomStream::next_bits() {
  auto generator = std::bit_cast<pcg32>(state_);
  const std::uint32_t bits = generator();
  state_ = std::bit_cast<State>(generator);
  return bits;
}

double RandomStream::next_uniform() {
  auto generator = std::bit_cast<pcg32>(state_);
  const double value = uniform_of(generator);
  state_ = std::bit_cast<State>(generator);
  return value;
}

void RandomStream::fill_normal(std::span<double> out) {
  auto generator = std::bit_cast<pcg32>(state_);
  for (std::size_t k = 0; k < out.size(); k += 2) {
    const double radius = std::sqrt(-2 * std::log(uniform_of(generator)));
    const double angle = 2 * std::numbers::pi * uniform_of(generator);
    out[k] = radius * std::cos(angle);
    if (k + 1 < out.size()) out[k + 1] = radius * std::sin(angle);
  }
  state_ = std::bit_cast<State>(generator);
}

}  // namespace glint
