// The bodies and dips of the programs that measure films.
#pragma once

#include "solvers/TestFilm.h"

#include <fstream>
#include <string>

namespace dipwright::bench {

// A body with its lowest point (y) and its height, in mm, in its own coordinates.
struct Body {
    test::SampledBody sampled;
    double lowest = 0, height = 0;
};

// `name`: sphere, cone, or a file as CudaFilmBench.cpp describes it.
inline Body bodyOf(const std::string& name) {
    if (name == "sphere") {
        return {test::sphere(35, 128), -35, 70};
    }
    if (name == "cone") { // sides at 45°, tip down
        return {test::sampledBody(96, 128,
                                  [](double x, double y, double z) {
                                      const double side =
                                          (std::hypot(x, z) - (y + 25)) * std::sqrt(0.5);
                                      return std::max(side, y - 20);
                                  }),
                -25, 45};
    }
    Body body;
    solver::FieldView& view = body.sampled.view;
    std::ifstream file(name, std::ios::binary);
    file >> view.size[0] >> view.size[1] >> view.size[2] >> view.origin[0] >> view.origin[1] >>
        view.origin[2] >> view.spacing >> body.lowest >> body.height;
    file.ignore();
    body.sampled.distance.resize(std::size_t(view.size[0]) * std::size_t(view.size[1]) *
                                 std::size_t(view.size[2]));
    file.read(reinterpret_cast<char*>(body.sampled.distance.data()),
              std::streamsize(body.sampled.distance.size() * sizeof(float)));
    view.distance = body.sampled.distance.data();
    return body;
}

// Steps per cell of the film: 2 as in new projects, 4 as in older ones.
inline constexpr int usualStepsPerCell = 2;

inline solver::DipSetup productionDip(const Body& body, int columns, int rows,
                                      double relaxationTime, int stepsPerCell) {
    solver::DipSetup setup =
        test::paperDip(body.sampled, body.lowest, columns, rows, body.height + 2.5);
    setup.settings.lattice = solver::Lattice::Isotropic;
    setup.settings.support = solver::Support::Water;
    setup.settings.contactTravel = 1.0 / stepsPerCell;
    setup.settings.relaxationTime = relaxationTime;
    return setup;
}

} // namespace dipwright::bench
