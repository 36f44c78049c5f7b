#include "ProductionDips.h"

#include "production/cpu/ProductionFilm.h"

#include <algorithm>

namespace dipwright::test {

std::size_t Ending::marked(solver::PointMark why) const {
    return std::size_t(
        std::ranges::count_if(marks, [&](std::uint8_t bits) { return solver::has(bits, why); }));
}

Ending dip(solver::FilmSolver& film, const solver::DipSetup& setup) {
    Ending ending;
    ending.setup = setup;
    film.begin(setup);
    solver::DipState progress;
    while (!progress.finished) {
        progress = film.advance(16);
    }
    ending.descent = progress.descent;
    ending.positions.resize(3 * setup.film.pointCount());
    ending.states.resize(setup.film.pointCount());
    film.read(ending.positions, ending.states);
    ending.marks.resize(setup.film.pointCount());
    film.readMarks(ending.marks);
    ending.equilibrium = progress.equilibrium;
    return ending;
}

Ending dipOnCpu(const solver::DipSetup& setup) {
    return dip(*cpu::makeProductionFilm(), setup);
}

Body bodyOf(const TriangleMesh& mesh) {
    return {posedBody(mesh, Immersion{}),
            std::make_shared<const DistanceField>(buildDistanceField(mesh, 128, {}))};
}

solver::DipSetup squareDip(const Body& body, int columns, double depth) {
    FilmSettings film;
    film.width = film.height = Millimetres(150);
    film.columns = film.rows = columns;
    ProcessSettings process;
    process.depth = Millimetres(depth);
    return dipSetup(body.posed, body.field, Immersion{}, film, process);
}

std::pair<double, double> difference(const Ending& coarse, const Ending& fine, int every) {
    std::vector<double> distances;
    const int columns = coarse.setup.film.columns, fineColumns = fine.setup.film.columns;
    for (int row = 0; row < coarse.setup.film.rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const auto point = std::size_t(row * columns + column);
            const auto other = std::size_t(row * every * fineColumns + column * every);
            if (coarse.adhered(point) && fine.adhered(other)) {
                distances.push_back((coarse.at(point) - fine.at(other)).norm());
            }
        }
    }
    std::sort(distances.begin(), distances.end());
    if (distances.size() < 50) {
        return {1e9, 1e9};
    }
    return {distances[distances.size() * 95 / 100], distances.back()};
}

} // namespace dipwright::test
