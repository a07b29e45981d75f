#include "core/pndf/triangle_rules.h"

#include "core/math/quadrature.h"

namespace glint {
namespace {

// Degree 5 (Radon) and degree 8 (Dunavant).
constexpr Cubature k_seven = {7,
                              {{{0.33333333F, 0.33333333F, 0.1125F},
                                {0.10128651F, 0.10128651F, 0.06296959F},
                                {0.79742699F, 0.10128651F, 0.06296959F},
                                {0.10128651F, 0.79742699F, 0.06296959F},
                                {0.47014206F, 0.47014206F, 0.06619708F},
                                {0.05971587F, 0.47014206F, 0.06619708F},
                                {0.47014206F, 0.05971587F, 0.06619708F}}}};
constexpr Cubature k_sixteen = {16,
                                {{{0.33333333F, 0.33333333F, 0.07215780F},
                                  {0.45929259F, 0.45929259F, 0.04754582F},
                                  {0.08141482F, 0.45929259F, 0.04754582F},
                                  {0.45929259F, 0.08141482F, 0.04754582F},
                                  {0.17056931F, 0.17056931F, 0.05160869F},
                                  {0.65886138F, 0.17056931F, 0.05160869F},
                                  {0.17056931F, 0.65886138F, 0.05160869F},
                                  {0.05054723F, 0.05054723F, 0.01622925F},
                                  {0.89890554F, 0.05054723F, 0.01622925F},
                                  {0.05054723F, 0.89890554F, 0.01622925F},
                                  {0.26311283F, 0.72849239F, 0.01361516F},
                                  {0.72849239F, 0.26311283F, 0.01361516F},
                                  {0.26311283F, 0.00839478F, 0.01361516F},
                                  {0.00839478F, 0.26311283F, 0.01361516F},
                                  {0.72849239F, 0.00839478F, 0.01361516F},
                                  {0.00839478F, 0.72849239F, 0.01361516F}}}};
constexpr Cubature k_one = {1, {{{0.33333333F, 0.33333333F, 0.5F}}}};

constexpr float k_one_up_to = 0.01F;  // longest whitened edge
constexpr float k_seven_up_to = 0.75F;

}  // namespace

RayRules::RayRules() {
  for (int n = 1; n <= k_most_panel_nodes; ++n) {
    const GaussRule rule = gauss_legendre(n);
    for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k) {
      rules[static_cast<std::size_t>(n)].nodes[k] = static_cast<float>(rule.nodes[k]);
      rules[static_cast<std::size_t>(n)].weights[k] = static_cast<float>(rule.weights[k]);
    }
  }
}

const RayRules& ray_rules() {
  static const RayRules rules;
  return rules;
}

const Cubature* cubature_for(float squared_longest) {
  if (squared_longest < k_one_up_to * k_one_up_to) return &k_one;
  if (squared_longest < k_seven_up_to * k_seven_up_to) return &k_seven;
  if (squared_longest < k_longest_cubature * k_longest_cubature) return &k_sixteen;
  return nullptr;
}

}  // namespace glint
