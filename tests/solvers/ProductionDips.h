// Whole dips of the production film, for its tests.
#pragma once

#include "dip/Dip.h"
#include "geometry/DistanceField.h"

#include <dipwright/FilmSolver.h>

#include <utility>
#include <vector>

namespace dipwright::test {

// How a dip ended.
struct Ending {
    solver::DipSetup setup;
    std::vector<float> positions;
    std::vector<solver::PointState> states;
    std::vector<std::uint8_t> marks;
    solver::EquilibriumAccount equilibrium;
    double descent = 0;

    Eigen::Vector3d at(std::size_t point) const {
        return {double(positions[3 * point]), double(positions[3 * point + 1]),
                double(positions[3 * point + 2])};
    }
    bool adhered(std::size_t point) const { return states[point] == solver::PointState::Adhered; }
    std::size_t marked(solver::PointMark why) const;
};

Ending dip(solver::FilmSolver& film, const solver::DipSetup& setup);
Ending dipOnCpu(const solver::DipSetup& setup);

// A body in its pose, or a mesh as one.
struct Body {
    PosedBody posed;
    std::shared_ptr<const DistanceField> own;
    FilledField field{posed, *own};
};

Body bodyOf(const TriangleMesh& mesh);

// A film of `columns` points a side over 150 mm, to a depth in mm.
solver::DipSetup squareDip(const Body& body, int columns, double depth);

// 95th percentile and largest distance between two films at points that both have on the body.
// `every`: one point of the coarse film stands for that many steps of the fine one's grid.
std::pair<double, double> difference(const Ending& coarse, const Ending& fine, int every);

} // namespace dipwright::test
