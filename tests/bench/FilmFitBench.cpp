// Measures how accurately a fit to photos of a dipped part finds known film and placement, for
// docs/inspection.md. The parts are eggs of several heights. They are dipped with smaller cells
// than the fit uses. The input of the fit is 16 corners of the print or all visible corners, and 24
// places of the body, in two photos, with a noise of 0 or 1 pixel.
//
//     film_fit_bench [CELL]      CELL: cell of the fit in mm; the true film's cell is 0.75 CELL
#include "../core/inspection/PhotographedPart.h"
#include "TestFolders.h"
#include "base/Error.h"
#include "solver/SolverRegistry.h"

#include <QGuiApplication>
#include <QTextStream>

#include <cmath>

using namespace dipwright;

namespace {

double offOf(const FilmFit& fit, FitQuantity quantity, double truth, bool isShare) {
    for (const FittedQuantity& one : fit.quantities) {
        if (one.unknown.quantity == quantity) {
            return isShare ? 100 * (one.after / truth - 1) : one.after - truth;
        }
    }
    return std::nan("");
}

// Returns half of the 95 % interval, in %.
double halfInterval(const FilmFit& fit, FitQuantity quantity) {
    for (const FittedQuantity& one : fit.quantities) {
        if (one.unknown.quantity == quantity) {
            return 50 * std::log(one.high / one.low);
        }
    }
    return std::nan("");
}

bool holds(const FilmFit& fit, FitQuantity quantity, double truth) {
    for (const FittedQuantity& one : fit.quantities) {
        if (one.unknown.quantity == quantity) {
            return one.low <= truth && truth <= one.high;
        }
    }
    return false;
}

} // namespace

int main(int argc, char** argv) {
    const QGuiApplication application(argc, argv);
    QTextStream out(stdout);
    const double cell = argc > 1 ? std::atof(argv[1]) : 1.5;
    const SolverRegistry registry{QStringList{pluginFolder()}};
    const solver::SolverModule& module = registry.module(QStringLiteral("pbd-cpu"));
    const auto cameras = test::camerasAround({{20, -35}, {140, -30}}, 280, 3.4, 4000);
    out << "height, hidden relaxation s, noise px, corners | off: swell X %, Y %, relaxation %, "
           "shift X mm, Z mm, turn deg | relaxation known to % | intervals of 6 that hold | mm "
           "before, "
           "after | rounds, dips\n";
    for (const double height : {1.0, 1.3, 1.6}) {
        for (const test::Hidden& hidden : {test::Hidden{1.062, 1.045, 4, 1.3, -0.9, 1.6},
                                           test::Hidden{1.01, 1.02, 1.5, -0.8, 0.6, -2},
                                           test::Hidden{1.09, 1.08, 10, 0.4, 1.5, 0.8}}) {
            const test::PhotographedPart part(test::eggToFit(height, cell), hidden, 0.75 * cell,
                                              module);
            for (const auto& [noise, corners] :
                 {std::pair(0.0, 8), std::pair(1.0, 8), std::pair(1.0, 100)}) {
                const FitPairs pairs = part.pairs(cameras, corners, 12, noise, 1);
                out << height << ", " << hidden.relaxation << ", " << noise << ", "
                    << pairs.printed.size() << " | ";
                try {
                    const FilmFit fit =
                        fitFilm(part.project(), part.field(), pairs, {}, module, {});
                    int held = 0;
                    const auto tell = [&](FitQuantity quantity, double truth, bool isShare) {
                        out << QString::number(offOf(fit, quantity, truth, isShare), 'f', 2) << ' ';
                        held += holds(fit, quantity, truth);
                    };
                    tell(FitQuantity::SwellX, hidden.swellX, true);
                    tell(FitQuantity::SwellY, hidden.swellY, true);
                    tell(FitQuantity::Relaxation, hidden.relaxation, true);
                    tell(FitQuantity::ShiftX, hidden.shiftX, false);
                    tell(FitQuantity::ShiftZ, hidden.shiftZ, false);
                    tell(FitQuantity::Turn, hidden.turn, false);
                    out << "| "
                        << QString::number(halfInterval(fit, FitQuantity::Relaxation), 'f', 1)
                        << " | " << held << " | " << QString::number(fit.beforeMillimetres, 'f', 3)
                        << ' ' << QString::number(fit.afterMillimetres, 'f', 3) << " | "
                        << fit.rounds << ' ' << fit.dips << '\n';
                } catch (const Error& error) {
                    out << error.message() << '\n';
                }
                out.flush();
            }
        }
    }
    return 0;
}
