#pragma once
// How one whitened triangle is integrated in single precision, in images as for single normals: rays or a cubature, and
// what is too long for either.

#include <array>

namespace glint {

// Rays across the shortest whitened edge: with two more they are good to 1e-5 of the triangle's scale.
inline constexpr float k_nodes_per_deviation = 1.1F;
inline constexpr int k_most_panel_nodes = 24;

// Of whitened edges, deviations: up to here a cubature does, above there double precision must.
inline constexpr float k_longest_cubature = 2;
inline constexpr float k_longest_query_edge = 60;
inline constexpr float k_longest_edge = 250;  // of images

// Gauss rules of floats, padded to whole vectors.
struct RayRules {
  struct alignas(64) Rule {
    std::array<float, 32> nodes{};
    std::array<float, 32> weights{};
  };
  std::array<Rule, k_most_panel_nodes + 1> rules;

  RayRules();
};

const RayRules& ray_rules();

// A symmetric rule on the unit simplex.
struct Cubature {
  int count;
  std::array<std::array<float, 3>, 16> points;  // two coordinates, weight (they sum to 1/2)
};

// The cheapest that is exact to 1e-5 of the peak for a triangle whose longest whitened edge has this squared length;
// null for one that is too long.
const Cubature* cubature_for(float squared_longest);

}  // namespace glint
