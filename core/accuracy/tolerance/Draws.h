// How far everything is off at once, at random, for a few dips that stand for all.
#pragma once

#include <Eigen/Core>

namespace dipwright {

// A row a dip, a column a quantity: normally distributed with mean 0 and variance 1, drawn from
// `seed`. Dips come in pairs that are off by as much to either side, and the rows are turned and
// stretched until all means are 0 and all variances 1 with no correlation, exactly: what is linear
// in the quantities comes out as if all dips that there are had been done. That takes at least two
// dips a quantity; `dips` is raised to that, and to an even number. The same on every machine but
// for rounding.
Eigen::MatrixXd evenDraws(int dips, int quantities, int seed);

} // namespace dipwright
