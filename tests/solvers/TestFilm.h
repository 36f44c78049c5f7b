// Makes small dips for tests of films. The bodies' distances are exact and are sampled like a real
// field.
#pragma once

#include "common/FieldSampling.h"

#include <dipwright/FilmSolver.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dipwright::test {

// The samples of a body's distance field. `view` points into `distance`.
struct SampledBody {
    std::vector<float> distance;
    solver::FieldView view;
};

// Samples distance(x, y, z) on a cube about the origin, with `samples` samples along each side of
// `edge` mm.
template <typename Distance>
SampledBody sampledBody(double edge, int samples, const Distance& distance) {
    SampledBody body;
    const double spacing = edge / (samples - 1);
    body.distance.reserve(std::size_t(samples) * std::size_t(samples) * std::size_t(samples));
    for (int k = 0; k < samples; ++k) {
        for (int j = 0; j < samples; ++j) {
            for (int i = 0; i < samples; ++i) {
                body.distance.push_back(float(distance(
                    -edge / 2 + i * spacing, -edge / 2 + j * spacing, -edge / 2 + k * spacing)));
            }
        }
    }
    body.view = {body.distance.data(),
                 {samples, samples, samples},
                 {-edge / 2, -edge / 2, -edge / 2},
                 spacing};
    return body;
}

inline SampledBody sphere(double radius, int samples) {
    return sampledBody(2.1 * radius, samples, [radius](double x, double y, double z) {
        return std::sqrt(x * x + y * y + z * z) - radius;
    });
}

inline SampledBody box(double halfX, double halfY, double halfZ, int samples) {
    const double edge = 2.2 * std::max({halfX, halfY, halfZ});
    return sampledBody(edge, samples, [=](double x, double y, double z) {
        const double dx = std::abs(x) - halfX, dy = std::abs(y) - halfY, dz = std::abs(z) - halfZ;
        const double outside = std::hypot(std::max(dx, 0.0), std::max(dy, 0.0), std::max(dz, 0.0));
        return outside + std::min(std::max({dx, dy, dz}), 0.0);
    });
}

// Returns a dip of the paper's film. The body's lowest point starts `gap` mm above the water.
// `lowest` is the y of that point in the body's frame, mm.
inline solver::DipSetup paperDip(const SampledBody& body, double lowest, int columns, int rows,
                                 double travel, double gap = 0.5) {
    solver::DipSetup setup;
    setup.film = {columns, rows, 210, 297};
    setup.field = body.view;
    setup.motion.start = {0, gap - lowest, 0};
    setup.motion.travel = travel;
    setup.settings.lattice = solver::Lattice::Structural;
    setup.settings.support = solver::Support::None;
    return setup;
}

// The state at the end of a dip.
struct Ending {
    std::vector<float> positions;
    std::vector<solver::PointState> states;
    solver::DipState progress;

    numerics::Vector3<double> position(std::size_t point) const {
        return {positions[3 * point], positions[3 * point + 1], positions[3 * point + 2]};
    }
    bool isAdhered(std::size_t point) const { return states[point] == solver::PointState::Adhered; }
};

inline Ending ending(const solver::FilmSolver& film, const solver::FilmGrid& grid) {
    Ending end;
    end.positions.resize(3 * grid.pointCount());
    end.states.resize(grid.pointCount());
    film.read(end.positions, end.states);
    return end;
}

inline Ending dip(solver::FilmSolver& film, const solver::DipSetup& setup) {
    film.begin(setup);
    solver::DipState progress;
    while (!progress.finished) {
        progress = film.advance(64);
    }
    Ending end = ending(film, setup.film);
    end.progress = progress;
    return end;
}

} // namespace dipwright::test
