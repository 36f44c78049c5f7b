// Runs whole dips of the production film for tests.
#pragma once

#include "dip/Dip.h"
#include "geometry/DistanceField.h"

#include <dipwright/FilmSolver.h>

#include <utility>
#include <vector>

namespace dipwright::test {

// The state at the end of a dip. Positions are in mm in the world frame.
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

// A posed body and its distance field.
struct Body {
    PosedBody posed;
    std::shared_ptr<const DistanceField> own;
    FilledField field{posed, *own};
};

Body bodyOf(const TriangleMesh& mesh);

// Returns a dip through a square film of 150 mm with `columns` points along each side. `depth` is
// in mm.
solver::DipSetup squareDip(const Body& body, int columns, double depth);

// Returns the 95th percentile and the maximum of the distance between two films, in mm, over the
// points that are adhered in both. `every` is the number of cells of the fine film per cell of the
// coarse film.
std::pair<double, double> difference(const Ending& coarse, const Ending& fine, int every);

} // namespace dipwright::test
