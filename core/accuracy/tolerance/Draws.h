// Draws random deviations of all quantities at once, for a few dips that represent all dips.
#pragma once

#include <Eigen/Core>

namespace dipwright {

// Returns one row for each dip and one column for each quantity: normally distributed values with
// mean 0 and variance 1, drawn from `seed`. Dips come in pairs with opposite deviations. The values
// are transformed so that means, variances and correlations are exactly 0, 1 and 0. The result of
// anything linear in the quantities is therefore exact. That needs at least two dips for each
// quantity; `dips` is raised to that, and to an even number. Equal on all machines except for
// rounding.
Eigen::MatrixXd evenDraws(int dips, int quantities, int seed);

} // namespace dipwright
