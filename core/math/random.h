#pragma once
// Random numbers that can be repeated: PCG32 with one stream per purpose, pixel or block, so that a result never
// depends on threads or on the order of work. Not thread-safe: one stream belongs to one thread at a time.

#include <array>
#include <cstdint>
#include <span>

namespace glint {

class RandomStream {
 public:
  /// Streams with different (seed, stream) pairs are independent.
  RandomStream(std::uint64_t seed, std::uint64_t stream);

  std::uint32_t next_bits();
  /// Uniform in the open interval (0, 1), with 52 random bits.
  double next_uniform();
  /// Independent standard normal deviates (Box and Muller's transform).
  void fill_normal(std::span<double> out);

 private:
  std::array<std::uint64_t, 2> state_;  // of the generator, kept opaque so that pcg-cpp stays private
};

}  // namespace glint
