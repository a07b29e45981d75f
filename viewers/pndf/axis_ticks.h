#pragma once
// Where the ticks of an axis stand, and what they are called. Pure functions.

#include <string>
#include <vector>

namespace glint::view {

/// The smallest step of 1, 2 or 5 x 10^n that is at least `step`; `step` is positive and finite.
double rounded_up_step(double step);

/// Multiples of a 1-2-5 step inside [lowest, highest], at most `most` of them (at least 2). Empty where the range is.
std::vector<double> linear_ticks(double lowest, double highest, int most);

/// Powers of ten inside [lowest, highest], thinned to every second, third … so that at most `most` are left; where no
/// more than one lies inside, 1, 2 and 5 times powers of ten. Empty where the range is, or is not positive.
std::vector<double> log_ticks(double lowest, double highest, int most);

/// Texts of linear ticks with as many decimals as their step needs: "−0.5", "0.0", "0.5".
std::vector<std::string> tick_texts(const std::vector<double>& ticks);

}  // namespace glint::view
