// Draws random deviations of all quantities for a few dips that represent all possible dips.
#pragma once

#include <Eigen/Core>

namespace dipwright {

// Returns one row for each dip and one column for each quantity: normally distributed values with
// mean 0 and variance 1, drawn from `seed`. Dips come in pairs with opposite deviations. The values
// are transformed so that means, variances and correlations are exactly 0, 1 and 0. Results that
// are linear in the quantities are therefore exact. This needs an even number of dips, at least two
// per quantity; `dips` is raised to such a number. All machines give the same values except for
// rounding.
Eigen::MatrixXd evenDraws(int dips, int quantities, int seed);

} // namespace dipwright
